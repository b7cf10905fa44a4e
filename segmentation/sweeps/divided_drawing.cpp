#include "segmentation/sweeps/internal/divided_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <future>
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
/// nowhere far from where it is divided; thorough ones several times. The best of them at all heights.
class InclinedWalls {
 public:
  InclinedWalls(const geometry::Brep& solid, const SweepFrame& frame, SweptDrawing drawing)
      : solid_(solid), frame_(frame), drawing_(std::move(drawing)) {
    const auto [low, high] = range_of(drawing_.tracks);
    half_way_ = (low + high) / 2;
  }

  DividedDrawing divided(QuadrangulationOptions options) {
    constexpr unsigned most = 4;
    if (options.thorough) options.good_jacobian = std::max(options.good_jacobian, at_one_height);
    const double enough = options.thorough ? at_one_height : good;
    for (unsigned again = 0; again < (options.thorough ? most : 1U); ++again, ++options.seed) {
      // Beside the other, since each takes seconds where it is thorough.
      std::future<Quadrangulation> half_way =
          std::async(options.thorough ? std::launch::async | std::launch::deferred : std::launch::deferred,
                     [&] { return divided_half_way(options); });
      consider([&] { return quadrangulate(drawing_.profile, options); });
      if (!options.thorough && best_ && least_ >= enough) break;
      consider([&] { return half_way.get(); });
      if (best_ && least_ >= enough) break;
    }
    if (!best_) throw *refusal_;
    return {std::move(drawing_), *std::move(best_)};
  }

 private:
  /// Of a scaled Jacobian where a drawing is divided, so that it is good at other heights.
  static constexpr double at_one_height = 0.4;

  template <class Make>
  void consider(const Make& make) {
    try {
      Quadrangulation made = make();
      const double least = least_over_heights(solid_, frame_, drawing_, made);
      if (best_ && cost_of(*best_, least_) <= cost_of(made, least)) return;
      best_ = std::move(made);
      least_ = least;
    } catch (const Error& error) {
      if (error.code() == ErrorCode::internal) throw;
      if (!refusal_) refusal_ = error;
    }
  }

  Quadrangulation divided_half_way(const QuadrangulationOptions& options) const {
    const Profile there = profile_at(solid_, frame_, drawing_, half_way_);
    return as_drawn(solid_, frame_, drawing_, quadrangulate(there, options), half_way_);
  }

  const geometry::Brep& solid_;
  const SweepFrame& frame_;
  SweptDrawing drawing_;
  double half_way_ = 0;
  std::optional<Quadrangulation> best_;
  double least_ = 0;  // scaled Jacobian of the best
  std::optional<Error> refusal_;
};

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
    return InclinedWalls(solid, frame, std::move(whole)).divided(options);
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
