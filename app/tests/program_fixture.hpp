#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/commands/program.hpp"
#include "geometry/base/atomic_file.hpp"
#include "geometry/base/temporary_folder.hpp"

namespace isopatch::app {

using nlohmann::json;
using testing::HasSubstr;
using testing::StartsWith;
namespace fs = std::filesystem;

/// 2 x 1 x 1 m of two patches on guides, free to contract.
inline const std::string guided_bar = R"(title = "bar"
[model]
generate = "box"
size = [2, 1, 1]
patches = [2, 1, 1]
[[material]]
young = 1e9
poisson = 0.25
[[support]]
name = "guides"
faces = ["x_min", "y_min", "z_min"]
roller = true
)";
/// Pulled by 10 MPa.
inline const std::string bar = guided_bar + R"([[load]]
faces = ["x_max"]
traction = [1e7, 0, 0]
[[probe]]
name = "end"
point = [2, 1, 1]
)";

/// A text in which another stands for a part that it must have.
inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

/// Runs the program in a folder of its own with a study in it.
class Program : public testing::Test {
 protected:
  void SetUp() override { write_file(study(), bar); }
  std::string study() const { return (folder_ / "study.toml").string(); }
  fs::path results() const { return folder_ / "results"; }

  int run(const std::vector<std::string>& arguments, bool terminal = false) {
    std::ostringstream out;
    std::ostringstream err;
    const int code = run_program(arguments, {out, err, terminal, false, false});
    out_ = out.str();
    err_ = err.str();
    return code;
  }
  /// Runs another study text.
  int run_text(const std::string& text, const std::vector<std::string>& more = {}) {
    write_file(study(), text);
    std::vector<std::string> arguments = {"run", study()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run(arguments);
  }

  TemporaryFolder temporary_;
  fs::path folder_ = temporary_.path();
  std::string out_;
  std::string err_;
};

/// Exit code of a shell command.
inline int shell(const std::string& command) {
  return WEXITSTATUS(std::system(command.c_str()));
}

/// Names of all files in a folder and below.
inline std::vector<std::string> files_below(const fs::path& folder) {
  std::vector<std::string> names;
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) names.push_back(entry.path().lexically_relative(folder).string());
  return names;
}

}  // namespace isopatch::app
