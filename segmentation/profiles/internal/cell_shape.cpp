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

namespace {

/// The sum of the angles between neighbours, all taken positive.
double turning_of(const std::array<Vector2d, SideShape::samples>& derivatives) {
  double result = 0;
  Vector2d turn(1,
                0);  // by all since the last sum; angles add up where these are multiplied as complex numbers
  for (std::size_t s = 1; s < derivatives.size(); ++s) {
    const Vector2d &a = derivatives[s - 1], &b = derivatives[s];
    const Vector2d next(a.dot(b), cross2(a, b));
    const bool goes_on = turn.x() > 0 && next.x() > 0 && turn.y() * next.y() >= 0;  // within half a turn
    if (!goes_on) {
      result += std::abs(direction_of(turn));
      turn = next;
      continue;
    }
    turn = Vector2d(turn.x() * next.x() - turn.y() * next.y(), turn.x() * next.y() + turn.y() * next.x())
               .normalized();
  }
  return result + std::abs(direction_of(turn));
}

}  // namespace

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
    if (s != 0) result.length += (result.points[s] - result.points[s - 1]).norm();
  }
  result.turning = turning_of(result.derivatives);
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

/// Numbers at samples of a row, filled up so that they are dealt with side by side.
constexpr int width = 8;
using Row = std::array<double, width>;

/// The transfinite map of four sides, at samples.
class MapSamples {
 public:
  explicit MapSamples(const std::array<const SideShape*, 4>& sides) {
    const SideShape &bottom = *sides[0], &right = *sides[1], &top = *sides[2], &left = *sides[3];
    const Vector2d a = bottom.points.front(), b = right.points.front(), c = top.points.front(),
                   d = left.points.front();
    for (int i = 0; i < width; ++i) {
      const int at = std::min(i, last);
      // Parts of the derivative along u that are the same along a column or a row, and likewise along v.
      enter(low_u_, i, bottom.derivative(at) - (b - a));
      enter(high_u_, i, -top.derivative(last - at) - (c - d));
      enter(across_u_, i, right.point(at) - left.point(last - at));
      enter(low_v_, i, -left.derivative(last - at) - (d - a));
      enter(high_v_, i, right.derivative(at) - (c - b));
      enter(across_v_, i, top.point(last - at) - bottom.point(at));
      share_[static_cast<std::size_t>(i)] = static_cast<double>(at) / last;
    }
  }
  static constexpr int last = SideShape::samples - 1;

  /// Of the points with one j: determinants of the derivatives and products of their squared lengths.
  struct Values {
    Row determinants, squares;
  };
  Values at_row(int number) const {
    const auto j = static_cast<std::size_t>(number);
    const double share = share_[j], rest = 1 - share;
    Values result;
    for (std::size_t i = 0; i < width; ++i) {
      const double ux = rest * low_u_[0][i] + share * high_u_[0][i] + across_u_[0][j],
                   uy = rest * low_u_[1][i] + share * high_u_[1][i] + across_u_[1][j],
                   vx = (1 - share_[i]) * low_v_[0][j] + share_[i] * high_v_[0][j] + across_v_[0][i],
                   vy = (1 - share_[i]) * low_v_[1][j] + share_[i] * high_v_[1][j] + across_v_[1][i];
      result.determinants[i] = ux * vy - uy * vx;
      result.squares[i] = (ux * ux + uy * uy) * (vx * vx + vy * vy);
    }
    return result;
  }

 private:
  using Rows = std::array<Row, 2>;  // x and y
  static void enter(Rows& rows, int i, const Vector2d& value) {
    rows[0][static_cast<std::size_t>(i)] = value.x();
    rows[1][static_cast<std::size_t>(i)] = value.y();
  }

  Rows low_u_, high_u_, across_u_, low_v_, high_v_, across_v_;
  Row share_;
};

/// The least Jacobian determinant of all samples, and their sum.
struct Determinants {
  double least = refused, sum = 0;
  void enter(const Row& row) {
    for (std::size_t i = 0; i < SideShape::samples; ++i) {
      least = std::min(least, row[i]);
      sum += row[i];
    }
  }
  double least_over_mean() const { return least * SideShape::samples * SideShape::samples / sum; }
};

}  // namespace

double least_jacobian(const std::array<const SideShape*, 4>& sides) {
  const MapSamples map(sides);
  double least = refused;
  Determinants determinants;
  for (int j = 0; j <= MapSamples::last; ++j) {
    const MapSamples::Values values = map.at_row(j);
    determinants.enter(values.determinants);
    for (std::size_t i = 0; i < width; ++i)
      least =
          std::min(least, values.squares[i] > 0 ? values.determinants[i] / std::sqrt(values.squares[i]) : -1);
  }
  constexpr int number = SideShape::samples * SideShape::samples;
  const bool is_thin = determinants.least < thinnest_at_all * determinants.sum / number;
  return is_thin ? std::min(least, -1e-3) : least;
}

double thinness(const std::array<const SideShape*, 4>& sides) {
  const MapSamples map(sides);
  Determinants determinants;
  for (int j = 0; j <= MapSamples::last; ++j) determinants.enter(map.at_row(j).determinants);
  return determinants.least_over_mean();
}

double slenderness(const std::array<const SideShape*, 4>& sides) {
  constexpr double most = 1e6;
  double result = 1;
  for (std::size_t k = 0; k < 2; ++k) {
    const SideShape &side = *sides[k], &opposite = *sides[k + 2];
    double apart = refused;
    for (int i = 0; i < SideShape::samples; ++i)
      apart = std::min(apart, (side.point(i) - opposite.point(SideShape::samples - 1 - i)).norm());
    const double length = (side.length + opposite.length) / 2;
    result = std::max(result, length > most * apart ? most : length / apart);
  }
  return result;
}

bool map_stands(const std::array<const SideShape*, 4>& sides, double smallest, double thinnest) {
  // A bilinear map is steepest and flattest in its corners.
  if (std::all_of(sides.begin(), sides.end(), [](const SideShape* side) { return side->straight; }))
    return true;
  const MapSamples map(sides);
  Determinants determinants;
  for (int j = 0; j <= MapSamples::last; ++j) {
    const MapSamples::Values values = map.at_row(j);
    bool stands = true;
    for (std::size_t i = 0; i < width; ++i)
      stands &= values.determinants[i] * std::abs(values.determinants[i]) >=
                smallest * smallest * values.squares[i];
    if (!stands) return false;
    determinants.enter(values.determinants);
  }
  return determinants.least >= thinnest * determinants.sum / (SideShape::samples * SideShape::samples);
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
