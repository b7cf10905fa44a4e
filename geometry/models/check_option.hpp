#pragma once

#include <string_view>

#include "geometry/base/angle.hpp"

namespace isopatch::geometry {

/// Refuses an option that is not a positive, finite number.
/// @throws Error invalid_argument: "link: thickness is -3; it must be a positive length"
void check_length(std::string_view model, std::string_view field, double value);

/// Refuses an option that is not a finite number of at least 0.
void check_length_or_zero(std::string_view model, std::string_view field, double value);

/// Refuses a number of patches outside 1 .. 1000.
void check_count(std::string_view model, std::string_view field, int value);

/// Refuses a model of more than 100,000 patches, which only a slip of the pen asks for.
/// @param count  a product of numbers that `check_count` has seen
void check_total(std::string_view model, double count);

/// Refuses a number outside [low, high].
void check_range(std::string_view model, std::string_view field, double value, double low, double high);

/// Refuses an angle outside (0, most].
void check_angle(std::string_view model, std::string_view field, Angle value, Angle most);

/// Refuses `value` unless it is below the limit that another field, or an expression of fields, sets.
/// @throws Error invalid_argument: "link: left_bore_radius is 20; it must be below left_outer_radius, 15"
void check_below(std::string_view model, std::string_view field, double value, std::string_view limit_name,
                 double limit);

}  // namespace isopatch::geometry
