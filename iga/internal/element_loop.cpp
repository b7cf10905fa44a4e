#include "iga/internal/element_loop.hpp"

#include <fmt/format.h>

#include "geometry/base/error.hpp"

namespace isopatch::iga {

void require_positive_jacobian(const Discretization& d, int patch, const ElementEvaluator& evaluator,
                               std::int64_t element, const ElementValues& values) {
  Eigen::Index worst = 0;
  const double smallest = values.jacobians.minCoeff(&worst);
  if (smallest > 0) return;
  const auto parameter = d.model.renamed(PatchId(patch), evaluator.parameter(element, worst));
  const Eigen::Vector3d place = values.places.col(worst);
  throw Error(
      ErrorCode::fold_over,
      fmt::format("patch {} is folded: det J = {:.3g} m^3 at the Gauss point with parameter ({:.6g}, {:.6g}, "
                  "{:.6g}), place "
                  "({:.6g}, {:.6g}, {:.6g}) m; mend the patch's inner control points there",
                  patch, smallest, parameter[0], parameter[1], parameter[2], place[0], place[1], place[2]));
}

}  // namespace isopatch::iga
