#include "geometry/models/check_option.hpp"

#include <fmt/format.h>

#include <cmath>

#include "geometry/base/error.hpp"

namespace isopatch::geometry {
namespace {

[[noreturn]] void refuse(std::string_view model, std::string_view field, const std::string& value,
                         const std::string& demand) {
  throw Error(ErrorCode::invalid_argument,
              fmt::format("{}: {} is {}; it must be {}", model, field, value, demand));
}

}  // namespace

void check_length(std::string_view model, std::string_view field, double value) {
  if (!(value > 0 && std::isfinite(value)))
    refuse(model, field, fmt::format("{:g}", value), "a positive length");
}

void check_length_or_zero(std::string_view model, std::string_view field, double value) {
  if (!(value >= 0 && std::isfinite(value)))
    refuse(model, field, fmt::format("{:g}", value), "a length of 0 or more");
}

void check_count(std::string_view model, std::string_view field, int value) {
  if (value < 1 || value > 1000)
    refuse(model, field, fmt::format("{}", value), "a whole number from 1 to 1000");
}

void check_total(std::string_view model, double count) {
  constexpr double most = 100'000;
  if (!(count <= most))
    refuse(model, "the number of all patches", fmt::format("{:.0f}", count), "at most 100000");
}

void check_range(std::string_view model, std::string_view field, double value, double low, double high) {
  if (!(value >= low && value <= high))
    refuse(model, field, fmt::format("{:g}", value), fmt::format("between {:g} and {:g}", low, high));
}

void check_angle(std::string_view model, std::string_view field, Angle value, Angle most) {
  if (!(value > Angle() && value <= most))
    refuse(model, field, fmt::format("{:g} degrees", value.degrees()),
           fmt::format("above 0 and at most {:g} degrees", most.degrees()));
}

void check_below(std::string_view model, std::string_view field, double value, std::string_view limit_name,
                 double limit) {
  if (!(value < limit))
    refuse(model, field, fmt::format("{:g}", value), fmt::format("below {}, {:g}", limit_name, limit));
}

}  // namespace isopatch::geometry
