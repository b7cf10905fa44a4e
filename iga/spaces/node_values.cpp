#include "iga/spaces/node_values.hpp"

#include "geometry/splines/basis.hpp"

namespace isopatch::iga {

std::vector<NodeValue> node_values(const PatchSpace& space, const geometry::Parameter<3>& parameter) {
  std::array<geometry::BasisValues, 3> along;
  for (std::size_t d = 0; d < 3; ++d)
    along[d] = geometry::basis(space.knots[d], parameter[static_cast<Eigen::Index>(d)]);
  const auto sizes = space.sizes();
  std::vector<NodeValue> result;
  double total = 0;
  for (Eigen::Index k = 0; k < along[2].values.cols(); ++k)
    for (Eigen::Index j = 0; j < along[1].values.cols(); ++j)
      for (Eigen::Index i = 0; i < along[0].values.cols(); ++i) {
        double value = along[0].values(0, i) * along[1].values(0, j) * along[2].values(0, k);
        if (value == 0) continue;
        const int node = along[0].first + static_cast<int>(i) +
                         sizes[0] * (along[1].first + static_cast<int>(j) +
                                     sizes[1] * (along[2].first + static_cast<int>(k)));
        if (space.is_rational()) value *= space.weights[node];
        total += value;
        result.push_back({node, value});
      }
  for (NodeValue& at : result) at.value /= total;
  return result;
}

}  // namespace isopatch::iga
