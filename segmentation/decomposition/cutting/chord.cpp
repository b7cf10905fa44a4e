#include "segmentation/decomposition/cutting/chord.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>

#include "segmentation/decomposition/cutting/auxiliary_curve.hpp"
#include "segmentation/decomposition/cutting/divide.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::CellComplex;
using geometry::CurveId;
using geometry::EdgeUse;

/// A vertex as a face's outline passes it.
struct Corner {
  FaceId face;
  VertexId vertex;
  Eigen::Vector2d point, before,
      after;  ///< in the domain: there, and where the outline comes from and goes to
};

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

class ChordMaker {
 public:
  ChordMaker(const geometry::Brep& source, CellComplex& complex, std::vector<FaceId> side,
             const ChordOptions& options)
      : source_(source), complex_(complex), side_(std::move(side)), options_(options) {
    plane_ = frame_of_side();
  }

  std::optional<std::vector<EdgeUse>> make(VertexId from, VertexId to) {
    if (options_.plane && !plane_)
      if (auto chord = make_in_plane(from, to)) return chord;
    if (!options_.bent) return make_straight(from, to);
    const CellComplex before = complex_;
    const std::vector<FaceId> side = side_;
    if (auto chord = make_straight(from, to)) return chord;
    complex_ = before;
    side_ = side;
    return make_bent(from, to);
  }

 private:
  std::optional<std::vector<EdgeUse>> make_straight(VertexId from, VertexId to) {
    const auto end = domain_point_of(to);
    if (!end) return std::nullopt;
    std::vector<EdgeUse> chord;
    for (VertexId at = from; at != to;) {
      const std::optional<EdgeUse> next = step(at, to, *end);
      if (!next || chord.size() > 100) return std::nullopt;
      chord.push_back(*next);
      at = complex_.to(*next);
    }
    return chord;
  }

  bool has(FaceId face, VertexId vertex) const {
    const std::vector<EdgeUse>& loop = complex_.face(face).loop;
    return std::any_of(loop.begin(), loop.end(),
                       [&](const EdgeUse& use) { return complex_.from(use) == vertex; });
  }

  /// An edge of the side between two vertices that lies in the plane, or a new one across one face.
  std::optional<std::vector<EdgeUse>> make_in_plane(VertexId from, VertexId to) {
    for (const FaceId face : side_)
      for (EdgeUse use : complex_.face(face).loop) {
        if (complex_.from(use) == to && complex_.to(use) == from) use.reversed = !use.reversed;
        if (complex_.from(use) != from || complex_.to(use) != to) continue;
        const Eigen::Vector3d middle = shapes().point(use.edge, 0.5) - options_.plane->origin;
        if (std::abs(options_.plane->normal().dot(middle)) <= 100 * options_.tolerance)
          return std::vector<EdgeUse>{use};
      }
    for (const FaceId face : std::vector<FaceId>(side_)) {
      if (!has(face, from) || !has(face, to)) continue;
      if (const auto use = put(face, from, to,
                               section_curve(shapes(), face, from, to, *options_.plane, options_.tolerance)))
        return std::vector<EdgeUse>{*use};
    }
    return std::nullopt;
  }

  std::optional<std::vector<EdgeUse>> make_bent(VertexId from, VertexId to) {
    for (const FaceId face : std::vector<FaceId>(side_)) {
      if (!has(face, from) || !has(face, to)) continue;
      if (const auto use = put(face, from, to, bent_curve(shapes(), face, from, to, options_.tolerance)))
        return std::vector<EdgeUse>{*use};
    }
    return std::nullopt;
  }

  CellShapes shapes() const { return CellShapes(source_, complex_); }

  /// Of a plane side, whose faces may have surfaces, and so domains, of their own.
  std::optional<geometry::PlaneSurface> frame_of_side() const {
    for (const FaceId face : side_)
      if (!shapes().is_plane(complex_.face(face).surface)) return std::nullopt;
    const EdgeUse use = complex_.face(side_[0]).loop.front();
    geometry::PlaneSurface frame;
    frame.origin = shapes().point(use.edge, 0);
    const Eigen::Vector3d normal = shapes().normal(side_[0], shapes().domain_point(side_[0], use.edge, 0));
    frame.x = normal.unitOrthogonal();
    frame.y = normal.cross(frame.x);
    return frame;
  }

  bool is_turned(FaceId face) const {
    if (!plane_) return shapes().is_turned(face);
    const Eigen::Vector2d uv = shapes().domain_point(face, complex_.face(face).loop.front().edge, 0);
    return shapes().normal(face, uv).dot(plane_->normal()) < 0;
  }

  Eigen::Vector2d domain_point(FaceId face, EdgeUse use, double share) const {
    if (plane_) return plane_->domain_point(shapes().point(use.edge, use.reversed ? 1 - share : share));
    return shapes().domain_point(face, use.edge, use.reversed ? 1 - share : share);
  }

  std::optional<Eigen::Vector2d> domain_point_of(VertexId vertex) const {
    for (const FaceId face : side_)
      for (const EdgeUse& use : complex_.face(face).loop)
        if (complex_.from(use) == vertex) return domain_point(face, use, 0);
    return std::nullopt;
  }

  std::vector<Corner> corners_at(VertexId vertex) const {
    std::vector<Corner> result;
    for (const FaceId face : side_) {
      const std::vector<EdgeUse>& loop = complex_.face(face).loop;
      for (std::size_t i = 0; i < loop.size(); ++i) {
        if (complex_.from(loop[i]) != vertex) continue;
        const EdgeUse last = loop[(i + loop.size() - 1) % loop.size()];
        result.push_back({face, vertex, domain_point(face, loop[i], 0), domain_point(face, last, 0.999),
                          domain_point(face, loop[i], 1e-3)});
      }
    }
    return result;
  }

  /// The next piece of the chord from a vertex: an edge that lies there, or a new one across one face.
  std::optional<EdgeUse> step(VertexId at, VertexId to, const Eigen::Vector2d& end) {
    for (const Corner& corner : corners_at(at)) {
      const Eigen::Vector2d ahead = end - corner.point;
      if (const auto along = edge_along(corner, ahead)) return along;
    }
    for (const Corner& corner : corners_at(at)) {
      const Eigen::Vector2d ahead = end - corner.point;
      if (!looks_into(corner, ahead)) continue;
      const std::optional<VertexId> next = where_it_leaves(corner, to, end);
      if (!next) return std::nullopt;
      return across(corner.face, at, *next);
    }
    return std::nullopt;
  }

  /// An edge from the corner that runs straight ahead.
  std::optional<EdgeUse> edge_along(const Corner& corner, const Eigen::Vector2d& ahead) const {
    const std::vector<EdgeUse>& loop = complex_.face(corner.face).loop;
    for (const EdgeUse& use : loop) {
      EdgeUse out = use;
      if (complex_.from(use) != corner.vertex) {
        if (complex_.to(use) != corner.vertex) continue;
        out.reversed = !out.reversed;
      }
      const Eigen::Vector2d half = domain_point(corner.face, out, 0.5) - corner.point,
                            whole = domain_point(corner.face, out, 1) - corner.point;
      const auto straight = [&](const Eigen::Vector2d& way) {
        return std::abs(cross(way, ahead)) <= 1e-8 * ahead.norm() * way.norm() && way.dot(ahead) > 0;
      };
      if (straight(half) && straight(whole) && whole.norm() <= (1 + 1e-8) * ahead.norm()) return out;
    }
    return std::nullopt;
  }

  bool looks_into(const Corner& corner, const Eigen::Vector2d& ahead) const {
    Eigen::Vector2d after = corner.after - corner.point, before = corner.before - corner.point;
    if (is_turned(corner.face)) std::swap(after, before);
    const auto turn = [&](const Eigen::Vector2d& way) {
      const double angle = std::atan2(cross(after, way), after.dot(way));
      return angle < 0 ? angle + 2 * std::numbers::pi : angle;
    };
    return turn(ahead) < turn(before);
  }

  /// The vertex where the straight way leaves the corner's face, made where there is none.
  std::optional<VertexId> where_it_leaves(const Corner& corner, VertexId to, const Eigen::Vector2d& end) {
    const Eigen::Vector2d ahead = end - corner.point;
    constexpr int pieces = 16;
    double nearest = 1 - 1e-9;
    std::optional<EdgeUse> crossed;
    double share = 0;
    bool has_end = false;
    for (const EdgeUse& use : complex_.face(corner.face).loop) {
      has_end = has_end || complex_.from(use) == to;
      const bool straight =
          shapes().is_straight(use.edge) && shapes().is_plane(complex_.face(corner.face).surface);
      const int count = straight ? 1 : pieces;
      for (int i = 0; i < count; ++i) {
        if (i == 0 && complex_.from(use) == corner.vertex) continue;
        if (i == count - 1 && complex_.to(use) == corner.vertex) continue;
        const Eigen::Vector2d a = domain_point(corner.face, use, double(i) / count) - corner.point,
                              b = domain_point(corner.face, use, double(i + 1) / count) - corner.point;
        const double at_a = cross(ahead, a), at_b = cross(ahead, b);
        if (at_a * at_b > 0 || at_a == at_b) continue;
        const double s = at_a / (at_a - at_b);
        const double distance = (a + s * (b - a)).dot(ahead) / ahead.squaredNorm();
        if (distance <= 1e-9 || distance >= nearest) continue;
        nearest = distance;
        crossed = use;
        share = (i + s) / count;
      }
    }
    if (!crossed) return has_end ? std::optional(to) : std::nullopt;
    if (share < 1e-6) return complex_.from(*crossed);
    if (share > 1 - 1e-6) return complex_.to(*crossed);
    if (!is_inside(crossed->edge)) return std::nullopt;  // it leaves the side
    const double t = crossed->reversed ? 1 - share : share;
    return divide_edge(complex_, crossed->edge, t, shapes().point(crossed->edge, t));
  }

  /// Whether an edge lies between two faces of the side.
  bool is_inside(EdgeId edge) const {
    int uses = 0;
    for (const FaceId face : side_)
      for (const EdgeUse& use : complex_.face(face).loop) uses += use.edge == edge ? 1 : 0;
    return uses == 2;
  }

  std::optional<EdgeUse> across(FaceId face, VertexId from, VertexId to) {
    return put(face, from, to, auxiliary_curve(shapes(), face, from, to, options_.tolerance));
  }

  std::optional<EdgeUse> put(FaceId face, VertexId from, VertexId to,
                             const std::optional<AuxiliaryCurve>& curve) {
    if (!curve || curve->smallest_angle.degrees() < options_.smallest.degrees()) return std::nullopt;
    const EdgeId edge = divide_face(complex_, face, from, to, complex_.add_curve(curve->curve));
    side_.emplace_back(static_cast<int>(complex_.faces.size()) - 1);
    return EdgeUse{edge, false};
  }

  const geometry::Brep& source_;
  CellComplex& complex_;
  std::vector<FaceId> side_;
  ChordOptions options_;
  std::optional<geometry::PlaneSurface> plane_;
};

}  // namespace

std::optional<std::vector<EdgeUse>> add_chord(const geometry::Brep& source, CellComplex& complex,
                                              const std::vector<FaceId>& side, VertexId from, VertexId to,
                                              const ChordOptions& options) {
  return ChordMaker(source, complex, side, options).make(from, to);
}

}  // namespace isopatch::segmentation
