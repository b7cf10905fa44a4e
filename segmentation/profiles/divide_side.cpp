#include "segmentation/profiles/divide_side.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "segmentation/profiles/internal/curve.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::EdgeUse;

/// Parts of an edge, in its direction.
struct Halves {
  int first, second, vertex;
};

class Divider {
 public:
  Divider(const Profile& profile, const Quadrangulation& quads)
      : curves_(planar::curves_of(profile)), quads_(quads) {
    made_.quads.vertices = quads.vertices;
    made_.quads.edges = quads.edges;
  }

  DividedQuads make(int edge, double share) {
    follow(edge, share);
    for (const auto& [number, at] : shares_) divide_edge(number, at);
    for (std::size_t q = 0; q < quads_.quads.size(); ++q) divide_quad(static_cast<int>(q));
    drop_unused();
    return std::move(made_);
  }

 private:
  const QuadEdge& edge(int number) const { return quads_.edges[static_cast<std::size_t>(number)]; }
  const Eigen::Vector2d& vertex(int number) const {
    return made_.quads.vertices[static_cast<std::size_t>(number)];
  }
  static double along(const EdgeUse& use, double share) { return use.reversed ? 1 - share : share; }

  /// Finds all edges on the way, and where each is divided.
  void follow(int first, double share) {
    std::vector<std::vector<std::pair<std::size_t, std::size_t>>> at(quads_.edges.size());
    for (std::size_t q = 0; q < quads_.quads.size(); ++q)
      for (std::size_t k = 0; k < 4; ++k)
        at[static_cast<std::size_t>(quads_.quads[q].sides[k].edge.value)].emplace_back(q, k);
    shares_[first] = share;
    std::vector<int> open = {first};
    while (!open.empty()) {
      const int number = open.back();
      open.pop_back();
      for (const auto& [q, k] : at[static_cast<std::size_t>(number)]) {
        const auto& sides = quads_.quads[q].sides;
        const EdgeUse opposite = sides[(k + 2) % 4];
        const double there = along(opposite, 1 - along(sides[k], shares_.at(number)));
        if (shares_.try_emplace(opposite.edge.value, there).second) open.push_back(opposite.edge.value);
      }
    }
  }

  Eigen::Vector2d point(const QuadEdge& on, double share) const {
    if (on.profile_edge >= 0)
      return curves_[static_cast<std::size_t>(on.profile_edge)].at(on.low + share * (on.high - on.low));
    const Eigen::Vector2d start = vertex(on.start), end = vertex(on.end);
    if (!on.apex) return (1 - share) * start + share * end;
    return (1 - share) * (1 - share) * start + 2 * share * (1 - share) * *on.apex + share * share * end;
  }

  int add_vertex(const Eigen::Vector2d& at) {
    made_.quads.vertices.push_back(at);
    return static_cast<int>(made_.quads.vertices.size()) - 1;
  }
  int add_edge(const QuadEdge& made) {
    made_.quads.edges.push_back(made);
    return static_cast<int>(made_.quads.edges.size()) - 1;
  }

  void divide_edge(int number, double share) {
    const QuadEdge whole = edge(number);
    const int middle = add_vertex(point(whole, share));
    QuadEdge first = whole, second = whole;
    first.end = second.start = middle;
    first.high = second.low = whole.low + share * (whole.high - whole.low);
    if (whole.apex) {
      first.apex = (1 - share) * vertex(whole.start) + share * *whole.apex;
      second.apex = (1 - share) * *whole.apex + share * vertex(whole.end);
    }
    const int low = add_edge(first);
    halves_[number] = {low, add_edge(second), middle};
  }

  /// The transfinite map of a quadrilateral's sides; u runs along side 0, v along side 1.
  Eigen::Vector2d inside(const Quad& quad, double u, double v) const {
    const auto side = [&](std::size_t k, double share) {
      const EdgeUse& use = quad.sides[k];
      return point(edge(use.edge.value), along(use, share));
    };
    const Eigen::Vector2d a = side(0, 0), b = side(1, 0), c = side(2, 0), d = side(3, 0);
    return (1 - v) * side(0, u) + v * side(2, 1 - u) + (1 - u) * side(3, 1 - v) + u * side(1, v) -
           ((1 - u) * (1 - v) * a + u * (1 - v) * b + u * v * c + (1 - u) * v * d);
  }

  /// From vertex to vertex, over a point in its middle.
  int add_chord(int start, int end, const Eigen::Vector2d& middle) {
    QuadEdge made{start, end};
    const Eigen::Vector2d chord = (vertex(start) + vertex(end)) / 2;
    if ((middle - chord).norm() > 1e-6 * (vertex(end) - vertex(start)).norm()) made.apex = 2 * middle - chord;
    return add_edge(made);
  }

  EdgeUse half(const EdgeUse& use, bool second) const {
    const Halves& of = halves_.at(use.edge.value);
    return {EdgeId(second == use.reversed ? of.first : of.second), use.reversed};
  }

  void add_quad(const Quad& whole, int parent, const std::array<EdgeUse, 4>& sides) {
    made_.quads.quads.push_back({whole.region, sides});
    made_.parent.push_back(parent);
  }

  void divide_quad(int number) {
    Quad quad = quads_.quads[static_cast<std::size_t>(number)];
    const auto divided = [&](std::size_t k) { return halves_.contains(quad.sides[k].edge.value); };
    if (!divided(0) && !divided(1)) return add_quad(quad, number, quad.sides);
    if (!divided(0)) std::rotate(quad.sides.begin(), quad.sides.begin() + 1, quad.sides.end());
    const auto share = [&](std::size_t k) {
      return along(quad.sides[k], shares_.at(quad.sides[k].edge.value));
    };
    const auto middle = [&](std::size_t k) { return halves_.at(quad.sides[k].edge.value).vertex; };
    const double u = (share(0) + 1 - share(2)) / 2;
    if (!divided(1)) {
      const EdgeId chord(add_chord(middle(0), middle(2), inside(quad, u, 0.5)));
      add_quad(quad, number,
               {half(quad.sides[0], false), {chord, false}, half(quad.sides[2], true), quad.sides[3]});
      add_quad(quad, number,
               {half(quad.sides[0], true), quad.sides[1], half(quad.sides[2], false), {chord, true}});
      return;
    }
    const double v = (share(1) + 1 - share(3)) / 2;
    const int centre = add_vertex(inside(quad, u, v));
    std::array<EdgeId, 4> spokes = {EdgeId(0), EdgeId(0), EdgeId(0), EdgeId(0)};
    const std::array<Eigen::Vector2d, 4> halfway = {inside(quad, u, v / 2), inside(quad, (1 + u) / 2, v),
                                                    inside(quad, u, (1 + v) / 2), inside(quad, u / 2, v)};
    for (std::size_t k = 0; k < 4; ++k) spokes[k] = EdgeId(add_chord(centre, middle(k), halfway[k]));
    for (std::size_t k = 0; k < 4; ++k) {
      const std::size_t before = (k + 3) % 4;
      add_quad(quad, number,
               {half(quad.sides[k], false),
                {spokes[k], true},
                {spokes[before], false},
                half(quad.sides[before], true)});
    }
  }

  /// Edges that were divided.
  void drop_unused() {
    std::vector<int> renumbered(made_.quads.edges.size(), -1);
    std::vector<QuadEdge> kept;
    for (std::size_t e = 0; e < made_.quads.edges.size(); ++e) {
      if (halves_.contains(static_cast<int>(e))) continue;
      renumbered[e] = static_cast<int>(kept.size());
      kept.push_back(made_.quads.edges[e]);
    }
    made_.quads.edges = std::move(kept);
    for (Quad& quad : made_.quads.quads)
      for (EdgeUse& use : quad.sides) use.edge = EdgeId(renumbered[static_cast<std::size_t>(use.edge.value)]);
  }

  std::vector<planar::Curve> curves_;
  const Quadrangulation& quads_;
  std::map<int, double> shares_;
  std::map<int, Halves> halves_;
  DividedQuads made_;
};

}  // namespace

DividedQuads divide_side(const Profile& profile, const Quadrangulation& quads, int edge, double share) {
  return Divider(profile, quads).make(edge, share);
}

}  // namespace isopatch::segmentation
