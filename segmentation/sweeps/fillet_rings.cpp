#include "segmentation/sweeps/internal/fillet_rings.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include "geometry/base/error.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::EdgeUse;

/// A corner of a quadrilateral: between its side k and the one before.
using QuadCorner = std::pair<std::size_t, std::size_t>;

class RingInserter {
 public:
  RingInserter(const Profile& profile, const Quadrangulation& quads, const std::vector<FilletPiece>& pieces,
               double tolerance)
      : profile_(profile), tolerance_(tolerance), given_(quads), corners_(quads.vertices.size()) {
    made_.quads = quads;
    for (const FilletPiece& piece : pieces) pieces_.emplace(piece.edge, &piece);
    for (std::size_t q = 0; q < quads.quads.size(); ++q)
      for (std::size_t k = 0; k < 4; ++k)
        corners_[static_cast<std::size_t>(from(quads.quads[q].sides[k]))].emplace_back(q, k);
  }

  FilletRings make() {
    for (const auto& [edge, piece] : pieces_) {
      add_foot(given(edge).start, piece->feet[0]);
      add_foot(given(edge).end, piece->feet[1]);
    }
    for (const auto& [vertex, foot] : feet_) move_corners(vertex);
    for (const auto& [edge, piece] : pieces_) add_ring(edge, *piece);
    return std::move(made_);
  }

 private:
  const QuadEdge& given(int number) const { return given_.edges[static_cast<std::size_t>(number)]; }
  QuadEdge& made(int number) { return made_.quads.edges[static_cast<std::size_t>(number)]; }
  int from(const EdgeUse& use) const {
    return use.reversed ? given(use.edge.value).end : given(use.edge.value).start;
  }
  const EdgeUse& side(const QuadCorner& corner, std::size_t further) const {
    return given_.quads[corner.first].sides[(corner.second + further) % 4];
  }

  [[noreturn]] void refuse(int vertex, const char* what) const {
    const Eigen::Vector2d& at = given_.vertices[static_cast<std::size_t>(vertex)];
    throw Error(ErrorCode::unsupported,
                fmt::format("the round at ({:.6g}, {:.6g}) m of its drawing {}", at.x(), at.y(), what));
  }

  void add_foot(int vertex, const Eigen::Vector2d& at) {
    const auto [known, fresh] = feet_.try_emplace(vertex, static_cast<int>(made_.quads.vertices.size()));
    if (fresh)
      made_.quads.vertices.push_back(at);
    else if ((made_.quads.vertices[static_cast<std::size_t>(known->second)] - at).norm() > tolerance_)
      refuse(vertex, "turns sharply");
  }

  /// Whether a quadrilateral is on the floor's side of one of its sides.
  bool is_on_floor(const EdgeUse& use) const { return pieces_.at(use.edge.value)->left != use.reversed; }

  /// Corners on the floor's side of the pieces that meet in a vertex go to its foot, with the edges between
  /// them.
  void move_corners(int vertex) {
    const auto& around = corners_[static_cast<std::size_t>(vertex)];
    std::set<QuadCorner> on_floor;
    std::set<int> edges;
    std::vector<QuadCorner> open;
    for (const QuadCorner& corner : around)
      for (const std::size_t k : {0, 3})
        if (const EdgeUse& use = side(corner, k); pieces_.contains(use.edge.value) && is_on_floor(use))
          open.push_back(corner);
    while (!open.empty()) {
      const QuadCorner corner = open.back();
      open.pop_back();
      if (!on_floor.insert(corner).second) continue;
      for (const std::size_t k : {0, 3}) {
        const EdgeUse& use = side(corner, k);
        if (pieces_.contains(use.edge.value)) {
          if (!is_on_floor(use)) refuse(vertex, "ends inside the drawing");
          continue;
        }
        edges.insert(use.edge.value);
        for (const QuadCorner& other : around)
          for (const std::size_t l : {0, 3})
            if (side(other, l).edge == use.edge) open.push_back(other);
      }
    }
    std::optional<int> outline;
    for (const int edge : edges)
      if (const auto cut = move_end(edge, vertex)) {
        if (outline) refuse(vertex, "has two ends at one place");
        outline = *cut;
      }
    made_.radials[vertex] = outline ? *outline : add_edge({vertex, feet_.at(vertex)});
  }

  int add_edge(const QuadEdge& edge) {
    made_.quads.edges.push_back(edge);
    return static_cast<int>(made_.quads.edges.size()) - 1;
  }

  /// @return  what was cut off an outline
  std::optional<int> move_end(int edge, int vertex) {
    const QuadEdge whole = made(edge);
    const bool at_start = whole.start == vertex;
    const int foot = feet_.at(vertex);
    (at_start ? made(edge).start : made(edge).end) = foot;
    if (whole.profile_edge < 0) return std::nullopt;
    const ProfileEdge& outline = profile_.edges[static_cast<std::size_t>(whole.profile_edge)];
    const Eigen::Vector2d along = outline.points.back() - outline.points.front(),
                          to_foot =
                              made_.quads.vertices[static_cast<std::size_t>(foot)] - outline.points.front();
    const double at = to_foot.dot(along) / along.squaredNorm();
    if (outline.points.size() != 2 || (to_foot - at * along).norm() > tolerance_)
      refuse(vertex, "meets another outline");
    if (at <= whole.low || at >= whole.high) refuse(vertex, "is wider than the floor");
    QuadEdge cut = whole;
    (at_start ? cut.end : cut.start) = foot;
    (at_start ? cut.high : cut.low) = at;
    (at_start ? made(edge).low : made(edge).high) = at;
    return add_edge(cut);
  }

  EdgeUse radial(int vertex) {
    const int edge = made_.radials.at(vertex);
    return {EdgeId(edge), made(edge).start != vertex};
  }

  void add_ring(int edge, const FilletPiece& piece) {
    QuadEdge beside = given(edge);
    const int start = beside.start, end = beside.end;
    beside.start = feet_.at(start);
    beside.end = feet_.at(end);
    const int far = add_edge(beside);
    made_.offsets[far] = piece.left ? piece.width : -piece.width;
    std::optional<int> region;
    for (std::size_t q = 0; q < given_.quads.size(); ++q)
      for (std::size_t k = 0; k < 4; ++k)
        if (const EdgeUse& use = given_.quads[q].sides[k]; use.edge.value == edge && is_on_floor(use)) {
          made_.quads.quads[q].sides[k].edge = EdgeId(far);
          region = given_.quads[q].region;
        }
    if (!region) refuse(start, "has no floor beside it");
    const int first = piece.left ? start : end, second = piece.left ? end : start;
    const EdgeUse across = radial(second), back = radial(first);
    made_.rings[edge] = static_cast<int>(made_.quads.quads.size());
    made_.quads.quads.push_back({*region,
                                 {EdgeUse{EdgeId(edge), !piece.left}, across,
                                  EdgeUse{EdgeId(far), piece.left}, EdgeUse{back.edge, !back.reversed}}});
  }

  const Profile& profile_;
  double tolerance_;
  const Quadrangulation& given_;
  std::map<int, const FilletPiece*> pieces_;      // by edge
  std::vector<std::vector<QuadCorner>> corners_;  // by vertex
  std::map<int, int> feet_;                       // by vertex
  FilletRings made_;
};

}  // namespace

FilletRings fillet_rings(const Profile& profile, const Quadrangulation& quads,
                         const std::vector<FilletPiece>& pieces, double tolerance) {
  return RingInserter(profile, quads, pieces, tolerance).make();
}

}  // namespace isopatch::segmentation
