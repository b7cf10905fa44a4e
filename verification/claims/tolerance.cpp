#include "verification/claims/tolerance.hpp"

#include <fmt/format.h>

#include <limits>

namespace isopatch::verification {

Tolerance round_off(double amplification, const std::string& of) {
  return {round_off_safety * std::numeric_limits<double>::epsilon() * amplification,
          fmt::format("round-off of {}: unit round-off times {:g}, times {:g} for other machines", of,
                      amplification, round_off_safety)};
}

}  // namespace isopatch::verification
