#include "segmentation/branches/internal/own_columns.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "geometry/base/error.hpp"
#include "geometry/brep/require_solid.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::SurfaceKind;

/// Beside a bore, of its radius: where a column ends that has nothing else near, how much it has at least,
/// and up to where it ends at a corner instead.
constexpr double wanted_room = 1, least_room_of_column = 0.1, nearest_corner = 3;

/// Of a wall, along the view's y.
struct Corner {
  double y;         ///< m
  bool is_upright;  ///< an edge along the stack ends there
};

/// Where a line meets a wall of the stack first.
struct Hit {
  FaceId wall;
  Eigen::Vector3d place;
};

class ColumnFinder {
 public:
  ColumnFinder(const Brep& solid, const Brep& blank, const SweepFrame& frame,
               const std::vector<CrossBore>& bores)
      : solid_(solid), blank_(blank), frame_(frame), bores_(bores), tolerance_(1e-6 * blank.size()) {}

  OwnColumns make() {
    for (const CrossBore& bore : bores_) add(bore);
    return std::move(made_);
  }

 private:
  /// Of a bore, as far as others that run beside it at the same wall need the same column.
  struct Column {
    double low, high;            ///< along its view's y, m: what bores take
    double radius;               ///< of the widest
    double most_low, most_high;  ///< where the column has to end at last
  };

  void add(const CrossBore& bore) {
    const PlanView& view = bore.branch.view;
    const Column column = column_of(bore);
    const Eigen::Vector3d start = view.point({0, (column.low + column.high) / 2}, bore.branch.surface);
    const std::optional<Hit> end = next_wall(start, -view.along);
    if (!end) return refuse(bore, 0);
    const std::vector<Corner> corners = corners_near(bore, *end);
    std::array<Line, 2> sides;
    for (const int side : {0, 1}) {
      const double y = end_beside(bore, column, side == 0 ? -1 : 1, corners);
      sides[static_cast<std::size_t>(side)] = side_at(bore, column, y, *end);
    }
    for (const Line& line : sides) draw(line);
    for (const double floor : bore.branch.floors) {
      Line across;
      for (const std::size_t i : {0U, 1U}) {
        const double from = view.height(sides[i][0]), to = view.height(sides[i][1]);
        if ((floor - from) * (floor - to) >= 0) return;  // where the column ends
        across[i] = sides[i][0] + (floor - from) / (to - from) * (sides[i][1] - sides[i][0]);
      }
      draw(across);
    }
  }

  [[noreturn]] void refuse(const CrossBore& bore, double free) const {
    throw Error(ErrorCode::unsupported, fmt::format("{} has no room beside it: {:.3g} mm to what is next",
                                                    describe(solid_, bore.faces.front()), 1e3 * free));
  }

  /// Others along the same direction that overlap with it, seen along the stack, are in its column; to those
  /// beside it, it has half of the way.
  Column column_of(const CrossBore& bore) const {
    const PlanView& view = bore.branch.view;
    Column result{bore.low.y(), bore.high.y(), bore.radius, -1e300, 1e300};
    std::vector<std::array<double, 3>> others;
    for (const CrossBore& other : bores_) {
      const PlanView& there = other.branch.view;
      if (there.along.cross(view.along).norm() > 1e-7) continue;
      const double at = (there.origin - view.origin).dot(view.y), sign = there.y.dot(view.y);
      const double one = at + sign * other.low.y(), two = at + sign * other.high.y();
      others.push_back({std::min(one, two), std::max(one, two), other.radius});
    }
    for (bool grown = true; grown;) {
      grown = false;
      for (const auto& [low, high, radius] : others) {
        if (high < result.low - tolerance_ || low > result.high + tolerance_) continue;
        grown = grown || low < result.low - tolerance_ || high > result.high + tolerance_;
        result.low = std::min(result.low, low);
        result.high = std::max(result.high, high);
        result.radius = std::max(result.radius, radius);
      }
    }
    for (const auto& [low, high, radius] : others) {
      if (high < result.low) result.most_low = std::max(result.most_low, (high + result.low) / 2);
      if (low > result.high) result.most_high = std::min(result.most_high, (low + result.high) / 2);
    }
    return result;
  }

  bool is_upright_plane(FaceId wall) const {
    const auto carrier = blank_.carrier(wall);
    return carrier && carrier->kind == SurfaceKind::plane;
  }

  /// Walls that a line meets, from a place on one: planes and cylinders along the stack.
  std::optional<Hit> next_wall(const Eigen::Vector3d& from, const Eigen::Vector3d& along) const {
    std::optional<Hit> result;
    double nearest = 1e300;
    const auto consider = [&](FaceId wall, double t) {
      if (!(t > tolerance_ && t < nearest)) return;
      const Eigen::Vector3d place = from + t * along;
      const geometry::FaceProjection found = blank_.project(wall, place);
      if (found.distance > tolerance_ || !blank_.contains(wall, found.uv)) return;
      result = Hit{wall, place};
      nearest = t;
    };
    for (const FaceId wall : frame_.walls) {
      const auto carrier = blank_.carrier(wall);
      if (!carrier) continue;
      const Eigen::Vector3d to = from - carrier->origin;
      if (carrier->kind == SurfaceKind::plane) {
        consider(wall, -to.dot(carrier->axis) / along.dot(carrier->axis));
      } else if (carrier->kind == SurfaceKind::cylinder) {
        const Eigen::Vector3d across = to - to.dot(carrier->axis) * carrier->axis;
        const double b = across.dot(along), c = across.squaredNorm() - carrier->radius * carrier->radius;
        const double root = std::sqrt(std::max(0.0, b * b - c));
        if (b * b < c) continue;
        consider(wall, -b - root);
        consider(wall, -b + root);
      }
    }
    return result;
  }

  /// Corners of the walls at both ends.
  std::vector<Corner> corners_near(const CrossBore& bore, const Hit& end) const {
    std::vector<Corner> result;
    const PlanView& view = bore.branch.view;
    const auto add = [&](const Brep& solid, FaceId face) {
      for (const auto& loop : solid.face(face).loops)
        for (const geometry::EdgeUse& use : loop) {
          const geometry::BrepEdge& edge = solid.edge(use.edge);
          if (edge.start == edge.end) continue;
          const Eigen::Vector3d way = solid.vertex(edge.end) - solid.vertex(edge.start);
          const bool is_upright = way.cross(frame_.along).norm() < tolerance_;
          for (const VertexId vertex : {edge.start, edge.end})
            result.push_back({view.flat(solid.vertex(vertex)).y(), is_upright});
        }
    };
    if (bore.opening) add(solid_, *bore.opening);
    if (is_upright_plane(end.wall)) add(blank_, end.wall);
    return result;
  }

  /// @param side  -1 or 1, along the view's y
  double end_beside(const CrossBore& bore, const Column& column, double side,
                    const std::vector<Corner>& corners) {
    const double edge = side < 0 ? -column.low : column.high;
    const double most = side < 0 ? -column.most_low : column.most_high;
    const double from = edge + least_room_of_column * bore.radius, to = edge + nearest_corner * column.radius;
    double nearest = 1e300, result = std::min(edge + wanted_room * column.radius, most);
    bool is_upright = false;
    for (const Corner& corner : corners) {
      const double at = side * corner.y;
      if (at < from || at > std::min(to, most) || at > nearest) continue;
      is_upright = corner.is_upright || (is_upright && nearest - at < tolerance_);
      result = nearest = at;
    }
    if (!is_upright) made_.end_at_corners = false;
    if (result < from) refuse(bore, result - edge);
    return side * result;
  }

  /// From the wall that a bore opens in to where its column ends.
  Line side_at(const CrossBore& bore, const Column& column, double y, const Hit& end) const {
    const PlanView& view = bore.branch.view;
    Eigen::Vector3d from = view.point({0, y}, bore.branch.surface);
    if (!bore.opening) {  // on the wall, which is round
      const Eigen::Vector3d outside = view.point({0, y}, bore.branch.surface + 2 * blank_.size());
      const std::optional<Hit> wall = next_wall(outside, -view.along);
      if (!wall) refuse(bore, 0);
      from = wall->place;
    }
    const auto carrier = blank_.carrier(end.wall);
    if (carrier->kind == SurfaceKind::cylinder && is_hollow(end.wall)) {
      const Eigen::Vector3d centre =
          carrier->origin + (from - carrier->origin).dot(frame_.along) * frame_.along;
      if (std::abs(view.flat(centre).y()) < tolerance_) {
        const double share = std::max(-column.low, column.high) / carrier->radius;
        const double turn = std::max(std::numbers::pi / 4, std::asin(std::min(1.0, (1 + share) / 2)));
        const double sign = y < 0 ? -1 : 1;
        return {from,
                centre + carrier->radius * (std::cos(turn) * view.along + sign * std::sin(turn) * view.y)};
      }
    }
    const std::optional<Hit> last = next_wall(from, -view.along);
    if (!last)
      throw Error(ErrorCode::unsupported,
                  fmt::format("{} has no straight way to its other end {:.3g} mm beside its middle",
                              describe(solid_, bore.faces.front()), 1e3 * std::abs(y)));
    return {from, last->place};
  }

  bool is_hollow(FaceId wall) const {
    const geometry::DomainBox box = blank_.domain(wall);
    const Eigen::Vector2d uv = (box.low + box.high) / 2;
    return blank_.outward_normal(wall, uv).dot(blank_.point(wall, uv) - blank_.carrier(wall)->origin) < 0;
  }

  void draw(const Line& line) {
    const auto flat = [&](const Eigen::Vector3d& p) { return frame_.flat(p); };
    if (std::any_of(made_.lines.begin(), made_.lines.end(), [&](const Line& known) {
          return (flat(known[0]) - flat(line[0])).norm() + (flat(known[1]) - flat(line[1])).norm() <
                 tolerance_;
        }))
      return;
    made_.lines.push_back(line);
  }

  const Brep& solid_;
  const Brep& blank_;
  const SweepFrame& frame_;
  const std::vector<CrossBore>& bores_;
  double tolerance_;
  OwnColumns made_;
};

}  // namespace

OwnColumns own_columns(const Brep& solid, const Brep& blank, const SweepFrame& frame,
                       const std::vector<CrossBore>& bores) {
  return ColumnFinder(solid, blank, frame, bores).make();
}

}  // namespace isopatch::segmentation
