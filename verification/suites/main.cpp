#include <gtest/gtest.h>

#include "verification/claims/claim_record.hpp"

int main(int count, char** arguments) {
  ::testing::InitGoogleTest(&count, arguments);
  isopatch::verification::write_record_at_the_end();
  return RUN_ALL_TESTS();
}
