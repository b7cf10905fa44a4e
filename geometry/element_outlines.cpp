#include "geometry/element_outlines.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "geometry/base/larger.hpp"
#include "geometry/surface_foot.hpp"

namespace isopatch::geometry {
namespace {

using Point = Parameter<2>;

// Of a curved edge, and how far it may be from its segments as a share of the other face.
constexpr int fewest_segments = 16;
constexpr int most_segments = 64;
constexpr double seen_bend = 1e-4;
constexpr double straight = 1e-9;  // of the range of the parameters

// A point of one surface as the other sees it.
struct OnOuter {
  Point at;  // of the nearest point
  bool is_there = false;
};

// The border of a surface's parameters as a length counted from its low corner, turning left.
class ParameterBorder {
 public:
  explicit ParameterBorder(const NurbsSurface& surface)
      : low_(surface.low()), range_(surface.high() - surface.low()) {}

  bool has(const Point& at) const {
    const Point share = (at - low_).cwiseQuotient(range_);
    return (share.array() < same).any() || (share.array() > 1 - same).any();
  }
  // The corners on the way from one place on it to another, turning left or right; none if they are one
  // place.
  ParameterPolygon corners_between(const Point& from, const Point& to, bool left) const {
    ParameterPolygon result;
    const double start = length(left ? from : to);
    double way = length(left ? to : from) - start;
    if (way < 0) way += 4;
    // Round-off must not send the way all around.
    if (way > 4 - same) return result;
    for (int k = 1; k <= 8; ++k)
      if (k > start && k < start + way) result.push_back(corner(k % 4));
    if (!left) std::reverse(result.begin(), result.end());
    return result;
  }

 private:
  static constexpr double same = 1e-6;  // as a share of the range

  // Each side has the length 1.
  double length(const Point& at) const {
    const Point share = (at - low_).cwiseQuotient(range_);
    const std::array<double, 4> away = {share[1], 1 - share[0], 1 - share[1], share[0]};
    const auto side = std::min_element(away.begin(), away.end()) - away.begin();
    const double along = side == 0   ? share[0]
                         : side == 1 ? share[1]
                         : side == 2 ? 1 - share[0]
                                     : 1 - share[1];
    return static_cast<double>(side) + along;
  }
  Point corner(int number) const {
    return low_ + range_.cwiseProduct(Point(number == 1 || number == 2, number >= 2));
  }

  Point low_, range_;
};

// One surface's lines of elements in the parameters of another one.
class Outlines {
 public:
  Outlines(const DividedSurface& inner, const DividedSurface& outer, double same_point)
      : inner_(inner), outer_(outer), border_(*outer.surface), same_point_(same_point) {
    const Eigen::Matrix3Xd& points = outer.surface->control_points();
    box_ = Eigen::AlignedBox3d(points.rowwise().minCoeff(), points.rowwise().maxCoeff());
    if (!edges_are_straight()) segments_ = segments_needed();
  }

  // An element, or what the other surface has of it; without corners where that is nothing.
  ElementOutline of_element(int i, int j) {
    if (segments_ == 1) return {{i, j}, {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)}, false};
    const Outline outline = around(i, j);
    const bool is_cut = std::any_of(outline.places.begin(), outline.places.end(),
                                    [](const OnOuter& place) { return !place.is_there; });
    return {{i, j}, what_is_there(outline), is_cut};
  }

 private:
  // The steps around an element, in the inner surface's parameters, and their places.
  struct Outline {
    std::vector<Point> on_inner;
    std::vector<OnOuter> places;
  };
  Outline around(int i, int j) {
    const int m = segments_;
    std::vector<std::pair<int, int>> steps;
    for (int k = 0; k < m; ++k) steps.emplace_back(m * i + k, m * j);
    for (int k = 0; k < m; ++k) steps.emplace_back(m * (i + 1), m * j + k);
    for (int k = 0; k < m; ++k) steps.emplace_back(m * (i + 1) - k, m * (j + 1));
    for (int k = 0; k < m; ++k) steps.emplace_back(m * i, m * (j + 1) - k);
    Outline result;
    for (const auto& [s, t] : steps) {
      result.on_inner.emplace_back(parameter(0, s), parameter(1, t));
      auto known = known_.find({s, t});
      if (known == known_.end()) known = known_.emplace(std::pair(s, t), place(result.on_inner.back())).first;
      result.places.push_back(known->second);
    }
    return result;
  }

  // Steps that are not there are replaced by the way along the other surface's border between the places
  // where the outline leaves it and comes back. Source: Weiler, Atherton 1977, of two outlines whose common
  // part is in one piece.
  ParameterPolygon what_is_there(const Outline& outline) const {
    const std::size_t count = outline.places.size();
    const auto is_there = [&](std::size_t k) { return outline.places[k % count].is_there; };
    std::size_t first = 0;
    while (first < count && !is_there(first)) ++first;
    if (first == count) return {};
    const bool left = turns_left(outline.on_inner[first], outline.places[first].at);
    ParameterPolygon result;
    std::optional<Point> left_at;
    for (std::size_t k = first; k < first + count; ++k) {
      if (is_there(k)) result.push_back(outline.places[k % count].at);
      if (is_there(k) == is_there(k + 1)) continue;
      const Point end = crossing(outline.on_inner[k % count], outline.on_inner[(k + 1) % count], is_there(k),
                                 outline.places[(is_there(k) ? k : k + 1) % count].at);
      if (left_at && border_.has(*left_at) && border_.has(end))
        for (const Point& corner : border_.corners_between(*left_at, end, left)) result.push_back(corner);
      result.push_back(end);
      left_at = is_there(k) ? std::optional(end) : std::nullopt;
    }
    return result;
  }

  // Whether outlines that turn left in the inner surface's parameters do so in the outer's.
  bool turns_left(const Point& on_inner, const Point& on_outer) const {
    const auto a = inner_.surface->jacobian(on_inner), b = outer_.surface->jacobian(on_outer);
    return Eigen::Vector3d(a.col(0))
               .cross(Eigen::Vector3d(a.col(1)))
               .dot(Eigen::Vector3d(b.col(0)).cross(Eigen::Vector3d(b.col(1)))) > 0;
  }

  // Where the line between two steps, of which one is there, ends to be there.
  Point crossing(Point from, Point to, bool from_is_there, Point near) const {
    if (!from_is_there) std::swap(from, to);
    for (int halving = 0; halving < 40; ++halving) {
      const Point middle = 0.5 * (from + to);
      const SurfaceFoot foot = surface_foot(*outer_.surface, inner_.surface->point(middle), near);
      if (is_near(foot)) {
        from = middle;
        near = foot.parameter;
      } else {
        to = middle;
      }
    }
    return near;
  }

  bool is_near(const SurfaceFoot& foot) const { return foot.distance <= 10 * same_point_; }

  OnOuter place(const Point& on_inner) {
    const Eigen::Vector3d point = inner_.surface->point(on_inner);
    if (box_.exteriorDistance(point) > 10 * same_point_) return {};
    const SurfaceFoot foot = foot_on_outer(point);
    return {foot.parameter, is_near(foot)};
  }

  double parameter(std::size_t direction, int step) const {
    const std::vector<double>& breaks = inner_.breaks[direction];
    const auto i = std::min(static_cast<std::size_t>(step / segments_), breaks.size() - 2);
    const double share = static_cast<double>(step) / segments_ - static_cast<double>(i);
    return breaks[i] + share * (breaks[i + 1] - breaks[i]);
  }

  const Point& at(int i, int j) {
    const auto known = places_.find({i, j});
    if (known != places_.end()) return known->second;
    return places_.emplace(std::pair(i, j), on_outer({parameter(0, i), parameter(1, j)})).first->second;
  }

  // Neighbours follow each other, so the last foot is a start for the next; a bad one is seen and mended.
  SurfaceFoot foot_on_outer(const Eigen::Vector3d& point) {
    const NurbsSurface& outer = *outer_.surface;
    SurfaceFoot foot = surface_foot(outer, point, last_);
    // A foot on the edge belongs to a point beyond it.
    const bool is_inside = (foot.parameter.array() > outer.low().array()).all() &&
                           (foot.parameter.array() < outer.high().array()).all();
    if (foot.distance > same_point_ && is_inside) {
      const SurfaceFoot other = surface_foot(outer, point, same_point_);
      if (other.distance < foot.distance) foot = other;
    }
    last_ = foot.parameter;
    return foot;
  }
  Point on_outer(const Point& on_inner) {
    const Eigen::Vector3d point = inner_.surface->point(on_inner);
    return continued_parameter(*outer_.surface, point, foot_on_outer(point));
  }

  bool edges_are_straight() {
    const Point range = outer_.surface->high() - outer_.surface->low();
    last_ =
        surface_foot(*outer_.surface, inner_.surface->point(inner_.surface->low()), same_point_).parameter;
    segments_ = 1;
    const auto count = [&](std::size_t d) { return static_cast<int>(inner_.breaks[d].size()); };
    const auto bends = [&](const Point& a, const Point& b, const Point& on_inner) {
      return ((on_outer(on_inner) - 0.5 * (a + b)).cwiseQuotient(range)).cwiseAbs().maxCoeff() > straight;
    };
    for (int j = 0; j < count(1); ++j)
      for (int i = 0; i < count(0); ++i) {
        const double s = parameter(0, i), t = parameter(1, j);
        if (i + 1 < count(0) && bends(at(i, j), at(i + 1, j), {0.5 * (s + parameter(0, i + 1)), t}))
          return false;
        if (j + 1 < count(1) && bends(at(i, j), at(i, j + 1), {s, 0.5 * (t + parameter(1, j + 1))}))
          return false;
      }
    return true;
  }

  // An edge in m segments is m^2 times as near to them as to its chord.
  int segments_needed() {
    const Point range = outer_.surface->high() - outer_.surface->low();
    double largest = 0;
    const auto look = [&](const Point& from, const Point& to) {
      constexpr int parts = 4;  // of edges that are there in part
      for (int k = 0; k < parts; ++k) {
        const Point low = from + k * (to - from) / parts, high = low + (to - from) / parts;
        const OnOuter a = place(low), b = place(high), middle = place(0.5 * (low + high));
        if (!a.is_there || !b.is_there || !middle.is_there) continue;
        const double bend = (middle.at - 0.5 * (a.at + b.at)).cwiseQuotient(range).norm();
        largest = larger(largest, parts * parts * bend);
      }
    };
    const std::vector<double>&u = inner_.breaks[0], &v = inner_.breaks[1];
    for (std::size_t j = 0; j < v.size(); ++j)
      for (std::size_t i = 0; i < u.size(); ++i) {
        if (i + 1 < u.size()) look({u[i], v[j]}, {u[i + 1], v[j]});
        if (j + 1 < v.size()) look({u[i], v[j]}, {u[i], v[j + 1]});
      }
    return std::clamp(static_cast<int>(std::ceil(std::sqrt(largest / seen_bend))), fewest_segments,
                      most_segments);
  }

  const DividedSurface& inner_;
  const DividedSurface& outer_;
  ParameterBorder border_;
  Eigen::AlignedBox3d box_;
  double same_point_;
  int segments_ = 1;
  Point last_ = Point::Zero();
  std::map<std::pair<int, int>, Point> places_;   // of corners, beyond the outer surface as if it continued
  std::map<std::pair<int, int>, OnOuter> known_;  // of steps along curved edges
};

}  // namespace

std::vector<ElementOutline> element_outlines(const DividedSurface& surface, const DividedSurface& other,
                                             double same_point) {
  Outlines outlines(surface, other, same_point);
  std::vector<ElementOutline> result;
  for (int j = 0; j + 1 < static_cast<int>(surface.breaks[1].size()); ++j)
    for (int i = 0; i + 1 < static_cast<int>(surface.breaks[0].size()); ++i) {
      ElementOutline outline = outlines.of_element(i, j);
      if (outline.on_other.size() >= 3) result.push_back(std::move(outline));
    }
  return result;
}

}  // namespace isopatch::geometry
