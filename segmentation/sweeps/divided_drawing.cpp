#include "segmentation/sweeps/internal/divided_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry/base/error.hpp"
#include "segmentation/profiles/quadrangulate.hpp"
#include "segmentation/profiles/symmetry.hpp"
#include "segmentation/sweeps/internal/drawing_at_height.hpp"

namespace isopatch::segmentation {
namespace {

using Lines = std::vector<std::array<Eigen::Vector3d, 2>>;

Profile profile_of(const SweptDrawing& drawing, const AsDivided& as_divided) {
  return as_divided ? as_divided(drawing) : drawing.profile;
}

bool stays(const Tracks& tracks) {
  return tracks.vertices.empty() && tracks.edges.empty() && tracks.rings.empty();
}

double least_jacobian(const Profile& profile, const Quadrangulation& quads) {
  double least = 1;
  for (int q = 0; q < static_cast<int>(quads.quads.size()); ++q)
    least = std::min(least, shape_of(profile, quads, q).jacobian);
  return least;
}

/// Of a scaled Jacobian: better ones are not worth another quadrilateral.
constexpr double good = 0.25;

/// Their number, and more where some are poor.
double cost_of(const Quadrangulation& quads, double least) {
  return static_cast<double>(quads.quads.size()) / std::clamp(least, 0.01, good);
}

/// Of a drawing whose walls are inclined: divided where they are lowest, and half-way up, where what moves is
/// nowhere far from where it is divided; the better of both at all heights.
DividedDrawing divided_with_inclined_walls(const geometry::Brep& solid, const SweepFrame& frame,
                                           SweptDrawing drawing, const QuadrangulationOptions& options) {
  const auto [low, high] = range_of(drawing.tracks);
  const auto least = [&](const Quadrangulation& quads) {
    return least_over_heights(solid, frame, drawing, quads);
  };
  std::optional<Quadrangulation> best;
  std::optional<Error> refusal;
  for (const bool half_way : {false, true}) {
    if (half_way && best && !options.thorough && least(*best) >= good) break;
    try {
      const double height = (low + high) / 2;
      Quadrangulation made =
          half_way ? as_drawn(solid, frame, drawing,
                              quadrangulate(profile_at(solid, frame, drawing, height), options), height)
                   : quadrangulate(drawing.profile, options);
      if (!best || cost_of(made, least(made)) < cost_of(*best, least(*best))) best = std::move(made);
    } catch (const Error& error) {
      if (error.code() == ErrorCode::internal) throw;
      if (!refusal) refusal = error;
    }
  }
  if (!best) throw *refusal;
  return {std::move(drawing), *std::move(best)};
}

/// As long as the solid to both sides, so that it crosses all of the drawing.
std::array<Eigen::Vector3d, 2> in_space(const MirrorLine& line, const geometry::Brep& solid,
                                        const SweepFrame& frame) {
  const Eigen::Vector2d middle =
      line.point + (frame.flat(solid.vertex(VertexId(0))) - line.point).dot(line.along) * line.along;
  return {frame.point(middle - solid.size() * line.along, 0),
          frame.point(middle + solid.size() * line.along, 0)};
}

/// Each line, and the first two at right angles.
std::vector<std::vector<MirrorLine>> ways_to_mirror(const std::vector<MirrorLine>& lines) {
  constexpr std::size_t most = 2;
  std::vector<std::vector<MirrorLine>> result;
  for (const MirrorLine& line : lines)
    if (result.size() < most) result.push_back({line});
  for (std::size_t j = 1; j < lines.size(); ++j)
    if (std::abs(lines[0].along.dot(lines[j].along)) < 1e-6) {
      result.push_back({lines[0], lines[j]});
      break;
    }
  return result;
}

}  // namespace

DividedDrawing divided_drawing(const geometry::Brep& solid, const SweepFrame& frame, const Lines& lines,
                               const QuadrangulationOptions& options, const AsDivided& as_divided) {
  std::optional<DividedDrawing> best;
  std::optional<Error> refusal;
  double least = 0;
  const auto consider = [&](SweptDrawing drawing, const std::vector<MirrorLine>& mirrors) {
    try {
      const Profile profile = profile_of(drawing, as_divided);
      Quadrangulation quads = mirrored_quadrangulation(profile, mirrors, options);
      const double cost = cost_of(quads, least_jacobian(profile, quads));
      if (!best || cost < least) best = DividedDrawing{std::move(drawing), std::move(quads)}, least = cost;
    } catch (const Error& error) {
      if (error.code() == ErrorCode::internal) throw;
      if (!refusal) refusal = error;
    }
  };
  SweptDrawing whole = swept_drawing(solid, frame, lines);
  if (!as_divided && !stays(whole.tracks))
    return divided_with_inclined_walls(solid, frame, std::move(whole), options);
  std::vector<std::vector<MirrorLine>> ways;
  if (lines.empty() && stays(whole.tracks))
    ways = ways_to_mirror(mirror_lines(profile_of(whole, as_divided)));
  consider(std::move(whole), {});
  for (const std::vector<MirrorLine>& mirrors : ways) {
    Lines drawn;
    for (const MirrorLine& mirror : mirrors) drawn.push_back(in_space(mirror, solid, frame));
    consider(swept_drawing(solid, frame, drawn), mirrors);
  }
  if (!best) throw *refusal;
  return std::move(*best);
}

}  // namespace isopatch::segmentation
