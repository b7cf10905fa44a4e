#pragma once

#include <functional>
#include <vector>

namespace isopatch::segmentation {

/// Places that loops may pass, and which faces they lie on.
struct PlaceGraph {
  int faces = 0;
  std::vector<int> face_begin = {0}, face;  ///< of place p: the faces that it lies on
  std::vector<int> near_begin = {0},
                   near;  ///< of place p: the places that a step leads to, with which it shares a face

  int places() const { return static_cast<int>(face_begin.size()) - 1; }
};

/// Depth-first search for valid loops: a path grows by places that share a face with its last one and with no
/// earlier one; one that also shares a face with the first closes it.
class LoopWalk {
 public:
  /// Returns false to stop the search.
  using Visit = std::function<bool(const std::vector<int>& loop)>;

  LoopWalk(const PlaceGraph& graph, int max_length, Visit visit);

  /// Every valid loop once, its lowest place first and the lower neighbour of that second.
  void all();
  /// Every valid loop that starts with these places, two or more. More than two of them may lie on one face,
  /// which the rest of the loop then avoids.
  void starting_with(const std::vector<int>& places);

 private:
  bool grow();
  bool visit_next(int place);
  enum class Fit { none, grows, closes };
  Fit fit(int place) const;
  void push(int place);
  void pop();

  const PlaceGraph& graph_;
  int max_length_;
  Visit visit_;
  bool each_once_ = true;
  std::vector<int> path_, count_, occupant_;
  std::vector<char> on_path_;
};

}  // namespace isopatch::segmentation
