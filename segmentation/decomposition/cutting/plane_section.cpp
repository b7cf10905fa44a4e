#include "segmentation/decomposition/cutting/plane_section.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "segmentation/decomposition/cutting/inside.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::PlaneSurface;

/// A straight piece of the section from one place to another.
struct Piece {
  int from = 0, to = 0;
  LoopStep step;
};

/// Where a plane meets the sides of a cell: places, and what joins them.
class Section {
 public:
  Section(const CellShapes& shapes, const CellSides& sides, const PlaneSurface& plane, double same_point)
      : shapes_(shapes), sides_(sides), plane_(plane), same_point_(same_point) {
    for (const VertexId vertex : sides.vertices)
      height_.push_back((shapes.complex().vertex(vertex) - plane.origin).dot(plane.normal()));
    add_places();
    for (std::size_t f = 0; f < sides.graph.faces.size(); ++f) add_pieces(f);
  }

  /// The loop around the part of the plane to the left of an edge, walked from `from`.
  std::optional<SpacedLoop> loop_at(EdgeId edge, VertexId from) const {
    const CellGraph::Edge& ends = sides_.graph.edge(edge);
    return loop_from({place_.at(LoopPlace::at(from)),
                      place_.at(LoopPlace::at(ends.start == from ? ends.end : ends.start)),
                      LoopStep::along(edge)});
  }

  /// The loop around the part of the plane to the left of the line across a side that a point lies on, where
  /// the line is walked along a direction.
  std::optional<SpacedLoop> loop_at(FaceId side, const Eigen::Vector3d& point,
                                    const Eigen::Vector3d& along) const {
    for (const auto& [place, pieces] : from_)
      for (const Piece& piece : pieces) {
        const Eigen::Vector3d &from = points_[static_cast<std::size_t>(piece.from)],
                              &to = points_[static_cast<std::size_t>(piece.to)];
        if (piece.step.face == side && (to - from).dot(along) > 0 &&
            (point - from).norm() + (to - point).norm() <= (to - from).norm() + 10 * same_point_)
          return loop_from(piece);
      }
    return std::nullopt;
  }

 private:
  std::optional<SpacedLoop> loop_from(Piece piece) const {
    if (several_) return std::nullopt;
    const Piece first = piece;
    SpacedLoop result;
    std::set<int> passed;
    do {
      if (!passed.insert(piece.from).second) return std::nullopt;
      result.loop.places.push_back(places_[static_cast<std::size_t>(piece.from)]);
      result.places.push_back(points_[static_cast<std::size_t>(piece.from)]);
      result.loop.steps.push_back(piece.step);
      const auto next = leftmost_after(piece);
      if (!next) return std::nullopt;
      piece = *next;
    } while (piece.from != first.from || piece.to != first.to);
    if (result.loop.length() < 3) return std::nullopt;
    return result;
  }

  bool is_on(VertexId vertex) const {
    return std::abs(height_[static_cast<std::size_t>(vertex.value)]) <= same_point_;
  }
  Eigen::Vector3d corner(VertexId vertex) const {
    return shapes_.complex().vertex(sides_.vertices[static_cast<std::size_t>(vertex.value)]);
  }
  Eigen::Vector2d flat(int place) const {
    return plane_.domain_point(points_[static_cast<std::size_t>(place)]);
  }

  void add_place(LoopPlace place, const Eigen::Vector3d& point) {
    place_[place] = static_cast<int>(places_.size());
    places_.push_back(place);
    points_.push_back(point);
  }

  void add_places() {
    for (int v = 0; v < sides_.graph.vertex_count; ++v)
      if (is_on(VertexId(v))) add_place(LoopPlace::at(VertexId(v)), corner(VertexId(v)));
    for (std::size_t e = 0; e < sides_.graph.edges.size(); ++e) {
      const CellGraph::Edge& edge = sides_.graph.edges[e];
      if (!is_straight(e)) {
        add_places_on_curve(e);
        continue;
      }
      if (is_on(edge.start) || is_on(edge.end)) continue;
      const double a = height_[static_cast<std::size_t>(edge.start.value)],
                   b = height_[static_cast<std::size_t>(edge.end.value)];
      if (a * b > 0) continue;
      const Eigen::Vector3d at = corner(edge.start) + a / (a - b) * (corner(edge.end) - corner(edge.start));
      add_place(LoopPlace::inside(EdgeId(static_cast<int>(e))), at);
    }
  }

  bool is_straight(std::size_t edge) const {
    const auto& chain = sides_.edges[edge];
    return std::all_of(chain.begin(), chain.end(),
                       [&](const auto& use) { return shapes_.is_straight(use.edge); });
  }

  double height_of(const Eigen::Vector3d& point) const {
    return (point - plane_.origin).dot(plane_.normal());
  }

  /// Where a curved edge passes through the plane; that it lies in the plane is remembered.
  void add_places_on_curve(std::size_t e) {
    const EdgeId id(static_cast<int>(e));
    bool all_on = true;
    int crossings = 0;
    for (const geometry::EdgeUse& use : sides_.edges[e]) {
      constexpr int samples = 24;
      const auto height = [&](double t) { return height_of(shapes_.point(use.edge, t)); };
      for (int i = 0; i < samples; ++i) {
        double low = double(i) / samples, high = double(i + 1) / samples;
        all_on = all_on && std::abs(height(low)) <= same_point_ && std::abs(height(high)) <= same_point_;
        if (std::abs(height(low)) <= same_point_ || std::abs(height(high)) <= same_point_ ||
            height(low) * height(high) > 0)
          continue;
        ++crossings;
        const bool rises = height(low) < 0;
        for (int k = 0; k < 60; ++k) {
          const double middle = (low + high) / 2;
          ((height(middle) < 0) == rises ? low : high) = middle;
        }
        if (crossings == 1) add_place(LoopPlace::inside(id), shapes_.point(use.edge, low));
      }
    }
    if (all_on) in_plane_.insert(id);
    if (crossings > 1) several_ = true;
  }

  bool lies_in_plane(EdgeId id) const {
    const CellGraph::Edge& edge = sides_.graph.edge(id);
    return is_on(edge.start) && is_on(edge.end) &&
           (is_straight(static_cast<std::size_t>(id.value)) || in_plane_.contains(id));
  }

  bool is_plane(std::size_t side) const {
    return shapes_.is_plane(shapes_.complex().face(sides_.faces[side].front().face).surface);
  }

  void add_piece(int a, int b, LoopStep step) {
    from_[a].push_back({a, b, step});
    from_[b].push_back({b, a, step});
  }

  /// What the plane has of one side: the edges that lie in it, and the stretches inside it.
  void add_pieces(std::size_t f) {
    const CellGraph::Corners& corners = sides_.graph.faces[f];
    std::vector<int> on;
    bool all_on = true;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const VertexId from = corners[k], to = corners[(k + 1) % corners.size()];
      all_on = all_on && is_on(from);
      const EdgeId edge = *edge_between(sides_.graph, from, to);
      if (is_on(from)) on.push_back(place_.at(LoopPlace::at(from)));
      if (const auto inside = place_.find(LoopPlace::inside(edge)); inside != place_.end())
        on.push_back(inside->second);
      if (lies_in_plane(edge) && known_.insert(edge).second)
        add_piece(place_.at(LoopPlace::at(from)), place_.at(LoopPlace::at(to)), LoopStep::along(edge));
    }
    if (on.size() < 2) return;
    if (!is_plane(f)) {
      if (on.size() == 2 && !joined_by_edge(on[0], on[1]))
        add_piece(on[0], on[1], LoopStep::across(FaceId(static_cast<int>(f))));
      return;
    }
    if (all_on) return;
    const auto farthest = std::max_element(on.begin(), on.end(), [&](int a, int b) {
      return (flat(a) - flat(on[0])).norm() < (flat(b) - flat(on[0])).norm();
    });
    const Eigen::Vector2d along = flat(*farthest) - flat(on[0]);
    std::sort(on.begin(), on.end(), [&](int a, int b) { return flat(a).dot(along) < flat(b).dot(along); });
    on.erase(std::unique(on.begin(), on.end()), on.end());
    for (std::size_t i = 0; i + 1 < on.size(); ++i)
      if (!joined_by_edge(on[i], on[i + 1]) && lies_inside(corners, on[i], on[i + 1]))
        add_piece(on[i], on[i + 1], LoopStep::across(FaceId(static_cast<int>(f))));
  }

  bool joined_by_edge(int a, int b) const {
    const LoopPlace from = places_[static_cast<std::size_t>(a)], to = places_[static_cast<std::size_t>(b)];
    if (from.auxiliary() || to.auxiliary()) return false;
    const auto edge = edge_between(sides_.graph, from.vertex, to.vertex);
    return edge && lies_in_plane(*edge);
  }

  /// From the first vertex of an edge, in the sense asked for, up to but without the last.
  std::vector<Eigen::Vector3d> points_along(EdgeId edge, bool forwards) const {
    std::vector<Eigen::Vector3d> result;
    for (const geometry::EdgeUse& use : sides_.edges[static_cast<std::size_t>(edge.value)]) {
      const int pieces = shapes_.is_straight(use.edge) ? 1 : 16;
      for (int i = 0; i <= pieces; ++i) {
        const double t = double(i) / pieces;
        result.push_back(shapes_.point(use.edge, use.reversed ? 1 - t : t));
      }
    }
    if (!forwards) std::reverse(result.begin(), result.end());
    result.pop_back();
    return result;
  }

  /// Whether the middle between two places lies in a side.
  bool lies_inside(const CellGraph::Corners& corners, int a, int b) const {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (std::size_t k = 1; k + 1 < corners.size(); ++k)
      normal += (corner(corners[k]) - corner(corners[0])).cross(corner(corners[k + 1]) - corner(corners[0]));
    PlaneSurface side;
    side.origin = corner(corners[0]);
    side.x = normal.unitOrthogonal();
    side.y = normal.normalized().cross(side.x);
    std::vector<Eigen::Vector2d> around;
    for (std::size_t k = 0; k < corners.size(); ++k) {
      const EdgeId edge = *edge_between(sides_.graph, corners[k], corners[(k + 1) % corners.size()]);
      const bool forwards = sides_.graph.edge(edge).start == corners[k];
      const std::vector<Eigen::Vector3d> points = points_along(edge, forwards);
      for (const Eigen::Vector3d& point : points) around.push_back(side.domain_point(point));
    }
    Eigen::Matrix2Xd polygon(2, static_cast<Eigen::Index>(around.size()));
    for (std::size_t k = 0; k < around.size(); ++k) polygon.col(static_cast<Eigen::Index>(k)) = around[k];
    const Eigen::Vector3d middle =
        (points_[static_cast<std::size_t>(a)] + points_[static_cast<std::size_t>(b)]) / 2;
    return is_inside(polygon, side.domain_point(middle));
  }

  /// The next piece around the region to the left of one.
  std::optional<Piece> leftmost_after(const Piece& piece) const {
    const Eigen::Vector2d back = flat(piece.from) - flat(piece.to);
    std::optional<Piece> best;
    double least = 1e9;
    for (const Piece& next : from_.at(piece.to)) {
      if (next.to == piece.from) continue;
      const Eigen::Vector2d ahead = flat(next.to) - flat(next.from);
      // Clockwise from where we come from.
      double angle = -std::atan2(back.x() * ahead.y() - back.y() * ahead.x(), back.dot(ahead));
      if (angle < 0) angle += 2 * std::numbers::pi;
      if (angle < least) least = angle, best = next;
    }
    return best;
  }

  const CellShapes& shapes_;
  const CellSides& sides_;
  PlaneSurface plane_;
  double same_point_;
  std::vector<double> height_;
  std::vector<LoopPlace> places_;
  std::vector<Eigen::Vector3d> points_;
  std::map<LoopPlace, int> place_;
  std::map<int, std::vector<Piece>> from_;
  std::set<EdgeId> known_, in_plane_;
  bool several_ = false;  // crossings of one edge
};

/// The outward normal of a side, from its corners.
Eigen::Vector3d outward(const CellShapes& shapes, const CellSides& sides, FaceId side) {
  const geometry::CellFaceUse use = sides.faces[static_cast<std::size_t>(side.value)].front();
  const EdgeId edge = shapes.complex().face(use.face).loop.front().edge;
  const Eigen::Vector3d front = shapes.normal(use.face, shapes.domain_point(use.face, edge, 0.5));
  return use.reversed ? Eigen::Vector3d(-front) : front;
}

/// Marks the steps along which the plane continues a side that lies in it.
void mark_extensions(const CellShapes& shapes, const CellSides& sides, const Eigen::Vector3d& normal,
                     CuttingLoop& loop) {
  std::optional<CellIncidence> incidence;  // dear, and seldom needed
  for (std::size_t k = 0; k < loop.steps.size(); ++k) {
    LoopStep& step = loop.steps[k];
    if (step.auxiliary() || sides.graph.edge(step.edge).kind == EdgeKind::convex) continue;
    if (!incidence) incidence.emplace(sides.graph);
    const bool forwards = loop.places[k].vertex == sides.graph.edge(step.edge).start;
    const FaceId left = forwards ? incidence->left(step.edge) : incidence->right(step.edge);
    const FaceId right = forwards ? incidence->right(step.edge) : incidence->left(step.edge);
    const auto in_plane = [&](FaceId side) {
      const FaceId face = sides.faces[static_cast<std::size_t>(side.value)].front().face;
      return shapes.is_plane(shapes.complex().face(face).surface) &&
             outward(shapes, sides, side).cross(normal).norm() < 1e-6;
    };
    if (in_plane(left))
      step.extension = Extension::left;
    else if (in_plane(right))
      step.extension = Extension::right;
  }
}

}  // namespace

std::optional<SpacedLoop> plane_section(const CellShapes& shapes, const CellSides& sides, EdgeId edge,
                                        const Eigen::Vector3d& normal, const Eigen::Vector3d& into,
                                        double same_point) {
  const CellGraph::Edge& ends = sides.graph.edge(edge);
  const auto corner = [&](VertexId v) {
    return shapes.complex().vertex(sides.vertices[static_cast<std::size_t>(v.value)]);
  };
  PlaneSurface plane;
  plane.origin = corner(ends.start);
  plane.x = (corner(ends.end) - plane.origin).normalized();
  plane.y = normal.normalized().cross(plane.x);
  const bool left = plane.y.dot(into) > 0;
  auto result = Section(shapes, sides, plane, same_point).loop_at(edge, left ? ends.start : ends.end);
  if (result) mark_extensions(shapes, sides, plane.normal(), result->loop);
  return result;
}

std::optional<SpacedLoop> plane_section(const CellShapes& shapes, const CellSides& sides, FaceId side,
                                        const Eigen::Vector3d& point, const Eigen::Vector3d& along,
                                        const Eigen::Vector3d& normal, double same_point) {
  PlaneSurface plane;
  plane.origin = point;
  plane.x = along.normalized();
  plane.y = normal.normalized().cross(plane.x);
  const bool left = plane.y.dot(outward(shapes, sides, side)) < 0;
  auto result =
      Section(shapes, sides, plane, same_point).loop_at(side, point, left ? along : Eigen::Vector3d(-along));
  if (result) mark_extensions(shapes, sides, plane.normal(), result->loop);
  return result;
}

std::vector<SpacedLoop> plane_sections(const CellShapes& shapes, const CellSides& sides, EdgeId edge,
                                       double same_point) {
  for (const geometry::EdgeUse& use : sides.edges[static_cast<std::size_t>(edge.value)])
    if (!shapes.is_straight(use.edge)) return {};
  const CellIncidence incidence(sides.graph);
  const CellGraph::Edge& ends = sides.graph.edge(edge);
  const auto corner = [&](VertexId v) -> Eigen::Vector3d {
    return shapes.complex().vertex(sides.vertices[static_cast<std::size_t>(v.value)]);
  };
  const Eigen::Vector3d along = (corner(ends.end) - corner(ends.start)).normalized();
  const Eigen::Vector3d one = outward(shapes, sides, incidence.left(edge)),
                        two = outward(shapes, sides, incidence.right(edge));
  // Directions away from the edge in the two sides; seen along the edge the left side is to the left.
  const Eigen::Vector3d in_left = one.cross(along), in_right = along.cross(two);
  const double inner = std::numbers::pi - std::atan2(one.cross(two).dot(along), one.dot(two));
  // Directions into the cell make an angle with the left side below the inner one, through the inside.
  const auto angle_from_left = [&](const Eigen::Vector3d& d) {
    const double angle = std::atan2(d.dot(-one), d.dot(in_left));
    return angle < 0 ? angle + 2 * std::numbers::pi : angle;
  };
  std::vector<Eigen::Vector3d> directions = {-in_left, -in_right};
  directions.push_back(std::cos(inner / 2) * in_left - std::sin(inner / 2) * one);
  for (int v = 0; v < sides.graph.vertex_count; ++v) {
    Eigen::Vector3d away = corner(VertexId(v)) - corner(ends.start);
    away -= away.dot(along) * along;
    if (away.norm() <= same_point) continue;
    directions.push_back(away.normalized());
    directions.push_back(-away.normalized());
  }
  std::vector<SpacedLoop> result;
  std::set<CuttingLoop> known;
  for (const Eigen::Vector3d& into : directions) {
    const double angle = angle_from_left(into);
    if (!(angle > 1e-3 && angle < inner - 1e-3)) continue;
    auto section = plane_section(shapes, sides, edge, along.cross(into), into, same_point);
    if (section && known.insert(section->loop).second) result.push_back(std::move(*section));
  }
  return result;
}

}  // namespace isopatch::segmentation
