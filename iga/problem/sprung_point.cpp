#include "iga/problem/sprung_point.hpp"

#include <fmt/format.h>

#include <cmath>

#include "geometry/base/error.hpp"

namespace isopatch::iga {

void validate(const ElasticSupport& springs, const std::string& support) {
  const auto [normal, tangential] = springs;
  if (!(normal >= 0) || !(tangential >= 0) || !std::isfinite(normal) || !std::isfinite(tangential))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("'{}': an elastic support has the stiffness {} across and {} N/m^3 along its "
                            "faces; both must be finite and not negative",
                            support, normal, tangential));
}

}  // namespace isopatch::iga
