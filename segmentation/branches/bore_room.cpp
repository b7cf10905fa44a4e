#include "segmentation/branches/internal/bore_room.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "segmentation/branches/internal/own_columns.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;

/// What features take of a line.
struct Interval {
  double low, high;
  double radius;  ///< of the widest bore across; 0 where there is none
};

constexpr double quarter = std::numbers::pi / 2;
/// Beside a bore, of its radius: where a plane is put that has nothing else near.
constexpr double beside = 1;
/// Likewise: how much is left there at least.
constexpr double least_beside = 0.1;
/// Likewise: how near a vertex is that a plane goes through instead.
constexpr double near_vertex = 0.5;
/// Up to this, no plane is put between a bore and the end.
constexpr double near_end = 2;

std::vector<Interval> merged(std::vector<Interval> intervals) {
  std::sort(intervals.begin(), intervals.end(),
            [](const Interval& a, const Interval& b) { return a.low < b.low; });
  std::vector<Interval> result;
  for (const Interval& next : intervals) {
    if (result.empty() || next.low > result.back().high) {
      result.push_back(next);
      continue;
    }
    result.back().high = std::max(result.back().high, next.high);
    result.back().radius = std::max(result.back().radius, next.radius);
  }
  return result;
}

/// Coordinates of the planes that separate bores along an axis: between neighbouring intervals of which at
/// least one is of a bore across, and beside the first and the last.
std::vector<double> separators(const std::vector<Interval>& merged, double low, double high) {
  std::vector<double> result;
  const auto at_end = [&](const Interval& last, double free, double sign, double from) {
    if (last.radius > 0 && free > near_end * last.radius)
      result.push_back(from + sign * beside * last.radius);
  };
  for (std::size_t i = 0; i < merged.size(); ++i) {
    if (i == 0) at_end(merged[i], merged[i].low - low, -1, merged[i].low);
    if (i + 1 == merged.size()) {
      at_end(merged[i], high - merged[i].high, 1, merged[i].high);
      continue;
    }
    const Interval &one = merged[i], &next = merged[i + 1];
    const double gap = next.low - one.high, wanted = beside * (one.radius + next.radius);
    if (wanted == 0) continue;
    if (gap < 1.5 * wanted || one.radius == 0 || next.radius == 0) {
      const double share = one.radius == 0    ? 0.75
                           : next.radius == 0 ? 0.25
                                              : one.radius / (one.radius + next.radius);
      result.push_back(gap < 1.5 * wanted ? one.high + (0.25 + 0.5 * share) * gap
                       : one.radius == 0  ? next.low - beside * next.radius
                                          : one.high + beside * one.radius);
    } else {
      result.push_back(one.high + beside * one.radius);
      result.push_back(next.low - beside * next.radius);
    }
  }
  return result;
}

class BoreRoomFinder {
 public:
  BoreRoomFinder(const Brep& solid, const Brep& blank, const SweepFrame& frame,
                 const std::vector<CrossBore>& bores, FloorLines floors)
      : solid_(solid),
        blank_(blank),
        frame_(frame),
        bores_(bores),
        floors_(floors),
        tolerance_(1e-6 * blank.size()) {}

  BoreRoom make() {
    find_heights();
    if (floors_ == FloorLines::own_columns) {
      made_.lines = own_columns(solid_, blank_, frame_, bores_).lines;
      return std::move(made_);
    }
    std::vector<Eigen::Vector3d> done;
    for (const CrossBore& bore : bores_) {
      const Eigen::Vector3d& direction = bore.branch.view.along;
      if (std::any_of(done.begin(), done.end(),
                      [&](const Eigen::Vector3d& known) { return known.cross(direction).norm() < 1e-7; }))
        continue;
      done.push_back(direction);
      draw_strips(direction);
    }
    const std::vector<Line> strips = made_.lines;
    for (const CrossBore& bore : bores_)
      for (const double floor : bore.branch.floors) draw_floor(bore, floor, strips);
    const std::vector<Line> grid = made_.lines;
    for (const FaceId wall : frame_.walls) draw_spokes(wall, grid);
    return std::move(made_);
  }

 private:
  std::array<double, 2> extent(const Eigen::Vector3d& direction) const {
    std::array<double, 2> result = {1e300, -1e300};
    for (int e = 0; e < static_cast<int>(blank_.edges().size()); ++e)
      for (int i = 0; i <= 8; ++i) {
        const double at = (blank_.point(EdgeId(e), i / 8.0) - frame_.origin).dot(direction);
        result = {std::min(result[0], at), std::max(result[1], at)};
      }
    return result;
  }

  /// A plane beside bores along a direction goes through a vertex of a face that they open in, where one is
  /// near: else there would be thin hexahedra between.
  double at_a_vertex(double at, const Eigen::Vector3d& across, const Eigen::Vector3d& direction) const {
    double best = at, nearest = 1e300;
    for (const CrossBore& bore : bores_) {
      if (!bore.opening || bore.branch.view.along.cross(direction).norm() > 1e-7) continue;
      for (const auto& loop : solid_.face(*bore.opening).loops)
        for (const geometry::EdgeUse& use : loop) {
          const geometry::BrepEdge& edge = solid_.edge(use.edge);
          if (edge.start == edge.end) continue;
          const double place = (solid_.vertex(edge.start) - frame_.origin).dot(across);
          const double distance = std::abs(place - at);
          if (distance < std::min(nearest, near_vertex * bore.radius)) best = place, nearest = distance;
        }
    }
    return best;
  }

  Interval interval(const CrossBore& bore, const Eigen::Vector3d& direction) const {
    const PlanView& view = bore.branch.view;
    const Eigen::Vector2d way(view.x.dot(direction), view.y.dot(direction));
    const double at = (view.origin - frame_.origin).dot(direction);
    const double one = way.dot(bore.low), other = way.dot(bore.high);
    return {at + std::min(one, other), at + std::max(one, other), bore.radius};
  }

  void find_heights() {
    std::vector<Interval> all;
    for (const CrossBore& bore : bores_) {
      all.push_back(interval(bore, frame_.along));
      made_.kept_free.push_back(
          {all.back().low - least_beside * bore.radius, all.back().high + least_beside * bore.radius});
    }
    const auto [low, high] = extent(frame_.along);
    made_.heights = separators(merged(std::move(all)), low, high);
  }

  /// Lines along a direction of bores, between them and beside bores along the stack.
  void draw_strips(const Eigen::Vector3d& direction) {
    const Eigen::Vector3d across = frame_.along.cross(direction);
    std::vector<Interval> all;
    for (const CrossBore& bore : bores_)
      if (bore.branch.view.along.cross(direction).norm() < 1e-7) all.push_back(interval(bore, across));
    for (const FaceId wall : frame_.walls) {
      const auto carrier = blank_.carrier(wall);
      if (!carrier || carrier->kind != geometry::SurfaceKind::cylinder || !is_hollow(wall)) continue;
      const double at = (carrier->origin - frame_.origin).dot(across);
      all.push_back({at - carrier->radius, at + carrier->radius, 0});
    }
    const auto [low, high] = extent(across);
    for (const double at : separators(merged(std::move(all)), low, high))
      draw(frame_.origin + at_a_vertex(at, across, direction) * across, direction);
    if (floors_ == FloorLines::through_all) return;
    const std::vector<Line> strips = made_.lines;
    for (const CrossBore& bore : bores_)
      if (bore.branch.view.along.cross(direction).norm() < 1e-7) draw_ends_of_opening(bore, across, strips);
  }

  /// Draws the lines at which the plane that a bore opens in ends, where they come before the next plane.
  void draw_ends_of_opening(const CrossBore& bore, const Eigen::Vector3d& across,
                            const std::vector<Line>& strips) {
    if (!bore.opening) return;
    const Interval taken = interval(bore, across);
    const double middle = (taken.low + taken.high) / 2;
    const Eigen::Vector3d centre =
        bore.branch.view.point({0, 0}, 0) +
        (middle - (bore.branch.view.point({0, 0}, 0) - frame_.origin).dot(across)) * across;
    const std::array<double, 2> free = cell(centre, across, strips);
    for (const double side : {-1.0, 1.0}) {
      const double end = side * ((side < 0 ? taken.low : taken.high) - middle);
      const double limit = side * free[side < 0 ? 0 : 1], from = end + least_beside * bore.radius;
      double nearest = limit - tolerance_;
      std::optional<Eigen::Vector3d> corner;
      for (const auto& loop : solid_.face(*bore.opening).loops)
        for (const geometry::EdgeUse& use : loop) {
          const Eigen::Vector3d place = solid_.vertex(solid_.edge(use.edge).start);
          const double at = side * ((place - frame_.origin).dot(across) - middle);
          if (at > from && at < nearest) corner = place, nearest = at;
        }
      if (!corner) continue;
      // What is narrow beyond is bent round: room is left for a row along it.
      const double back = limit - nearest < beside * bore.radius ? (nearest - end) / 2 : 0;
      draw(*corner - side * back * across, bore.branch.view.along);
    }
  }

  bool is_hollow(FaceId wall) const {
    const geometry::DomainBox box = blank_.domain(wall);
    const Eigen::Vector2d uv = (box.low + box.high) / 2;
    return blank_.outward_normal(wall, uv).dot(blank_.point(wall, uv) - blank_.carrier(wall)->origin) < 0;
  }

  /// From a bore along the stack to the corners of its cell in the grid, so that bores across find room
  /// between them.
  void draw_spokes(FaceId wall, const std::vector<Line>& grid) {
    const auto carrier = blank_.carrier(wall);
    if (!carrier || carrier->kind != geometry::SurfaceKind::cylinder || !is_hollow(wall)) return;
    std::optional<Eigen::Vector3d> up;
    std::array<double, 4> share = {0, 0, 0, 0};  // of the radius, that bores from each side take
    for (const CrossBore& bore : bores_) {
      const PlanView& view = bore.branch.view;
      if (!ends_in(bore, carrier->radius, carrier->origin)) continue;
      if (!up) up = view.along;
      const Eigen::Vector3d side = frame_.along.cross(*up);
      const double along = view.along.dot(*up), across = view.along.dot(side);
      if (std::abs(along * across) > 1e-7) return;
      double& taken = share[along > 0.5 ? 0 : across > 0.5 ? 1 : along < -0.5 ? 2 : 3];
      taken = std::max(taken, smallest_radius(bore) / carrier->radius);
    }
    if (!up) return;
    const Eigen::Vector3d side = frame_.along.cross(*up);
    const Eigen::Vector3d centre = frame_.point(frame_.flat(carrier->origin), 0);
    const std::array<double, 2> rows = cell(centre, *up, grid), columns = cell(centre, side, grid);
    for (const std::size_t i : {0U, 1U, 2U, 3U}) {
      const double angle = angle_between(share[i], share[(i + 1) % 4]);
      const double turn = static_cast<double>(i) * quarter + angle;
      const Eigen::Vector3d foot = centre + carrier->radius * (std::cos(turn) * *up + std::sin(turn) * side);
      const Eigen::Vector3d corner =
          centre + (i == 0 || i == 3 ? rows[1] : rows[0]) * *up + (i < 2 ? columns[1] : columns[0]) * side;
      made_.lines.push_back({foot, corner});
    }
  }

  /// From the middle of a side of a bore to the next side, where bores of a share of its radius end in both.
  static double angle_between(double share, double next) {
    if (share == 0 && next == 0) return quarter / 2;
    if (next == 0) return angle_for(share);
    if (share == 0) return quarter - angle_for(next);
    const double least = std::asin(share), most = quarter - std::asin(next);
    return (least + most) / 2;
  }

  static double angle_for(double share) {
    return std::max(quarter / 2, std::asin(std::min(1.0, (1 + share) / 2)));
  }

  static double smallest_radius(const CrossBore& bore) {
    double result = bore.radius;
    if (bore.is_slot) return result;
    for (const Outline& outline : bore.branch.outlines)
      result = std::min(result, (outline.curves.front().from - outline.curves.front().centre).norm());
    return result;
  }

  /// Whether a bore goes as far as one along the stack, and not beyond.
  bool ends_in(const CrossBore& bore, double radius, const Eigen::Vector3d& axis) const {
    const PlanView& view = bore.branch.view;
    if (std::abs(view.flat(axis).y()) > tolerance_) return false;
    return std::any_of(bore.ends.begin(), bore.ends.end(), [&](const geometry::Carrier& end) {
      return end.kind == geometry::SurfaceKind::cylinder && std::abs(end.radius - radius) < tolerance_ &&
             (end.origin - axis).cross(frame_.along).norm() < tolerance_;
    });
  }

  /// From the nearest line or end below a place to the nearest above, relative to it.
  std::array<double, 2> cell(const Eigen::Vector3d& centre, const Eigen::Vector3d& direction,
                             const std::vector<Line>& grid) const {
    std::array<double, 2> result = extent(direction);
    for (double& end : result) end -= (centre - frame_.origin).dot(direction);
    for (const Line& line : grid) {
      if (std::abs((line[1] - line[0]).normalized().dot(direction)) > 1e-7) continue;
      const double at = (line[0] - centre).dot(direction);
      if (at < 0) result[0] = std::max(result[0], at);
      if (at > 0) result[1] = std::min(result[1], at);
    }
    return result;
  }

  /// A floor's line, which ends at the planes beside the bore where that is asked for.
  void draw_floor(const CrossBore& bore, double floor, const std::vector<Line>& strips) {
    const PlanView& view = bore.branch.view;
    const Eigen::Vector3d middle = view.point({0, 0}, floor);
    const std::array<double, 2> beside = cell(middle, view.y, strips);
    if (floors_ == FloorLines::through_all)
      draw(middle, view.y);
    else
      made_.lines.push_back({middle + beside[0] * view.y, middle + beside[1] * view.y});
  }

  /// Draws a line through the whole drawing, unless it is there already.
  void draw(const Eigen::Vector3d& through, const Eigen::Vector3d& direction) {
    const Eigen::Vector2d from = frame_.flat(through);
    if (std::any_of(made_.lines.begin(), made_.lines.end(), [&](const Line& line) {
          const Eigen::Vector2d a = frame_.flat(line[0]), way = (frame_.flat(line[1]) - a).normalized();
          return (line[1] - line[0]).normalized().cross(direction).norm() < 1e-7 &&
                 std::abs(way.x() * (from - a).y() - way.y() * (from - a).x()) < tolerance_;
        }))
      return;
    const Eigen::Vector3d centre = blank_.vertices().rowwise().mean();
    const Eigen::Vector3d middle = through + (centre - through).dot(direction) * direction;
    made_.lines.push_back({middle - blank_.size() * direction, middle + blank_.size() * direction});
  }

  const Brep& solid_;
  const Brep& blank_;
  const SweepFrame& frame_;
  const std::vector<CrossBore>& bores_;
  FloorLines floors_;
  double tolerance_;
  BoreRoom made_;
};

}  // namespace

BoreRoom bore_room(const Brep& solid, const Brep& blank, const SweepFrame& frame,
                   const std::vector<CrossBore>& bores, FloorLines floors) {
  return BoreRoomFinder(solid, blank, frame, bores, floors).make();
}

}  // namespace isopatch::segmentation
