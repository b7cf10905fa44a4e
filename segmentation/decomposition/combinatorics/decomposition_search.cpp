#include "segmentation/decomposition/combinatorics/decomposition_search.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <utility>

#include "geometry/base/error.hpp"
#include "segmentation/decomposition/combinatorics/internal/search_cells.hpp"

namespace isopatch::segmentation {
namespace {

constexpr double unfinished_cost = 1000;

// How a state came about, last cut first; shared by all that come of it. Without an option a cell stays as it
// is.
struct CutDecision {
  int cell = -1, option = -1;
  std::shared_ptr<const CutDecision> before;
};

// A set of cells that the whole has been cut into.
struct SearchState {
  std::vector<int> open;
  double done = 0;  // what cells that stay and penalties cost
  double score = 0;
  int cuts = 0;
  std::size_t fingerprint = 0;
  std::shared_ptr<const CutDecision> decisions;
};

class BeamSearch {
 public:
  BeamSearch(const SearchCell& cell, const SearchOracle& oracle, const SearchOptions& options)
      : oracle_(oracle), options_(options), cells_(oracle, options), root_(cells_.add(cell)) {
    if (root_ < 0)
      throw Error(ErrorCode::not_three_connected,
                  "the cell to be cut must have a 3-connected graph; put auxiliary edges in its faces "
                  "before, or contract "
                  "flat edges");
  }

  std::vector<CutTree> run() {
    SearchState start;
    put(start, root_);
    rate(start);
    beam_.push_back(std::move(start));
    while (!beam_.empty() && goes_on()) advance();
    if (best_.empty()) best_.push_back(beam_.front());
    std::vector<CutTree> result;
    for (const SearchState& state : best_) result.push_back(tree(state));
    return result;
  }

 private:
  bool goes_on() const {
    const SearchState& best = beam_.front();
    return !oracle_.goes_on || oracle_.goes_on({best.cuts, static_cast<int>(best.open.size())});
  }

  void put(SearchState& state, int cell) const {
    if (cells_.entry(cell).base)
      state.done += cells_.entry(cell).cost;
    else
      state.open.push_back(cell);
  }

  // Open cells dearest first: the last is the cheapest.
  void rate(SearchState& state) const {
    std::sort(state.open.begin(), state.open.end(), [&](int a, int b) {
      const double dear_a = cells_.entry(a).cost, dear_b = cells_.entry(b).cost;
      return dear_a != dear_b ? dear_a > dear_b : a < b;
    });
    state.score = state.done;
    state.fingerprint = 0;
    for (const int cell : state.open) {
      state.score += cells_.entry(cell).cost;
      state.fingerprint += cells_.entry(cell).fingerprint;
    }
  }

  // One round: every state cut at its dearest cell.
  void advance() {
    const bool greedy = cells_.evaluations() >= options_.evaluations;
    if (greedy) beam_.resize(1);
    std::vector<SearchState> next;
    for (const SearchState& state : beam_) {
      if (state.open.empty())
        finish(state);
      else
        expand(state, greedy ? 1 : options_.branches, next);
    }
    std::erase_if(next, [&](const SearchState& state) { return !is_wanted(state); });
    std::stable_sort(next.begin(), next.end(),
                     [](const SearchState& a, const SearchState& b) { return a.score < b.score; });
    next.erase(std::unique(next.begin(), next.end(), are_alike), next.end());
    if (static_cast<int>(next.size()) > options_.beam) next.resize(static_cast<std::size_t>(options_.beam));
    beam_ = std::move(next);
  }

  // Scores of the same cells summed in another order differ by rounding.
  static bool are_alike(const SearchState& a, const SearchState& b) {
    return a.fingerprint == b.fingerprint && std::abs(a.score - b.score) < 1e-9 * (1 + std::abs(a.score));
  }

  bool is_wanted(const SearchState& state) const {
    if (best_.empty()) return true;
    const double most = 1.5 * best_.front().score + 3;
    return state.score < (static_cast<int>(best_.size()) < options_.alternatives ? most : best_.back().score);
  }

  void finish(const SearchState& state) {
    if (!is_wanted(state)) return;
    const auto place =
        std::upper_bound(best_.begin(), best_.end(), state,
                         [](const SearchState& a, const SearchState& b) { return a.score < b.score; });
    best_.insert(place, state);
    if (static_cast<int>(best_.size()) > options_.alternatives) best_.pop_back();
  }

  void expand(const SearchState& state, int branches, std::vector<SearchState>& next) {
    const int cell = state.open.front();
    if (cells_.entry(cell).other) {
      next.push_back(as_it_is(state, cell));
      if (options_.finish != Finish::base_solids) return;
    }
    const std::size_t count = state.cuts < options_.cuts ? cells_.options(cell, branches).size() : 0;
    const std::size_t followed = std::min(count, static_cast<std::size_t>(branches));
    for (std::size_t k = 0; k < followed; ++k) next.push_back(after_cut(state, cell, static_cast<int>(k)));
    if (followed == 0 && !cells_.entry(cell).other) next.push_back(without_cut(state, cell));
  }

  SearchState after_cut(const SearchState& state, int cell, int option) const {
    const CutOption& cut = cells_.entry(cell).options[static_cast<std::size_t>(option)];
    SearchState result = state;
    result.open.erase(result.open.begin());
    result.done += cut.penalty;
    ++result.cuts;
    for (const int piece : cut.pieces) put(result, piece);
    result.decisions = std::make_shared<const CutDecision>(CutDecision{cell, option, state.decisions});
    rate(result);
    return result;
  }

  SearchState as_it_is(const SearchState& state, int cell) const {
    SearchState result = state;
    result.open.erase(result.open.begin());
    result.done += cells_.entry(cell).other_cost;
    result.decisions = std::make_shared<const CutDecision>(CutDecision{cell, -1, state.decisions});
    rate(result);
    return result;
  }

  SearchState without_cut(const SearchState& state, int cell) const {
    SearchState result = state;
    result.open.erase(result.open.begin());
    result.done += unfinished_cost + cells_.entry(cell).cost;
    rate(result);
    return result;
  }

  CutTree tree(const SearchState& state) const {
    std::map<int, int> option_of;
    for (const CutDecision* d = state.decisions.get(); d; d = d->before.get()) option_of[d->cell] = d->option;
    CutTree result;
    add_node(result, root_, option_of);
    result.evaluations = cells_.evaluations();
    result.refusals = cells_.refusals();
    result.cost = state.score;
    return result;
  }

  int add_node(CutTree& tree, int cell, const std::map<int, int>& option_of) const {
    const int number = static_cast<int>(tree.nodes.size());
    const SearchCells::Entry& entry = cells_.entry(cell);
    const auto found = option_of.find(cell);
    const bool stays = found != option_of.end() && found->second < 0;
    const std::optional<BaseSolid>& base = stays ? entry.other : entry.base;
    tree.nodes.push_back({entry.cell, std::nullopt, {}, base});
    if (base) {
      tree.hexahedra += template_hexahedra(base->kind, base->sides);
    } else if (found != option_of.end()) {
      const CutOption& cut = entry.options[static_cast<std::size_t>(found->second)];
      tree.nodes[static_cast<std::size_t>(number)].loop = cut.loop;
      for (const int piece : cut.pieces) {
        const int node = add_node(tree, piece, option_of);
        tree.nodes[static_cast<std::size_t>(number)].pieces.push_back(node);
      }
    } else {
      tree.unfinished.push_back(number);
    }
    return number;
  }

  const SearchOracle& oracle_;
  const SearchOptions& options_;
  SearchCells cells_;
  int root_;
  std::vector<SearchState> beam_;
  std::vector<SearchState> best_;  // finished, cheapest first
};

}  // namespace

std::vector<CutTree> search_several(const SearchCell& cell, const SearchOracle& oracle,
                                    const SearchOptions& options) {
  validate(options);
  if (!oracle.cut)
    throw Error(ErrorCode::invalid_argument,
                "a search needs SearchOracle::cut; take combinatorial_oracle() where there is no geometry");
  return BeamSearch(cell, oracle, options).run();
}

CutTree search_cuts(const SearchCell& cell, const SearchOracle& oracle, const SearchOptions& options) {
  SearchOptions one = options;
  one.alternatives = 1;
  return search_several(cell, oracle, one).front();
}

}  // namespace isopatch::segmentation
