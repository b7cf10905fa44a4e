#include "segmentation/profiles/quadrangulate.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "segmentation/profiles/internal/midpoint_division.hpp"
#include "segmentation/profiles/internal/start.hpp"

namespace isopatch::segmentation {

namespace {

/// Without unused nodes, sides as edges.
Quadrangulation result_of(const planar::CellMesh& mesh) {
  Quadrangulation result;
  std::vector<int> numbers(mesh.nodes.size(), -1);
  const auto enter = [&](int node) {
    if (numbers[node] < 0) {
      numbers[node] = static_cast<int>(result.vertices.size());
      result.vertices.push_back(mesh.nodes[node].point);
    }
    return numbers[node];
  };
  for (std::size_t n = 0; n < mesh.nodes.size(); ++n)
    if (mesh.nodes[n].given) enter(static_cast<int>(n));
  std::map<planar::SideKey, int> edges;
  for (const planar::Cell& cell : mesh.cells) {
    Quad quad;
    quad.region = cell.region;
    for (int k = 0; k < 4; ++k) {
      const planar::Side& side = cell.sides[k];
      const bool reversed = side.curve >= 0 ? side.reversed : side.from > side.to;
      const planar::SideKey key = reversed ? planar::key_across(side) : planar::key_of(side);
      const auto [entry, is_new] = edges.try_emplace(key, static_cast<int>(result.edges.size()));
      if (is_new) {
        const int from = enter(reversed ? side.to : side.from), to = enter(reversed ? side.from : side.to);
        const double turns = side.curve >= 0 ? std::floor(side.low) : 0;
        result.edges.push_back({from, to, side.curve, side.low - turns, side.high - turns});
      }
      quad.sides[static_cast<std::size_t>(k)] = {EdgeId(entry->second), reversed};
    }
    result.quads.push_back(quad);
  }
  return result;
}

}  // namespace

Quadrangulation quadrangulate(const Profile& profile, const QuadrangulationOptions& options) {
  validate(profile);
  validate(options);
  const std::vector<planar::Curve> curves = planar::curves_of(profile);
  const planar::CutPlaces places = planar::even_places(profile, curves, std::numbers::pi / 12);
  const planar::CellMesh triangles = planar::triangles_of(profile, curves, places);
  return result_of(planar::midpoint_division(curves, triangles));
}

}  // namespace isopatch::segmentation
