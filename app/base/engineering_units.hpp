#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <string>
#include <string_view>

#include "app/pages/display_unit.hpp"

namespace isopatch::app {

/// The unit in which a quantity whose largest value is `largest` reads well.
/// @param unit  m, Pa, J, N and the like
DisplayUnit display_unit(double largest, std::string_view unit);
/// mm for machine parts, m for what is larger than ten metres.
DisplayUnit model_length_unit(double model_size);

/// A value with the prefix that keeps it readable, four digits: "6.838 mm", "674.1 MPa", "68.60 J".
/// @param unit  m, Pa, J, N or g and the like; powers of m ("m^2", "m^3") get prefixes of the length
std::string with_unit(double value, std::string_view unit);

/// A value with its uncertainty, both in the unit that suits the larger one: "290 +- 110 kPa", two digits of
/// the uncertainty and never a power of ten.
std::string with_uncertainty(double value, double uncertainty, std::string_view unit);

/// A unit with the prefix that suits a size: {1e6, "MPa"}; powers of m as above, no unit for pure numbers.
struct ScaledUnit {
  double factor = 1;
  std::string symbol;
};
ScaledUnit unit_for(double value, std::string_view unit);

/// "(198.02, -179.69, -27.44) mm": metres, with the unit that suits a model of this size.
std::string place_with_unit(const Eigen::Vector3d& place, double model_size);

/// "(1.20, 0, -3.4) kN": the largest component chooses the prefix.
std::string vector_with_unit(const Eigen::Vector3d& vector, std::string_view unit);

/// 0 for values that are round-off beside others of the same kind, the value itself otherwise.
/// @param scale  size of the others; less than 1e-10 of it, what the solver's residual allows, is round-off
double without_round_off(double value, double scale);
Eigen::Vector3d without_round_off(const Eigen::Vector3d& vector, double scale);

/// 73746 as "73,746".
std::string with_separators(std::int64_t count);

/// "1 face", "73,746 faces".
/// @param plural  where it is not the singular with an s
std::string counted(std::int64_t count, std::string_view singular, std::string_view plural = {});
inline std::string counted(std::size_t count, std::string_view singular, std::string_view plural = {}) {
  return counted(static_cast<std::int64_t>(count), singular, plural);
}
inline std::string counted(int count, std::string_view singular, std::string_view plural = {}) {
  return counted(static_cast<std::int64_t>(count), singular, plural);
}

/// "1.4 GB".
std::string bytes_text(std::int64_t bytes);

/// "0.43 s", "3 min 12 s".
std::string seconds_text(double seconds);

}  // namespace isopatch::app
