#include "geometry/common_refinement.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/element_outlines.hpp"
#include "geometry/parameter_polygon.hpp"
#include "geometry/quadrature.hpp"
#include "geometry/surface_foot.hpp"

namespace isopatch::geometry {
namespace {

using Point = Parameter<2>;

bool lies_within(const NurbsSurface& surface, const NurbsSurface& other, double same_point) {
  for (const double s : {0.0, 0.5, 1.0})
    for (const double t : {0.0, 0.5, 1.0}) {
      const Point at = surface.low() + Point(s, t).cwiseProduct(surface.high() - surface.low());
      if (surface_foot(other, surface.point(at), same_point).distance > 10 * same_point) return false;
    }
  return true;
}

constexpr double beside_outlines = 1e-3;  // of the area, where chords stand for curved outlines

constexpr double much_smaller = 0.25;
constexpr double equal_size = 0.999;  // of elements

// About its area: that of the parallelogram of its tangents in the middle.
double rough_area(const NurbsSurface& surface) {
  const Point range = surface.high() - surface.low();
  const auto tangents = surface.jacobian(Point(surface.low() + 0.5 * range));
  return range.prod() * Eigen::Vector3d(tangents.col(0)).cross(Eigen::Vector3d(tangents.col(1))).norm();
}

double elements(const DividedSurface& divided) {
  return static_cast<double>((divided.breaks[0].size() - 1) * (divided.breaks[1].size() - 1));
}

// Whether the second is the one whose elements are taken into the other's parameters: that within the other,
// else one that is much smaller, since parameters continue beyond a face for a short way only. Of faces of
// about one size it is that with the smaller elements, of which more lie within one of the other's.
bool is_second_inner(const DividedSurface& first, const DividedSurface& second, double same_point) {
  const bool first_within = lies_within(*first.surface, *second.surface, same_point);
  const bool second_within = lies_within(*second.surface, *first.surface, same_point);
  if (first_within != second_within) return second_within;
  if (first_within) return false;
  const double of_first = rough_area(*first.surface), of_second = rough_area(*second.surface);
  if (of_second < much_smaller * of_first) return true;
  if (of_first < much_smaller * of_second) return false;
  return of_second / elements(second) < equal_size * of_first / elements(first);
}

// The elements that an interval meets, first and last, of those between breaks; none if last < first.
std::pair<int, int> elements_met(const std::vector<double>& breaks, double low, double high) {
  const auto first = std::upper_bound(breaks.begin(), breaks.end(), low) - breaks.begin() - 1;
  const auto last = std::lower_bound(breaks.begin(), breaks.end(), high) - breaks.begin() - 1;
  return {static_cast<int>(std::max<std::ptrdiff_t>(first, 0)),
          static_cast<int>(std::min(last, static_cast<std::ptrdiff_t>(breaks.size()) - 2))};
}

Point corner(const DividedSurface& divided, int i, int j) {
  return {divided.breaks[0][static_cast<std::size_t>(i)], divided.breaks[1][static_cast<std::size_t>(j)]};
}

class Refinement {
 public:
  Refinement(const DividedSurface& inner, const DividedSurface& outer, int points, double same_point)
      : inner_(inner), outer_(outer), rule_(gauss_legendre(points)), same_point_(same_point) {}

  // Cells whose `first` is of the inner and whose `second` is of the outer surface.
  std::vector<SharedCell> cells() const {
    std::vector<Piece> pieces;
    for (const ElementOutline& outline : element_outlines(inner_, outer_, same_point_))
      add_pieces(outline, pieces);
    // Polygons that are cut off from elements are straight where these are curved, and fit to polygons alone.
    const bool are_whole =
        std::all_of(pieces.begin(), pieces.end(), [](const Piece& piece) { return piece.is_whole; });
    std::vector<SharedCell> result;
    for (const Piece& piece : pieces) {
      SharedCell& made = result.emplace_back(SharedCell{piece.of_inner, piece.of_outer, {}});
      if (are_whole)
        made.points = points_of_whole(piece.of_inner, piece.outline.front());
      else
        for (const auto& [at, weight] : polygon_points(piece.outline, piece.area, rule_))
          made.points.push_back(shared_point(at, weight, piece.of_inner));
    }
    return result;
  }

 private:
  // What one of the outer elements has of an inner one.
  struct Piece {
    std::array<int, 2> of_inner, of_outer;
    ParameterPolygon outline;
    double area = 0;        // with the sign of its turn
    bool is_whole = false;  // all of the inner element
  };

  void add_pieces(const ElementOutline& outline, std::vector<Piece>& pieces) const {
    const ParameterPolygon& element = outline.on_other;
    Point low = element[0], high = element[0];
    for (const Point& point : element) {
      low = low.cwiseMin(point);
      high = high.cwiseMax(point);
    }
    const auto [first_i, last_i] = elements_met(outer_.breaks[0], low[0], high[0]);
    const auto [first_j, last_j] = elements_met(outer_.breaks[1], low[1], high[1]);
    for (int j = first_j; j <= last_j; ++j)
      for (int i = first_i; i <= last_i; ++i) {
        const Point from = corner(outer_, i, j), to = corner(outer_, i + 1, j + 1);
        ParameterPolygon cell = clipped(element, from, to);
        if (cell.size() < 3) continue;
        const double area = signed_area(cell);
        if (std::abs(area) <= 1e-12 * (to - from).prod()) continue;
        const Point reach = same_place * (to - from);
        const bool is_whole = !outline.is_cut && ((low - from + reach).array() >= 0).all() &&
                              ((to - high + reach).array() >= 0).all();
        pieces.push_back({outline.element, {i, j}, std::move(cell), area, is_whole});
      }
  }

  // Of an element of the inner surface that lies within one of the outer: Gauss's, whatever its outline
  // there.
  std::vector<SharedPoint> points_of_whole(const std::array<int, 2>& of_inner, const Point& start) const {
    std::vector<SharedPoint> result;
    Point near = start.cwiseMax(outer_.surface->low()).cwiseMin(outer_.surface->high());
    for (const auto& [at, weight] : box_points(corner(inner_, of_inner[0], of_inner[1]),
                                               corner(inner_, of_inner[0] + 1, of_inner[1] + 1), rule_)) {
      const auto tangents = inner_.surface->jacobian(at);
      const Eigen::Vector3d area = Eigen::Vector3d(tangents.col(0)).cross(Eigen::Vector3d(tangents.col(1)));
      const Eigen::Vector3d place = inner_.surface->point(at);
      SurfaceFoot foot = surface_foot(*outer_.surface, place, near);
      if (foot.distance > 10 * same_point_) foot = surface_foot(*outer_.surface, place, same_point_);
      near = foot.parameter;
      result.push_back({at, foot.parameter, weight * area.norm()});
    }
    return result;
  }

  SharedPoint shared_point(const Point& on_outer, double weight, const std::array<int, 2>& of_inner) const {
    const auto tangents = outer_.surface->jacobian(on_outer);
    const Eigen::Vector3d area = Eigen::Vector3d(tangents.col(0)).cross(Eigen::Vector3d(tangents.col(1)));
    const Point low = corner(inner_, of_inner[0], of_inner[1]);
    const Point high = corner(inner_, of_inner[0] + 1, of_inner[1] + 1);
    const Eigen::Vector3d place = outer_.surface->point(on_outer);
    SurfaceFoot foot = surface_foot(*inner_.surface, place, 0.5 * (low + high));
    if (foot.distance > 10 * same_point_) foot = surface_foot(*inner_.surface, place, same_point_);
    return {foot.parameter.cwiseMax(low).cwiseMin(high), on_outer, weight * area.norm()};
  }

  const DividedSurface& inner_;
  const DividedSurface& outer_;
  static constexpr double same_place = 1e-9;  // as a share of an element

  QuadratureRule rule_;
  double same_point_;
};

}  // namespace

std::vector<SharedCell> common_refinement(const DividedSurface& first, const DividedSurface& second,
                                          int points, double same_point) {
  const bool exchanged = is_second_inner(first, second, same_point);
  if (!exchanged) return Refinement(first, second, points, same_point).cells();
  std::vector<SharedCell> cells = Refinement(second, first, points, same_point).cells();
  for (SharedCell& cell : cells) {
    std::swap(cell.first, cell.second);
    for (SharedPoint& point : cell.points) std::swap(point.first, point.second);
  }
  return cells;
}

SharedSurface shared_surface(const NurbsSurface& first, const NurbsSurface& second, double same_point) {
  const auto divided = [](const NurbsSurface& surface) {
    return DividedSurface{&surface, {surface.knots(0).breaks(), surface.knots(1).breaks()}};
  };
  const int points = 3 + std::max({first.degree(0), first.degree(1), second.degree(0), second.degree(1)});
  SharedSurface result;
  double coarse = 0;
  std::vector<std::pair<double, double>> apart;  // with the area
  for (const SharedCell& cell : common_refinement(divided(first), divided(second), points, same_point))
    for (const SharedPoint& point : cell.points) {
      result.area += point.weight;
      apart.emplace_back((first.point(point.first) - second.point(point.second)).norm(),
                         std::abs(point.weight));
    }
  for (const SharedCell& cell : common_refinement(divided(first), divided(second), points - 1, same_point))
    for (const SharedPoint& point : cell.points) coarse += point.weight;
  result.area_error = std::abs(result.area - coarse);
  std::sort(apart.rbegin(), apart.rend());
  double beyond = 0;
  for (const auto& [distance, area] : apart) {
    result.gap = distance;
    beyond += area;
    if (beyond > beside_outlines * result.area) break;
  }
  return result;
}

}  // namespace isopatch::geometry
