#include "segmentation/branches/internal/cross_bores.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>
#include <tuple>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/brep/require_solid.hpp"
#include "segmentation/sweeps/sweep_frame.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::Carrier;
using geometry::SurfaceKind;

constexpr double no_slope = 1e-7;

class CrossBoreFinder {
 public:
  CrossBoreFinder(const Brep& solid, const Eigen::Vector3d& along)
      : solid_(solid), along_(along), tolerance_(1e-6 * solid.size()) {}

  std::optional<std::vector<CrossBore>> make() {
    std::vector<FaceId> seeds = neither_floor_nor_wall(solid_, along_);
    if (seeds.empty()) return std::nullopt;
    std::set<FaceId> left(seeds.begin(), seeds.end());
    std::vector<CrossBore> result;
    for (const FaceId seed : seeds) {
      if (!left.contains(seed) || !is_stud(seed)) continue;
      std::optional<CrossBore> boss = boss_about(seed);
      if (!boss) return std::nullopt;
      for (const FaceId face : boss->faces) left.erase(face);
      result.push_back(*std::move(boss));
    }
    while (!left.empty()) {
      const auto direction = direction_of(*left.begin());
      if (!direction) return std::nullopt;
      CrossBore bore;
      std::vector<FaceId> walls = walls_around(*left.begin(), *direction);
      bore.is_slot = !std::all_of(walls.begin(), walls.end(), [&](FaceId face) {
        return is_bored(face) && is_about(face, *solid_.carrier(walls.front()));
      });
      if (!bore.is_slot)
        walls = coaxial(*left.begin());
      else if (!are_closed(walls, *direction) || !look_inwards(walls))
        return std::nullopt;
      bore.faces = with_floors(walls, *direction);
      for (const FaceId face : bore.faces) left.erase(face);
      look_at(bore, walls, *direction);
      result.push_back(std::move(bore));
    }
    std::stable_sort(result.begin(), result.end(),
                     [](const CrossBore& a, const CrossBore& b) { return a.radius > b.radius; });
    return result;
  }

 private:
  Carrier carrier(FaceId face) const { return *solid_.carrier(face); }

  /// A cylinder across the stack whose wall looks at its axis.
  bool is_bored(FaceId face) const { return looks_out(face) < 0; }

  /// Of a cylinder across the stack: whether its wall looks away from its axis (1) or at it (-1); 0 of
  /// others.
  int looks_out(FaceId face) const {
    const std::optional<Carrier> found = solid_.carrier(face);
    if (!found || found->kind != SurfaceKind::cylinder || std::abs(found->axis.dot(along_)) > no_slope)
      return 0;
    const geometry::DomainBox box = solid_.domain(face);
    const Eigen::Vector2d uv = (box.low + box.high) / 2;
    const Eigen::Vector3d way = solid_.point(face, uv) - found->origin;
    return solid_.outward_normal(face, uv).dot(way - way.dot(found->axis) * found->axis) < 0 ? -1 : 1;
  }

  /// A cylinder across the stack that looks outwards all around.
  bool is_stud(FaceId face) const {
    if (looks_out(face) <= 0) return false;
    const Carrier axis = carrier(face);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();  // of a whole circle, nothing
    double length = 0;
    for (const auto& loop : solid_.face(face).loops)
      for (const geometry::EdgeUse& use : loop)
        if (solid_.edge(use.edge).start == solid_.edge(use.edge).end) return true;
    constexpr int steps = 16;
    const geometry::DomainBox box = solid_.domain(face);
    for (int i = 0; i < steps; ++i) {
      const Eigen::Vector2d share((i + 0.5) / steps, 0.5);
      const Eigen::Vector3d way =
          solid_.point(face, box.low + share.cwiseProduct(box.high - box.low)) - axis.origin;
      sum += way - way.dot(axis.axis) * axis.axis;
      length += axis.radius;
    }
    return sum.norm() < 1e-3 * length;
  }

  /// Whether a face is turned about an axis; a plane across it only if nothing else bounds it.
  bool is_turned_about(FaceId face, const Carrier& axis) const {
    const std::optional<Carrier> found = solid_.carrier(face);
    if (!found) return false;
    const bool along = found->axis.cross(axis.axis).norm() < no_slope;
    const bool centred = (found->origin - axis.origin).cross(axis.axis).norm() < tolerance_;
    if (found->kind != SurfaceKind::plane) return centred && (along || found->kind == SurfaceKind::sphere);
    if (!along) return false;
    bool result = true;
    for_neighbours(face, [&](FaceId other) {
      const std::optional<Carrier> beside = solid_.carrier(other);
      result = result && beside && beside->kind != SurfaceKind::plane &&
               (beside->origin - axis.origin).cross(axis.axis).norm() < tolerance_;
    });
    return result;
  }

  /// The boss that a face belongs to, with all faces that are joined to it and turned about its axis; nothing
  /// if it stands on no plane across the axis.
  std::optional<CrossBore> boss_about(FaceId first) const {
    const Carrier axis = carrier(first);
    CrossBore boss;
    boss.is_boss = true;
    boss.faces = {first};
    for (std::size_t done = 0; done < boss.faces.size(); ++done)
      for_neighbours(boss.faces[done], [&](FaceId other) {
        if (is_turned_about(other, axis) &&
            std::find(boss.faces.begin(), boss.faces.end(), other) == boss.faces.end())
          boss.faces.push_back(other);
      });
    std::sort(boss.faces.begin(), boss.faces.end());
    const auto stands_on = foot_of(boss.faces, axis.axis);
    if (!stands_on) return std::nullopt;
    boss.opening = stands_on->other;
    Branch& branch = boss.branch;
    branch.faces = boss.faces;
    branch.view.origin = axis.origin;
    branch.view.x = along_;
    branch.view.along = stands_on->outwards > 0 ? axis.axis : Eigen::Vector3d(-axis.axis);
    branch.view.y = branch.view.along.cross(branch.view.x);
    branch.surface = branch.view.height(carrier(stands_on->other).origin);
    find_below(boss);
    return boss;
  }

  /// Where a bore or a boss meets what is none of it.
  struct Rim {
    FaceId wall, other;
    double outwards;  ///< cosine of the angle between the bore's direction and where the other face looks
    double height;    ///< along the direction, m
  };

  /// Where walls that look outwards meet a plane across them.
  std::optional<Rim> foot_of(const std::vector<FaceId>& faces, const Eigen::Vector3d& direction) const {
    for (const Rim& rim : rims_of(faces, faces, direction))
      if (looks_out(rim.wall) > 0 && is_across(rim.other, direction)) return rim;
    return std::nullopt;
  }

  /// Outlines and floors of what a boss has at its foot and below.
  void find_below(CrossBore& boss) const {
    Branch& branch = boss.branch;
    std::vector<FaceId> walls;
    for (const FaceId face : boss.faces) {
      double low = 1e300;
      for (const auto& loop : solid_.face(face).loops)
        for (const geometry::EdgeUse& use : loop)
          low = std::min(low, branch.view.height(solid_.point(use.edge, 0.37)));
      if (low > branch.surface + tolerance_) continue;
      if (is_wall(solid_, face, branch.view.along))
        walls.push_back(face);
      else if (low < branch.surface - tolerance_ && is_across(face, branch.view.along))
        branch.floors.push_back(low);
      else
        throw Error(ErrorCode::unsupported,
                    fmt::format("{} is neither wall nor floor of a boss", describe(solid_, face)));
    }
    branch.outlines = outlines_of(solid_, branch.view, walls);
    std::tie(boss.low, boss.high) = box_of_bores(walls);
    boss.radius = boss.high.x();
    branch.low = boss.low.x();
    branch.high = boss.high.x();
  }

  /// Along which a face runs, at right angles to the stack.
  std::optional<Eigen::Vector3d> direction_of(FaceId face) const {
    if (is_bored(face)) return carrier(face).axis;
    for (const auto& loop : solid_.face(face).loops)
      for (const geometry::EdgeUse& use : loop) {
        const Eigen::Vector3d way = solid_.tangent(use.edge, 0.5).normalized();
        if (std::abs(way.dot(along_)) < no_slope && is_straight_along(solid_, use.edge, way) &&
            runs_along(solid_, face, way))
          return way;
      }
    return std::nullopt;
  }

  /// With all that follow each other across edges along a direction.
  std::vector<FaceId> walls_around(FaceId first, const Eigen::Vector3d& direction) const {
    std::vector<FaceId> result = {first};
    for (std::size_t done = 0; done < result.size(); ++done)
      for_sideways(result[done], direction, [&](FaceId other) {
        if (std::find(result.begin(), result.end(), other) == result.end() &&
            runs_along(solid_, other, direction))
          result.push_back(other);
      });
    return result;
  }

  /// Whether walls have none but themselves across edges along a direction.
  bool are_closed(const std::vector<FaceId>& walls, const Eigen::Vector3d& direction) const {
    bool result = true;
    for (const FaceId wall : walls)
      for_sideways(wall, direction, [&](FaceId other) {
        result = result && std::find(walls.begin(), walls.end(), other) != walls.end();
      });
    return result;
  }

  /// Whether the highest walls along the stack look down: around a slot, not around the solid.
  bool look_inwards(const std::vector<FaceId>& walls) const {
    std::vector<std::pair<double, double>> looks;  // height, and how far up it looks there
    constexpr int steps = 9;
    for (const FaceId wall : walls) {
      const geometry::DomainBox box = solid_.domain(wall);
      for (int i = 0; i < steps * steps; ++i) {
        const int row = i / steps;
        const Eigen::Vector2d share((i % steps + 0.5) / steps, (row + 0.5) / steps);
        const Eigen::Vector2d uv = box.low + share.cwiseProduct(box.high - box.low);
        looks.emplace_back(solid_.point(wall, uv).dot(along_), solid_.outward_normal(wall, uv).dot(along_));
      }
    }
    const auto [lowest, highest] = std::minmax_element(looks.begin(), looks.end());
    const double near_top = highest->first - 0.05 * (highest->first - lowest->first);
    double sum = 0;
    for (const auto& [height, up] : looks) sum += height > near_top ? up : 0;
    return sum < 0;
  }

  /// Neighbours across edges along a direction.
  template <class Take>
  void for_sideways(FaceId face, const Eigen::Vector3d& direction, const Take& take) const {
    for (const auto& loop : solid_.face(face).loops)
      for (const geometry::EdgeUse& use : loop)
        if (is_straight_along(solid_, use.edge, direction))
          for (const FaceId other : solid_.edge(use.edge).faces) take(other);
  }

  template <class Take>
  void for_neighbours(FaceId face, const Take& take) const {
    for (const auto& loop : solid_.face(face).loops)
      for (const geometry::EdgeUse& use : loop)
        for (const FaceId other : solid_.edge(use.edge).faces)
          if (other != face) take(other);
  }

  bool is_about(FaceId face, const Carrier& axis) const {
    const Carrier other = carrier(face);
    return other.axis.cross(axis.axis).norm() < no_slope &&
           (other.origin - axis.origin).cross(axis.axis).norm() < tolerance_;
  }

  /// Cylinders about one axis that hang together, by floors between them as well.
  std::vector<FaceId> coaxial(FaceId first) const {
    const Carrier axis = carrier(first);
    std::vector<FaceId> result = {first};
    const auto add = [&](FaceId face) {
      if (is_bored(face) && is_about(face, axis) &&
          std::find(result.begin(), result.end(), face) == result.end())
        result.push_back(face);
    };
    std::size_t done = 0;
    while (done < result.size())
      for_neighbours(result[done++], [&](FaceId other) {
        add(other);
        if (is_across(other, axis.axis)) for_neighbours(other, add);
      });
    return result;
  }

  bool is_across(FaceId face, const Eigen::Vector3d& direction) const {
    const std::optional<Carrier> found = solid_.carrier(face);
    return found && found->kind == SurfaceKind::plane && found->axis.cross(direction).norm() < no_slope;
  }

  /// With planes that nothing else bounds.
  std::vector<FaceId> with_floors(const std::vector<FaceId>& walls, const Eigen::Vector3d& direction) const {
    std::set<FaceId> result(walls.begin(), walls.end());
    for (const FaceId wall : walls)
      for_neighbours(wall, [&](FaceId floor) {
        if (!is_across(floor, direction)) return;
        bool alone = true;
        for_neighbours(floor, [&](FaceId other) {
          alone = alone && std::find(walls.begin(), walls.end(), other) != walls.end();
        });
        if (alone) result.insert(floor);
      });
    return {result.begin(), result.end()};
  }

  /// @param faces  what is no rim's other side
  std::vector<Rim> rims_of(const std::vector<FaceId>& faces, const std::vector<FaceId>& walls,
                           const Eigen::Vector3d& direction) const {
    std::vector<Rim> result;
    for (const FaceId wall : walls)
      for (const auto& loop : solid_.face(wall).loops)
        for (const geometry::EdgeUse& use : loop)
          for (const FaceId other : solid_.edge(use.edge).faces) {
            if (std::find(faces.begin(), faces.end(), other) != faces.end()) continue;
            const Eigen::Vector3d place = solid_.point(use.edge, 0.37);
            result.push_back({wall, other,
                              solid_.outward_normal(other, solid_.project(other, place).uv).dot(direction),
                              place.dot(direction)});
          }
    return result;
  }

  /// Seen from outside of the plane that it opens in, or else from where its walls go up to walls of the
  /// stack.
  void look_at(CrossBore& bore, const std::vector<FaceId>& walls, const Eigen::Vector3d& direction) const {
    const std::vector<Rim> rims = rims_of(bore.faces, walls, direction);
    const Rim* from = nullptr;
    for (const Rim& rim : rims) {
      const bool flat = is_across(rim.other, direction);
      if (flat) bore.opening = rim.other;
      if (flat)
        from = &rim;
      else if (const auto end = solid_.carrier(rim.other); end && !is_outside(rim.other))
        bore.ends.push_back(*end);
    }
    if (!from)
      for (const Rim& rim : rims)
        if (is_opened_in(rim.other) && std::abs(rim.outwards) > least_facing) from = &rim;
    if (!from)
      throw Error(ErrorCode::unsupported, fmt::format("{} is a bore that opens in no wall across it",
                                                      describe(solid_, walls.front())));
    Branch& branch = bore.branch;
    branch.faces = bore.faces;
    branch.view.origin = solid_.carrier(walls.front())
                             ? carrier(walls.front()).origin
                             : solid_.point(solid_.face(walls.front()).loops[0][0].edge, 0.5);
    branch.view.x = along_;
    branch.view.along = from->outwards > 0 ? direction : Eigen::Vector3d(-direction);
    branch.view.y = branch.view.along.cross(branch.view.x);
    if (bore.is_slot)
      branch.view.origin = branch.view.point(middle_of(outlines_of(solid_, branch.view, walls)), 0);
    branch.surface = (from->outwards > 0 ? 1 : -1) * from->height - branch.view.origin.dot(branch.view.along);
    branch.outlines = outlines_of(solid_, branch.view, walls);
    for (const FaceId face : bore.faces)
      if (is_across(face, direction)) branch.floors.push_back(branch.view.height(carrier(face).origin));
    std::tie(bore.low, bore.high) = bore.is_slot ? box_of(branch.outlines) : box_of_bores(walls);
    bore.radius = (bore.high - bore.low).minCoeff() / 2;
    branch.low = bore.low.x();
    branch.high = bore.high.x();
    if (!bore.is_slot) require_narrower(bore, walls);
  }

  /// A wall of the stack, but none of a bore along it.
  bool is_opened_in(FaceId face) const {
    if (!runs_along(solid_, face, along_)) return false;
    const std::optional<Carrier> found = solid_.carrier(face);
    return !found || found->kind == SurfaceKind::plane || is_outside(face);
  }

  /// A cylinder along the stack that looks away from its axis.
  bool is_outside(FaceId face) const {
    const std::optional<Carrier> found = solid_.carrier(face);
    if (!found || found->kind != SurfaceKind::cylinder || found->axis.cross(along_).norm() > no_slope)
      return false;
    const geometry::DomainBox box = solid_.domain(face);
    const Eigen::Vector2d uv = (box.low + box.high) / 2;
    return solid_.outward_normal(face, uv).dot(solid_.point(face, uv) - found->origin) > 0;
  }

  std::pair<Eigen::Vector2d, Eigen::Vector2d> box_of_bores(const std::vector<FaceId>& walls) const {
    double radius = 0;
    for (const FaceId wall : walls) radius = std::max(radius, carrier(wall).radius);
    return {Eigen::Vector2d::Constant(-radius), Eigen::Vector2d::Constant(radius)};
  }

  static std::pair<Eigen::Vector2d, Eigen::Vector2d> box_of(const std::vector<Outline>& outlines) {
    Eigen::Vector2d low(1e300, 1e300), high(-1e300, -1e300);
    constexpr int steps = 256;
    for (const Outline& outline : outlines)
      for (const PlanCurve& curve : outline.curves)
        for (int i = 0; i <= steps; ++i) {
          low = low.cwiseMin(curve.point(static_cast<double>(i) / steps));
          high = high.cwiseMax(curve.point(static_cast<double>(i) / steps));
        }
    return {low, high};
  }

  static Eigen::Vector2d middle_of(const std::vector<Outline>& outlines) {
    const auto [low, high] = box_of(outlines);
    return (low + high) / 2;
  }

  /// Than bores along the stack that it ends in.
  void require_narrower(const CrossBore& bore, const std::vector<FaceId>& walls) const {
    for (const FaceId wall : walls)
      for_neighbours(wall, [&](FaceId other) {
        const std::optional<Carrier> end = solid_.carrier(other);
        if (std::find(bore.faces.begin(), bore.faces.end(), other) == bore.faces.end() && end &&
            end->kind == SurfaceKind::cylinder && end->axis.cross(along_).norm() < no_slope &&
            carrier(wall).radius > largest_share * end->radius)
          throw Error(ErrorCode::unsupported, fmt::format("{} is as wide as {}, in which it ends, or wider",
                                                          describe(solid_, wall), describe(solid_, other)));
      });
  }

  /// Of the radius of a bore that one ends in.
  static constexpr double largest_share = 0.97;
  /// Cosine of the angle between a bore and the wall's normal that it opens in.
  static constexpr double least_facing = 0.3;
  const Brep& solid_;
  Eigen::Vector3d along_;
  double tolerance_;
};

}  // namespace

std::optional<std::vector<CrossBore>> cross_bores(const Brep& solid, const Eigen::Vector3d& along) {
  return CrossBoreFinder(solid, along).make();
}

}  // namespace isopatch::segmentation
