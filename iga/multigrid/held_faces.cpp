#include "iga/multigrid/held_faces.hpp"

#include <algorithm>

#include "iga/assembly/support_stiffness.hpp"
#include "iga/multigrid/side_matrix.hpp"

namespace isopatch::iga {
namespace {

SidesOfPatches sides_of(const Springs& holds) {
  SidesOfPatches result;
  for (const SprungFace& held : holds.faces) {
    std::vector<geometry::Side>& sides = result[held.face.patch];
    if (std::find(sides.begin(), sides.end(), held.face.side) == sides.end()) sides.push_back(held.face.side);
  }
  return result;
}

Springs of_patch(const Springs& holds, PatchId patch) {
  Springs result;
  for (const SprungFace& held : holds.faces)
    if (held.face.patch == patch) result.faces.push_back(held);
  return result;
}

// The nodes of sides whose rows are in no block yet, which takes them.
std::vector<int> take_nodes(const Level& level, PatchId patch, const std::vector<geometry::Side>& sides,
                            std::vector<char>& taken) {
  const auto p = static_cast<std::size_t>(patch.value);
  std::vector<int> result;
  for (const geometry::Side side : sides)
    for (const int node : geometry::face_control_points(level.spaces[p].sizes(), side)) {
      const int own = level.first_node[p] + node;
      char& is_taken = taken[static_cast<std::size_t>(level.global_of[static_cast<std::size_t>(own)])];
      if (is_taken) continue;
      is_taken = 1;
      result.push_back(own);
    }
  return result;
}

}  // namespace

HeldFaces::HeldFaces(const Level& level, const std::vector<Material>& materials, const Springs& holds,
                     const std::vector<Eigen::Matrix3d>& diagonal, std::vector<char>& taken) {
  for (const auto& [patch, sides] : sides_of(holds)) {
    const std::vector<int> nodes = take_nodes(level, patch, sides, taken);
    if (nodes.empty() || !level.is_primary[static_cast<std::size_t>(patch.value)]) continue;
    Block& made = blocks_.emplace_back();
    for (const int node : nodes) made.rows.push_back(level.row_of_node[static_cast<std::size_t>(node)]);
    std::sort(made.rows.begin(), made.rows.end());
    const NodeBlocks springs =
        support_stiffness(level.spaces, whole_patches(level.spaces), of_patch(holds, patch));
    made.inverse =
        inverse_for_smoothing(side_matrix(level, {{patch, sides}}, made.rows, materials, springs, diagonal));
  }
}

void HeldFaces::add(const Eigen::VectorXd& residual, Eigen::VectorXd& result) const {
  for (const Block& block : blocks_) add_to_rows(block.rows, block.inverse, residual, result);
}

}  // namespace isopatch::iga
