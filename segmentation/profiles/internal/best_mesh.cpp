#include "segmentation/profiles/internal/best_mesh.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <optional>

#include "geometry/base/error.hpp"
#include "segmentation/profiles/internal/midpoint_division.hpp"
#include "segmentation/profiles/internal/shared_cuts.hpp"

namespace isopatch::segmentation::planar {

namespace {

CellMesh last_resort(const SearchInput& input, const CellMesh& mesh) {
  CellMesh result = midpoint_division(input.curves, mesh);
  for (const Cell& cell : result.cells) {
    std::array<SideShape, 4> shapes;
    for (std::size_t k = 0; k < 4; ++k) shapes[k] = side_shape(input.curves, result.nodes, cell.sides[k]);
    if (least_jacobian({&shapes[0], &shapes[1], &shapes[2], &shapes[3]}) <= 0)
      throw Error(
          ErrorCode::unsupported,
          fmt::format("region {} of the profile cannot be divided: all divisions found are folded near "
                      "({:.4g}, {:.4g}) of its size; try a larger effort or wider bounds of angles",
                      cell.region, shapes[0].points.front().x(), shapes[0].points.front().y()));
  }
  return result;
}

}  // namespace

CellMesh best_mesh(const SearchInput& input, const Profile& profile, const QuadrangulationOptions& options) {
  const bool any_shared =
      std::any_of(input.shared.begin(), input.shared.end(), [](bool shared) { return shared; });
  std::vector<SharedCuts> ways = {{false, 0}, {true, 0}, {false, 0}, {true, 0}};
  std::optional<Search> best;
  const auto consider = [&](const SharedCuts& way, unsigned seed, int tries) {
    const CutPlaces places = even_places(input.curves, input.shared,
                                         shared_places(profile, input.curves, way), std::numbers::pi / 12);
    Search search(input, triangles_of(profile, input.curves, places), seed);
    search.remove_triangles(tries);
    const int windows = static_cast<int>(options.effort * (search.mesh().cells.size() + 5) / 40);
    search.improve(windows);
    if (!best || search.cost() < best->cost()) best = std::move(search);
  };
  for (std::size_t w = 0; w < ways.size(); ++w) {
    const std::size_t cells = best ? best->mesh().cells.size() : 0;
    if (w > 0 && best->is_valid() && w * cells > 150) break;  // large drawings have no time for more
    consider(ways[w], options.seed + static_cast<unsigned>(w), 60);
  }
  for (unsigned again = 0; again < 6 && !best->is_valid();
       ++again) {  // shared edges cut more, and more patience
    const int more = any_shared && again < 4 ? 1 : 0;
    consider({again % 2 == 1, more}, options.seed + 10 + again, 150);
  }
  best->polish();
  return best->is_valid() ? best->mesh() : last_resort(input, best->mesh());
}

}  // namespace isopatch::segmentation::planar
