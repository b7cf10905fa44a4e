#include "geometry/parameter_polygon.hpp"

#include <algorithm>
#include <cmath>

namespace isopatch::geometry {
namespace {

using Point = Parameter<2>;

// Along sides so short, as a share of the box around the polygon, fewer points do: linear fields come through
// faces with errors below 1e-10.
constexpr double short_side = 0.1;
constexpr int points_of_short_sides = 3;
constexpr int most_halvings = 9;  // of a polygon, each of its two parts again

double cross(const Point& a, const Point& b) {
  return a[0] * b[1] - a[1] * b[0];
}

// What is left of a polygon where sign * (x[direction] - limit) >= 0.
// Source: Sutherland, Hodgman 1974.
ParameterPolygon clipped(const ParameterPolygon& polygon, int direction, double limit, double sign) {
  ParameterPolygon result;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Point& a = polygon[i];
    const Point& b = polygon[(i + 1) % polygon.size()];
    const double inside_a = sign * (a[direction] - limit), inside_b = sign * (b[direction] - limit);
    if (inside_a >= 0) result.push_back(a);
    if ((inside_a > 0 && inside_b < 0) || (inside_a < 0 && inside_b > 0)) {
      Point cut = a + inside_a / (inside_a - inside_b) * (b - a);
      cut[direction] = limit;
      result.push_back(cut);
    }
  }
  return result;
}

// Whether a polygon fills the box around it.
bool is_box(const ParameterPolygon& polygon, const Point& low, const Point& high, double area) {
  const Point sides = high - low;
  return std::abs(std::abs(area) - sides[0] * sides[1]) <= 1e-9 * std::abs(area) && polygon.size() >= 4;
}

// A square collapsed into a triangle; weights have the sign of its turn.
// Source: Duffy 1982.
void add_triangle(const Point& apex, const Point& b, const Point& c, double sign,
                  const QuadratureRule& of_away, const QuadratureRule& of_along, PlanePoints& points) {
  const double twice = sign * cross(b - apex, c - apex);
  for (Eigen::Index j = 0; j < of_along.nodes.size(); ++j)
    for (Eigen::Index i = 0; i < of_away.nodes.size(); ++i) {
      const double away = of_away.nodes[i], along = of_along.nodes[j];
      points.emplace_back(apex + away * ((1 - along) * (b - apex) + along * (c - apex)),
                          of_away.weights[i] * of_along.weights[j] * twice * away);
    }
}

Point centroid(const ParameterPolygon& polygon, double area) {
  Point sum = Point::Zero();
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Point b = polygon[i] - polygon[0], c = polygon[i + 1] - polygon[0];
    sum += cross(b, c) / 6 * (b + c);
  }
  return polygon[0] + sum / area;
}

// The area that the triangles from a point to the polygon's sides have with the wrong sign: 0 where all of
// the polygon is seen from there.
double hidden_area(const ParameterPolygon& polygon, const Point& from, double area) {
  double sum = 0;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const double twice = cross(polygon[k] - from, polygon[(k + 1) % polygon.size()] - from);
    if ((twice > 0) != (area > 0)) sum += 0.5 * std::abs(twice);
  }
  return sum;
}

// Polygons that cannot be seen whole from one point, as bent strips, are halved until their parts
// can: triangles that cancel each other would have points far from the polygon.
void add_polygon(const ParameterPolygon& polygon, double sign, const QuadratureRule& rule, int halvings,
                 PlanePoints& result) {
  if (polygon.size() < 3) return;
  const double area = signed_area(polygon);
  if (!(std::abs(area) > 0)) return;
  Point low = polygon[0], high = polygon[0];
  for (const Point& point : polygon) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const Point middle = centroid(polygon, area);
  if (halvings > 0 && hidden_area(polygon, middle, area) > 1e-9 * std::abs(area)) {
    const int longer = high[0] - low[0] > high[1] - low[1] ? 0 : 1;
    const double half = 0.5 * (low[longer] + high[longer]);
    for (const double side : {1.0, -1.0})
      add_polygon(clipped(polygon, longer, half, side), sign, rule, halvings - 1, result);
    return;
  }
  const QuadratureRule few =
      gauss_legendre(std::min(points_of_short_sides, static_cast<int>(rule.nodes.size())));
  const Point sides = high - low;
  for (std::size_t k = 0; k < polygon.size(); ++k) {
    const Point& next = polygon[(k + 1) % polygon.size()];
    const bool is_short = ((next - polygon[k]).cwiseAbs().array() < short_side * sides.array()).all();
    add_triangle(middle, polygon[k], next, sign, rule, is_short ? few : rule, result);
  }
}

}  // namespace

double signed_area(const ParameterPolygon& polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i)
    sum += cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
  return 0.5 * sum;
}

ParameterPolygon clipped(ParameterPolygon polygon, const Point& low, const Point& high) {
  for (int d = 0; d < 2; ++d) {
    polygon = clipped(polygon, d, low[d], 1);
    polygon = clipped(polygon, d, high[d], -1);
  }
  return polygon;
}

PlanePoints box_points(const Point& low, const Point& high, const QuadratureRule& rule) {
  PlanePoints points;
  const Point sides = high - low;
  for (Eigen::Index j = 0; j < rule.nodes.size(); ++j)
    for (Eigen::Index i = 0; i < rule.nodes.size(); ++i)
      points.emplace_back(low + sides.cwiseProduct(Point(rule.nodes[i], rule.nodes[j])),
                          rule.weights[i] * rule.weights[j] * sides[0] * sides[1]);
  return points;
}

PlanePoints polygon_points(const ParameterPolygon& polygon, double area, const QuadratureRule& rule) {
  Point low = polygon[0], high = polygon[0];
  for (const Point& point : polygon) {
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  if (is_box(polygon, low, high, area)) return box_points(low, high, rule);
  PlanePoints result;
  add_polygon(polygon, area > 0 ? 1 : -1, rule, most_halvings, result);
  return result;
}

}  // namespace isopatch::geometry
