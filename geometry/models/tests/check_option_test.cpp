#include "geometry/models/check_option.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "geometry/base/tests/expect_error.hpp"

namespace isopatch::geometry {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr ErrorCode invalid = ErrorCode::invalid_argument;

TEST(CheckOption, LengthsArePositiveAndFinite) {
  check_length("box", "size", 1e-30);
  for (const double value : {0.0, -1.0, nan, infinity})
    EXPECT_ERROR(check_length("box", "size", value), invalid, "box: size is") << value;
  EXPECT_ERROR(check_length("box", "size", -1), invalid, "size is -1; it must be a positive length");
}

TEST(CheckOption, SomeLengthsMayVanish) {
  check_length_or_zero("elbow", "inlet", 0);
  for (const double value : {-1e-9, nan, infinity})
    EXPECT_ERROR(check_length_or_zero("elbow", "inlet", value), invalid, "a length of 0 or more") << value;
}

TEST(CheckOption, CountsHaveBothEnds) {
  check_count("cook", "layers", 1);
  check_count("cook", "layers", 1000);
  for (const int value : {0, -3, 1001})
    EXPECT_ERROR(check_count("cook", "layers", value), invalid, "a whole number from 1 to 1000") << value;
  check_total("box", 1e5);
  EXPECT_ERROR(check_total("box", 1e5 + 1), invalid, "at most 100000");
  EXPECT_ERROR(check_total("box", nan), invalid, "the number of all patches is nan");
}

TEST(CheckOption, RangesIncludeTheirEnds) {
  check_range("box", "distortion", 0, 0, 0.4);
  check_range("box", "distortion", 0.4, 0, 0.4);
  for (const double value : {-1e-12, 0.41, nan})
    EXPECT_ERROR(check_range("box", "distortion", value, 0, 0.4), invalid, "between 0 and 0.4") << value;
}

TEST(CheckOption, AnglesAreAboveNothingAndUpToTheMost) {
  check_angle("elbow", "bend", Angle::degrees(180), Angle::degrees(180));
  for (const double degrees : {0.0, -10.0, 181.0})
    EXPECT_ERROR(check_angle("elbow", "bend", Angle::degrees(degrees), Angle::degrees(180)), invalid,
                 "above 0 and at most 180 degrees")
        << degrees;
}

TEST(CheckOption, LimitsAreNotReached) {
  check_below("plate", "hole_radius", 3.9, "width", 4);
  for (const double value : {4.0, 5.0, nan})
    EXPECT_ERROR(check_below("plate", "hole_radius", value, "width", 4), invalid, "below width, 4") << value;
}

}  // namespace
}  // namespace isopatch::geometry
