#include "segmentation/branches/internal/main_body.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/brep/require_solid.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::Carrier;
using geometry::SurfaceKind;

constexpr double no_turn = 1e-7;
/// Of the surface; solids with less do not look turned.
constexpr double least_turned = 0.4;

struct AxisLine {
  Eigen::Vector3d origin, direction;
  double distance(const Eigen::Vector3d& point) const { return (point - origin).cross(direction).norm(); }
};

bool is_turned_about(const Brep& solid, FaceId face, const AxisLine& axis) {
  const std::optional<Carrier> carrier = solid.carrier(face);
  if (!carrier) return false;
  const bool centred = axis.distance(carrier->origin) < 1e-7 * solid.size();
  const bool along = carrier->axis.cross(axis.direction).norm() < no_turn;
  if (carrier->kind == SurfaceKind::plane) return along;
  return centred && (along || carrier->kind == SurfaceKind::sphere);
}

std::vector<AxisLine> axes_of_cylinders(const Brep& solid) {
  std::vector<AxisLine> result;
  for (int f = 0; f < static_cast<int>(solid.faces().size()); ++f) {
    const std::optional<Carrier> carrier = solid.carrier(FaceId(f));
    if (!carrier || carrier->kind != SurfaceKind::cylinder) continue;
    if (std::none_of(result.begin(), result.end(), [&](const AxisLine& known) {
          return known.direction.cross(carrier->axis).norm() < no_turn &&
                 known.distance(carrier->origin) < 1e-7 * solid.size();
        }))
      result.push_back({carrier->origin, carrier->axis});
  }
  return result;
}

/// Faces by the edges between them.
std::vector<std::vector<FaceId>> groups_of(const Brep& solid, const std::set<FaceId>& faces) {
  std::vector<std::vector<FaceId>> result;
  std::set<FaceId> left = faces;
  while (!left.empty()) {
    std::vector<FaceId> group = {*left.begin()};
    left.erase(left.begin());
    for (std::size_t i = 0; i < group.size(); ++i)
      for (const auto& loop : solid.face(group[i]).loops)
        for (const geometry::EdgeUse& use : loop)
          for (const FaceId other : solid.edge(use.edge).faces)
            if (left.erase(other) > 0) group.push_back(other);
    std::sort(group.begin(), group.end());
    result.push_back(std::move(group));
  }
  return result;
}

class BranchMaker {
 public:
  BranchMaker(const Brep& solid, const AxisLine& axis, std::vector<FaceId> group)
      : solid_(solid), axis_(axis), tolerance_(1e-6 * solid.size()) {
    made_.faces = std::move(group);
  }

  Branch make() {
    find_neighbours();
    find_view();
    find_surface();
    find_walls();
    measure();
    return std::move(made_);
  }

 private:
  bool is_mine(FaceId face) const { return std::binary_search(made_.faces.begin(), made_.faces.end(), face); }

  [[noreturn]] void refuse(FaceId face, const std::string& what) const {
    throw Error(ErrorCode::unsupported, fmt::format("{} {}", describe(solid_, face), what));
  }

  template <class Take>
  void for_edges(FaceId face, const Take& take) const {
    for (const auto& loop : solid_.face(face).loops)
      for (const geometry::EdgeUse& use : loop) take(use.edge);
  }

  void find_neighbours() {
    for (const FaceId face : made_.faces)
      for_edges(face, [&](EdgeId edge) {
        for (const FaceId other : solid_.edge(edge).faces)
          if (!is_mine(other) &&
              std::find(made_.neighbours.begin(), made_.neighbours.end(), other) == made_.neighbours.end())
            made_.neighbours.push_back(other);
      });
  }

  /// Cylinders, or for bores along the axis planes across it.
  void find_surface() {
    made_.surface = -1e300;
    for (const FaceId face : made_.neighbours) {
      const Carrier carrier = *solid_.carrier(face);
      if (carrier.kind != (made_.along_axis ? SurfaceKind::plane : SurfaceKind::cylinder))
        refuse(face, made_.along_axis ? "is met by a bore along the axis, and only planes are allowed there"
                                      : "is met by a branch, and only cylinders are allowed there");
      made_.surface =
          std::max(made_.surface, made_.along_axis ? made_.view.height(carrier.origin) : carrier.radius);
    }
  }

  /// Along the first cylinder's axis, else across the first plane along the body.
  void find_view() {
    for (const FaceId face : made_.faces)
      if (const std::optional<Carrier> carrier = solid_.carrier(face);
          carrier && carrier->kind == SurfaceKind::cylinder &&
          carrier->axis.cross(axis_.direction).norm() < no_turn)
        return look_along_axis(carrier->origin - axis_.origin);
    std::optional<Eigen::Vector3d> along;
    for (const SurfaceKind kind : {SurfaceKind::cylinder, SurfaceKind::plane})
      for (const FaceId face : made_.faces) {
        const std::optional<Carrier> carrier = solid_.carrier(face);
        if (along || !carrier || carrier->kind != kind ||
            std::abs(carrier->axis.dot(axis_.direction)) > no_turn || is_neighbour_of_body(face, kind))
          continue;
        along = carrier->axis;
      }
    if (!along) refuse(made_.faces.front(), "is of no branch across the axis");
    double sum = 0;
    for (const FaceId face : made_.faces)
      for_edges(face, [&](EdgeId edge) { sum += (solid_.point(edge, 0.4) - axis_.origin).dot(*along); });
    made_.view.origin = axis_.origin;
    made_.view.along = sum < -tolerance_ ? Eigen::Vector3d(-*along) : *along;
    made_.view.x = axis_.direction;
    made_.view.y = made_.view.along.cross(made_.view.x);
  }

  void look_along_axis(const Eigen::Vector3d& way) {
    const Eigen::Vector3d out = way - way.dot(axis_.direction) * axis_.direction;
    made_.along_axis = true;
    made_.view = {axis_.origin, out.normalized(), axis_.direction.cross(out.normalized()), axis_.direction};
  }

  /// Planes that meet the body are walls, not floors.
  bool is_neighbour_of_body(FaceId face, SurfaceKind kind) const {
    bool result = false;
    if (kind == SurfaceKind::plane)
      for_edges(face, [&](EdgeId edge) {
        for (const FaceId other : solid_.edge(edge).faces) result = result || !is_mine(other);
      });
    return result;
  }

  double height_at(EdgeId edge, double t) const { return made_.view.height(solid_.point(edge, t)); }

  double lowest(FaceId face) const {
    double result = 1e300;
    for_edges(face, [&](EdgeId edge) {
      for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) result = std::min(result, height_at(edge, t));
    });
    return result;
  }

  void find_walls() {
    std::vector<FaceId> walls;
    for (const FaceId face : made_.faces) {
      const double low = lowest(face);
      if (low > made_.surface - tolerance_) continue;
      const std::optional<Carrier> carrier = solid_.carrier(face);
      if (is_wall(solid_, face, made_.view.along))
        walls.push_back(face);
      else if (carrier && carrier->kind == SurfaceKind::plane &&
               carrier->axis.cross(made_.view.along).norm() < no_turn)
        made_.floors.push_back(low);
      else
        refuse(face, "is neither wall nor floor of a branch");
    }
    std::sort(made_.floors.rbegin(), made_.floors.rend());
    made_.floors.erase(std::unique(made_.floors.begin(), made_.floors.end(),
                                   [&](double a, double b) { return std::abs(a - b) < tolerance_; }),
                       made_.floors.end());
    made_.outlines = outlines_of(solid_, made_.view, walls);
    if (made_.outlines.empty()) refuse(made_.faces.front(), "is of a branch without walls");
  }

  void measure() {
    made_.low = 1e300;
    made_.high = -1e300;
    for (const Outline& outline : made_.outlines)
      for (const PlanCurve& curve : outline.curves)
        for (int i = 0; i <= 64; ++i) {
          made_.low = std::min(made_.low, curve.point(i / 64.0).x());
          made_.high = std::max(made_.high, curve.point(i / 64.0).x());
        }
  }

  const Brep& solid_;
  const AxisLine& axis_;
  double tolerance_;
  Branch made_;
};

double area_of(const Brep& solid, const MainBody& body) {
  double sum = 0;
  for (const FaceId face : body.faces) sum += solid.area(face);
  return sum;
}

/// Whether a round face looks away from the axis; plates with bores have none.
bool has_outside(const Brep& solid, const MainBody& body) {
  return std::any_of(body.faces.begin(), body.faces.end(), [&](FaceId face) {
    if (solid.carrier(face)->kind == SurfaceKind::plane) return false;
    const geometry::DomainBox box = solid.domain(face);
    const Eigen::Vector2d uv = box.low + 0.37 * (box.high - box.low);
    const Eigen::Vector3d way = solid.point(face, uv) - body.origin;
    return solid.outward_normal(face, uv).dot(way - way.dot(body.axis) * body.axis) > 0;
  });
}

std::optional<MainBody> body_about(const Brep& solid, const AxisLine& axis) {
  MainBody result{axis.origin, axis.direction, {}, {}};
  std::set<FaceId> others;
  for (int f = 0; f < static_cast<int>(solid.faces().size()); ++f)
    if (is_turned_about(solid, FaceId(f), axis))
      result.faces.emplace_back(f);
    else
      others.insert(FaceId(f));
  if (others.empty() || !has_outside(solid, result) || area_of(solid, result) < least_turned * solid.area())
    return std::nullopt;
  for (std::vector<FaceId>& group : groups_of(solid, others))
    result.branches.push_back(BranchMaker(solid, axis, std::move(group)).make());
  return result;
}

}  // namespace

std::vector<MainBody> main_bodies(const Brep& solid) {
  std::vector<MainBody> result;
  std::optional<Error> refusal;
  for (const AxisLine& axis : axes_of_cylinders(solid)) {
    try {
      if (std::optional<MainBody> body = body_about(solid, axis)) result.push_back(*std::move(body));
    } catch (const Error& error) {
      if (error.code() != ErrorCode::unsupported) throw;
      refusal = error;
    }
  }
  if (result.empty() && refusal) throw *refusal;
  std::stable_sort(result.begin(), result.end(), [&](const MainBody& a, const MainBody& b) {
    return area_of(solid, a) > area_of(solid, b);
  });
  return result;
}

}  // namespace isopatch::segmentation
