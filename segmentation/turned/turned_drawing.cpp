#include "segmentation/turned/internal/turned_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/splines/arc.hpp"
#include "segmentation/profiles/quadrangulate.hpp"
#include "segmentation/turned/internal/end_drawing.hpp"
#include "segmentation/turned/internal/half_rays.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::EdgeUse;
using Loop = std::vector<EdgeUse>;

/// The way on along curves that meet two by two.
class LoopWalk {
 public:
  explicit LoopWalk(const HalfProfile& half) : half_(half), done_(half.curves.size(), false) {
    at_.resize(half.vertices.size());
    for (std::size_t c = 0; c < half.curves.size(); ++c)
      for (const int end : {half.curves[c].start, half.curves[c].end})
        if (end >= 0) at_[static_cast<std::size_t>(end)].push_back(c);
  }

  std::vector<Loop> loops() {
    std::vector<Loop> result;
    for (std::size_t c = 0; c < half_.curves.size(); ++c)
      if (!done_[c]) result.push_back(from(c));
    return result;
  }

 private:
  Loop from(std::size_t first) {
    Loop loop;
    std::size_t c = first;
    int to = half_.curves[first].end;
    for (bool reversed = false;;) {
      done_[c] = true;
      loop.push_back({EdgeId(static_cast<int>(c)), reversed});
      if (to == half_.curves[first].start) return loop;
      const auto& here = at_[static_cast<std::size_t>(to)];
      if (here.size() != 2)
        throw Error(ErrorCode::unsupported, "its half profile does not close, or touches itself");
      c = here[0] == c ? here[1] : here[0];
      reversed = half_.curves[c].end == to;
      to = reversed ? half_.curves[c].start : half_.curves[c].end;
    }
  }

  const HalfProfile& half_;
  std::vector<std::vector<std::size_t>> at_;
  std::vector<bool> done_;
};

void turn(Loop& loop) {
  std::reverse(loop.begin(), loop.end());
  for (EdgeUse& use : loop) use.reversed = !use.reversed;
}

/// The largest loop is the outline, the others are holes in it.
ProfileRegion region_of(const Profile& profile, std::vector<Loop> loops) {
  if (loops.empty()) throw Error(ErrorCode::unsupported, "its half profile is empty");
  std::sort(loops.begin(), loops.end(), [&](const Loop& a, const Loop& b) {
    return std::abs(twice_area(profile, a)) > std::abs(twice_area(profile, b));
  });
  for (std::size_t i = 0; i < loops.size(); ++i)
    if ((twice_area(profile, loops[i]) > 0) != (i == 0)) turn(loops[i]);
  return {std::move(loops), true};
}

/// @param regions  their loops may run either way round; none: the curves bound one
Profile profile_of(const Brep& solid, const TurnedFrame& frame, const HalfProfile& half,
                   const std::vector<ProfileRegion>& regions) {
  Profile profile;
  // Vertices that are left over are no corners.
  profile.vertices = half.vertices;
  for (const HalfCurve& curve : half.curves) {
    ProfileEdge& drawn = profile.edges.emplace_back(ProfileEdge{curve.start, curve.end, {}});
    const int pieces = is_straight(solid, curve) ? 1 : 48;
    for (int i = 0; i <= pieces; ++i)
      drawn.points.push_back(point(solid, frame, half, curve, static_cast<double>(i) / pieces));
  }
  if (regions.empty()) profile.regions = {region_of(profile, LoopWalk(half).loops())};
  for (const ProfileRegion& region : regions) profile.regions.push_back(region_of(profile, region.loops));
  return profile;
}

/// As many quadrilaterals for each curve are a division that did not end within its bounds of angles.
constexpr std::size_t too_many = 2;
/// Searches of a drawing that is hard to divide; one in three finds a good division of a shaft with rounds.
constexpr unsigned more_searches = 5;
constexpr int more_effort = 8;

/// Looks further where few curves need many quadrilaterals.
Quadrangulation divided(const Profile& profile, QuadrangulationOptions options) {
  std::optional<Quadrangulation> best;
  std::optional<Error> refusal;
  for (unsigned search = 0; search <= more_searches; ++search) {
    try {
      Quadrangulation found = quadrangulate(profile, options);
      if (!best || found.quads.size() < best->quads.size()) best = std::move(found);
      if (best->quads.size() <= too_many * profile.edges.size() + 4) break;
    } catch (const Error& error) {
      if (error.code() != ErrorCode::unsupported) throw;
      refusal = error;
    }
    if (search == 0) options.effort *= more_effort;
    ++options.seed;
  }
  if (!best) throw *refusal;
  return *std::move(best);
}

void find_curves(const Brep& solid, const TurnedFrame& frame, TurnedDrawing& drawing) {
  drawing.places = drawing.quads.vertices;
  drawing.curves.resize(drawing.quads.edges.size());
  const auto place = [&](int vertex) -> Eigen::Vector2d& {
    return drawing.places[static_cast<std::size_t>(vertex)];
  };
  const auto curve_of = [&](const QuadEdge& edge) {
    return edge.profile_edge < 0 ? HalfCurve{}
                                 : drawing.half.outside.curves[static_cast<std::size_t>(edge.profile_edge)];
  };
  for (std::size_t e = 0; e < drawing.curves.size(); ++e) {
    const QuadEdge& edge = drawing.quads.edges[e];
    const HalfCurve half = curve_of(edge);
    if (!half.edge && !half.arc) continue;
    geometry::NurbsCurve& curve = drawing.curves[e];
    curve = piece_of_half_curve(solid, frame, half, edge.low, edge.high);
    place(edge.start) = frame.flat(curve.point(curve.low()));
    place(edge.end) = frame.flat(curve.point(curve.high()));
  }
  for (std::size_t e = 0; e < drawing.curves.size(); ++e) {
    const QuadEdge& edge = drawing.quads.edges[e];
    if (const HalfCurve half = curve_of(edge); !half.edge && !half.arc)
      drawing.curves[e] =
          geometry::segment(frame.point(place(edge.start), 0), frame.point(place(edge.end), 0));
  }
}

/// Edges of quadrilaterals that are pieces of some curves, in their order.
std::vector<int> pieces_of(const Quadrangulation& quads, const std::vector<int>& curves) {
  std::vector<int> result;
  for (const int curve : curves) {
    const auto first = static_cast<std::ptrdiff_t>(result.size());
    for (std::size_t e = 0; e < quads.edges.size(); ++e)
      if (quads.edges[e].profile_edge == curve) result.push_back(static_cast<int>(e));
    std::sort(result.begin() + first, result.end(), [&](int a, int b) {
      return quads.edges[static_cast<std::size_t>(a)].low < quads.edges[static_cast<std::size_t>(b)].low;
    });
  }
  return result;
}

void divide_whole(const Brep& solid, const TurnedFrame& frame, const std::vector<ProfileRegion>& regions,
                  const QuadrangulationOptions& options, TurnedDrawing& drawing) {
  drawing.quads = divided(profile_of(solid, frame, drawing.half.outside, regions), options);
  find_curves(solid, frame, drawing);
  for (const CoreStrip& strip : drawing.half.strips)
    drawing.columns.push_back(pieces_of(drawing.quads, strip.line));
}

}  // namespace

TurnedDrawing turned_drawing(const Brep& solid, const TurnedFrame& frame,
                             const std::vector<std::array<Eigen::Vector3d, 2>>& lines,
                             const QuadrangulationOptions& options) {
  TurnedDrawing result;
  result.half = without_cores(solid, frame, half_profile(solid, frame));
  if (!frame.is_whole() && result.half.strips.empty()) {
    EndDrawing end = end_drawing(solid, frame, lines);
    result.half.outside = std::move(end.half);
    result.quads = divided(profile_of(end.sheet, frame, result.half.outside, end.regions), options);
    find_curves(end.sheet, frame, result);
    return result;
  }
  divide_whole(solid, frame, {}, options, result);
  return result;
}

TurnedDrawing turned_drawing(const Brep& solid, const TurnedFrame& frame, const TurnedRequest& request,
                             const QuadrangulationOptions& options) {
  TurnedDrawing result;
  result.half = without_cores(solid, frame, half_profile(solid, frame), request.core_share);
  draw_rays(solid, frame, request.rays, result.half);
  std::vector<ProfileRegion> regions;
  if (!request.rays.empty()) regions = half_regions(solid, frame, result.half.outside);
  divide_whole(solid, frame, regions, options, result);
  return result;
}

}  // namespace isopatch::segmentation
