#include "iga/spaces/internal/folded_patch.hpp"

#include <fmt/format.h>

#include "geometry/base/error.hpp"

namespace isopatch::iga {

void refuse_folded(const Discretization& discretization, int patch, double jacobian,
                   const geometry::Parameter<3>& parameter, const Eigen::Vector3d& place) {
  const geometry::Parameter<3> given = discretization.model.to_input(PatchId(patch), parameter);
  throw Error(
      ErrorCode::fold_over,
      fmt::format("patch {} is folded: det J = {:.3g} m^3 at the Gauss point with parameter ({:.6g}, {:.6g}, "
                  "{:.6g}), place "
                  "({:.6g}, {:.6g}, {:.6g}) m; mend the patch's inner control points there",
                  patch, jacobian, given[0], given[1], given[2], place[0], place[1], place[2]));
}

}  // namespace isopatch::iga
