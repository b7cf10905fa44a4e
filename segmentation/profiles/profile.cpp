#include "segmentation/profiles/profile.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/base/error.hpp"

namespace isopatch::segmentation {

using Eigen::Vector2d;

namespace {

/// Ends of edges may lie so far from their vertices, relative to the drawing: what files written with 6
/// digits need.
constexpr double joint_tolerance = 1e-6;

/// The diagonal of the box around it.
double size_of(const Profile& profile) {
  Eigen::AlignedBox2d box;
  for (const ProfileEdge& edge : profile.edges)
    for (const Vector2d& point : edge.points) box.extend(point);
  return box.isEmpty() ? 0 : box.diagonal().norm();
}

[[noreturn]] void refuse_profile(const std::string& message) {
  throw Error(ErrorCode::bad_format, "the profile is invalid: " + message);
}

void check_edge(const Profile& profile, int number, double size) {
  const ProfileEdge& edge = profile.edges[static_cast<std::size_t>(number)];
  const int vertices = static_cast<int>(profile.vertices.size());
  const bool closed = edge.start == -1 && edge.end == -1;
  if (!closed && (edge.start < 0 || edge.end < 0 || edge.start >= vertices || edge.end >= vertices))
    refuse_profile(
        fmt::format("edge {} runs from vertex {} to {} of {}", number, edge.start, edge.end, vertices));
  if (edge.points.size() < (edge.start == edge.end ? 4U : 2U))
    refuse_profile(
        fmt::format("edge {} has {} points; a line needs 2, a closed curve 4", number, edge.points.size()));
  for (std::size_t i = 0; i + 1 < edge.points.size(); ++i)
    if ((edge.points[i + 1] - edge.points[i]).norm() <= 1e-12 * size)
      refuse_profile(fmt::format("edge {} has a point twice, number {}", number, i));
  const Vector2d start = closed ? edge.points.back() : profile.vertices[static_cast<std::size_t>(edge.start)];
  const Vector2d end = closed ? edge.points.back() : profile.vertices[static_cast<std::size_t>(edge.end)];
  const double gap = std::max((edge.points.front() - start).norm(), (edge.points.back() - end).norm());
  if (!(gap <= joint_tolerance * size))
    refuse_profile(
        fmt::format("edge {} ends {:.3g} from its vertices (size of the drawing {:.3g})", number, gap, size));
}

double signed_area(const Profile& profile, const std::vector<geometry::EdgeUse>& loop) {
  double sum = 0;
  for (const geometry::EdgeUse& use : loop) {
    const auto& points = profile.edges[static_cast<std::size_t>(use.edge.value)].points;
    double piece = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
      piece += points[i].x() * points[i + 1].y() - points[i].y() * points[i + 1].x();
    sum += use.reversed ? -piece : piece;
  }
  return sum / 2;
}

void check_loop(const Profile& profile, std::size_t region, std::size_t number) {
  const auto& loop = profile.regions[region].loops[number];
  if (loop.empty()) refuse_profile(fmt::format("loop {} of region {} is empty", number, region));
  const auto end_of = [&](const geometry::EdgeUse& use, bool start) {
    const ProfileEdge& edge = profile.edges[static_cast<std::size_t>(use.edge.value)];
    return use.reversed == start ? edge.end : edge.start;
  };
  for (const geometry::EdgeUse& use : loop)
    if (use.edge.value < 0 || use.edge.value >= static_cast<int>(profile.edges.size()))
      refuse_profile(fmt::format("loop {} of region {} uses edge {} of {}", number, region, use.edge.value,
                                 profile.edges.size()));
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const int end = end_of(loop[i], false), start = end_of(loop[(i + 1) % loop.size()], true);
    if (end != start || (end < 0 && loop.size() > 1))
      refuse_profile(
          fmt::format("loop {} of region {} is open after edge {}", number, region, loop[i].edge.value));
  }
  if (!((signed_area(profile, loop) > 0) == (number == 0)))
    refuse_profile(fmt::format("loop {} of region {} runs the wrong way round", number, region));
}

}  // namespace

void validate(const Profile& profile) {
  // First, since all lengths are held against the size.
  for (const Vector2d& vertex : profile.vertices)
    if (!vertex.allFinite()) refuse_profile("a vertex is not finite");
  for (std::size_t e = 0; e < profile.edges.size(); ++e)
    for (const Vector2d& point : profile.edges[e].points)
      if (!point.allFinite()) refuse_profile(fmt::format("edge {} has a point that is not finite", e));
  const double size = size_of(profile);
  for (std::size_t e = 0; e < profile.edges.size(); ++e) check_edge(profile, static_cast<int>(e), size);
  for (std::size_t r = 0; r < profile.regions.size(); ++r) {
    if (profile.regions[r].loops.empty()) refuse_profile(fmt::format("region {} has no loop", r));
    for (std::size_t l = 0; l < profile.regions[r].loops.size(); ++l) check_loop(profile, r, l);
  }
}

double twice_area(const Profile& profile, const std::vector<geometry::EdgeUse>& loop) {
  double result = 0;
  for (const geometry::EdgeUse& use : loop) {
    const auto& points = profile.edges[static_cast<std::size_t>(use.edge.value)].points;
    double part = 0;
    for (std::size_t i = 1; i < points.size(); ++i)
      part += points[i - 1].x() * points[i].y() - points[i - 1].y() * points[i].x();
    result += use.reversed ? -part : part;
  }
  return result;
}

}  // namespace isopatch::segmentation
