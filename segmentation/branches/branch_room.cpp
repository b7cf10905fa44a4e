#include "segmentation/branches/internal/branch_room.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "geometry/base/error.hpp"
#include "geometry/brep/require_solid.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;

/// Room beside a branch across the axis, as a share of its half width: less would make thin hexahedra.
constexpr double least_room = 0.15;
/// Along the axis, where there is more.
constexpr double room_along = 0.35;

class RoomFinder {
 public:
  RoomFinder(const Brep& solid, const MainBody& body)
      : solid_(solid), body_(body), tolerance_(1e-6 * solid.size()) {}

  BranchLayout make() {
    find_radii();
    find_sectors();
    for (const Branch& branch : body_.branches) ends_.push_back(ends(branch));
    while (join_ends()) continue;
    for (std::size_t b = 0; b < ends_.size(); ++b) add(body_.branches[b], ends_[b]);
    return std::move(made_);
  }

 private:
  [[noreturn]] void refuse(const Branch& branch, const std::string& what) const {
    throw Error(ErrorCode::unsupported,
                fmt::format("{} {}", describe(solid_, branch.outlines.front().walls.front()), what));
  }

  double along(const Eigen::Vector3d& point) const { return (point - body_.origin).dot(body_.axis); }
  double radius(const Eigen::Vector3d& point) const {
    return (point - body_.origin).cross(body_.axis).norm();
  }

  template <class Take>
  void for_points(FaceId face, const Take& take) const {
    for (const auto& loop : solid_.face(face).loops)
      for (const geometry::EdgeUse& use : loop)
        for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0}) take(solid_.point(use.edge, t));
  }

  /// Whether the axis is free, and the smallest radius of what is around it.
  void find_radii() {
    smallest_ = 1e300;
    for (const FaceId face : body_.faces) {
      const auto carrier = solid_.carrier(face);
      for_points(face, [&](const Eigen::Vector3d& p) {
        if (radius(p) > tolerance_) smallest_ = std::min(smallest_, radius(p));
      });
      if (carrier->kind != geometry::SurfaceKind::plane) continue;
      const Eigen::Vector3d centre =
          body_.origin + (carrier->origin - body_.origin).dot(body_.axis) * body_.axis;
      is_solid_ = is_solid_ || solid_.contains(face, solid_.project(face, centre).uv);
    }
  }

  /// Half of a branch's width across the axis.
  static double half_width(const Outline& outline) {
    double result = 0;
    for (const PlanCurve& curve : outline.curves)
      for (int i = 0; i <= 64; ++i) result = std::max(result, std::abs(curve.point(i / 64.0).y()));
    return result;
  }

  /// Of those outlines that a cylinder of the body meets, the widest; wider ones, which are squeezed there,
  /// take as much room beside it as half of what they are wider.
  double half_width_on(const Branch& branch, FaceId cylinder) const {
    double result = 0, widest = 0;
    for (const Outline& outline : branch.outlines) {
      widest = std::max(widest, half_width(outline));
      for (const FaceId wall : outline.walls)
        for (const auto& loop : solid_.face(wall).loops)
          for (const geometry::EdgeUse& use : loop)
            for (const FaceId face : solid_.edge(use.edge).faces)
              if (face == cylinder) result = std::max(result, half_width(outline));
    }
    return (result + widest) / 2;
  }

  /// The first number of sectors that have every branch in the middle of one, with room for it.
  void find_sectors() {
    made_.request.towards = side_of(body_.branches.front());
    std::vector<int> numbers = {4};
    for (int n = 3; !is_solid_ && n <= most_sectors; ++n)
      if (n != 4) numbers.push_back(n);
    for (const int n : numbers) {
      made_.request.sectors = n;
      if (!outside_of_middles() && !too_wide() && !bulges_into_a_frame()) {
        if (is_solid_) find_core();
        return;
      }
    }
    made_.request.sectors = 4;
    if (const Branch* branch = bulges_into_a_frame())
      refuse(*branch, "is so near to what is round inside of it that no straight line leads past that");
    if (const Branch* branch = too_wide())
      refuse(*branch,
             fmt::format("is too wide for its body: with the room beside it, it takes {:.0f} % of the width "
                         "that a quarter of it has",
                         100 * share_of_sector(*branch)));
    refuse(
        *outside_of_middles(),
        is_solid_
            ? "is at no right angle, seen along the axis, with the other branches"
            : "is at an angle with the other branches, seen along the axis, for which more than 16 sectors "
              "would be needed");
  }

  /// From the axis to it.
  static const Eigen::Vector3d& side_of(const Branch& branch) {
    return branch.along_axis ? branch.view.x : branch.view.along;
  }

  /// The first branch that is not in the middle of a sector; none if all are.
  const Branch* outside_of_middles() const {
    for (const Branch& branch : body_.branches) {
      const Eigen::Vector3d& first = made_.request.towards;
      const double turn =
          std::atan2(side_of(branch).dot(body_.axis.cross(first)), side_of(branch).dot(first));
      const double sectors = turn * made_.request.sectors / (2 * std::numbers::pi);
      if (std::abs(sectors - std::round(sectors)) > 1e-6) return &branch;
    }
    return nullptr;
  }

  const Branch* too_wide() const {
    for (const Branch& branch : body_.branches)
      if (share_of_sector(branch) > 1) return &branch;
    return nullptr;
  }

  /// That a branch takes with the room beside it.
  double share_of_sector(const Branch& branch) const {
    double result = 0;
    if (branch.along_axis) {
      for (const Outline& outline : branch.outlines)
        result = std::max(result, half_width(outline) / ((branch.low + branch.high) / 2));
    } else {
      for (const FaceId face : branch.neighbours)
        result = std::max(result, half_width_on(branch, face) / solid_.carrier(face)->radius);
    }
    return (1 + least_room) * result / sine();
  }

  /// The first bore along the axis whose side's inner edge, an arc, would cut off the straight line from its
  /// end to the bore; none if there is none.
  const Branch* bulges_into_a_frame() const {
    for (const Branch& branch : body_.branches)
      if (branch.along_axis && angle_at_arc(branch) < least_at_arc) return &branch;
    return nullptr;
  }

  /// The angle between the inner edge of a bore's side and the shortest line from its end to the bore, rad.
  double angle_at_arc(const Branch& branch) const {
    const double inner = ends(branch)[0], middle = (branch.low + branch.high) / 2;
    const double half = std::numbers::pi / made_.request.sectors;
    const Eigen::Vector2d out(std::cos(half), std::sin(half)), along(std::sin(half), -std::cos(half));
    const Eigen::Vector2d to_middle = Eigen::Vector2d(middle, 0) - inner * out;
    return std::atan2(to_middle.dot(out), to_middle.dot(along));
  }

  double sine() const { return std::sin(std::numbers::pi / made_.request.sectors); }

  /// Bores through the middle pass through its column.
  void find_core() {
    made_.request.core_share = usual_core;
    for (const Branch& branch : body_.branches)
      for (const double floor : branch.floors) {
        const double share = below_floors * distance_of(floor) / smallest_;
        if (share < smallest_core) refuse(branch, "reaches too near to its body's axis, or beyond");
        made_.request.core_share = std::min(made_.request.core_share, share);
      }
    double widest = 0;
    for (const Branch& branch : body_.branches)
      for (const Outline& outline : branch.outlines)
        if (outline.is_void && reaches_core(branch, outline)) widest = std::max(widest, half_width(outline));
    double& share = made_.request.core_share;
    share = std::max(share, (1 + least_room) * widest / sine() / smallest_);
    if (share > largest_core)
      refuse(body_.branches.front(), "is too wide to pass through the middle of its body");
  }

  /// Of a ring that is as far from the axis as a floor is, on average over a sector.
  double distance_of(double floor) const {
    return floor * (std::numbers::pi / made_.request.sectors) / sine();
  }

  bool reaches_core(const Branch& branch, const Outline& outline) const {
    bool result = false;
    for (const FaceId wall : outline.walls)
      for_points(wall, [&](const Eigen::Vector3d& p) {
        result = result || branch.view.height(p) < made_.request.core_share * smallest_ * sine();
      });
    return result;
  }

  /// The range along the axis in which all cylinders of the body that a branch meets are.
  std::array<double, 2> room(const Branch& branch) const {
    std::array<double, 2> result = {-1e300, 1e300};
    for (const FaceId face : branch.neighbours) {
      if (branch.along_axis) {
        narrow_to_plane(branch, face, result);
        continue;
      }
      double low = 1e300, high = -1e300;
      for_points(face, [&](const Eigen::Vector3d& p) {
        low = std::min(low, along(p));
        high = std::max(high, along(p));
      });
      result = {std::max(result[0], low), std::min(result[1], high)};
    }
    return result;
  }

  /// Distances from the axis at which a plane meets other faces of the body.
  void narrow_to_plane(const Branch& branch, FaceId face, std::array<double, 2>& room) const {
    for (const auto& loop : solid_.face(face).loops)
      for (const geometry::EdgeUse& use : loop)
        for (const FaceId other : solid_.edge(use.edge).faces) {
          if (other == face || !std::binary_search(body_.faces.begin(), body_.faces.end(), other)) continue;
          const double distance = radius(solid_.point(use.edge, 0.3));
          if (distance < branch.low) room[0] = std::max(room[0], distance);
          if (distance > branch.high) room[1] = std::min(room[1], distance);
        }
    room[0] = std::max(room[0], 0.0);
  }

  /// Where its side begins and ends: beside it, or where the cylinder ends if that is not far.
  std::array<double, 2> ends(const Branch& branch) const {
    const std::array<double, 2> all = room(branch);
    const double width = (branch.high - branch.low) / 2;
    double across = 0;
    for (const Outline& outline : branch.outlines) across = std::max(across, half_width(outline));
    const double middle = branch.along_axis ? (branch.low + branch.high) / 2 : branch.surface;
    const double beside = std::max(room_along * std::min(width, across), middle * sine() - across);
    std::array<double, 2> result;
    for (const std::size_t end : {0U, 1U}) {
      const double sign = end == 0 ? -1 : 1, from = end == 0 ? branch.low : branch.high;
      const double free = sign * (all[end] - from);
      if (free < least_room * std::min(width, across))
        refuse(branch, fmt::format("ends too near to the end of its cylinder: {:.3g} m are left", free));
      result[end] = free < 1.6 * beside ? all[end] : from + sign * beside;
    }
    return result;
  }

  /// A point of the surface where a branch begins: at a distance along the branch's x, turned about the axis.
  Eigen::Vector3d on_surface(const Branch& branch, double at, double angle) const {
    if (!branch.along_axis) return on_body(branch, at, branch.surface, angle);
    return body_.origin + branch.surface * body_.axis +
           at * (std::cos(angle) * branch.view.x + std::sin(angle) * branch.view.y);
  }

  Eigen::Vector3d on_body(const Branch& branch, double height, double distance, double angle) const {
    return body_.origin + height * body_.axis +
           distance * (std::cos(angle) * branch.view.along + std::sin(angle) * branch.view.y);
  }

  /// Gives two branches whose sides overlap along the axis, in sectors of their own, one side each from the
  /// first to the last end.
  /// @return  whether there were two that had not
  bool join_ends() {
    for (std::size_t a = 0; a < ends_.size(); ++a)
      for (std::size_t b = a + 1; b < ends_.size(); ++b) {
        const Branch &one = body_.branches[a], &other = body_.branches[b];
        if (one.along_axis != other.along_axis || ends_[b][1] < ends_[a][0] + tolerance_ ||
            ends_[b][0] > ends_[a][1] - tolerance_)
          continue;
        if (side_of(one).dot(side_of(other)) > 1 - 1e-6)
          refuse(other, "is too near to the next branch beside it");
        const std::array<double, 2> both = {std::min(ends_[a][0], ends_[b][0]),
                                            std::max(ends_[a][1], ends_[b][1])};
        const auto differs = [&](const std::array<double, 2>& known) {
          return std::abs(known[0] - both[0]) + std::abs(known[1] - both[1]) > tolerance_;
        };
        const bool changes = differs(ends_[a]) || differs(ends_[b]);
        ends_[a] = ends_[b] = both;
        if (changes) return true;
      }
    return false;
  }

  void add(const Branch& branch, const std::array<double, 2>& at) {
    if (branch.along_axis && !branch.floors.empty())
      refuse(branch, "has a floor; bores along the axis have to go through");
    const double half = std::numbers::pi / made_.request.sectors;
    BranchPlace place;
    place.corners = {on_surface(branch, at[0], -half), on_surface(branch, at[1], -half),
                     on_surface(branch, at[1], half), on_surface(branch, at[0], half)};
    for (const double end : at) add_ray(on_surface(branch, end, 0), -branch.view.along);
    for (const double floor : branch.floors) {
      const double distance = distance_of(floor);
      place.floor_radii.push_back(distance);
      add_ray(on_body(branch, at[0], distance, 0), body_.axis);
    }
    made_.places.push_back(std::move(place));
  }

  void add_ray(const Eigen::Vector3d& from, const Eigen::Vector3d& along_ray) {
    if (std::none_of(made_.request.rays.begin(), made_.request.rays.end(),
                     [&](const TurnedRequest::Ray& known) {
                       return std::abs(along(known.from) - along(from)) < tolerance_ &&
                              std::abs(radius(known.from) - radius(from)) < tolerance_ &&
                              known.along.cross(along_ray).norm() < 1e-7;
                     }))
      made_.request.rays.push_back({from, along_ray});
  }

  /// Wider than of bodies without branches, so that drawings are squeezed less on their way through.
  static constexpr int most_sectors = 16;
  static constexpr double least_at_arc = 5 * std::numbers::pi / 180;
  static constexpr double usual_core = 0.7, largest_core = 0.85, smallest_core = 0.3;
  /// Of a floor's ring: how far the column along the axis reaches there.
  static constexpr double below_floors = 0.85;
  const Brep& solid_;
  const MainBody& body_;
  double tolerance_, smallest_ = 0;
  bool is_solid_ = false;
  std::vector<std::array<double, 2>> ends_;  // along x, by branch
  BranchLayout made_;
};

}  // namespace

BranchLayout layout_of(const Brep& solid, const MainBody& body) {
  return RoomFinder(solid, body).make();
}

}  // namespace isopatch::segmentation
