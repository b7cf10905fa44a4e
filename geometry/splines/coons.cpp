#include "geometry/splines/coons.hpp"

#include <algorithm>

#include "geometry/base/error.hpp"
#include "geometry/splines/permute.hpp"
#include "geometry/splines/refine.hpp"
#include "geometry/splines/sweep.hpp"

namespace isopatch::geometry {
namespace {

void require_loop(const std::array<NurbsCurve, 4>& sides) {
  double size = 0;
  for (const NurbsCurve& side : sides)
    size = std::max(size, (side.control_points().colwise() - side.control_points().col(0)).norm());
  for (std::size_t k = 0; k < 4; ++k) {
    const NurbsCurve &before = sides[k], &after = sides[(k + 1) % 4];
    const double gap = (before.point(before.high()) - after.point(after.low())).norm();
    if (!(gap <= 1e-6 * size))
      throw Error(ErrorCode::invalid_argument, "sides of a surface that do not meet at its corners");
  }
}

}  // namespace

NurbsSurface coons_surface(const std::array<NurbsCurve, 4>& sides) {
  require_loop(sides);
  const NurbsSurface along_v = ruled(sides[0], reversed(sides[2], 0));
  const NurbsSurface along_u = permuted(ruled(reversed(sides[3], 0), sides[1]), {1, 0});
  const NurbsSurface::KnotVectors knots{along_v.knots(0), along_u.knots(1)};
  const Eigen::Matrix4Xd first = along_v.homogeneous();
  Eigen::Matrix4Xd corners(4, 4);
  corners << first.col(0), first.col(along_v.size(0) - 1), first.col(along_v.size(0)),
      first.col(first.cols() - 1);
  const NurbsSurface between =
      NurbsSurface::from_homogeneous({KnotVector::bezier(1), KnotVector::bezier(1)}, corners);
  return NurbsSurface::from_homogeneous(knots, refined(along_v, knots).homogeneous() +
                                                   refined(along_u, knots).homogeneous() -
                                                   refined(between, knots).homogeneous());
}

}  // namespace isopatch::geometry
