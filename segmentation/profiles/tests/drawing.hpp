#pragma once

#include <cmath>
#include <numbers>
#include <vector>

#include "segmentation/profiles/profile.hpp"

namespace isopatch::segmentation::drawings {

using Eigen::Vector2d;

/// Puts profiles together. Uses of edges are numbers: e forwards, ~e backwards.
class Drawing {
 public:
  Profile profile;

  int vertex(double x, double y) {
    profile.vertices.emplace_back(x, y);
    return static_cast<int>(profile.vertices.size()) - 1;
  }
  int line(int a, int b) { return edge({a, b, {at(a), at(b)}}); }
  /// Counterclockwise about a centre from a to b.
  int arc(int a, int b, const Vector2d& centre) {
    const Vector2d from = at(a) - centre, to = at(b) - centre;
    double turn = std::atan2(to.y(), to.x()) - std::atan2(from.y(), from.x());
    while (turn <= 1e-9) turn += 2 * std::numbers::pi;
    return edge({a, b, round(centre, from, turn)});
  }
  int circle(const Vector2d& centre, double radius, double seam = 0) {
    const Vector2d from(radius * std::cos(seam), radius * std::sin(seam));
    ProfileEdge result{-1, -1, round(centre, from, 2 * std::numbers::pi)};
    result.points.back() = result.points.front();
    return edge(result);
  }
  int curve(int a, int b, const std::vector<Vector2d>& points) { return edge({a, b, points}); }
  /// Lines through points, closed; the edges in order.
  std::vector<int> polygon(const std::vector<Vector2d>& points) {
    std::vector<int> vertices, result;
    for (const Vector2d& point : points) vertices.push_back(vertex(point.x(), point.y()));
    for (std::size_t i = 0; i < vertices.size(); ++i)
      result.push_back(line(vertices[i], vertices[(i + 1) % vertices.size()]));
    return result;
  }
  std::vector<int> rectangle(double x0, double y0, double x1, double y1) {
    return polygon({{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}});
  }
  int region(const std::vector<std::vector<int>>& loops, bool wanted = true) {
    ProfileRegion result;
    result.wanted = wanted;
    for (const std::vector<int>& loop : loops) {
      result.loops.emplace_back();
      for (const int use : loop) result.loops.back().push_back({EdgeId(use < 0 ? ~use : use), use < 0});
    }
    profile.regions.push_back(result);
    return static_cast<int>(profile.regions.size()) - 1;
  }
  static std::vector<int> backwards(const std::vector<int>& loop) {
    std::vector<int> result;
    for (auto use = loop.rbegin(); use != loop.rend(); ++use) result.push_back(~*use);
    return result;
  }

 private:
  Vector2d at(int vertex) const { return profile.vertices[static_cast<std::size_t>(vertex)]; }
  int edge(const ProfileEdge& edge) {
    profile.edges.push_back(edge);
    return static_cast<int>(profile.edges.size()) - 1;
  }
  static std::vector<Vector2d> round(const Vector2d& centre, const Vector2d& from, double turn) {
    const int pieces = std::max(4, static_cast<int>(std::ceil(turn / 0.15)));
    std::vector<Vector2d> result;
    for (int i = 0; i <= pieces; ++i) {
      const double angle = turn * i / pieces, c = std::cos(angle), s = std::sin(angle);
      result.push_back(centre + Vector2d(c * from.x() - s * from.y(), s * from.x() + c * from.y()));
    }
    return result;
  }
};

inline Profile square() {
  Drawing drawing;
  drawing.region({drawing.rectangle(0, 0, 1, 1)});
  return drawing.profile;
}

inline Profile outline(const std::vector<Vector2d>& corners) {
  Drawing drawing;
  drawing.region({drawing.polygon(corners)});
  return drawing.profile;
}

inline Profile l_shape() {
  return outline({{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 3}, {0, 3}});
}
inline Profile t_shape() {
  return outline({{1, 0}, {2, 0}, {2, 2}, {3, 2}, {3, 3}, {0, 3}, {0, 2}, {1, 2}});
}
inline Profile h_shape() {
  return outline(
      {{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 0}, {3, 0}, {3, 3}, {2, 3}, {2, 2}, {1, 2}, {1, 3}, {0, 3}});
}

/// A plate with a row of bores of diameter 1, 2 apart.
inline Profile row_of_bores(int bores) {
  Drawing drawing;
  std::vector<std::vector<int>> loops = {drawing.rectangle(0, 0, 2.0 * bores, 2)};
  for (int i = 0; i < bores; ++i) loops.push_back({~drawing.circle({2.0 * i + 1, 1}, 0.5, 0.3 * i)});
  drawing.region(loops);
  return drawing.profile;
}

/// A rectangular plate with rows of bores.
inline Profile grid_of_bores(int columns, int rows) {
  Drawing drawing;
  std::vector<std::vector<int>> loops = {drawing.rectangle(0, 0, 2.0 * columns, 2.0 * rows)};
  for (int i = 0; i < columns; ++i)
    for (int j = 0; j < rows; ++j) loops.push_back({~drawing.circle({2.0 * i + 1, 2.0 * j + 1}, 0.5)});
  drawing.region(loops);
  return drawing.profile;
}

inline Profile disc() {
  Drawing drawing;
  drawing.region({{drawing.circle({0, 0}, 1)}});
  return drawing.profile;
}

inline Profile ring(double inner) {
  Drawing drawing;
  const int out = drawing.circle({0, 0}, 1), in = drawing.circle({0, 0}, inner, 0.7);
  drawing.region({{out}, {~in}});
  return drawing.profile;
}

/// Discs of growing radius about one centre, each a region of its own.
inline Profile concentric(int circles) {
  Drawing drawing;
  for (int i = 0; i < circles; ++i) drawing.circle({0, 0}, i + 1.0, 0.4 * i);
  drawing.region({{0}});
  for (int i = 1; i < circles; ++i) drawing.region({{i}, {~(i - 1)}});
  return drawing.profile;
}

/// The uses of a slot's outline: two half circles of a radius and two lines.
inline std::vector<int> slot_outline(Drawing& drawing, const Vector2d& centre, double half_length,
                                     double radius) {
  const double x = centre.x(), y = centre.y();
  const int a = drawing.vertex(x - half_length, y - radius), b = drawing.vertex(x + half_length, y - radius);
  const int c = drawing.vertex(x + half_length, y + radius), d = drawing.vertex(x - half_length, y + radius);
  return {drawing.line(a, b), drawing.arc(b, c, {x + half_length, y}), drawing.line(c, d),
          drawing.arc(d, a, {x - half_length, y})};
}
inline Profile slot(double half_length) {
  Drawing drawing;
  drawing.region({slot_outline(drawing, {0, 0}, half_length, 1)});
  return drawing.profile;
}
inline Profile plate_with_slot() {
  Drawing drawing;
  const auto out = drawing.rectangle(-3, -2, 3, 2);
  drawing.region({out, Drawing::backwards(slot_outline(drawing, {0, 0}, 1.2, 0.7))});
  return drawing.profile;
}
/// A plate with a pocket: a frame and the pocket's floor, which shares the slot-like outline.
inline Profile plate_with_pocket() {
  Drawing drawing;
  const auto out = drawing.rectangle(-3, -2, 3, 2);
  const auto in = slot_outline(drawing, {0, 0}, 1.2, 0.7);
  drawing.region({out, Drawing::backwards(in)});
  drawing.region({in});
  return drawing.profile;
}

/// A rectangle with corners of a radius.
inline std::vector<int> rounded(Drawing& drawing, double x0, double y0, double x1, double y1, double r) {
  const int a = drawing.vertex(x0 + r, y0), b = drawing.vertex(x1 - r, y0), c = drawing.vertex(x1, y0 + r);
  const int d = drawing.vertex(x1, y1 - r), e = drawing.vertex(x1 - r, y1), f = drawing.vertex(x0 + r, y1);
  const int g = drawing.vertex(x0, y1 - r), h = drawing.vertex(x0, y0 + r);
  return {drawing.line(a, b), drawing.arc(b, c, {x1 - r, y0 + r}),
          drawing.line(c, d), drawing.arc(d, e, {x1 - r, y1 - r}),
          drawing.line(e, f), drawing.arc(f, g, {x0 + r, y1 - r}),
          drawing.line(g, h), drawing.arc(h, a, {x0 + r, y0 + r})};
}
/// A plate and in it a long pocket, both divided; the pocket's four sides are smooth and join smoothly.
inline Profile plate_with_smooth_pocket() {
  Drawing drawing;
  const auto out = drawing.rectangle(-3, -1.5, 3, 1.5);
  const auto at = [](double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return Vector2d(2.2 * std::copysign(std::pow(std::abs(c), 0.8), c), (0.5 + 0.15 * c) * s + 0.15 * c * c);
  };
  const std::vector<double> joints = {0.5, 1.2, 2.8, 3.9};
  std::vector<int> vertices, in;
  for (const double joint : joints) vertices.push_back(drawing.vertex(at(joint).x(), at(joint).y()));
  for (std::size_t i = 0; i < joints.size(); ++i) {
    const std::size_t next = (i + 1) % joints.size();
    const double end = joints[next] + (next == 0 ? 2 * std::numbers::pi : 0);
    std::vector<Vector2d> points;
    for (int k = 0; k <= 48; ++k) points.push_back(at(joints[i] + (end - joints[i]) * k / 48));
    in.push_back(drawing.curve(vertices[i], vertices[next], points));
  }
  drawing.region({out, Drawing::backwards(in)});
  drawing.region({in});
  return drawing.profile;
}

/// Narrow and wide strips side by side, with two bores far apart in every second wide one: fins on a plate.
inline Profile strips_with_bores() {
  Drawing drawing;
  const std::vector<double> places = {0, 0.2, 1.2, 1.4, 2.4, 2.6};
  std::vector<int> low, high, lines;
  for (const double x : places) {
    low.push_back(drawing.vertex(x, 0));
    high.push_back(drawing.vertex(x, 6));
    lines.push_back(drawing.line(low.back(), high.back()));
  }
  for (std::size_t i = 0; i + 1 < places.size(); ++i) {
    const int bottom = drawing.line(low[i], low[i + 1]), top = drawing.line(high[i], high[i + 1]);
    std::vector<std::vector<int>> loops = {{bottom, lines[i + 1], ~top, ~lines[i]}};
    if (i == 1)
      for (const double y : {1.0, 5.0}) loops.push_back({~drawing.circle({places[i] + 0.5, y}, 0.2)});
    drawing.region(loops);
  }
  return drawing.profile;
}

inline Profile rounded_plate() {
  Drawing drawing;
  drawing.region({rounded(drawing, 0, 0, 4, 3, 0.6)});
  return drawing.profile;
}
inline Profile frame(double width, double radius) {
  Drawing drawing;
  const auto out = drawing.rectangle(0, 0, 5, 4);
  drawing.region({out, Drawing::backwards(rounded(drawing, width, width, 5 - width, 4 - width, radius))});
  return drawing.profile;
}
inline Profile half_disc() {
  Drawing drawing;
  const int a = drawing.vertex(-1, 0), b = drawing.vertex(1, 0);
  drawing.region({{drawing.line(a, b), drawing.arc(b, a, {0, 0})}});
  return drawing.profile;
}
inline Profile quarter_disc() {
  Drawing drawing;
  const int o = drawing.vertex(0, 0), a = drawing.vertex(1, 0), b = drawing.vertex(0, 1);
  drawing.region({{drawing.line(o, a), drawing.arc(a, b, {0, 0}), drawing.line(b, o)}});
  return drawing.profile;
}
/// A disc cut by a line at a height below 1.
inline Profile d_shape(double height) {
  Drawing drawing;
  const double x = std::sqrt(1 - height * height);
  const int a = drawing.vertex(x, height), b = drawing.vertex(-x, height);
  drawing.region({{drawing.line(a, b), drawing.arc(b, a, {0, 0})}});
  return drawing.profile;
}
/// A flange: a round plate with a bore and a circle of bolt holes.
inline Profile flange(int holes, bool bore) {
  Drawing drawing;
  std::vector<std::vector<int>> loops = {{drawing.circle({0, 0}, 5)}};
  if (bore) loops.push_back({~drawing.circle({0, 0}, 1.8)});
  for (int i = 0; i < holes; ++i) {
    const double angle = 2 * std::numbers::pi * i / holes + 0.2;
    loops.push_back({~drawing.circle({3.4 * std::cos(angle), 3.4 * std::sin(angle)}, 0.5)});
  }
  drawing.region(loops);
  return drawing.profile;
}
/// A shaft's section with a keyway.
inline Profile keyway() {
  Drawing drawing;
  const double x = 0.25, y = std::sqrt(1 - x * x), depth = 0.6;
  const int a = drawing.vertex(-x, y), b = drawing.vertex(-x, depth), c = drawing.vertex(x, depth),
            d = drawing.vertex(x, y);
  drawing.region({{drawing.arc(a, d, {0, 0}), drawing.line(d, c), drawing.line(c, b), drawing.line(b, a)}});
  return drawing.profile;
}
/// A toothed outline with a bore.
inline Profile gear(int teeth) {
  Drawing drawing;
  std::vector<Vector2d> points;
  for (int i = 0; i < teeth; ++i)
    for (const auto& [share, radius] :
         {std::pair(-0.22, 2.0), std::pair(-0.14, 2.5), std::pair(0.14, 2.5), std::pair(0.22, 2.0)}) {
      const double angle = 2 * std::numbers::pi * (i + share) / teeth;
      points.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
  const auto out = drawing.polygon(points);
  drawing.region({out, {~drawing.circle({0, 0}, 0.8)}});
  return drawing.profile;
}
/// A plate with four bores and one in the middle, corners rounded: a bearing's foot.
inline Profile bearing_plate() {
  Drawing drawing;
  std::vector<std::vector<int>> loops = {rounded(drawing, -4, -3, 4, 3, 1)};
  loops.push_back({~drawing.circle({0, 0}, 1.3)});
  for (const double x : {-3.0, 3.0})
    for (const double y : {-2.0, 2.0}) loops.push_back({~drawing.circle({x, y}, 0.4)});
  drawing.region(loops);
  return drawing.profile;
}

/// Thin sheets around the origin, over an angle, each a region of its own: all bend more than they are thick.
inline Profile thin_sheets(int number, double thickness, double angle) {
  Drawing drawing;
  std::vector<int> arcs, starts, ends, first, last;
  for (int i = 0; i <= number; ++i) {
    const double r = 100 + i * thickness;
    first.push_back(drawing.vertex(r, 0));
    last.push_back(drawing.vertex(r * std::cos(angle), r * std::sin(angle)));
    arcs.push_back(drawing.arc(first.back(), last.back(), {0, 0}));
  }
  for (std::size_t i = 0; i + 1 < first.size(); ++i) {
    const int start = drawing.line(first[i], first[i + 1]), end = drawing.line(last[i], last[i + 1]);
    drawing.region({{start, arcs[i + 1], ~end, ~arcs[i]}});
  }
  return drawing.profile;
}

/// A sheet around the origin with thinner legs inwards at both ends, and outside of it another sheet.
inline Profile sheet_with_legs(double angle, double thickness, double leg) {
  Drawing drawing;
  const auto at = [&](double radius, double turn) {
    return drawing.vertex(radius * std::cos(turn), radius * std::sin(turn));
  };
  constexpr double radius = 100, thin = 0.01;  // as long as 1 at the radius, as an angle
  const int a = at(radius + thickness, 0), b = at(radius + thickness, angle);
  const int c = at(radius - leg, angle), d = at(radius - leg, angle - thin);
  const int e = at(radius, angle - thin), f = at(radius, thin);
  const int g = at(radius - leg, thin), h = at(radius - leg, 0);
  const int outer = drawing.arc(a, b, {0, 0});
  drawing.region(
      {{outer, drawing.line(b, c), ~drawing.arc(d, c, {0, 0}), drawing.line(d, e), ~drawing.arc(f, e, {0, 0}),
        drawing.line(f, g), ~drawing.arc(h, g, {0, 0}), drawing.line(h, a)}});
  const int i = at(radius + thickness + 1, 0), j = at(radius + thickness + 1, angle);
  drawing.region({{drawing.line(a, i), drawing.arc(i, j, {0, 0}), drawing.line(j, b), ~outer}});
  return drawing.profile;
}

}  // namespace isopatch::segmentation::drawings
