#include "segmentation/profiles/settled.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "segmentation/profiles/internal/cell_shape.hpp"

namespace isopatch::segmentation {
namespace {

using Eigen::Vector2d;
using planar::Node;
using planar::Side;

/// What is one drawing's own.
struct Drawn {
  std::vector<planar::Curve> curves;
  std::vector<Node> nodes;
  std::vector<Vector2d> shifts;  ///< of vertices inside, from where they are in the first drawing
};

class Settling {
 public:
  Settling(const Quadrangulation& quads, const std::vector<Profile>& drawings,
           const std::vector<double>& upright)
      : rules_(even_rules()) {
    enter_sides(quads);
    for (const std::array<Side, 4>& cell : cells_) {
      double least = 1;
      for (const Side& side : cell) least = std::min(least, upright[static_cast<std::size_t>(side.from)]);
      upright_.push_back(least);
    }
    for (const Profile& profile : drawings) {
      Drawn drawn{planar::curves_of(profile), {}, {}};
      for (std::size_t v = 0; v < quads.vertices.size(); ++v) {
        const bool given = v < profile.vertices.size();
        drawn.nodes.push_back({given ? profile.vertices[v] : quads.vertices[v], given, -1, 0});
      }
      drawings_.push_back(std::move(drawn));
    }
    for (const QuadEdge& edge : quads.edges) {
      if (edge.profile_edge < 0) continue;
      enter_cut(edge.start, edge.profile_edge, edge.low);
      enter_cut(edge.end, edge.profile_edge, edge.high);
    }
    enter_neighbours(quads);
    follow();
  }

  /// Moves every vertex once, by steps of a share of its shortest side.
  void move_all(double share) {
    for (std::size_t v = 0; v < sides_at_.size(); ++v)
      if (!first().nodes[v].given && !cells_at_[v].empty()) move(static_cast<int>(v), share);
    follow();
  }

  /// Of all quadrilaterals in all drawings.
  double cost() const {
    double sum = 0;
    for (std::size_t q = 0; q < cells_.size(); ++q) sum += cost_of_cell(static_cast<int>(q));
    return sum;
  }

  Quadrangulation result(Quadrangulation quads) const {
    for (std::size_t v = 0; v < quads.vertices.size(); ++v) quads.vertices[v] = first().nodes[v].point;
    for (std::size_t q = 0; q < quads.quads.size(); ++q)
      for (std::size_t k = 0; k < 4; ++k) {
        const Side& side = cells_[q][k];
        QuadEdge& edge = quads.edges[static_cast<std::size_t>(quads.quads[q].sides[k].edge.value)];
        edge.low = side.low;
        edge.high = side.high;
      }
    return quads;
  }

 private:
  /// The same in every direction.
  static planar::ShapeRules even_rules() {
    QuadrangulationOptions options;
    options.slant_weight = 0;
    return planar::ShapeRules(options);
  }

  void enter_sides(const Quadrangulation& quads) {
    cells_at_.resize(quads.vertices.size());
    sides_at_.resize(quads.vertices.size());
    for (std::size_t q = 0; q < quads.quads.size(); ++q) {
      std::array<Side, 4> cell;
      for (std::size_t k = 0; k < 4; ++k) {
        const geometry::EdgeUse& use = quads.quads[q].sides[k];
        const QuadEdge& edge = quads.edges[static_cast<std::size_t>(use.edge.value)];
        cell[k] = {edge.start, edge.end, edge.profile_edge, edge.low, edge.high, use.reversed};
        if (use.reversed) std::swap(cell[k].from, cell[k].to);
        cells_at_[static_cast<std::size_t>(cell[k].from)].push_back(static_cast<int>(q));
        for (const int end : {edge.start, edge.end})
          sides_at_[static_cast<std::size_t>(end)].push_back({static_cast<int>(q), k});
      }
      cells_.push_back(cell);
    }
  }

  void enter_cut(int vertex, int curve, double at) {
    for (Drawn& drawn : drawings_) {
      Node& node = drawn.nodes[static_cast<std::size_t>(vertex)];
      if (node.given) return;
      const planar::Curve& along = drawn.curves[static_cast<std::size_t>(curve)];
      node.curve = curve;
      node.at = along.closed() ? at - std::floor(at) : at;
      node.point = along.at(node.at);
    }
  }

  void enter_neighbours(const Quadrangulation& quads) {
    neighbours_.resize(quads.vertices.size());
    for (const QuadEdge& edge : quads.edges)
      for (const auto& [end, other] : {std::pair(edge.start, edge.end), std::pair(edge.end, edge.start)})
        if (first().nodes[static_cast<std::size_t>(end)].is_inside())
          neighbours_[static_cast<std::size_t>(end)].push_back(other);
  }

  /// Puts vertices inside where the mean of their neighbours takes them.
  void follow() {
    constexpr int sweeps = 200;
    for (Drawn& drawn : drawings_) {
      if (&drawn == &drawings_.front()) continue;
      drawn.shifts.resize(drawn.nodes.size(), Vector2d::Zero());
      for (std::size_t v = 0; v < drawn.nodes.size(); ++v)
        if (!drawn.nodes[v].is_inside()) drawn.shifts[v] = drawn.nodes[v].point - first().nodes[v].point;
      for (int i = 0; i < sweeps; ++i)
        for (std::size_t v = 0; v < drawn.nodes.size(); ++v) {
          if (neighbours_[v].empty()) continue;
          Vector2d sum = Vector2d::Zero();
          for (const int other : neighbours_[v]) sum += drawn.shifts[static_cast<std::size_t>(other)];
          drawn.shifts[v] = sum / static_cast<double>(neighbours_[v].size());
        }
      for (std::size_t v = 0; v < drawn.nodes.size(); ++v)
        if (drawn.nodes[v].is_inside()) drawn.nodes[v].point = first().nodes[v].point + drawn.shifts[v];
    }
  }

  /// The cost of a quadrilateral, which grows steeply where its Jacobian is small (0.9 at 0.2, 0.02 at 0.4);
  /// to that comes a tenth of the cost by which divisions are chosen, so that good shapes are told apart as
  /// well.
  double cost_of_cell(int number) const {
    constexpr double weight = 50, steepness = 20, share_of_shape = 0.1;
    double sum = 0;
    for (const Drawn& drawn : drawings_) {
      std::array<planar::SideShape, 4> shapes;
      for (std::size_t k = 0; k < 4; ++k)
        shapes[k] = side_shape(drawn.curves, drawn.nodes, cells_[static_cast<std::size_t>(number)][k]);
      const std::array<const planar::SideShape*, 4> sides = {&shapes[0], &shapes[1], &shapes[2], &shapes[3]};
      sum +=
          share_of_shape * bounded_cost_of(rules_, sides, 4) + cost_of_slenderness(sides) +
          weight * std::exp(-steepness * upright_[static_cast<std::size_t>(number)] * least_jacobian(sides));
    }
    return sum;
  }

  /// Needles take solvers many iterations, since all knots of what meets them run along them: one of 1 by 10
  /// costs 0.1, one of 1 by 100 0.4.
  static double cost_of_slenderness(const std::array<const planar::SideShape*, 4>& sides) {
    constexpr double weight = 0.02;
    const double ratio = std::log(planar::slenderness(sides));
    return weight * ratio * ratio;
  }

  double cost_at(int vertex) const {
    double sum = 0;
    for (const int cell : cells_at_[static_cast<std::size_t>(vertex)]) sum += cost_of_cell(cell);
    return sum;
  }

  /// The shortest side, in the plane or along the curve.
  double reach(int vertex) const {
    double result = planar::refused;
    const Node& node = first().nodes[static_cast<std::size_t>(vertex)];
    for (const auto& [cell, k] : sides_at_[static_cast<std::size_t>(vertex)]) {
      const Side& side = cells_[static_cast<std::size_t>(cell)][k];
      if (!node.is_cut())
        result = std::min(result, (first().nodes[static_cast<std::size_t>(side.from)].point -
                                   first().nodes[static_cast<std::size_t>(side.to)].point)
                                      .norm());
      else if (side.curve >= 0)
        result = std::min(result, side.high - side.low);
    }
    return result;
  }

  void step(int vertex, const Vector2d& by) {
    const auto v = static_cast<std::size_t>(vertex);
    for (Drawn& drawn : drawings_) {
      Node& node = drawn.nodes[v];
      if (!node.is_cut()) {
        node.point += by;
        continue;
      }
      const planar::Curve& along = drawn.curves[static_cast<std::size_t>(node.curve)];
      node.at += by.x();
      if (along.closed()) node.at -= std::floor(node.at);
      node.point = along.at(node.at);
    }
    if (!first().nodes[v].is_cut()) return;
    for (const auto& [cell, k] : sides_at_[v]) {
      Side& side = cells_[static_cast<std::size_t>(cell)][k];
      if (side.curve < 0) continue;
      if (side.from == vertex) (side.reversed ? side.high : side.low) += by.x();
      if (side.to == vertex) (side.reversed ? side.low : side.high) += by.x();
    }
  }

  /// Tries steps in a few directions.
  void move(int vertex, double share) {
    double best = cost_at(vertex);
    const bool is_cut = first().nodes[static_cast<std::size_t>(vertex)].is_cut();
    const std::vector<Vector2d> directions = is_cut ? std::vector<Vector2d>{{1, 0}, {-1, 0}}
                                                    : std::vector<Vector2d>{{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const double length = share * reach(vertex);
    for (const Vector2d& direction : directions)
      for (int again = 0; again < 3; ++again) {
        step(vertex, length * direction);
        const double cost = cost_at(vertex);
        if (cost < best - 1e-12) {
          best = cost;
          continue;
        }
        step(vertex, -length * direction);
        break;
      }
  }

  const Drawn& first() const { return drawings_.front(); }

  planar::ShapeRules rules_;
  std::vector<double> upright_;  // by quadrilateral
  std::vector<std::array<Side, 4>> cells_;
  std::vector<std::vector<int>> cells_at_;                          // by vertex
  std::vector<std::vector<std::pair<int, std::size_t>>> sides_at_;  // likewise, cell and place
  std::vector<std::vector<int>> neighbours_;                        // of vertices inside
  std::vector<Drawn> drawings_;
};

}  // namespace

Quadrangulation settled(const Quadrangulation& quads, const std::vector<Profile>& drawings,
                        const std::vector<double>& upright) {
  for (const QuadEdge& edge : quads.edges)
    if (edge.apex) return quads;
  Settling settling(quads, drawings, upright);
  constexpr double most = 0.2, least = 0.001;  // of the shortest side, in a step
  constexpr int rounds = 300;
  double share = most;
  for (int round = 0; round < rounds && share > least; ++round) {
    const double before = settling.cost();
    settling.move_all(share);
    if (before - settling.cost() < 1e-3 * before) share /= 2;
  }
  return settling.result(quads);
}

}  // namespace isopatch::segmentation
