#include "segmentation/profiles/internal/midpoint_division.hpp"

#include <algorithm>
#include <map>

namespace isopatch::segmentation::planar {

using Eigen::Vector2d;

namespace {

/// A side's halves, at the parameter's middle.
std::pair<Side, Side> halves_of(const Side& side, int middle) {
  const double at = (side.low + side.high) / 2;
  Side first = side, second = side;
  first.to = second.from = middle;
  (side.reversed ? first.low : first.high) = at;
  (side.reversed ? second.high : second.low) = at;
  return {first, second};
}

}  // namespace

CellMesh midpoint_division(const std::vector<Curve>& curves, const CellMesh& mesh) {
  CellMesh result;
  result.nodes = mesh.nodes;
  std::map<SideKey, int> middles;
  const auto middle_of = [&](const Side& side) {
    const auto [entry, is_new] =
        middles.try_emplace(std::min(key_of(side), key_across(side)), static_cast<int>(result.nodes.size()));
    if (!is_new) return entry->second;
    const double at = (side.low + side.high) / 2;
    if (side.curve >= 0)
      result.nodes.push_back({curves[side.curve].at(at), false, side.curve, at >= 1 ? at - 1 : at});
    else
      result.nodes.push_back({(mesh.nodes[side.from].point + mesh.nodes[side.to].point) / 2, false, -1, 0});
    return entry->second;
  };
  for (const Cell& cell : mesh.cells) {
    std::array<std::pair<Side, Side>, 4> halves;
    Vector2d sum = Vector2d::Zero();
    for (int k = 0; k < cell.count; ++k) {
      const int middle = middle_of(cell.sides[k]);
      halves[k] = halves_of(cell.sides[k], middle);
      sum += result.nodes[middle].point;
    }
    const int centre = static_cast<int>(result.nodes.size());
    result.nodes.push_back({sum / cell.count, false, -1, 0});
    for (int k = 0; k < cell.count; ++k) {
      const Side &out = halves[k].first, &in = halves[(k + cell.count - 1) % cell.count].second;
      result.cells.push_back({cell.region, 4, {out, Side{out.to, centre}, Side{centre, in.from}, in}});
    }
  }
  return result;
}

}  // namespace isopatch::segmentation::planar
