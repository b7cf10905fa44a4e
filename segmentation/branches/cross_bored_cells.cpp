#include "segmentation/branches/cross_bored_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>
#include <utility>
#include <vector>

#include "geometry/base/error.hpp"
#include "geometry/base/processor_stopwatch.hpp"
#include "geometry/brep/hexahedra_quality.hpp"
#include "geometry/brep/require_solid.hpp"
#include "geometry/brep/without_faces.hpp"
#include "segmentation/branches/internal/bore_room.hpp"
#include "segmentation/branches/internal/branch_tops.hpp"
#include "segmentation/branches/internal/cross_bores.hpp"
#include "segmentation/branches/internal/own_columns.hpp"
#include "segmentation/sweeps/require_all_of.hpp"
#include "segmentation/sweeps/swept_cells.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::CellComplex;

class BoredStack {
 public:
  BoredStack(const Brep& solid, const Brep& blank, const SweepFrame& frame,
             const std::vector<CrossBore>& bores)
      : solid_(solid), blank_(blank), bores_(bores), frame_(frame) {}

  bool columns_end_at_corners() const {
    try {
      return own_columns(solid_, blank_, frame_, bores_).end_at_corners;
    } catch (const Error& error) {
      if (error.code() == ErrorCode::internal) throw;
      return false;
    }
  }

  CrossBoredCells make(FloorLines floors, bool thorough) {
    const BoreRoom room = bore_room(solid_, blank_, frame_, bores_, floors);
    CellComplex complex =
        swept_with(blank_, frame_, room.lines, room.heights, room.kept_free, {.thorough = thorough}).complex;
    std::vector<BranchPlace> places;
    for (const CrossBore& bore : bores_) places.push_back(place_of(bore, complex));
    name_faces(complex);
    BranchTops tops(solid_);
    for (std::size_t b = 0; b < bores_.size(); ++b) {
      if (bores_[b].is_boss) tops.find(bores_[b].branch, places[b]);
      complex = inserted_branch(solid_, complex, bores_[b].branch, places[b], tops.cut_face());
    }
    complex = tops.with(std::move(complex));
    require_all_of(solid_, complex);
    const auto count = [&](bool CrossBore::*is) {
      return static_cast<int>(
          std::count_if(bores_.begin(), bores_.end(), [&](const CrossBore& bore) { return bore.*is; }));
    };
    return {std::move(complex), frame_.along, static_cast<int>(bores_.size()), count(&CrossBore::is_slot),
            count(&CrossBore::is_boss)};
  }

 private:
  double tolerance() const { return 1e-6 * solid_.size(); }

  /// The side that the bore opens in, the outermost that looks like a rectangle around it along the bore.
  BranchPlace place_of(const CrossBore& bore, const CellComplex& complex) const {
    const PlanView& view = bore.branch.view;
    std::optional<BranchPlace> best;
    Eigen::Vector2d low, high;
    double highest = -1e300;
    for (const geometry::CellFace& face : complex.faces) {
      if (!face.origin || face.loop.size() != 4) continue;
      BranchPlace place;
      double height = 0;
      Eigen::Vector2d least(1e300, 1e300), most(-1e300, -1e300);
      for (std::size_t i = 0; i < 4; ++i) {
        place.corners[i] = complex.vertex(complex.from(face.loop[i]));
        height += view.height(place.corners[i]) / 4;
        least = least.cwiseMin(view.flat(place.corners[i]));
        most = most.cwiseMax(view.flat(place.corners[i]));
      }
      const bool is_rectangle =
          std::all_of(place.corners.begin(), place.corners.end(), [&](const Eigen::Vector3d& corner) {
            return (view.flat(corner) - least).cwiseMin(most - view.flat(corner)).cwiseAbs().maxCoeff() <
                   tolerance();
          });
      if (!is_rectangle || (bore.opening && std::abs(height - bore.branch.surface) > tolerance()) ||
          height < highest || least.maxCoeff() > -tolerance() || most.minCoeff() < tolerance())
        continue;
      best = place;
      low = least;
      high = most;
      highest = height;
    }
    if (!best)
      throw Error(ErrorCode::unsupported,
                  fmt::format("{} begins in no side of its stack that is rectangular as seen along it",
                              describe(solid_, bore.faces.front())));
    require_room(bore, low, high);
    return *best;
  }

  /// In a rectangle, seen as the bore is.
  void require_room(const CrossBore& bore, const Eigen::Vector2d& low, const Eigen::Vector2d& high) const {
    const double free = (bore.low - low).cwiseMin(high - bore.high).minCoeff();
    if (free < least_room * bore.radius)
      throw Error(ErrorCode::unsupported, fmt::format("{} has no room beside it: {:.3g} mm to what is next",
                                                      describe(solid_, bore.faces.front()), 1e3 * free));
  }

  /// Replaces the blank's faces as origins of the complex's by the solid's.
  void name_faces(CellComplex& complex) const {
    std::set<FaceId> bored;
    for (const CrossBore& bore : bores_) bored.insert(bore.faces.begin(), bore.faces.end());
    std::vector<FaceId> names;
    for (int f = 0; f < static_cast<int>(solid_.faces().size()); ++f)
      if (!bored.contains(FaceId(f))) names.emplace_back(f);
    if (names.size() != blank_.faces().size())
      throw Error(ErrorCode::unsupported, "its faces go on in others where its bores are filled");
    for (geometry::CellFace& face : complex.faces)
      if (face.origin) face.origin = names[static_cast<std::size_t>(face.origin->value)];
  }

  /// Beside a bore, as a share of its radius: less would make thin hexahedra.
  static constexpr double least_room = 0.1;
  const Brep& solid_;
  const Brep& blank_;
  const std::vector<CrossBore>& bores_;
  SweepFrame frame_;
};

/// Columns that end at corners of walls first, or else after others.
std::vector<FloorLines> ways_to_draw(const BoredStack& stack) {
  if (stack.columns_end_at_corners())
    return {FloorLines::own_columns, FloorLines::through_all, FloorLines::between_planes};
  return {FloorLines::through_all, FloorLines::between_planes, FloorLines::own_columns};
}

/// With the floors' planes through all of it, or else no longer than they have to be; last by drawings that
/// take longer. The first that is good enough, columns that end at corners only where they are better than
/// that; else the best.
CrossBoredCells made_of(BoredStack stack) {
  constexpr double good = 0.12, good_at_once = 0.25;  // least scaled Jacobian
  constexpr double enough_seconds = 15;               // after which no longer drawings are begun
  const ProcessorStopwatch watch;
  std::optional<CrossBoredCells> best;
  std::optional<Error> refusal;
  double least = 0;
  const std::vector<FloorLines> ways = ways_to_draw(stack);
  for (const bool thorough : {false, true})
    for (const FloorLines floors : ways) {
      if (thorough && watch.seconds() > enough_seconds) break;
      try {
        CrossBoredCells made = stack.make(floors, thorough);
        const double quality = geometry::least_quality(made.complex);
        if (!best || quality > least) best = std::move(made), least = quality;
        const bool first = !thorough && floors == FloorLines::own_columns && floors == ways.front();
        if (least > (first ? good_at_once : good)) return std::move(*best);
      } catch (const Error& error) {
        if (error.code() == ErrorCode::internal) throw;
        if (!refusal) refusal = error;
      }
    }
  if (!best) throw *refusal;
  return std::move(*best);
}

/// A direction along which a solid is a stack but for what is across it.
struct BoredWay {
  Eigen::Vector3d along;
  std::vector<CrossBore> bores;
};

/// The directions along which the solid is a stack but for bores across, those with the fewest bores first.
/// @param refusal  gets why one that looks so is none
std::vector<BoredWay> bored_ways(const Brep& solid, std::optional<Error>& refusal) {
  std::vector<BoredWay> result;
  for (const Eigen::Vector3d& along : floor_directions(solid)) {
    try {
      if (auto bores = cross_bores(solid, along)) result.push_back({along, *std::move(bores)});
    } catch (const Error& error) {
      if (error.code() == ErrorCode::internal) throw;
      if (!refusal) refusal = error;
    }
  }
  std::stable_sort(result.begin(), result.end(),
                   [](const BoredWay& a, const BoredWay& b) { return a.bores.size() < b.bores.size(); });
  return result;
}

std::optional<CrossBoredCells> bored_along(const Brep& solid, const BoredWay& way) {
  std::vector<FaceId> removed;
  for (const CrossBore& bore : way.bores) removed.insert(removed.end(), bore.faces.begin(), bore.faces.end());
  const Brep blank = geometry::without_faces(solid, removed);
  for (const SweepFrame& frame : sweep_frames(blank))
    if (frame.along.cross(way.along).norm() < 1e-7)
      return made_of(BoredStack(solid, blank, frame, way.bores));
  return std::nullopt;
}

}  // namespace

std::optional<Eigen::Vector3d> bored_across(const Brep& solid) {
  std::optional<Error> refusal;
  const std::vector<BoredWay> ways = bored_ways(solid, refusal);
  return ways.empty() ? std::nullopt : std::optional(ways.front().along);
}

bool bores_meet(const Brep& solid) {
  std::optional<Error> refusal;
  const std::vector<BoredWay> ways = bored_ways(solid, refusal);
  return std::any_of(ways.begin(), ways.end(), [](const BoredWay& way) {
    return std::any_of(way.bores.begin(), way.bores.end(),
                       [](const CrossBore& bore) { return !bore.ends.empty(); });
  });
}

std::optional<CrossBoredCells> cross_bored_cells(const Brep& solid) {
  std::optional<Error> refusal;
  for (const BoredWay& way : bored_ways(solid, refusal)) {
    try {
      if (auto made = bored_along(solid, way)) return made;
    } catch (const Error& error) {
      if (error.code() == ErrorCode::internal) throw;
      if (!refusal) refusal = error;
    }
  }
  if (refusal) throw *refusal;
  return std::nullopt;
}

}  // namespace isopatch::segmentation
