#include "iga/multigrid/smoothing_points.hpp"

#include <algorithm>
#include <vector>

namespace isopatch::iga {
namespace {

// Length over thickness of the elements in the middle of a patch.
double slenderness(const PatchSpace& space) {
  const geometry::NurbsVolume& volume = *space.geometry;
  Eigen::Vector3d lengths =
      volume.jacobian(0.5 * (volume.low() + volume.high())).colwise().norm().transpose();
  for (int d = 0; d < 3; ++d)
    lengths[d] *=
        (volume.high()[d] - volume.low()[d]) / space.knots[static_cast<std::size_t>(d)].element_count();
  return lengths.maxCoeff() / lengths.minCoeff();
}

}  // namespace

int smoothing_points(const geometry::KnotVector& knots) {
  const std::vector<int> multiplicities = knots.multiplicities();
  const bool is_smooth = std::all_of(multiplicities.begin() + 1, multiplicities.end() - 1,
                                     [&](int multiplicity) { return multiplicity <= knots.degree() - 2; });
  return knots.degree() + (is_smooth && knots.element_count() > 1 ? 0 : 1);
}

GaussPoints smoothing_points(const PatchSpace& space) {
  constexpr double most_slender = 100;
  GaussPoints result;
  const bool is_sheet = !(slenderness(space) <= most_slender);
  for (std::size_t d = 0; d < 3; ++d)
    result[d] = is_sheet ? space.knots[d].degree() + 1 : smoothing_points(space.knots[d]);
  return result;
}

}  // namespace isopatch::iga
