#include "segmentation/decomposition/decompose.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/base/error.hpp"
#include "geometry/brep/hexahedra_quality.hpp"
#include "geometry/brep/solid_error.hpp"
#include "segmentation/decomposition/conforming.hpp"
#include "segmentation/decomposition/cut_tree.hpp"
#include "segmentation/decomposition/geometric_oracle.hpp"
#include "segmentation/decomposition/keep_t_joints.hpp"
#include "segmentation/decomposition/known_shape.hpp"
#include "segmentation/decomposition/star_cells.hpp"
#include "segmentation/decomposition/star_pieces.hpp"
#include "segmentation/decomposition/starting_cell.hpp"
#include "segmentation/decomposition/templates.hpp"
#include "segmentation/decomposition/unfinished_parts.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::CellComplex;
using geometry::CellId;

/// ": 12 would leave the cell, ..."; "" if there are none.
std::string reasons(const CellStore& store) {
  std::string text;
  for (const auto& [reason, count] : store.refusals())
    text += fmt::format("{} {} times: {}", text.empty() ? ":" : ",", count, reason);
  return text;
}

bool is_polyhedral(const Brep& solid, const CellComplex& complex) {
  for (std::size_t c = 0; c < complex.cells.size(); ++c)
    if (!is_polyhedral(CellShapes(solid, complex), CellId(static_cast<int>(c)))) return false;
  return true;
}

/// Searches one after the other. The first are quick. The others differ in what no search can weigh that
/// looks at one cell at a time: T-joints, and solids that are no hexahedra, which divide their neighbours.
std::vector<SearchOptions> searches(const SearchOptions& asked) {
  std::vector<SearchOptions> result = {asked, asked};
  result[0].finish = Finish::convex_solids;
  result[1].finish = Finish::simple_solids;
  for (const double divided : {1.0, 2.0, 0.0})
    for (const double t_joint : {1.0, 0.25, 4.0}) {
      result.push_back(asked);
      result.back().cost.divided *= divided;
      result.back().cost.t_joint *= t_joint;
    }
  return result;
}

/// How parts are made to meet: few complexes are followed at first, and more in the end, when smaller angles,
/// shorter edges and curved sheets are allowed too.
struct Width {
  int beam, branches;
  bool last;
};
constexpr Width narrow = {3, 3, false}, wide = {12, 6, true};

/// Takes one solid apart: finds ways to cut it into base solids, and keeps the one of which the fewest
/// hexahedra come once its parts meet side to side.
class Decomposer {
 public:
  /// @param known  another way, which a better one has to beat
  Decomposer(const Brep& solid, const std::string& name, const DecompositionOptions& options,
             const Progress& progress, std::optional<Decomposition> known)
      : solid_(solid),
        name_(name),
        options_(options),
        progress_(progress),
        store_(solid, options.cut, options.time_limit),
        start_(starting_cell(store_)),
        plane_(is_polyhedral(solid, start_.complex)),
        oracle_(geometric_oracle(store_)),
        best_(std::move(known)) {
    if (best_) leave(options_.time_limit / 8);
    oracle_.goes_on = [this](const SearchRound& round) { return tell(round); };
  }

  Decomposition make() {
    look_all_ways();
    if (cut_.empty() && !best_ && !store_.time_is_up() && !plane_) {
      store_.allow_free_form();
      unfinished_.reset();
      look_all_ways();
    }
    if (options_.t_joints == TJoints::remove) let_meet(cut_, wide);
    if (!best_) give_up();
    best_->report.evaluations = evaluations_;
    best_->report.seconds = store_.seconds();
    return std::move(*best_);
  }

 private:
  void look_all_ways() {
    for (const SearchOptions& search : searches(options_.search)) {
      look(search);
      if (store_.time_is_up()) break;
    }
  }

  /// How far a search is, the details behind a tab.
  /// @return  whether there is time to go on
  bool tell(const SearchRound& round) const {
    progress_(fmt::format("cutting '{}'\t{} cut{}, {} part{} unfinished, {:.0f} of {:g} s", name_, round.cuts,
                          round.cuts == 1 ? "" : "s", round.open, round.open == 1 ? "" : "s",
                          store_.seconds(), options_.time_limit),
              store_.seconds() / options_.time_limit);
    return !store_.time_is_up();
  }

  /// One search; of its ways the one that takes the fewest hexahedra, if it takes fewer than those known.
  void look(const SearchOptions& search) {
    std::vector<Decomposition> ways;
    const std::vector<CutTree> trees = search_several(start_.cell, oracle_, search);
    evaluations_ += trees.front().evaluations;
    for (const CutTree& tree : trees) {
      if (!tree.complete()) {
        if (!unfinished_) unfinished_ = tree;
        continue;
      }
      try {
        ways.push_back(cut(tree));
      } catch (const Error& error) {
        why_not_ = error.what();
      }
    }
    if (ways.empty()) return;
    if (options_.t_joints == TJoints::keep)
      let_be(ways);
    else if (search.finish == Finish::convex_solids)
      return divide_around_points(std::move(ways.front()));
    else
      let_meet(ways, narrow);
    std::move(ways.begin(), ways.end(), std::back_inserter(cut_));
  }

  /// Tetrahedra around a point in every part, whatever meets.
  void divide_around_points(Decomposition way) {
    if (!is_polyhedral(solid_, way.parts)) return;
    CellComplex stars = star_cells(solid_, way.parts);
    way.report.by_tetrahedra = stars.cells.size() > way.parts.cells.size();
    finish(std::move(way), std::move(stars));
    leave(options_.time_limit / 4);
  }

  /// Sides that meet others in parts stay so.
  void let_be(const std::vector<Decomposition>& ways) {
    for (Decomposition way : ways) {
      try {
        way.complex = keep_t_joints(solid_, way.parts, tolerance(), options_.cut.sides);
      } catch (const Error& error) {
        why_not_ = error.what();
        continue;
      }
      way.report.t_joints_kept = true;
      take(std::move(way));
    }
  }

  void let_meet(const std::vector<Decomposition>& ways, const Width& width) {
    if (ways.empty() || store_.time_is_up()) return;
    std::vector<CellComplex> starts;
    for (const Decomposition& way : ways) starts.push_back(way.parts);
    ConformingAttempt attempt = conforming(solid_, starts, conforming_options(width), progress_);
    if (!attempt.best) {
      why_not_ = attempt.refusal;
      return;
    }
    ConformingCells& cells = *attempt.best;
    Decomposition way = ways[cells.start];
    way.report.further_cuts = cells.further_cuts;
    finish(std::move(way), std::move(cells.complex));
    leave(options_.time_limit / 6);
  }

  Decomposition cut(const CutTree& tree) const {
    Decomposition result;
    result.parts = start_.complex;
    result.report.cuts = apply_cuts(solid_, result.parts, CellId(0), tree, store_, store_.options());
    result.report.cells = static_cast<int>(result.parts.cells.size());
    result.t_joints = parted_sides(CellShapes(solid_, result.parts), options_.cut.sides);
    result.report.t_joints = static_cast<int>(result.t_joints.size());
    return result;
  }

  ConformingOptions conforming_options(const Width& width) const {
    ConformingOptions result;
    result.beam = width.beam;
    result.branches = width.branches;
    result.cut = store_.options();
    if (width.last) {
      result.cut.smallest_angle = Angle::degrees(1);
      result.cut.shortest_edge /= 10;
      result.cut.keep_plane = false;
      result.cut.free_form = true;
    }
    result.max_hexahedra = std::min(
        options_.max_cells, best_ ? static_cast<int>(std::ceil(cost(*best_))) - 1 : options_.max_cells);
    result.time_limit = std::max(0.1, store_.time_limit() - store_.seconds());
    return result;
  }

  double tolerance() const { return options_.cut.tolerance * solid_.size(); }

  /// Seconds from now on, if there are so many.
  void leave(double seconds) {
    if (best_) store_.set_time_limit(std::min(store_.time_limit(), store_.seconds() + seconds));
  }

  void finish(Decomposition way, CellComplex side_to_side) {
    try {
      way.complex = hexahedral(solid_, std::move(side_to_side), tolerance());
    } catch (const Error& error) {
      why_not_ = error.what();
      return;
    }
    if (plane_ && geometry::least_quality(way.complex) <= 0) {
      why_not_ =
          "one of its hexahedra would be folded; cut the solid in the CAD program where its parts join";
      return;
    }
    take(std::move(way));
  }

  void take(Decomposition way) {
    way.report.hexahedra = static_cast<int>(way.complex.cells.size());
    if (!best_ || cost(way) < cost(*best_)) best_ = std::move(way);
  }

  /// Hexahedra, and more where some are poor. What curved sides do to them is not known yet.
  double cost(const Decomposition& way) const {
    constexpr double worst = 0.01, good = 0.1;  // scaled Jacobians
    const auto count = static_cast<double>(way.complex.cells.size());
    return plane_ ? count * good / std::clamp(geometry::least_quality(way.complex), worst, good) : count;
  }

  std::string late_to_meet() const {
    return fmt::format(
        "its parts could not be made to meet side to side in {:.3g} s; raise time_limit, or cut "
        "the solid in the CAD program where they join",
        options_.time_limit);
  }

  [[noreturn]] void give_up() const {
    if (!cut_.empty())
      throw unfinished_meeting(Error(ErrorCode::unsupported, why_not_.empty() ? late_to_meet() : why_not_),
                               solid_, cut_.front().parts, cut_.front().t_joints);
    if (!unfinished_) throw Error(ErrorCode::unsupported, why_not_);
    if (store_.time_is_up())
      throw unfinished_search(
          fmt::format(
              "no way of cutting it into hexahedra was found in {:.3g} s; {} cuts were tried, {} of them "
              "refused{}. Raise time_limit, or cut the solid in the CAD program where its parts join",
              options_.time_limit, unfinished_->evaluations, unfinished_->refusals, reasons(store_)),
          *unfinished_, store_);
    throw unfinished_search(
        fmt::format(
            "{} of its parts could not be cut into hexahedra, prisms and tetrahedra, the first at {} "
            "of the solid; {} cuts were tried, {} of them refused{}. Cut the solid in the CAD program "
            "where its parts join",
            unfinished_->unfinished.size(), faces_of_unfinished(*unfinished_, store_),
            unfinished_->evaluations, unfinished_->refusals, reasons(store_)),
        *unfinished_, store_);
  }

  const Brep& solid_;
  const std::string& name_;
  const DecompositionOptions& options_;
  const Progress& progress_;
  CellStore store_;
  StartingCell start_;
  bool plane_;  ///< all sides and edges straight
  SearchOracle oracle_;
  int evaluations_ = 0;
  std::optional<CutTree> unfinished_;  // the first search that ended so
  std::vector<Decomposition> cut_;     // ways into base solids that need not meet side to side
  std::optional<Decomposition> best_;
  std::string why_not_;  // the last way did not end
};

/// What is known of it without a search, or by one.
Decomposition decomposed(const Brep& solid, const std::string& name, const DecompositionOptions& options,
                         const Progress& progress) {
  KnownShape known = known_shape(solid, options);
  if (is_cut_by_hand(options)) return std::move(*known.decomposition);
  const auto with_reason = [&](const Error& error) {
    return known.why_not.empty() ? std::string(error.what())
                                 : fmt::format("{}. {}", error.what(), known.why_not);
  };
  try {
    return Decomposer(solid, name, options, progress, known.decomposition).make();
  } catch (const CuttingError& error) {
    if (known.decomposition) return std::move(*known.decomposition);
    throw CuttingError(error.code(), with_reason(error), error.fault(), error.parts());
  } catch (const geometry::SolidError& error) {
    if (known.decomposition) return std::move(*known.decomposition);
    if (auto made = kept_triangles(solid, options)) return std::move(*made);
    throw geometry::SolidError(error.code(), with_reason(error), error.fault());
  } catch (const Error& error) {
    if (error.code() == ErrorCode::internal) throw;
    if (known.decomposition) return std::move(*known.decomposition);
    throw Error(error.code(), with_reason(error));
  }
}

}  // namespace

Decomposition decompose(const geometry::Brep& solid, const std::string& name,
                        const DecompositionOptions& options, const Progress& progress) {
  validate(options);
  progress(fmt::format("cutting '{}'", name), 0);
  const auto named = [&](const Error& error) { return fmt::format("solid '{}': {}", name, error.what()); };
  try {
    return decomposed(solid, name, options, progress);
  } catch (const CuttingError& error) {
    throw CuttingError(error.code(), named(error), of_solid(error.fault(), name), error.parts());
  } catch (const geometry::SolidError& error) {
    throw geometry::SolidError(error.code(), named(error), of_solid(error.fault(), name));
  } catch (const Error& error) {
    throw Error(error.code(), named(error));
  }
}

}  // namespace isopatch::segmentation
