#include "segmentation/profiles/internal/cell_shape.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isopatch::segmentation::planar {

using Eigen::Vector2d;
using std::numbers::pi;

namespace {

double cross2(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}
double direction_of(const Vector2d& v) {
  return std::atan2(v.y(), v.x());
}

double corner_angle(const std::array<const SideShape*, 4>& sides, int corner, int count) {
  const SideShape& arriving = *sides[(corner + count - 1) % count];
  return angle_between(sides[corner]->start_direction, arriving.end_direction + pi);
}

/// The triangle's three quadrilaterals around its middle.
bool triangle_stands(const std::array<const SideShape*, 4>& sides) {
  const Vector2d middle =
      (sides[0]->points.front() + sides[1]->points.front() + sides[2]->points.front()) / 3;
  const auto half = [](const SideShape& side, bool second) {
    SideShape result = side;
    constexpr int last = SideShape::samples - 1;
    const Vector2d centre = side.point(last / 2);
    (second ? result.points.front() : result.points.back()) = centre;
    if (side.straight) return result;
    for (int s = 0; s <= last; ++s) {  // linear between samples is enough for a sign
      const double at = (second ? 0.5 : 0.0) * last + s * 0.5;
      const int i = std::min(static_cast<int>(at), last - 1);
      result.points[s] = side.points[i] + (at - i) * (side.points[i + 1] - side.points[i]);
      result.derivatives[s] =
          0.5 * (side.derivatives[i] + (at - i) * (side.derivatives[i + 1] - side.derivatives[i]));
    }
    return result;
  };
  const auto line = [](const Vector2d& a, const Vector2d& b) {
    SideShape result;
    result.points.front() = a;
    result.points.back() = b;
    return result;
  };
  for (int k = 0; k < 3; ++k) {
    const SideShape &out = *sides[k], &in = *sides[(k + 2) % 3];
    const SideShape a = half(out, false), d = half(in, true);
    const SideShape b = line(a.points.back(), middle), c = line(middle, d.points.front());
    if (!map_stands({&a, &b, &c, &d}, 0.03, thinnest_at_all)) return false;
  }
  return true;
}

double triangle_cost(const ShapeRules& rules, const std::array<const SideShape*, 4>& sides) {
  double sum = 0;
  for (int k = 0; k < 3; ++k) {
    const double angle = corner_angle(sides, k, 3);
    if (angle < rules.smallest_in_triangle || angle > rules.largest_in_triangle) return refused;
    sum += std::pow((angle - pi / 3) / (pi / 2), 2);
  }
  return triangle_stands(sides) ? rules.triangle + rules.angle_weight * sum : refused;
}

}  // namespace

Vector2d SideShape::point(int sample) const {
  if (!straight) return points[sample];
  const double at = static_cast<double>(sample) / (samples - 1);
  return (1 - at) * points.front() + at * points.back();
}

SideShape side_shape(const std::vector<Curve>& curves, const std::vector<Node>& nodes, const Side& side) {
  SideShape result;
  const Vector2d &from = nodes[side.from].point, &to = nodes[side.to].point;
  result.points.front() = from;
  result.points.back() = to;
  result.length = (to - from).norm();
  result.straight = side.curve < 0 || curves[side.curve].straight();
  if (result.straight) {
    if (side.curve < 0) result.slant = slant_of(to - from);
    result.start_direction = result.end_direction = direction_of(to - from);
    return result;
  }
  const Curve& curve = curves[side.curve];
  const double span = side.high - side.low;
  constexpr int last = SideShape::samples - 1;
  result.length = 0;
  for (int s = 0; s <= last; ++s) {
    const double share = static_cast<double>(s) / last;
    const double at = side.reversed ? side.high - share * span : side.low + share * span;
    if (s != 0 && s != last) result.points[s] = curve.at(at);
    result.derivatives[s] = (side.reversed ? -span : span) * curve.derivative(at);
    if (s == 0) continue;
    result.length += (result.points[s] - result.points[s - 1]).norm();
    const Vector2d &a = result.derivatives[s - 1], &b = result.derivatives[s];
    result.turning += std::abs(std::atan2(cross2(a, b), a.dot(b)));
  }
  result.start_direction = direction_of(result.derivatives.front());
  result.end_direction = direction_of(result.derivatives.back());
  return result;
}

double slant_of(const Vector2d& along) {
  const double c = along.x() * along.x() - along.y() * along.y(), s = 2 * along.x() * along.y();
  const double sine = 2 * c * s / (c * c + s * s);  // of four times the angle
  return sine * sine;
}

SideShape turned(const SideShape& shape) {
  SideShape result = shape;
  std::reverse(result.points.begin(), result.points.end());
  for (int s = 0; s < SideShape::samples; ++s)
    result.derivatives[s] = -shape.derivatives[SideShape::samples - 1 - s];
  result.start_direction = shape.end_direction + pi;
  result.end_direction = shape.start_direction + pi;
  return result;
}

ShapeRules::ShapeRules(const QuadrangulationOptions& options)
    : smallest(options.smallest_angle.radians()),
      largest(options.largest_angle.radians()),
      largest_turn(options.largest_turn.radians()),
      smallest_jacobian(options.smallest_jacobian),
      angle_weight(options.angle_weight),
      turn_weight(options.turn_weight),
      length_weight(options.length_weight),
      aspect_weight(options.aspect_weight),
      slant_weight(options.slant_weight),
      good_jacobian(options.good_jacobian) {}

double angle_between(double leaving, double arriving) {
  const double angle = std::fmod(arriving - leaving, 2 * pi);
  return angle < 0 ? angle + 2 * pi : angle;
}

double corner_cost(const ShapeRules& rules, double angle) {
  if (angle < rules.smallest || angle > rules.largest) return refused;
  const double off = (angle - pi / 2) / (pi / 2);
  return rules.angle_weight * off * off * (1 + 3 * off * off * off * off);
}

namespace {

/// The transfinite map of four sides, at samples.
class MapSamples {
 public:
  explicit MapSamples(const std::array<const SideShape*, 4>& sides) {
    const SideShape &bottom = *sides[0], &right = *sides[1], &top = *sides[2], &left = *sides[3];
    const Vector2d a = bottom.points.front(), b = right.points.front(), c = top.points.front(),
                   d = left.points.front();
    for (int i = 0; i <= last; ++i) {
      const double share = static_cast<double>(i) / last;
      // Parts of the derivative along u that are the same along a column or a row, and likewise along v.
      low_u_[i] = bottom.derivative(i) - (b - a);
      high_u_[i] = -top.derivative(last - i) - (c - d);
      across_u_[i] = right.point(i) - left.point(last - i);
      low_v_[i] = -left.derivative(last - i) - (d - a);
      high_v_[i] = right.derivative(i) - (c - b);
      across_v_[i] = top.point(last - i) - bottom.point(i);
      share_[i] = share;
    }
  }
  static constexpr int last = SideShape::samples - 1;
  Vector2d along_u(int i, int j) const {
    return (1 - share_[j]) * low_u_[i] + share_[j] * high_u_[i] + across_u_[j];
  }
  Vector2d along_v(int i, int j) const {
    return (1 - share_[i]) * low_v_[j] + share_[i] * high_v_[j] + across_v_[i];
  }

 private:
  std::array<Vector2d, SideShape::samples> low_u_, high_u_, across_u_, low_v_, high_v_, across_v_;
  std::array<double, SideShape::samples> share_;
};

}  // namespace

double least_jacobian(const std::array<const SideShape*, 4>& sides) {
  const MapSamples map(sides);
  double least = refused, least_determinant = refused, sum = 0;
  for (int i = 0; i <= MapSamples::last; ++i)
    for (int j = 0; j <= MapSamples::last; ++j) {
      const Vector2d u = map.along_u(i, j), v = map.along_v(i, j);
      const double determinant = cross2(u, v), scale = u.norm() * v.norm();
      sum += determinant;
      least_determinant = std::min(least_determinant, determinant);
      least = std::min(least, scale > 0 ? determinant / scale : -1.0);
    }
  constexpr int number = SideShape::samples * SideShape::samples;
  return least_determinant < thinnest_at_all * sum / number ? std::min(least, -1e-3) : least;
}

double thinness(const std::array<const SideShape*, 4>& sides) {
  const MapSamples map(sides);
  double least = refused, sum = 0;
  for (int i = 0; i <= MapSamples::last; ++i)
    for (int j = 0; j <= MapSamples::last; ++j) {
      const double determinant = cross2(map.along_u(i, j), map.along_v(i, j));
      sum += determinant;
      least = std::min(least, determinant);
    }
  return least * SideShape::samples * SideShape::samples / sum;
}

bool map_stands(const std::array<const SideShape*, 4>& sides, double smallest, double thinnest) {
  // A bilinear map is steepest and flattest in its corners.
  if (std::all_of(sides.begin(), sides.end(), [](const SideShape* side) { return side->straight; }))
    return true;
  const MapSamples map(sides);
  double least = refused, sum = 0;
  for (int i = 0; i <= MapSamples::last; ++i)
    for (int j = 0; j <= MapSamples::last; ++j) {
      const Vector2d u = map.along_u(i, j), v = map.along_v(i, j);
      const double determinant = cross2(u, v);
      if (determinant * std::abs(determinant) < smallest * smallest * u.squaredNorm() * v.squaredNorm())
        return false;
      sum += determinant;
      least = std::min(least, determinant);
    }
  return least >= thinnest * sum / (SideShape::samples * SideShape::samples);
}

double cost_of(const ShapeRules& rules, const std::array<const SideShape*, 4>& sides, int count) {
  if (count == 3) return triangle_cost(rules, sides);
  double sum = 1 + sides_cost(rules, *sides[0], *sides[1], *sides[2], *sides[3]);
  for (int k = 0; k < 4; ++k) sum += corner_cost(rules, corner_angle(sides, k, 4));
  for (const SideShape* side : sides)
    if (side->turning > rules.largest_turn) return refused;
  if (!(sum < refused)) return refused;
  if (!map_stands(sides, rules.smallest_jacobian, rules.thinnest)) return refused;
  return sum;
}

double cost_of(const ShapeRules& rules, const std::vector<Curve>& curves, const CellMesh& mesh,
               const Cell& cell) {
  std::array<SideShape, 4> shapes;
  std::array<const SideShape*, 4> sides = {};
  for (int k = 0; k < cell.count; ++k) {
    shapes[k] = side_shape(curves, mesh.nodes, cell.sides[k]);
    sides[k] = &shapes[k];
  }
  return bounded_cost_of(rules, sides, cell.count);
}

double bounded_cost_of(const ShapeRules& rules, const std::array<const SideShape*, 4>& sides, int count) {
  const double cost = cost_of(rules, sides, count);
  if (cost < refused) return std::min(cost, rules.not_valid);
  const double middle = (rules.invalid + rules.not_valid) / 2;
  if (count == 3) return middle;
  const double stands = std::min(least_jacobian(sides), thinness(sides) - rules.thinnest);
  return middle - (rules.invalid - middle) * std::clamp(stands, -1.0, 1.0);
}

}  // namespace isopatch::segmentation::planar
