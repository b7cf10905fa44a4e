#include "segmentation/reconstruction/internal/wireframe.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>

namespace isopatch::segmentation {
namespace {

using geometry::EdgeUse;
using geometry::TriangleSide;

// A curve of two smooth surfaces that turns by more in one vertex of the mesh has a corner there.
constexpr double corner_turn = 0.8;  // rad, 46 degrees

class WireMaker {
 public:
  WireMaker(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
            const Regions& regions)
      : mesh_(mesh),
        neighbours_(neighbours),
        regions_(regions),
        border_count_(static_cast<std::size_t>(mesh.vertices.cols()), 0),
        corner_(border_count_.size(), false),
        number_(border_count_.size(), -1),
        use_(3 * regions.of_triangle.size()) {}

  Wireframe make() {
    result_.loops.resize(regions_.regions.size());
    find_corners();
    for (const TriangleSide& side : borders_)
      if (corner_[static_cast<std::size_t>(from(side))]) add_edge(side);
    for (const TriangleSide& side : borders_)
      if (use(side).edge.value < 0) add_closed(side);
    for (const TriangleSide& side : borders_)
      if (!walked(side)) add_loop(side);
    return std::move(result_);
  }

 private:
  struct Use {
    EdgeUse use{EdgeId(-1), false};
    bool walked = false;
  };
  Use& slot(const TriangleSide& s) {
    return use_[3 * static_cast<std::size_t>(s.triangle) + static_cast<std::size_t>(s.side)];
  }
  EdgeUse& use(const TriangleSide& s) { return slot(s).use; }
  bool& walked(const TriangleSide& s) { return slot(s).walked; }
  int from(const TriangleSide& s) const { return mesh_.triangles(s.side, s.triangle); }
  int to(const TriangleSide& s) const { return mesh_.triangles((s.side + 1) % 3, s.triangle); }
  int region(const TriangleSide& s) const {
    return regions_.of_triangle[static_cast<std::size_t>(s.triangle)];
  }
  TriangleSide across(const TriangleSide& s) const {
    return neighbours_.across[static_cast<std::size_t>(s.triangle)][static_cast<std::size_t>(s.side)];
  }
  bool is_border(const TriangleSide& s) const { return region(s) != region(across(s)); }

  /// The next side of the region's border, around the side's end.
  TriangleSide next(const TriangleSide& s) const {
    TriangleSide at{s.triangle, (s.side + 1) % 3};
    while (!is_border(at)) {
      at = across(at);
      at.side = (at.side + 1) % 3;
    }
    return at;
  }

  void find_corners() {
    for (int t = 0; t < mesh_.triangles.cols(); ++t)
      for (int i = 0; i < 3; ++i)
        if (is_border({t, i})) {
          borders_.push_back({t, i});
          ++border_count_[static_cast<std::size_t>(from({t, i}))];
        }
    // Each border edge has a side in both triangles, so two edges at a vertex are two sides that begin there.
    for (const TriangleSide& side : borders_) {
      const auto v = static_cast<std::size_t>(to(side));
      corner_[v] = corner_[v] || border_count_[v] != 2 || turn(side, next(side)) > corner_turn;
    }
  }

  double turn(const TriangleSide& a, const TriangleSide& b) const {
    const Eigen::Vector3d first = mesh_.vertices.col(to(a)) - mesh_.vertices.col(from(a));
    const Eigen::Vector3d second = mesh_.vertices.col(to(b)) - mesh_.vertices.col(from(b));
    return std::atan2(first.cross(second).norm(), first.dot(second));
  }

  int vertex(int v, const TriangleSide& side) {
    int& number = number_[static_cast<std::size_t>(v)];
    if (number < 0) {
      number = static_cast<int>(result_.vertices.size());
      result_.vertices.emplace_back(mesh_.vertices.col(v));
      result_.regions_at.emplace_back();
    }
    auto& around = result_.regions_at[static_cast<std::size_t>(number)];
    for (const int r : {region(side), region(across(side))})
      if (std::find(around.begin(), around.end(), r) == around.end()) around.push_back(r);
    return number;
  }

  void add_edge(const TriangleSide& first) {
    if (use(first).edge.value >= 0) return;
    const auto id = EdgeId(static_cast<int>(result_.edges.size()));
    WireEdge edge;
    edge.regions = {region(first), region(across(first))};
    edge.start = vertex(from(first), first);
    edge.points.emplace_back(mesh_.vertices.col(from(first)));
    edge.of_mesh.push_back(from(first));
    TriangleSide side = first;
    for (;; side = next(side)) {
      use(side) = {id, false};
      use(across(side)) = {id, true};
      edge.points.emplace_back(mesh_.vertices.col(to(side)));
      edge.of_mesh.push_back(to(side));
      if (corner_[static_cast<std::size_t>(to(side))] || to(side) == from(first)) break;
    }
    edge.end = vertex(to(side), side);
    result_.edges.push_back(std::move(edge));
  }

  /// Closed edges of coaxial surfaces begin on one side of the axis, wherever that is.
  void add_closed(const TriangleSide& any) {
    const auto score = [&](const TriangleSide& s) {
      return mesh_.vertices.col(from(s)).dot(Eigen::Vector3d(1, 1e-2, 1e-4));
    };
    TriangleSide best = any;
    for (TriangleSide side = next(any); !(side == any); side = next(side))
      if (score(side) > score(best)) best = side;
    add_edge(best);
    result_.edges.back().free_start = true;
  }

  void add_loop(const TriangleSide& first) {
    std::vector<EdgeUse> loop;
    for (TriangleSide side = first;; side = next(side)) {
      walked(side) = true;
      if (loop.empty() || loop.back() != use(side) || starts(side)) loop.push_back(use(side));
      if (next(side) == first) break;
    }
    if (loop.size() > 1 && loop.front() == loop.back() && !starts(first)) loop.pop_back();
    result_.loops[static_cast<std::size_t>(region(first))].push_back(std::move(loop));
  }
  /// Whether an edge begins there, for edges that one loop walks from the same vertex twice.
  bool starts(const TriangleSide& side) const { return corner_[static_cast<std::size_t>(from(side))]; }

  const geometry::TriangleMesh& mesh_;
  const geometry::MeshNeighbours& neighbours_;
  const Regions& regions_;
  std::vector<TriangleSide> borders_;
  std::vector<int> border_count_;
  std::vector<bool> corner_;
  std::vector<int> number_;
  std::vector<Use> use_;
  Wireframe result_;
};

}  // namespace

Wireframe wireframe(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                    const Regions& regions) {
  return WireMaker(mesh, neighbours, regions).make();
}

namespace {

/// A list along a closed edge, as it is from a new place in its segment on.
template <class T>
void begin_at(std::vector<T>& list, std::size_t segment, const T& added) {
  list.pop_back();
  std::rotate(list.begin(), list.begin() + static_cast<std::ptrdiff_t>((segment + 1) % list.size()),
              list.end());
  list.insert(list.begin(), added);
  list.push_back(added);
}

/// What is after a new place in a segment, with it; the list ends there.
template <class T>
std::vector<T> cut_at(std::vector<T>& list, std::size_t segment, const T& added) {
  std::vector<T> rest(list.begin() + static_cast<std::ptrdiff_t>(segment) + 1, list.end());
  rest.insert(rest.begin(), added);
  list.resize(segment + 1);
  list.push_back(added);
  return rest;
}

}  // namespace

int split(Wireframe& wires, int number, std::size_t segment, const Eigen::Vector3d& point) {
  WireEdge& edge = wires.edges[static_cast<std::size_t>(number)];
  if (edge.free_start) {
    begin_at(edge.points, segment, point);
    begin_at(edge.of_mesh, segment, -1);
    edge.free_start = false;
    wires.vertices[static_cast<std::size_t>(edge.start)] = point;
    return edge.start;
  }
  const int vertex = static_cast<int>(wires.vertices.size()), added = static_cast<int>(wires.edges.size());
  wires.vertices.push_back(point);
  wires.regions_at.push_back({edge.regions[0], edge.regions[1]});
  WireEdge rest = edge;
  rest.start = vertex;
  rest.points = cut_at(edge.points, segment, point);
  rest.of_mesh = cut_at(edge.of_mesh, segment, -1);
  edge.end = vertex;
  for (const int region : std::set<int>{edge.regions[0], edge.regions[1]})
    for (auto& loop : wires.loops[static_cast<std::size_t>(region)])
      for (std::size_t i = 0; i < loop.size(); ++i) {
        if (loop[i].edge.value != number) continue;
        const bool reversed = loop[i].reversed;
        loop.insert(loop.begin() + static_cast<std::ptrdiff_t>(i) + (reversed ? 0 : 1),
                    EdgeUse{EdgeId(added), reversed});
        ++i;
      }
  wires.edges.push_back(std::move(rest));
  return vertex;
}

}  // namespace isopatch::segmentation
