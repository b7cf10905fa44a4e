#include "segmentation/decomposition/conforming.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/base/processor_stopwatch.hpp"
#include "segmentation/decomposition/chords.hpp"
#include "segmentation/decomposition/closing_cuts.hpp"
#include "segmentation/decomposition/combinatorics/base_solid.hpp"
#include "segmentation/decomposition/combinatorics/cell_incidence.hpp"
#include "segmentation/decomposition/hexahedra_to_come.hpp"

namespace isopatch::segmentation {
namespace {

/// The guess of what comes of a complex on the way may be too high by so much.
constexpr double slack = 1.4;

using geometry::Brep;
using geometry::CellComplex;
using geometry::CellId;

/// What a chord makes more of, in hexahedra, as experience has it: a sheet, or parts that are no hexahedra.
double cost_of_chord(const CellComplex& complex, const CellSides& sides, const Chord& chord) {
  if (!chord.across) return 6;
  const auto from = place_of(complex, sides, chord.from), to = place_of(complex, sides, chord.to);
  return from && to && from->auxiliary() && to->auxiliary() ? 2 : 5;
}

/// A complex on the way, and which of its cells is to be cut next.
struct ConformingState {
  ConformingCells cells;
  double score = 0;
  int open = -1;  ///< cell; -1 where nothing is left to do
  CellSides sides = {};
  std::vector<Chord> chords = {};
};

class ConformingSearch {
 public:
  ConformingSearch(const Brep& source, const ConformingOptions& options, const Progress& progress)
      : source_(source), options_(options), progress_(progress) {}

  ConformingAttempt from(const std::vector<CellComplex>& starts) {
    progress_("letting parts meet side to side", 0);
    for (std::size_t s = 0; s < starts.size(); ++s) put(beam_, {starts[s], s, 0, 0});
    keep_best(beam_);
    while (!beam_.empty() && watch_.seconds() < options_.time_limit) advance();
    ConformingAttempt result;
    result.best = std::move(best_);
    if (!result.best) result.refusal = refusal_;
    return result;
  }

 private:
  void advance() {
    std::vector<ConformingState> next;
    for (const ConformingState& state : beam_) {
      const CellShapes shapes(source_, state.cells.complex);
      const CellId cell(state.open);
      ClosingCuts cuts = state.chords.empty()
                             ? cuts_at_vertices(shapes, cell, state.sides, options_.cut)
                             : closing_cuts(shapes, cell, state.sides, state.chords, options_.cut);
      if (cuts.cuts.empty())
        refusal_ = fmt::format("a part cannot be cut {}: {}",
                               state.chords.empty() ? "where more than three of its edges meet"
                                                    : "along the edges that its neighbours put on its sides",
                               cuts.refusal);
      std::vector<ConformingState> mine;
      for (CutCell& cut : cuts.cuts)
        put(mine, {std::move(cut.complex), state.cells.start, state.cells.further_cuts + 1, 0});
      std::stable_sort(mine.begin(), mine.end(), is_better);
      if (static_cast<int>(mine.size()) > options_.branches)
        mine.resize(static_cast<std::size_t>(options_.branches));
      std::move(mine.begin(), mine.end(), std::back_inserter(next));
    }
    keep_best(next);
    beam_ = std::move(next);
  }

  static bool is_better(const ConformingState& a, const ConformingState& b) { return a.score < b.score; }

  void keep_best(std::vector<ConformingState>& states) const {
    std::erase_if(states,
                  [&](const ConformingState& state) { return state.cells.hexahedra >= slack * limit(); });
    std::stable_sort(states.begin(), states.end(), is_better);
    const auto alike = [](const ConformingState& a, const ConformingState& b) {
      return std::abs(a.score - b.score) < 1e-9 &&
             a.cells.complex.cells.size() == b.cells.complex.cells.size() &&
             a.cells.complex.edges.size() == b.cells.complex.edges.size() && a.open == b.open;
    };
    states.erase(std::unique(states.begin(), states.end(), alike), states.end());
    if (static_cast<int>(states.size()) > options_.beam)
      states.resize(static_cast<std::size_t>(options_.beam));
  }

  double limit() const { return best_ ? best_->hexahedra : options_.max_hexahedra + 1; }

  /// Rates a complex: finished ones are compared with the best, others are put to the states.
  void put(std::vector<ConformingState>& states, ConformingCells cells) {
    ConformingState state{std::move(cells)};
    try {
      rate(state);
    } catch (const Error& error) {
      refusal_ = error.what();
      return;
    }
    if (state.cells.hexahedra >= (state.open >= 0 ? slack : 1) * limit()) {
      if (!best_) refusal_ = fmt::format("more than {} hexahedra would come of it", options_.max_hexahedra);
      return;
    }
    if (state.open >= 0)
      states.push_back(std::move(state));
    else
      best_ = std::move(state.cells);
  }

  void rate(ConformingState& state) const {
    const CellComplex& complex = state.cells.complex;
    const CellShapes shapes(source_, complex);
    std::vector<CellSides> all;
    double chords_cost = 0;
    int curved = 0;  // planes may not cut them any more
    for (std::size_t c = 0; c < complex.cells.size(); ++c) {
      all.push_back(cell_sides(shapes, CellId(static_cast<int>(c)), options_.cut.sides));
      if (!is_three_connected(all.back().graph))
        throw Error(ErrorCode::unsupported, "a part would not be 3-connected");
      if (!is_polyhedral(shapes, CellId(static_cast<int>(c)))) ++curved;
      std::vector<Chord> chords = chords_of(shapes, all.back());
      for (const Chord& chord : chords) chords_cost += cost_of_chord(complex, all.back(), chord);
      const bool closed = chords.empty() && simple_solid(all.back().graph);
      if (closed || (state.open >= 0 && (!state.chords.empty() || chords.empty()))) continue;
      state.open = static_cast<int>(c);
      state.chords = std::move(chords);
    }
    state.cells.hexahedra = hexahedra_to_come(complex, all);
    state.score = state.cells.hexahedra + chords_cost + 0.5 * curved;
    if (state.open >= 0) state.sides = std::move(all[static_cast<std::size_t>(state.open)]);
  }

  const Brep& source_;
  const ConformingOptions& options_;
  const Progress& progress_;
  ProcessorStopwatch watch_;
  std::vector<ConformingState> beam_;
  std::optional<ConformingCells> best_;
  std::string refusal_;
};

}  // namespace

ConformingAttempt conforming(const Brep& source, const std::vector<CellComplex>& starts,
                             const ConformingOptions& options, const Progress& progress) {
  return ConformingSearch(source, options, progress).from(starts);
}

}  // namespace isopatch::segmentation
