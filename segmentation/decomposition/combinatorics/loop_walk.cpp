#include "segmentation/decomposition/combinatorics/internal/loop_walk.hpp"

#include <utility>

namespace isopatch::segmentation {

LoopWalk::LoopWalk(const PlaceGraph& graph, int max_length, Visit visit)
    : graph_(graph),
      max_length_(max_length),
      visit_(std::move(visit)),
      count_(graph.faces),
      occupant_(graph.faces),
      on_path_(graph.places()) {}

void LoopWalk::all() {
  each_once_ = true;
  for (int start = 0; start < graph_.places(); ++start) {
    push(start);
    const bool go_on = grow();
    pop();
    if (!go_on) return;
  }
}

void LoopWalk::starting_with(const std::vector<int>& places) {
  each_once_ = false;
  for (const int place : places) push(place);
  grow();
  for (std::size_t k = 0; k < places.size(); ++k) pop();
}

bool LoopWalk::grow() {
  const int last = path_.back();
  for (int k = graph_.near_begin[last]; k < graph_.near_begin[last + 1]; ++k)
    if (!visit_next(graph_.near[k])) return false;
  return true;
}

bool LoopWalk::visit_next(int place) {
  if (on_path_[place] || (each_once_ && place < path_.front())) return true;
  const Fit found = fit(place);
  const int length = static_cast<int>(path_.size()) + 1;
  if (found == Fit::none || length > max_length_) return true;
  if (found == Fit::grows && length == max_length_) return true;
  if (found == Fit::closes && each_once_ && place < path_[1]) return true;
  push(place);
  const bool go_on = found == Fit::closes ? visit_(path_) : grow();
  pop();
  return go_on;
}

LoopWalk::Fit LoopWalk::fit(int place) const {
  const int last = path_.back(), first = path_.front();
  bool closes = false;
  for (int k = graph_.face_begin[place]; k < graph_.face_begin[place + 1]; ++k) {
    const int face = graph_.face[k];
    if (count_[face] == 0) continue;
    if (count_[face] > 1) return Fit::none;
    if (occupant_[face] == last) continue;
    if (occupant_[face] != first) return Fit::none;
    closes = true;
  }
  return closes ? Fit::closes : Fit::grows;
}

void LoopWalk::push(int place) {
  path_.push_back(place);
  on_path_[place] = 1;
  for (int k = graph_.face_begin[place]; k < graph_.face_begin[place + 1]; ++k)
    if (count_[graph_.face[k]]++ == 0) occupant_[graph_.face[k]] = place;
}

void LoopWalk::pop() {
  const int place = path_.back();
  path_.pop_back();
  on_path_[place] = 0;
  for (int k = graph_.face_begin[place]; k < graph_.face_begin[place + 1]; ++k) --count_[graph_.face[k]];
}

}  // namespace isopatch::segmentation
