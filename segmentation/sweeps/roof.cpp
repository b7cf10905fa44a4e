#include "segmentation/sweeps/internal/roof.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/splines/arc.hpp"
#include "segmentation/sweeps/internal/straight_wall.hpp"
#include "segmentation/sweeps/interpolate.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::NurbsCurve;
using geometry::SurfaceKind;

constexpr double no_lean = 1e-7;

/// Whether an edge of a cone is a circle about its axis, its seam, or in an upright plane.
enum class RoofEdge { circle, seam, on_upright_plane, other };

RoofEdge edge_of_roof(const Brep& solid, const Eigen::Vector3d& along, FaceId cone, EdgeId edge) {
  const geometry::BrepEdge& line = solid.edge(edge);
  if (line.faces.size() == 2 && line.faces[0] == line.faces[1]) return RoofEdge::seam;
  if (line.kind == geometry::CurveKind::circle) return RoofEdge::circle;
  for (const FaceId face : line.faces)
    if (const auto carrier = solid.carrier(face); face != cone && carrier &&
                                                  carrier->kind == SurfaceKind::plane &&
                                                  std::abs(carrier->axis.dot(along)) < no_lean)
      return RoofEdge::on_upright_plane;
  return RoofEdge::other;
}

bool is_roof(const Brep& solid, const Eigen::Vector3d& along, FaceId face) {
  const auto carrier = solid.carrier(face);
  if (!carrier || carrier->kind != SurfaceKind::cone) return false;
  bool cuts = false;
  for (const auto& loop : solid.face(face).loops)
    for (const geometry::EdgeUse& use : loop) {
      const RoofEdge kind = edge_of_roof(solid, along, face, use.edge);
      if (kind == RoofEdge::other) return false;
      cuts = cuts || kind == RoofEdge::on_upright_plane;
    }
  return cuts;
}

}  // namespace

Roof::Roof(const Brep& solid, const SweepFrame& frame, FaceId face) : frame_(frame), face_(face) {
  const geometry::Carrier cone = *solid.carrier(face);
  const double tangent = std::tan(cone.half_angle.radians()), up = cone.axis.dot(frame.along) > 0 ? 1 : -1;
  slope_ = up / tangent;
  centre_ = frame.flat(cone.origin);
  apex_ = frame.height(cone.origin) - slope_ * cone.radius;
  const geometry::DomainBox box = solid.domain(face);
  looks_up_ = solid.outward_normal(face, (box.low + box.high) / 2).dot(frame.along) > 0;
  top_ = looks_up_ ? -1e300 : 1e300;
  for (const auto& loop : solid.face(face).loops)
    for (const geometry::EdgeUse& use : loop)
      for (const double t : {0.0, 0.5, 1.0}) {
        const double at = frame.height(solid.point(use.edge, t));
        top_ = looks_up_ ? std::max(top_, at) : std::min(top_, at);
      }
}

double Roof::height(const Eigen::Vector2d& flat) const {
  return apex_ + slope_ * (flat - centre_).norm();
}

std::vector<Eigen::Vector2d> Roof::corners(const Brep& solid) const {
  std::vector<Eigen::Vector2d> result;
  for (const auto& loop : solid.face(face_).loops)
    for (const geometry::EdgeUse& use : loop) {
      const geometry::BrepEdge& edge = solid.edge(use.edge);
      if (edge_of_roof(solid, frame_.along, face_, use.edge) == RoofEdge::on_upright_plane)
        for (const VertexId end : {edge.start, edge.end}) result.push_back(frame_.flat(solid.vertex(end)));
    }
  return result;
}

NurbsCurve Roof::lifted(const NurbsCurve& plan) const {
  const auto flat = [&](double t) { return frame_.flat(plan.point(geometry::Parameter<1>(t))); };
  if (is_segment(plan)) return conic(flat(0), flat(1));
  const double radius = (flat(0) - centre_).norm();
  const bool level = std::abs((flat(0.5) - centre_).norm() - radius) < 1e-9 * radius &&
                     std::abs((flat(1) - centre_).norm() - radius) < 1e-9 * radius;
  if (level) {
    const double by = height(flat(0)) - frame_.height(plan.control_points().col(0));
    return NurbsCurve(plan.knots(), plan.control_points().colwise() + by * frame_.along, plan.weights());
  }
  return interpolated([&](double t) { return frame_.point(flat(t), height(flat(t))); });
}

/// The section of a cone by an upright plane as one rational quadratic arc: its middle point is where the
/// tangents at its ends meet, and half way it is on the cone.
NurbsCurve Roof::conic(const Eigen::Vector2d& from, const Eigen::Vector2d& to) const {
  const double length = (to - from).norm(), low = height(from), high = height(to);
  const Eigen::Vector2d way = (to - from) / length;
  const auto rise = [&](const Eigen::Vector2d& at) { return slope_ * (at - centre_).normalized().dot(way); };
  const double start = rise(from), end = rise(to);
  const Eigen::Vector3d first = frame_.point(from, low), last = frame_.point(to, high);
  if (std::abs(start - end) < 1e-9) return geometry::segment(first, last);
  const double meets = (high - low - end * length) / (start - end);
  const Eigen::Vector2d flat = from + meets * way;
  const double crest = low + start * meets;
  const auto off = [&](double weight) {
    const Eigen::Vector2d at = ((from + to) / 2 + weight * flat) / (1 + weight);
    return ((low + high) / 2 + weight * crest) / (1 + weight) - height(at);
  };
  double less = 0, more = 1;
  while (off(less) * off(more) > 0 && more < 1e6) more *= 2;
  for (int i = 0; i < 100; ++i) {
    const double middle = (less + more) / 2;
    (off(less) * off(middle) > 0 ? less : more) = middle;
  }
  Eigen::Matrix3Xd points(3, 3);
  points << first, frame_.point(flat, crest), last;
  return NurbsCurve({geometry::KnotVector::bezier(2)}, points, Eigen::Vector3d(1, (less + more) / 2, 1));
}

std::vector<FaceId> roofs(const Brep& solid, const SweepFrame& frame) {
  std::vector<FaceId> result;
  for (const FaceId face : frame.inclined)
    if (is_roof(solid, frame.along, face)) result.push_back(face);
  return result;
}

}  // namespace isopatch::segmentation
