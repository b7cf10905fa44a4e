#include <gtest/gtest.h>

#include "solvers/blas_threads.hpp"
#include "verification/claims/claim_record.hpp"

int main(int count, char** arguments) {
  ::testing::InitGoogleTest(&count, arguments);
  // As in the program itself: factorizations raise it.
  isopatch::solvers::set_blas_threads(1);
  isopatch::verification::write_record_at_the_end();
  return RUN_ALL_TESTS();
}
