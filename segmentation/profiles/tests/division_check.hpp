#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "geometry/base/larger.hpp"
#include "segmentation/profiles/internal/curve.hpp"
#include "segmentation/profiles/quadrangulation.hpp"

/// What makes a division one, looked at without the code that makes it.
namespace isopatch::segmentation::checks {

using Eigen::Vector2d;

inline double cross(const Vector2d& a, const Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

/// A side's points, run from its start.
class Shapes {
 public:
  Shapes(const Profile& profile, const Quadrangulation& quads)
      : quads_(quads), curves_(planar::curves_of(profile)) {}

  Vector2d at(const geometry::EdgeUse& use, double share) const {
    const QuadEdge& edge = quads_.edges[use.edge.value];
    const double s = use.reversed ? 1 - share : share;
    if (edge.apex)
      return (1 - s) * (1 - s) * quads_.vertices[edge.start] + 2 * s * (1 - s) * *edge.apex +
             s * s * quads_.vertices[edge.end];
    if (edge.profile_edge < 0) return (1 - s) * quads_.vertices[edge.start] + s * quads_.vertices[edge.end];
    return curves_[edge.profile_edge].at(edge.low + s * (edge.high - edge.low));
  }
  /// Twice the area between a curve's piece and the origin, by many trapezoids.
  double sector(int curve, double low, double high) const {
    constexpr int steps = 4000;
    double sum = 0;
    for (int i = 0; i < steps; ++i)
      sum += cross(curves_[curve].at(low + (high - low) * i / steps),
                   curves_[curve].at(low + (high - low) * (i + 1) / steps));
    return sum;
  }
  Vector2d coons(const Quad& quad, double u, double v) const {
    const auto& s = quad.sides;
    const Vector2d a = at(s[0], 0), b = at(s[1], 0), c = at(s[2], 0), d = at(s[3], 0);
    return (1 - v) * at(s[0], u) + v * at(s[2], 1 - u) + (1 - u) * at(s[3], 1 - v) + u * at(s[1], v) -
           ((1 - u) * (1 - v) * a + u * (1 - v) * b + u * v * c + (1 - u) * v * d);
  }

 private:
  const Quadrangulation& quads_;
  std::vector<planar::Curve> curves_;
};

/// Of each quadrilateral: closed, and no small piece of its transfinite map turned over; and the sum of these
/// pieces.
inline std::string fault_of_quad(const Quadrangulation& quads, const Shapes& shapes, int number) {
  const Quad& quad = quads.quads[number];
  for (std::size_t k = 0; k < 4; ++k) {
    const geometry::EdgeUse &use = quad.sides[k], &next = quad.sides[(k + 1) % 4];
    const QuadEdge &edge = quads.edges[use.edge.value], &following = quads.edges[next.edge.value];
    if ((use.reversed ? edge.start : edge.end) != (next.reversed ? following.end : following.start))
      return fmt::format("quadrilateral {} is open after side {}", number, k);
    if ((shapes.at(use, 1) - quads.vertices[use.reversed ? edge.start : edge.end]).norm() > 1e-9)
      return fmt::format("side {} of quadrilateral {} does not end in its vertex", k, number);
  }
  constexpr int n = 12;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double u = static_cast<double>(i) / n, v = static_cast<double>(j) / n, h = 1.0 / n;
      const Vector2d p = shapes.coons(quad, u, v), q = shapes.coons(quad, u + h, v),
                     r = shapes.coons(quad, u + h, v + h), s = shapes.coons(quad, u, v + h);
      if (cross(q - p, s - p) <= 0 || cross(r - q, p - q) <= 0 || cross(s - r, q - r) <= 0 ||
          cross(p - s, r - s) <= 0)
        return fmt::format("quadrilateral {} is folded near ({}, {})", number, u, v);
    }
  return "";
}

/// Whether the pieces of each profile's edge beside wanted regions follow each other from its start to its
/// end.
inline std::string fault_of_outline(const Profile& profile, const Quadrangulation& quads) {
  std::map<std::pair<int, int>, std::vector<std::pair<double, double>>> pieces;  // of region and edge
  for (const Quad& quad : quads.quads)
    for (const geometry::EdgeUse& use : quad.sides) {
      const QuadEdge& edge = quads.edges[use.edge.value];
      if (edge.profile_edge >= 0)
        pieces[{quad.region, 2 * edge.profile_edge + (use.reversed ? 1 : 0)}].emplace_back(edge.low,
                                                                                           edge.high);
    }
  for (std::size_t r = 0; r < profile.regions.size(); ++r)
    for (const auto& loop : profile.regions[r].loops)
      for (const geometry::EdgeUse& use : loop) {
        if (!profile.regions[r].wanted) continue;
        auto& covered = pieces[{static_cast<int>(r), 2 * use.edge.value + (use.reversed ? 1 : 0)}];
        std::sort(covered.begin(), covered.end());
        const bool closed = profile.edges[use.edge.value].start < 0;
        const bool whole =
            !covered.empty() && (closed ? covered.back().second == covered.front().first + 1
                                        : covered.front().first == 0 && covered.back().second == 1);
        for (std::size_t i = 0; i + 1 < covered.size(); ++i)
          if (covered[i].second != covered[i + 1].first)
            return fmt::format("edge {} has a gap or an overlap", use.edge.value);
        if (!whole) return fmt::format("edge {} is not covered beside region {}", use.edge.value, r);
      }
  return "";
}

/// That chords are used by two quadrilaterals of one region, once in each direction, and pieces of edges at
/// most so.
inline std::string fault_of_edges(const Quadrangulation& quads) {
  std::vector<std::array<std::vector<int>, 2>> uses(quads.edges.size());
  for (const Quad& quad : quads.quads)
    for (const geometry::EdgeUse& use : quad.sides)
      uses[use.edge.value][use.reversed ? 1 : 0].push_back(quad.region);
  for (std::size_t e = 0; e < uses.size(); ++e) {
    const auto& [forwards, backwards] = uses[e];
    const bool chord = quads.edges[e].profile_edge < 0;
    if (forwards.size() > 1 || backwards.size() > 1 || forwards.size() + backwards.size() == 0)
      return fmt::format("edge {} is used {} times forwards and {} backwards", e, forwards.size(),
                         backwards.size());
    if (chord && (forwards.size() != 1 || backwards != forwards))
      return fmt::format("chord {} is not inside one region", e);
  }
  return "";
}

/// Areas of quadrilaterals, by their transfinite maps, against that of their region.
inline std::string fault_of_areas(const Profile& profile, const Quadrangulation& quads,
                                  const Shapes& shapes) {
  std::vector<double> sums(profile.regions.size(), 0.0), sizes(profile.regions.size(), 0.0);
  for (const Quad& quad : quads.quads)
    for (const geometry::EdgeUse& use : quad.sides) {
      const QuadEdge& edge = quads.edges[use.edge.value];
      const double piece = edge.profile_edge < 0 ? cross(quads.vertices[edge.start], quads.vertices[edge.end])
                                                 : shapes.sector(edge.profile_edge, edge.low, edge.high);
      sums[quad.region] += use.reversed ? -piece / 2 : piece / 2;
    }
  for (std::size_t r = 0; r < profile.regions.size(); ++r) {
    if (!profile.regions[r].wanted) continue;
    for (const auto& loop : profile.regions[r].loops)
      for (const geometry::EdgeUse& use : loop)
        sizes[r] += (use.reversed ? -0.5 : 0.5) * shapes.sector(use.edge.value, 0, 1);
    if (std::abs(sums[r] - sizes[r]) > 1e-6 * std::abs(sizes[r]))  // the trapezoids'
      return fmt::format("region {} has area {} and its quadrilaterals {}", r, sizes[r], sums[r]);
  }
  return "";
}

/// What is wrong with a division, in a line; empty if nothing is.
inline std::string fault_of(const Profile& profile, const Quadrangulation& quads) {
  const Shapes shapes(profile, quads);
  for (std::string fault :
       {fault_of_edges(quads), fault_of_outline(profile, quads), fault_of_areas(profile, quads, shapes)})
    if (!fault.empty()) return fault;
  for (std::size_t q = 0; q < quads.quads.size(); ++q) {
    const std::string fault = fault_of_quad(quads, shapes, static_cast<int>(q));
    if (!fault.empty()) return fault;
  }
  return "";
}

/// The least and the largest corner, in degrees.
inline std::pair<double, double> angles_of(const Profile& profile, const Quadrangulation& quads) {
  std::pair<double, double> result = {360, 0};
  for (std::size_t q = 0; q < quads.quads.size(); ++q) {
    const QuadShape shape = shape_of(profile, quads, static_cast<int>(q));
    result.first = smaller(result.first, shape.smallest.degrees());
    result.second = larger(result.second, shape.largest.degrees());
  }
  return result;
}

}  // namespace isopatch::segmentation::checks
