#include "iga/multigrid/smoothing_points.hpp"

#include <algorithm>
#include <vector>

namespace isopatch::iga {

int smoothing_points(const geometry::KnotVector& knots) {
  const std::vector<int> multiplicities = knots.multiplicities();
  const bool is_smooth = std::all_of(multiplicities.begin() + 1, multiplicities.end() - 1,
                                     [&](int multiplicity) { return multiplicity <= knots.degree() - 2; });
  return knots.degree() + (is_smooth && knots.element_count() > 1 ? 0 : 1);
}

}  // namespace isopatch::iga
