#include "iga/spaces/internal/folded_patch.hpp"

#include <fmt/format.h>

#include <Eigen/LU>
#include <limits>

#include "geometry/base/error.hpp"

namespace isopatch::iga {

using geometry::Parameter;

void refuse_folded(int patch, const geometry::NurbsVolume& volume, bool reversed,
                   const Parameter<3>& parameter) {
  const double determinant = volume.jacobian(parameter).determinant();
  const Eigen::Vector3d place = volume.point(parameter);
  Parameter<3> given = parameter;
  if (reversed) given[0] = volume.knots(0).first() + (volume.knots(0).last() - parameter[0]);
  throw Error(
      ErrorCode::fold_over,
      fmt::format("patch {} is folded: det J = {:.3g} m^3 at the Gauss point with parameter ({:.6g}, {:.6g}, "
                  "{:.6g}), place ({:.6g}, {:.6g}, {:.6g}) m; mend the patch's inner control points there",
                  patch, determinant, given[0], given[1], given[2], place[0], place[1], place[2]));
}

void refuse_folded(int patch, const geometry::NurbsVolume& volume, bool reversed,
                   const std::array<std::vector<double>, 3>& nodes) {
  double smallest = std::numeric_limits<double>::infinity();
  Parameter<3> worst = Parameter<3>::Zero();
  for (const double w : nodes[2])
    for (const double v : nodes[1])
      for (const double u : nodes[0]) {
        const Parameter<3> here(u, v, w);
        const double determinant = volume.jacobian(here).determinant();
        if (determinant >= smallest) continue;
        smallest = determinant;
        worst = here;
      }
  refuse_folded(patch, volume, reversed, worst);
}

}  // namespace isopatch::iga
