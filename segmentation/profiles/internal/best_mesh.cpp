#include "segmentation/profiles/internal/best_mesh.hpp"

#include <algorithm>
#include <numbers>
#include <optional>

#include "segmentation/profiles/internal/midpoint_division.hpp"
#include "segmentation/profiles/internal/shared_cuts.hpp"

namespace isopatch::segmentation::planar {

CellMesh best_mesh(const SearchInput& input, const Profile& profile, const QuadrangulationOptions& options) {
  const bool any_shared =
      std::any_of(input.shared.begin(), input.shared.end(), [](bool shared) { return shared; });
  std::vector<SharedCuts> ways = {{false, 0}, {true, 0}, {false, 0}, {true, 0}};
  std::optional<Search> best;
  const auto consider = [&](const SharedCuts& way, unsigned seed) {
    const CutPlaces places = even_places(input.curves, input.shared,
                                         shared_places(profile, input.curves, way), std::numbers::pi / 12);
    Search search(input, triangles_of(profile, input.curves, places), seed);
    search.remove_triangles(60);
    const int windows = static_cast<int>(options.effort * (search.mesh().cells.size() + 5) / 40);
    search.improve(windows);
    if (!best || search.cost() < best->cost()) best = std::move(search);
  };
  for (std::size_t w = 0; w < ways.size(); ++w) consider(ways[w], options.seed + static_cast<unsigned>(w));
  if (any_shared && !best->is_valid()) consider({false, 1}, options.seed);
  best->polish();
  return best->is_valid() ? best->mesh() : midpoint_division(input.curves, best->mesh());
}

}  // namespace isopatch::segmentation::planar
