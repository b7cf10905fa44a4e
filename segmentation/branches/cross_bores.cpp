#include "segmentation/branches/internal/cross_bores.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <set>
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
    if (seeds.empty() ||
        !std::all_of(seeds.begin(), seeds.end(), [&](FaceId face) { return is_bored(face); }))
      return std::nullopt;
    std::set<FaceId> left(seeds.begin(), seeds.end());
    std::vector<CrossBore> result;
    while (!left.empty()) {
      CrossBore bore;
      bore.faces = with_floors(coaxial(*left.begin()));
      for (const FaceId face : bore.faces) left.erase(face);
      look_at(bore);
      result.push_back(std::move(bore));
    }
    std::stable_sort(result.begin(), result.end(),
                     [](const CrossBore& a, const CrossBore& b) { return a.radius > b.radius; });
    return result;
  }

 private:
  Carrier carrier(FaceId face) const { return *solid_.carrier(face); }

  /// A cylinder across the stack whose wall looks at its axis.
  bool is_bored(FaceId face) const {
    const std::optional<Carrier> found = solid_.carrier(face);
    if (!found || found->kind != SurfaceKind::cylinder || std::abs(found->axis.dot(along_)) > no_slope)
      return false;
    const geometry::DomainBox box = solid_.domain(face);
    const Eigen::Vector2d uv = (box.low + box.high) / 2;
    const Eigen::Vector3d way = solid_.point(face, uv) - found->origin;
    return solid_.outward_normal(face, uv).dot(way - way.dot(found->axis) * found->axis) < 0;
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
        if (is_across(other, axis)) for_neighbours(other, add);
      });
    return result;
  }

  bool is_across(FaceId face, const Carrier& axis) const {
    const std::optional<Carrier> found = solid_.carrier(face);
    return found && found->kind == SurfaceKind::plane && found->axis.cross(axis.axis).norm() < no_slope;
  }

  /// With planes that nothing else bounds.
  std::vector<FaceId> with_floors(std::vector<FaceId> walls) const {
    std::set<FaceId> result(walls.begin(), walls.end());
    for (const FaceId wall : walls)
      for_neighbours(wall, [&](FaceId floor) {
        if (!is_across(floor, carrier(wall))) return;
        bool alone = true;
        for_neighbours(floor, [&](FaceId other) {
          alone = alone && std::find(walls.begin(), walls.end(), other) != walls.end();
        });
        if (alone) result.insert(floor);
      });
    return {result.begin(), result.end()};
  }

  /// From outside of the plane that it opens in.
  void look_at(CrossBore& bore) const {
    std::vector<FaceId> walls;
    for (const FaceId face : bore.faces)
      if (carrier(face).kind == SurfaceKind::cylinder) walls.push_back(face);
    const Carrier axis = carrier(walls.front());
    std::optional<FaceId> opening;
    for (const FaceId wall : walls) {
      bore.radius = std::max(bore.radius, carrier(wall).radius);
      for_neighbours(wall, [&](FaceId other) {
        if (std::find(bore.faces.begin(), bore.faces.end(), other) != bore.faces.end()) return;
        if (is_across(other, axis))
          opening = other;
        else if (const auto end = solid_.carrier(other))
          bore.ends.push_back(*end);
      });
    }
    if (!opening)
      throw Error(ErrorCode::unsupported, fmt::format("{} is a bore that opens in no plane across it",
                                                      describe(solid_, walls.front())));
    bore.opening = *opening;
    require_narrower(bore, walls);
    Branch& branch = bore.branch;
    branch.faces = bore.faces;
    branch.view.origin = axis.origin;
    branch.view.x = along_;
    branch.view.along = solid_.outward_normal(*opening, solid_.domain(*opening).low);
    branch.view.y = branch.view.along.cross(branch.view.x);
    branch.surface = branch.view.height(carrier(*opening).origin);
    branch.outlines = outlines_of(solid_, branch.view, walls);
    for (const FaceId face : bore.faces)
      if (carrier(face).kind == SurfaceKind::plane)
        branch.floors.push_back(branch.view.height(carrier(face).origin));
    branch.low = -bore.radius;
    branch.high = bore.radius;
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
  const Brep& solid_;
  Eigen::Vector3d along_;
  double tolerance_;
};

}  // namespace

std::optional<std::vector<CrossBore>> cross_bores(const Brep& solid, const Eigen::Vector3d& along) {
  return CrossBoreFinder(solid, along).make();
}

}  // namespace isopatch::segmentation
