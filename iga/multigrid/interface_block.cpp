#include "iga/multigrid/interface_block.hpp"

#include <algorithm>
#include <utility>

#include "iga/multigrid/side_matrix.hpp"

namespace isopatch::iga {
namespace {

SidesOfPatches sides_that_do_not_match(const geometry::MultiPatch& model,
                                       const std::vector<PatchLayers>& parts) {
  SidesOfPatches result;
  const auto is_here = [&](const PatchLayers& part, PatchId patch) {
    return part.couples && part.patch == patch.value;
  };
  const auto add = [&](const geometry::PatchFace& face) {
    if (std::none_of(parts.begin(), parts.end(),
                     [&](const PatchLayers& part) { return is_here(part, face.patch); }))
      return;
    std::vector<geometry::Side>& sides = result[face.patch];
    if (std::find(sides.begin(), sides.end(), face.side) == sides.end()) sides.push_back(face.side);
  };
  for (const geometry::NonMatchingInterface& interface : model.non_matching()) {
    add(interface.first);
    add(interface.second);
  }
  return result;
}

}  // namespace

std::vector<bool> nodes_that_do_not_match(const geometry::MultiPatch& model, const Level& level) {
  std::vector<bool> result(level.global_of.size(), false);
  for (const auto& [patch, sides] : sides_that_do_not_match(model, whole_patches(level.spaces))) {
    const auto p = static_cast<std::size_t>(patch.value);
    for (const geometry::Side side : sides)
      for (const int node : geometry::face_control_points(level.spaces[p].sizes(), side))
        result[static_cast<std::size_t>(level.first_node[p] + node)] = true;
  }
  return result;
}

InterfaceMatrix interface_matrix(const geometry::MultiPatch& model, const Level& level,
                                 const std::vector<Material>& materials, const NodeBlocks& surfaces,
                                 const std::vector<Eigen::Matrix3d>& diagonal) {
  if (model.non_matching().empty()) return {};
  const SidesOfPatches sides = sides_that_do_not_match(model, level.parts);
  std::vector<int> rows = rows_on(level, sides);
  if (rows.empty()) return {};
  solvers::SymmetricBlockMatrix matrix = side_matrix(level, sides, rows, materials, surfaces, diagonal);
  return {std::move(rows), std::move(matrix)};
}

InterfaceBlock::InterfaceBlock(const geometry::MultiPatch& model, const Level& level,
                               const std::vector<Material>& materials, const NodeBlocks& surfaces,
                               const std::vector<Eigen::Matrix3d>& diagonal) {
  InterfaceMatrix of_faces = interface_matrix(model, level, materials, surfaces, diagonal);
  if (of_faces.rows.empty()) return;
  rows_ = std::move(of_faces.rows);
  inverse_ = inverse_for_smoothing(of_faces.matrix);
}

void InterfaceBlock::add(const Eigen::VectorXd& residual, Eigen::VectorXd& result) const {
  if (!rows_.empty()) add_to_rows(rows_, inverse_, residual, result);
}

}  // namespace isopatch::iga
