#include "geometry/io/reader_limits.hpp"

#include <fmt/format.h>

#include "geometry/base/error.hpp"

namespace isopatch::geometry {

std::int64_t checked_control_points(const KnotVector& u, const KnotVector& v, const KnotVector& w) {
  // Two factors below 2^31 fit into 64 bits; the third is applied by division.
  const std::int64_t layer = std::int64_t{u.size()} * v.size();
  if (layer > max_control_points / w.size())
    throw Error(ErrorCode::bad_format,
                fmt::format("{} x {} x {} control points are more than the {} accepted", u.size(), v.size(),
                            w.size(), max_control_points));
  return layer * w.size();
}

}  // namespace isopatch::geometry
