#include "segmentation/profiles/internal/relax.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace isopatch::segmentation::planar {

using Eigen::Vector2d;

namespace {

/// One node with the cells around it.
class MovedNode {
 public:
  MovedNode(const ShapeRules& rules, const std::vector<Curve>& curves, CellMesh& mesh,
            const Neighbours& neighbours, int node)
      : rules_(rules), curves_(curves), mesh_(mesh), node_(node), cells_(neighbours.around(node)) {
    std::sort(cells_.begin(), cells_.end());
    cells_.erase(std::unique(cells_.begin(), cells_.end()), cells_.end());
    shapes_.resize(cells_.size());
    for (std::size_t c = 0; c < cells_.size(); ++c)
      for (int k = 0; k < mesh_.cells[cells_[c]].count; ++k)
        shapes_[c][k] = side_shape(curves_, mesh_.nodes, mesh_.cells[cells_[c]].sides[k]);
  }

  double cost() {
    double sum = 0;
    for (std::size_t c = 0; c < cells_.size(); ++c) {
      const Cell& cell = mesh_.cells[cells_[c]];
      std::array<const SideShape*, 4> sides = {};
      for (int k = 0; k < cell.count; ++k) {
        const Side& side = cell.sides[k];  // those that do not move are known
        if (side.from == node_ || side.to == node_) shapes_[c][k] = side_shape(curves_, mesh_.nodes, side);
        sides[k] = &shapes_[c][k];
      }
      sum += bounded_cost_of(rules_, sides, cell.count);
    }
    return sum;
  }

  /// The shortest side, in the plane or along the curve.
  double reach() const {
    double result = refused;
    const bool cut = mesh_.nodes[node_].is_cut();
    for (const int cell : cells_)
      for (int k = 0; k < mesh_.cells[cell].count; ++k) {
        const Side& side = mesh_.cells[cell].sides[k];
        if (side.from != node_ && side.to != node_) continue;
        if (cut && side.curve >= 0) result = std::min(result, side.high - side.low);
        if (!cut)
          result = std::min(result, (mesh_.nodes[side.from].point - mesh_.nodes[side.to].point).norm());
      }
    return result;
  }

  bool is_cut() const { return mesh_.nodes[node_].is_cut(); }

  void move(const Vector2d& by) {
    Node& node = mesh_.nodes[node_];
    if (!node.is_cut()) {
      node.point += by;
      return;
    }
    const double step = by.x();
    node.at += step;
    if (curves_[node.curve].closed()) node.at -= std::floor(node.at);
    node.point = curves_[node.curve].at(node.at);
    for (const int cell : cells_)
      for (int k = 0; k < mesh_.cells[cell].count; ++k) {
        Side& side = mesh_.cells[cell].sides[k];
        if (side.curve < 0) continue;
        if (side.from == node_) (side.reversed ? side.high : side.low) += step;
        if (side.to == node_) (side.reversed ? side.low : side.high) += step;
      }
  }

 private:
  const ShapeRules& rules_;
  const std::vector<Curve>& curves_;
  CellMesh& mesh_;
  int node_;
  std::vector<int> cells_;
  std::vector<std::array<SideShape, 4>> shapes_;
};

/// Tries steps of a length in a few directions, longer ones after success.
double settle(MovedNode& node, double length) {
  const double before = node.cost();
  double best = before;
  const std::vector<Vector2d> directions = node.is_cut()
                                               ? std::vector<Vector2d>{{1, 0}, {-1, 0}}
                                               : std::vector<Vector2d>{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
  for (int halving = 0; halving < 3; ++halving, length /= 3)
    for (const Vector2d& direction : directions)
      for (int step = 0; step < 3; ++step) {
        node.move(length * direction);
        const double cost = node.cost();
        if (cost < best - 1e-12) {
          best = cost;
          continue;
        }
        node.move(-length * direction);
        break;
      }
  return before - best;
}

}  // namespace

double relax(const ShapeRules& rules, const std::vector<Curve>& curves, CellMesh& mesh,
             const Neighbours& neighbours, const std::vector<int>& nodes, int rounds) {
  double gained = 0, share = 0.2;
  for (int round = 0; round < rounds; ++round, share *= 0.6) {
    double now = 0;
    for (const int number : nodes) {
      if (mesh.nodes[number].given || neighbours.around(number).empty()) continue;
      MovedNode node(rules, curves, mesh, neighbours, number);
      now += settle(node, share * node.reach());
    }
    gained += now;
    if (now < 1e-7) break;
  }
  return gained;
}

}  // namespace isopatch::segmentation::planar
