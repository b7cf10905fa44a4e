#include "iga/spaces/patch_space.hpp"

namespace isopatch::iga {

std::vector<PatchSpace> isoparametric_spaces(const Discretization& discretization) {
  std::vector<PatchSpace> spaces;
  for (std::size_t p = 0; p < discretization.patches.size(); ++p) {
    const geometry::NurbsVolume& patch = discretization.patches[p];
    spaces.push_back({&patch, patch.knots(), patch.is_rational() ? patch.weights() : Eigen::VectorXd(),
                      discretization.model.was_reversed(PatchId(static_cast<int>(p))),
                      discretization.gauss_points[p]});
  }
  return spaces;
}

std::vector<int> first_nodes(const std::vector<PatchSpace>& spaces) {
  std::vector<int> result = {0};
  for (const PatchSpace& space : spaces) result.push_back(result.back() + space.size());
  return result;
}

std::vector<PatchLayers> whole_patches(const std::vector<PatchSpace>& spaces) {
  std::vector<PatchLayers> parts;
  for (std::size_t p = 0; p < spaces.size(); ++p)
    parts.push_back({static_cast<int>(p), 0, spaces[p].knots[2].element_count()});
  return parts;
}

}  // namespace isopatch::iga
