#include "iga/internal/element_loop.hpp"

#include "iga/internal/folded_patch.hpp"

namespace isopatch::iga {

void require_positive_jacobian(const Discretization& d, int patch, const ElementEvaluator& evaluator,
                               std::int64_t element, const ElementValues& values) {
  Eigen::Index worst = 0;
  const double smallest = values.jacobians.minCoeff(&worst);
  if (smallest > 0) return;
  refuse_folded(d, patch, smallest, evaluator.parameter(element, worst), values.places.col(worst));
}

}  // namespace isopatch::iga
