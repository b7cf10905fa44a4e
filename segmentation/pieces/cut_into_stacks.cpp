#include "segmentation/pieces/internal/cut_into_stacks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/base/processor_stopwatch.hpp"
#include "geometry/brep/cut_by_plane.hpp"
#include "segmentation/pieces/internal/cut_planes.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;

constexpr std::size_t beam = 3;
constexpr int most_cuts = 100, most_depth = 8;

struct State {
  std::vector<Piece> pieces;
  int faults = 0;
};

bool is_better(const State& a, const State& b) {
  return std::pair(a.faults, a.pieces.size()) < std::pair(b.faults, b.pieces.size());
}

/// With one piece cut; the state as it was where the plane does not cut it.
State after(const State& state, std::size_t number, const geometry::PlaneSurface& plane) {
  const Piece& piece = state.pieces[number];
  State result = state;
  result.pieces.erase(result.pieces.begin() + static_cast<std::ptrdiff_t>(number));
  for (geometry::CutPart& part : geometry::cut_by_plane(piece.brep, plane.origin, plane.normal())) {
    for (std::optional<FaceId>& origin : part.origin)
      if (origin) origin = piece.origin[static_cast<std::size_t>(origin->value)];
    result.pieces.push_back(seen(std::move(part.brep), std::move(part.origin)));
  }
  result.faults = std::accumulate(result.pieces.begin(), result.pieces.end(), 0,
                                  [](int sum, const Piece& made) { return sum + made.faults; });
  return result;
}

State start(const Brep& solid, const std::vector<geometry::PlaneSurface>& cuts) {
  std::vector<std::optional<FaceId>> origin;
  for (int f = 0; f < static_cast<int>(solid.faces().size()); ++f) origin.emplace_back(FaceId(f));
  State state;
  state.pieces.push_back(seen(solid, std::move(origin)));
  state.faults = state.pieces.front().faults;
  for (std::size_t c = 0; c < cuts.size(); ++c) {
    const std::size_t before = state.pieces.size();
    for (std::size_t number = state.pieces.size(); number-- > 0;) state = after(state, number, cuts[c]);
    if (state.pieces.size() == before)
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("cut {} cuts nothing off: all of the solid lies on one side of it", c + 1));
  }
  return state;
}

class Search {
 public:
  explicit Search(double seconds) : seconds_(seconds) {}

  std::vector<std::vector<Piece>> make(const Brep& solid, const std::vector<geometry::PlaneSurface>& cuts) {
    std::vector<State> states = {start(solid, cuts)};
    if (states.front().faults == 0) found_.push_back(states.front());
    for (int depth = 0; depth < most_depth && !states.empty() && found_.empty(); ++depth)
      states = go_on(states);
    std::stable_sort(found_.begin(), found_.end(), is_better);
    std::vector<std::vector<Piece>> result;
    for (State& state : found_) result.push_back(std::move(state.pieces));
    return result;
  }

 private:
  std::vector<State> go_on(const std::vector<State>& states) {
    std::vector<State> next;
    for (const State& state : states) {
      const auto worst = std::max_element(state.pieces.begin(), state.pieces.end(),
                                          [](const Piece& a, const Piece& b) { return a.faults < b.faults; });
      for (const geometry::PlaneSurface& plane : cut_planes(worst->brep)) {
        if (++cuts_ > most_cuts || watch_.seconds() > seconds_) return {};
        try {
          State made = after(state, static_cast<std::size_t>(worst - state.pieces.begin()), plane);
          if (made.pieces.size() == state.pieces.size() || made.faults > state.faults) continue;
          (made.faults == 0 ? found_ : next).push_back(std::move(made));
        } catch (const Error& error) {
          if (error.code() == ErrorCode::internal) throw;
        }
      }
    }
    std::stable_sort(next.begin(), next.end(), is_better);
    if (next.size() > beam) next.erase(next.begin() + beam, next.end());
    return next;
  }

  std::vector<State> found_;
  int cuts_ = 0;
  double seconds_;
  ProcessorStopwatch watch_;
};

}  // namespace

std::vector<std::vector<Piece>> ways_to_cut(const Brep& solid,
                                            const std::vector<geometry::PlaneSurface>& cuts, double seconds) {
  return Search(seconds).make(solid, cuts);
}

std::vector<std::vector<Piece>> cut_once_more(const std::vector<Piece>& pieces) {
  std::vector<std::vector<Piece>> result;
  for (std::size_t number = 0; number < pieces.size(); ++number)
    for (const geometry::PlaneSurface& plane : cut_planes(pieces[number].brep)) {
      try {
        State made = after({pieces, 0}, number, plane);
        if (made.faults == 0 && made.pieces.size() > pieces.size()) result.push_back(std::move(made.pieces));
      } catch (const Error& error) {
        if (error.code() == ErrorCode::internal) throw;
      }
    }
  return result;
}

}  // namespace isopatch::segmentation
