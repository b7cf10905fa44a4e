#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "verification/suites/program_run.hpp"

namespace isopatch::verification {

/// Skips where the machine lets no processes be started, which says nothing about the program.
class SeveralProcesses : public testing::Test {
 protected:
  void SetUp() override {
    static const std::string fault = launcher_fault();
    if (!fault.empty()) GTEST_SKIP() << fault;
  }
};

/// Claims that a study of `verification/studies` has the same energy as two processes, with some overrides,
/// as by one that factorizes.
/// @param file  its name without the ending
void expect_same_energy(const std::string& file, const std::vector<std::string>& overrides,
                        const Tolerance& allowed);

/// The same where one process has some overrides too.
void expect_same_energy_of(const std::string& file, const std::vector<std::string>& of_both,
                           std::vector<std::string> overrides, const Tolerance& allowed);

}  // namespace isopatch::verification
