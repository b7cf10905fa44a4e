#include "iga/coupling/support_frames.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/base/error.hpp"
#include "geometry/measures.hpp"
#include "iga/coupling/free_body_support.hpp"
#include "iga/problem/internal/held_parts.hpp"
#include "iga/problem/springs.hpp"

namespace isopatch::iga {
namespace {

using geometry::PatchFace;

// One scalar condition on a point: direction . u = value.
struct Condition {
  Eigen::Vector3d direction;  // of unit length
  double value = 0;
  Angle uncertainty = {};  // of the direction: conditions that differ by less are the same
};

// Planes of published models are flat to about 1e-8 of their size.
constexpr Angle least_uncertainty = Angle::radians(1e-5);

// The outward normal of a plane face, and how far its points' own disagreement may turn it.
struct PlaneNormal {
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
  Angle uncertainty = least_uncertainty;
};

std::string point_text(const Eigen::Vector3d& x) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g}) m", x[0], x[1], x[2]);
}

// Fixes one more direction of a frame, or holds the condition against those already there.
void impose(SupportFrame& frame, const Condition& condition, int support, const ElasticityProblem& problem,
            const Eigen::Vector3d& place) {
  Eigen::Vector3d rest = condition.direction;
  for (int k = frame.free; k < 3; ++k) rest -= frame.axes.col(k) * frame.axes.col(k).dot(condition.direction);
  const double value_there = condition.direction.dot(frame.prescribed);
  frame.uncertainty = std::max(frame.uncertainty, condition.uncertainty);
  if (frame.free == 0 || rest.norm() < frame.uncertainty.radians()) {
    const double scale = std::max(
        {std::abs(condition.value), frame.prescribed.norm(), 1e-6 * problem.discretization.model.size()});
    if (std::abs(condition.value - value_there) <= std::max(1e-6, frame.uncertainty.radians()) * scale)
      return;
    int other = support;
    for (int k = frame.free; k < 3; ++k)
      if (std::abs(frame.axes.col(k).dot(condition.direction)) > 0.5)
        other = frame.support[static_cast<std::size_t>(k)];
    throw Error(ErrorCode::conflict,
                fmt::format("'{}' and '{}' contradict each other at {}: along ({:.3g}, {:.3g}, {:.3g}) one "
                            "prescribes {:.6g} m, the "
                            "other {:.6g} m",
                            problem.supports[static_cast<std::size_t>(other)].name,
                            problem.supports[static_cast<std::size_t>(support)].name, point_text(place),
                            condition.direction[0], condition.direction[1], condition.direction[2],
                            value_there, condition.value));
  }
  const Eigen::Vector3d axis = rest.normalized();
  frame.prescribed += axis * (condition.value - value_there) / rest.norm();
  // The new fixed axis takes the last free place; the free ones before it span what remains.
  const int place_of_axis = --frame.free;
  frame.axes.col(place_of_axis) = axis;
  frame.direction[static_cast<std::size_t>(place_of_axis)] = condition.direction;
  frame.support[static_cast<std::size_t>(place_of_axis)] = support;
  int filled = 0;
  for (int candidate = 0; candidate < 3 && filled < frame.free; ++candidate) {
    Eigen::Vector3d direction = Eigen::Vector3d::Unit(candidate);
    for (int pass = 0; pass < 2; ++pass) {
      for (int k = frame.free; k < 3; ++k) direction -= frame.axes.col(k) * frame.axes.col(k).dot(direction);
      for (int k = 0; k < filled; ++k) direction -= frame.axes.col(k) * frame.axes.col(k).dot(direction);
    }
    // What is still to be spanned is orthogonal to the unit vectors taken, so one of the others passes.
    if (direction.norm() > 0.5) frame.axes.col(filled++) = direction.normalized();
  }
}

// For a face that must be plane.
PlaneNormal plane_normal(const geometry::MultiPatch& model, PatchFace face, const std::string& support) {
  const geometry::NurbsVolume& patch = model.patch(face.patch);
  const Eigen::Matrix3Xd points = geometry::face_surface(patch, face.side).control_points();
  const Eigen::Vector3d centre = points.rowwise().mean();
  const Eigen::Matrix3d scatter = (points.colwise() - centre) * (points.colwise() - centre).transpose();
  const PrincipalAxes principal = principal_axes(scatter);
  Eigen::Vector3d normal = principal.axes.col(0);
  const double off_plane = ((points.colwise() - centre).transpose() * normal).cwiseAbs().maxCoeff();
  const double extent = std::sqrt(principal.values[2]);
  if (off_plane > std::max(1e-5 * extent, 10 * model.tolerance().same_point * model.size()))
    throw Error(ErrorCode::invalid_argument, fmt::format("'{}': face {} is not plane (off by {:.3g} m), so "
                                                         "it cannot be a symmetry plane or a roller; give "
                                                         "displacement components instead",
                                                         support, model.label(face), off_plane));
  const geometry::Parameter<3> middle = 0.5 * (patch.low() + patch.high());
  const auto directions = geometry::tangents(face.side);
  const geometry::Parameter<2> on_face(middle[directions[0]], middle[directions[1]]);
  if (geometry::outward_normal(patch, face.side, on_face).dot(normal) < 0) normal = -normal;
  // Nearly axis-parallel planes are taken as exactly so: conditions then touch one component each.
  for (int d = 0; d < 3; ++d)
    if (std::abs(std::abs(normal[d]) - 1) < 1e-12)
      normal = Eigen::Vector3d::Unit(d) * (normal[d] > 0 ? 1 : -1);
  // Points may be off by the tolerance, which turns narrow faces most; below a degree, so that corners stay
  // corners.
  const Eigen::VectorXd across = (points.colwise() - centre).transpose() * principal.axes.col(1);
  const double width = across.maxCoeff() - across.minCoeff();
  const double off = std::max(off_plane, model.tolerance().same_point * model.size());
  return {normal, std::clamp(Angle::radians(4 * off / width), least_uncertainty, Angle::radians(1e-2))};
}

Eigen::Vector3d control_point(const Discretization& d, int node) {
  const auto patch = static_cast<std::size_t>(
      std::upper_bound(d.first_node.begin(), d.first_node.end(), node) - d.first_node.begin() - 1);
  return d.patches[patch].control_points().col(node - d.first_node[patch]);
}

// Along the directions of cylinder coordinates at a control point, but for those that springs hold.
std::vector<Condition> conditions_about(const CylindricalSupport& about, const std::string& name,
                                        const Eigen::Vector3d& place) {
  const Eigen::Vector3d axis = about.axis.normalized();
  const Eigen::Vector3d arm = place - about.point;
  const Eigen::Vector3d radial = arm - axis * axis.dot(arm);
  if (!(radial.norm() > 1e-9 * arm.norm()))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("'{}': a control point at {} lies on the axis, where nothing is radial; choose "
                            "faces around the axis, or give another axis",
                            name, point_text(place)));
  std::vector<Condition> result;
  if (!is_sprung(about) && about.radial) {
    result.push_back({radial.normalized(), 0, least_uncertainty});
    result.push_back({axis.cross(radial).normalized(), 0, least_uncertainty});
  }
  if (about.axial) result.push_back({axis, 0, least_uncertainty});
  return result;
}

std::vector<Condition> conditions_at(const Support& support, const Eigen::Vector3d& place,
                                     const PlaneNormal& plane_of_face) {
  if (const auto* plane = std::get_if<PlaneSupport>(&support.condition))
    return {{plane_of_face.normal, plane->normal_displacement, plane_of_face.uncertainty}};
  if (const auto* about = std::get_if<CylindricalSupport>(&support.condition))
    return conditions_about(*about, support.name, place);
  const auto& prescribed = std::get<PrescribedDisplacement>(support.condition);
  std::vector<Condition> result;
  for (int d = 0; d < 3; ++d)
    if (const auto& value = prescribed.value[static_cast<std::size_t>(d)])
      result.push_back(
          {Eigen::Vector3d::Unit(d), *value + prescribed.gradient.row(d).dot(place), least_uncertainty});
  return result;
}

// Imposes a support on some control points of a patch.
void hold(const std::vector<int>& points, PatchId patch, int support, const PlaneNormal& normal,
          const ElasticityProblem& problem, const GlobalNodes& global, std::vector<SupportFrame>& frames) {
  const Discretization& d = problem.discretization;
  for (const int point : points) {
    const int node = d.first_node[static_cast<std::size_t>(patch.value)] + point;
    const int global_node = global.global_of[static_cast<std::size_t>(node)];
    // One place for all nodes of a global one, or a gradient would prescribe their distances as a
    // contradiction.
    const Eigen::Vector3d place = control_point(d, global.nodes_of(global_node)[0]);
    for (const Condition& condition :
         conditions_at(problem.supports[static_cast<std::size_t>(support)], place, normal))
      impose(frames[static_cast<std::size_t>(global_node)], condition, support, problem, place);
  }
}

void require_faces_alone(const Support& support) {
  if (std::holds_alternative<PrescribedDisplacement>(support.condition) ||
      (support.edges.empty() && support.corners.empty() && support.points.empty()))
    return;
  throw Error(
      ErrorCode::invalid_argument,
      fmt::format("'{}': a symmetry plane, a roller, a cylindrical or an elastic support needs faces, "
                  "an edge or a point has no normal; give displacement components instead",
                  support.name));
}

void require_patches(const Support& support, const Discretization& d) {
  const auto require = [&](PatchId patch) {
    if (patch.value < 0 || patch.value >= d.patch_count())
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("'{}': there is no patch {}, the model has patches 0 to {}", support.name,
                              patch.value, d.patch_count() - 1));
  };
  for (const SupportedEdge& held : support.edges) require(held.patch);
  for (const PatchCorner& corner : support.corners) require(corner.patch);
  for (const PatchPoint& point : support.points) require(point.patch);
}

}  // namespace

std::vector<SupportFrame> support_frames(const ElasticityProblem& problem, const GlobalNodes& global) {
  const Discretization& d = problem.discretization;
  const auto& boundary = d.model.boundary_faces();
  const auto sizes = [&](PatchId patch) { return d.patches[static_cast<std::size_t>(patch.value)].sizes(); };
  std::vector<SupportFrame> frames(static_cast<std::size_t>(global.count()));
  for (std::size_t s = 0; s < problem.supports.size(); ++s) {
    const Support& support = problem.supports[s];
    const bool plane = std::holds_alternative<PlaneSupport>(support.condition);
    require_faces_alone(support);
    require_patches(support, d);
    std::size_t count = 0;  // of control points on faces
    for (const PatchFace face : support.faces) {
      if (std::find(boundary.begin(), boundary.end(), face) == boundary.end())
        throw Error(ErrorCode::invalid_argument,
                    fmt::format("'{}': face {} is not on the boundary of the model", support.name,
                                d.model.label(face)));
      if (std::holds_alternative<ElasticSupport>(support.condition)) continue;
      const std::vector<int> held = held_control_points(d.patches[static_cast<std::size_t>(face.patch.value)],
                                                        face.side, support.region);
      count += held.size();
      hold(held, face.patch, static_cast<int>(s),
           plane ? plane_normal(d.model, face, support.name) : PlaneNormal{}, problem, global, frames);
    }
    if (count == 0 && !support.region.is_everywhere() &&
        !std::holds_alternative<ElasticSupport>(support.condition))
      throw Error(
          ErrorCode::invalid_argument,
          fmt::format("'{}': the part of its faces is smaller than half an element, so no function can "
                      "be held there; refine the discretization, or hold a point",
                      support.name));
    for (const SupportedEdge& held : support.edges)
      hold(geometry::edge_control_points(sizes(held.patch), held.edge), held.patch, static_cast<int>(s), {},
           problem, global, frames);
    for (const PatchCorner& corner : support.corners)
      hold({control_point_of(sizes(corner.patch), corner)}, corner.patch, static_cast<int>(s), {}, problem,
           global, frames);
  }
  for (std::size_t s = 0; s < problem.supports.size(); ++s)
    if (std::holds_alternative<FreeBodySupport>(problem.supports[s].condition))
      hold_free_bodies(problem, static_cast<int>(s), global, frames);
  return frames;
}

}  // namespace isopatch::iga
