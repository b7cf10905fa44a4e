#include "iga/assembly/interface_stiffness.hpp"

#include <algorithm>
#include <utility>

#include "geometry/shared_grid.hpp"
#include "iga/assembly/internal/cell_interface.hpp"
#include "iga/assembly/internal/grid_interface.hpp"
#include "iga/assembly/internal/patch_side.hpp"
#include "iga/assembly/internal/side_grid.hpp"
#include "iga/internal/parallel_for.hpp"

namespace isopatch::iga {
namespace {

using geometry::Side;

// How many sides of an element of a patch carry tractions.
int loaded_sides(const PatchSpace& space, const std::array<int, 3>& element, const std::vector<Side>& sides) {
  return static_cast<int>(std::count_if(sides.begin(), sides.end(), [&](Side side) {
    const auto d = static_cast<std::size_t>(geometry::direction(side));
    return element[d] == (geometry::is_high(side) ? space.knots[d].element_count() - 1 : 0);
  }));
}

// What A is multiplied by in T on each element of the traction's side, 1/m.
Eigen::MatrixXd penalties_of(const PatchSide& own, const SideFunctions& functions,
                             const std::vector<Side>& traction_sides) {
  Eigen::MatrixXd result = 2 * trace_constants(functions);
  for (int j = 0; j < result.cols(); ++j)
    for (int i = 0; i < result.rows(); ++i)
      result(i, j) *= loaded_sides(functions.space(), own.element({i, j}), traction_sides);
  return result;
}

}  // namespace

NodeBlocks interface_stiffness(const std::vector<CoupledFaces>& interfaces,
                               const std::vector<PatchSpace>& spaces, const std::vector<Material>& materials,
                               double same_point) {
  NodeBlocks result;
  if (interfaces.empty()) return result;
  const std::vector<int> first_node = first_nodes(spaces);
  std::vector<std::vector<Side>> traction_sides(spaces.size());
  for (const CoupledFaces& faces : interfaces) {
    std::vector<Side>& sides = traction_sides[static_cast<std::size_t>(faces.traction.patch.value)];
    if (std::find(sides.begin(), sides.end(), faces.traction.side) == sides.end())
      sides.push_back(faces.traction.side);
  }
  std::vector<NodeBlocks> of_interfaces(interfaces.size());
  parallel_for(static_cast<std::int64_t>(interfaces.size()), [&](std::int64_t number, int) {
    const auto i = static_cast<std::size_t>(number);
    const CoupledFaces& faces = interfaces[i];
    const auto p = static_cast<std::size_t>(faces.traction.patch.value);
    const auto q = static_cast<std::size_t>(faces.other.patch.value);
    const PatchSide own(spaces[p], faces.traction.side, first_node[p]);
    const PatchSide other(spaces[q], faces.other.side, first_node[q]);
    const SideFunctions of_own(spaces[p], faces.traction.side, first_node[p]);
    const SideFunctions of_other(spaces[q], faces.other.side, first_node[q]);
    const Eigen::MatrixXd penalties = penalties_of(own, of_own, traction_sides[p]);
    const auto grid = geometry::shared_grid(own.divided(), other.divided(),
                                            points_of_rectangle(of_own, of_other), same_point);
    of_interfaces[i] =
        grid ? grid_stiffness(of_own, of_other, *grid, penalties, materials[p])
             : cell_stiffness(own, other, penalties, materials[p], points_of_cell(own, other), same_point);
  });
  std::size_t count = 0;
  for (const NodeBlocks& blocks : of_interfaces) count += blocks.size();
  result.reserve(count);
  for (NodeBlocks& blocks : of_interfaces) result.add(std::exchange(blocks, {}));
  return result;
}

}  // namespace isopatch::iga
