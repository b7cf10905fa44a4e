#include "segmentation/sweeps/internal/divided_drawing.hpp"

#include <algorithm>
#include <cmath>
#include <future>
#include <iterator>
#include <optional>
#include <utility>

#include "geometry/base/error.hpp"
#include "segmentation/profiles/quadrangulate.hpp"
#include "segmentation/profiles/settled.hpp"
#include "segmentation/profiles/symmetry.hpp"
#include "segmentation/sweeps/internal/drawing_at_height.hpp"
#include "segmentation/sweeps/internal/placed_refusal.hpp"

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

/// A number of quadrilaterals or hexahedra, and more where some are poor.
double cost_of(double number, double least) {
  return number / std::clamp(least, 0.01, good);
}

/// Needles count more: of 1 by 10 as one and a half, of 1 by 100 as three; a Jacobian of 0.75 instead of 0.25
/// is worth a sixth of the hexahedra.
double cost_of(const StandingQuads& stands) {
  constexpr double weight = 0.1, worth = 0.1;
  const double better = std::max(0.0, stands.least_jacobian - good);
  return cost_of(stands.hexahedra + weight * stands.slenderness, stands.least_jacobian) /
         (1 + worth * better / good);
}

/// Of a drawing whose walls are inclined: divided where they are lowest, and half-way up, where what moves is
/// nowhere far from where it is divided, then settled at all heights; thorough ones several times where that
/// does not do, of which the most promising are finished. The best of them at all heights.
class InclinedWalls {
 public:
  /// @param merged   of the drawing's profile, what is divided in its place; must outlive this
  /// @param mirrors  lines that are drawn: what is to their left is divided, and mirrored
  InclinedWalls(const geometry::Brep& solid, const SweepFrame& frame, SweptDrawing drawing,
                const MergedProfile* merged = nullptr, std::vector<MirrorLine> mirrors = {})
      : solid_(solid),
        frame_(frame),
        drawing_(std::move(drawing)),
        merged_(merged),
        mirrors_(std::move(mirrors)) {
    const auto [low, high] = range_of(drawing_.tracks);
    half_way_ = (low + high) / 2;
    there_ = profiles_at_heights(solid, frame, drawing_);
  }

  DividedDrawing divided(QuadrangulationOptions options) {
    if (!options.thorough) {
      consider(draft_at_lowest(options));
      if (!best_ || least_ < good) consider(draft_half_way(options));
    } else {
      options.effort /= 2;  // two at least are made, and settled
      divide_again_and_again(options);
    }
    if (!best_) throw *refusal_;
    return {std::move(drawing_), *std::move(best_)};
  }
  /// Of what was divided: the least scaled Jacobian at all heights, and what it costs.
  double least() const { return least_; }
  double cost() const { return cost_; }

 private:
  /// Of a scaled Jacobian: what is better at all heights stays as it is.
  static constexpr double well_settled = 0.4;
  /// Of further drafts, which are made where the first two do not do.
  static constexpr int further = 6, finished_of_them = 2;

  struct Draft {
    std::optional<DraftedQuadrangulation> quads;  ///< none where it was refused
    std::optional<Error> refusal;
    bool half_way = false;

    double cost() const { return quads ? quads->cost() : 1e300; }
  };

  static Draft draft_of(const Profile& profile, const QuadrangulationOptions& options, bool half_way) {
    Draft result{std::nullopt, std::nullopt, half_way};
    try {
      result.quads.emplace(profile, options);
    } catch (const Error& error) {
      if (error.code() == ErrorCode::internal) throw;
      result.refusal = error;
    }
    return result;
  }
  Draft draft_at_lowest(const QuadrangulationOptions& options) const {
    return draft_of(reduced(drawing_.profile), options, false);
  }
  Draft draft_half_way(const QuadrangulationOptions& options) const {
    return draft_of(reduced(profile_at(solid_, frame_, drawing_, half_way_)), options, true);
  }

  void divide_again_and_again(QuadrangulationOptions options) {
    if (consider_all(both_drafts(options))) return;
    ++options.seed;
    consider_all(both_drafts(options));
    if (best_ && least_ >= good) return;
    std::vector<Draft> drafts;
    while (static_cast<int>(drafts.size()) < further) {
      ++options.seed;
      for (Draft& draft : both_drafts(options)) drafts.push_back(std::move(draft));
    }
    std::stable_sort(drafts.begin(), drafts.end(),
                     [](const Draft& a, const Draft& b) { return a.cost() < b.cost(); });
    // Where none of the best will do, the others may.
    while (!drafts.empty()) {
      const auto rest = drafts.begin() + finished_of_them;
      consider_all({std::make_move_iterator(drafts.begin()), std::make_move_iterator(rest)});
      drafts.erase(drafts.begin(), rest);
      if (best_) return;
    }
  }

  /// One beside the other, since each takes seconds.
  std::vector<Draft> both_drafts(const QuadrangulationOptions& options) const {
    const Profile there = reduced(profile_at(solid_, frame_, drawing_, half_way_));
    std::future<Draft> half_way = std::async(std::launch::async | std::launch::deferred,
                                             [&] { return draft_of(there, options, true); });
    std::vector<Draft> result;
    result.push_back(draft_at_lowest(options));
    result.push_back(half_way.get());
    return result;
  }

  /// Finishes drafts side by side, since each takes seconds, and keeps the best.
  /// @return  whether all of them are good
  bool consider_all(const std::vector<Draft>& drafts) {
    std::vector<std::future<Quadrangulation>> finished;
    for (const Draft& draft : drafts)
      finished.push_back(
          std::async(std::launch::async | std::launch::deferred, [&] { return finished_of(draft); }));
    bool all_are_good = true;
    for (std::size_t i = 0; i < drafts.size(); ++i) {
      const bool is_good = enter(drafts[i], [&] { return finished[i].get(); });
      all_are_good = all_are_good && is_good;
    }
    return all_are_good;
  }
  void consider(const Draft& draft) {
    enter(draft, [&] { return finished_of(draft); });
  }

  Profile reduced(Profile profile) const {
    return merged_ ? merged_->reduced(profile) : part_to_mirror(std::move(profile), mirrors_);
  }

  Quadrangulation finished_of(const Draft& draft) const {
    if (draft.refusal) throw Error(*draft.refusal);
    Quadrangulation quads = or_placed_refusal(solid_, frame_, [&] { return draft.quads->finished(); });
    if (merged_) return merged_->expanded(std::move(quads), drawing_.profile);
    if (mirrors_.empty()) return quads;
    const Profile& there =
        draft.half_way ? profile_at(solid_, frame_, drawing_, half_way_) : drawing_.profile;
    return without_lines(drawing_.profile, mirrors_, mirrored(there, mirrors_, std::move(quads)));
  }

  /// @return  whether it is good at all heights
  template <class Make>
  bool enter(const Draft& draft, const Make& make) {
    try {
      Quadrangulation made = make();
      if (draft.half_way) made = as_drawn(solid_, frame_, drawing_, made, half_way_);
      StandingQuads stands = standing(made);
      settle(made, stands);
      const double cost = cost_of(stands);
      if (!best_ || cost < cost_) {
        best_ = std::move(made);
        least_ = stands.least_jacobian;
        cost_ = cost;
      }
      return stands.least_jacobian >= good;
    } catch (const Error& error) {
      if (error.code() == ErrorCode::internal) throw;
      if (!refusal_) refusal_ = error;
      return false;
    }
  }

  StandingQuads standing(const Quadrangulation& quads) const {
    return standing_quads(solid_, frame_, drawing_, there_, quads);
  }

  /// Where that is better at all heights.
  void settle(Quadrangulation& quads, StandingQuads& stands) const {
    std::vector<Profile> drawings = {drawing_.profile};
    drawings.insert(drawings.end(), there_.profiles.begin(), there_.profiles.end());
    Quadrangulation moved = settled(quads, drawings, stands.upright);
    StandingQuads stand_then = standing(moved);
    if (stand_then.least_jacobian < std::min(stands.least_jacobian, well_settled)) return;
    quads = std::move(moved);
    stands = std::move(stand_then);
  }

  const geometry::Brep& solid_;
  const SweepFrame& frame_;
  SweptDrawing drawing_;
  const MergedProfile* merged_;
  std::vector<MirrorLine> mirrors_;
  double half_way_ = 0;
  ProfilesAtHeights there_;
  std::optional<Quadrangulation> best_;
  double least_ = 0, cost_ = 0;  // scaled Jacobian of the best, and its cost
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

Lines in_space(const std::vector<MirrorLine>& mirrors, const geometry::Brep& solid, const SweepFrame& frame) {
  Lines result;
  for (const MirrorLine& mirror : all_images(mirrors)) result.push_back(in_space(mirror, solid, frame));
  return result;
}

/// About which a drawing is symmetric where it is lowest, half-way up and where it is highest.
std::vector<MirrorLine> lines_at_all_heights(const geometry::Brep& solid, const SweepFrame& frame,
                                             const SweptDrawing& drawing) {
  const auto [low, high] = range_of(drawing.tracks);
  std::vector<MirrorLine> result = mirror_lines(drawing.profile);
  for (const double height : {(low + high) / 2, high}) {
    if (result.empty()) break;
    const Profile there = profile_at(solid, frame, drawing, height);
    result.erase(std::remove_if(result.begin(), result.end(),
                                [&](const MirrorLine& line) { return !is_symmetric(there, line); }),
                 result.end());
  }
  return result;
}

/// A drawing with inclined walls as a whole and by parts that are mirrored; no longer looked for than until
/// one is good, where it is large.
DividedDrawing divided_with_inclined_walls(const geometry::Brep& solid, const SweepFrame& frame,
                                           const Lines& lines, SweptDrawing whole,
                                           const QuadrangulationOptions& options) {
  constexpr std::size_t large = 8;  // outlines: the whole takes ten seconds and more then
  std::size_t outlines = 0;
  for (const ProfileRegion& region : whole.profile.regions)
    outlines += region.wanted ? region.loops.size() : 0;
  const bool is_large = outlines >= large;
  std::optional<DividedDrawing> best;
  std::optional<Error> refusal;
  double least = 0, cost = 0;
  const auto consider = [&](const std::vector<MirrorLine>& mirrors) {
    try {
      SweptDrawing drawing =
          mirrors.empty() ? std::move(whole) : swept_drawing(solid, frame, in_space(mirrors, solid, frame));
      InclinedWalls walls(solid, frame, std::move(drawing), nullptr, mirrors);
      DividedDrawing made = walls.divided(options);
      if (!best || walls.cost() < cost) best = std::move(made), cost = walls.cost(), least = walls.least();
    } catch (const Error& error) {
      if (error.code() == ErrorCode::internal) throw;
      if (!refusal) refusal = error;
    }
  };
  // Lines that others draw are sides of hexahedra: those are divided with the whole.
  std::vector<std::vector<MirrorLine>> ways;
  if (lines.empty()) ways = ways_to_mirror(lines_at_all_heights(solid, frame, whole));
  for (const std::vector<MirrorLine>& mirrors : ways) {
    if (best && is_large && least >= good && mirrors.size() == 1) break;
    consider(mirrors);
  }
  if (!best || !is_large || least < good) consider({});
  if (!best) throw *refusal;
  return std::move(*best);
}

/// Of a drawing that is the same at all heights: by its symmetries, and a thorough one once more where that
/// is not good.
class UprightWalls {
 public:
  /// All must outlive it.
  UprightWalls(const geometry::Brep& solid, const SweepFrame& frame, const Lines& lines,
               const AsDivided& as_divided, SweptDrawing whole)
      : solid_(solid), frame_(frame), as_divided_(as_divided) {
    std::vector<std::vector<MirrorLine>> mirrors;
    if (lines.empty() && stays(whole.tracks))
      mirrors = ways_to_mirror(mirror_lines(profile_of(whole, as_divided)));
    ways_.push_back({{}, std::move(whole)});
    for (const std::vector<MirrorLine>& way : mirrors) {
      add(way, [&] { return swept_drawing(solid, frame, in_space(way, solid, frame)); });
    }
  }

  DividedDrawing divided(QuadrangulationOptions options) {
    for (const Way& way : ways_) consider(way, options);
    // What is little better than its bounds ask for.
    if (!as_divided_ && options.thorough && (!best_ || least_ < 1.25 * options.smallest_jacobian)) {
      options.smallest_jacobian = std::max(options.smallest_jacobian, good);
      for (const Way& way : ways_) consider(way, options);
    }
    if (!best_) throw *refusal_;
    return std::move(*best_);
  }

 private:
  struct Way {
    std::vector<MirrorLine> mirrors;
    SweptDrawing drawing;
  };

  template <class Draw>
  void add(const std::vector<MirrorLine>& mirrors, const Draw& draw) {
    try {
      ways_.push_back({mirrors, draw()});
    } catch (const Error& error) {
      refuse(error);
    }
  }

  void refuse(const Error& error) {
    if (error.code() == ErrorCode::internal) throw error;
    if (!refusal_) refusal_ = error;
  }

  void consider(const Way& way, const QuadrangulationOptions& options) {
    try {
      const Profile profile = profile_of(way.drawing, as_divided_);
      Quadrangulation quads = or_placed_refusal(
          solid_, frame_, [&] { return mirrored_quadrangulation(profile, way.mirrors, options); });
      const double least = least_jacobian(profile, quads);
      const double cost = cost_of(static_cast<double>(quads.quads.size()), least);
      if (best_ && cost >= cost_) return;
      best_ = DividedDrawing{way.drawing, std::move(quads)};
      least_ = least;
      cost_ = cost;
    } catch (const Error& error) {
      refuse(error);
    }
  }

  const geometry::Brep& solid_;
  const SweepFrame& frame_;
  const AsDivided& as_divided_;
  std::vector<Way> ways_;
  std::optional<DividedDrawing> best_;
  double least_ = 0, cost_ = 0;  // scaled Jacobian of the best, and its cost
  std::optional<Error> refusal_;
};

}  // namespace

DividedDrawing divided_drawing(const geometry::Brep& solid, const SweepFrame& frame, const Lines& lines,
                               const QuadrangulationOptions& options, const AsDivided& as_divided) {
  SweptDrawing whole = swept_drawing(solid, frame, lines);
  if (!as_divided && !stays(whole.tracks))
    return divided_with_inclined_walls(solid, frame, lines, std::move(whole), options);
  return UprightWalls(solid, frame, lines, as_divided, std::move(whole)).divided(options);
}

DividedDrawing divided_drawing(const geometry::Brep& solid, const SweepFrame& frame, SweptDrawing drawing,
                               const MergedProfile& merged, const QuadrangulationOptions& options) {
  if (!stays(drawing.tracks))
    return InclinedWalls(solid, frame, std::move(drawing), &merged).divided(options);
  Quadrangulation quads = or_placed_refusal(
      solid, frame, [&] { return mirrored_quadrangulation(merged.reduced(drawing.profile), {}, options); });
  quads = merged.expanded(std::move(quads), drawing.profile);
  return {std::move(drawing), std::move(quads)};
}

}  // namespace isopatch::segmentation
