#include "segmentation/pieces/internal/cut_planes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/brep/edge_angles.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::Convexity;
using geometry::PlaneSurface;

PlaneSurface plane(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
  const Eigen::Vector3d x = normal.unitOrthogonal();
  return {point, x, normal.cross(x)};
}

class Collector {
 public:
  explicit Collector(const Brep& solid) : solid_(solid), tolerance_(1e-6 * solid.size()) {}

  std::vector<PlaneSurface> make() {
    const std::vector<geometry::EdgeAngles> angles = geometry::edge_angles(solid_);
    for (std::size_t e = 0; e < angles.size(); ++e) {
      const EdgeId edge(static_cast<int>(e));
      if (angles[e].convexity == Convexity::non_convex) extend_faces(edge);
      if (angles[e].convexity == Convexity::flat) cut_across(edge);
    }
    return std::move(result_);
  }

 private:
  void extend_faces(EdgeId edge) {
    for (const FaceId face : solid_.edge(edge).faces)
      if (const auto carrier = solid_.carrier(face); carrier && carrier->kind == geometry::SurfaceKind::plane)
        add(plane(carrier->origin, carrier->axis));
  }

  /// Through an edge where a flat face and a round one meet, at right angles to both, or the plane of a
  /// circle.
  void cut_across(EdgeId edge) {
    const geometry::BrepEdge& line = solid_.edge(edge);
    if (line.kind == geometry::CurveKind::circle)
      add(plane(solid_.point(edge, 0),
                solid_.tangent(edge, 0).cross(solid_.tangent(edge, 0.3)).normalized()));
    if (line.kind != geometry::CurveKind::line) return;
    for (const FaceId face : line.faces)
      if (const auto carrier = solid_.carrier(face);
          carrier && carrier->kind == geometry::SurfaceKind::plane) {
        add(plane(solid_.point(edge, 0), solid_.tangent(edge, 0).cross(carrier->axis).normalized()));
        return;
      }
  }

  void add(const PlaneSurface& made) {
    const bool known = std::any_of(result_.begin(), result_.end(), [&](const PlaneSurface& other) {
      return made.normal().cross(other.normal()).norm() < 1e-7 &&
             std::abs((other.origin - made.origin).dot(made.normal())) < tolerance_;
    });
    if (!known && cuts(made)) result_.push_back(made);
  }

  bool cuts(const PlaneSurface& made) const {
    bool above = false, below = false;
    for (int e = 0; e < static_cast<int>(solid_.edges().size()); ++e)
      for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) {
        const double height = (solid_.point(EdgeId(e), t) - made.origin).dot(made.normal());
        above = above || height > tolerance_;
        below = below || height < -tolerance_;
      }
    return above && below;
  }

  const Brep& solid_;
  double tolerance_;
  std::vector<PlaneSurface> result_;
};

}  // namespace

std::vector<PlaneSurface> cut_planes(const Brep& solid) {
  return Collector(solid).make();
}

}  // namespace isopatch::segmentation
