#include "segmentation/branches/internal/frame_around.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "geometry/base/error.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::EdgeUse;

class FrameMaker {
 public:
  FrameMaker(int region, const std::vector<int>& ring, Quadrangulation& drawing)
      : region_(region), ring_(ring), drawing_(drawing), count_(static_cast<int>(ring.size())) {}

  void make() {
    const std::array<int, 4> begins = best_places();
    std::array<EdgeUse, 4> spokes;  // from the ring to each corner
    for (int i = 0; i < 4; ++i) spokes[at(i)] = {add_edge(node(begins[at(i)]), i), false};
    for (int i = 0; i < 4; ++i) {
      const int next = (i + 1) % 4;
      std::vector<EdgeUse> pieces;
      for (int p = begins[at(i)]; p < begins[at(i)] + length(begins, i); ++p)
        pieces.push_back({EdgeId(ring_[at(p % count_)]), false});
      fill(spokes[at(i)], pieces, spokes[at(next)], {EdgeId(i), false});
    }
  }

 private:
  static std::size_t at(int i) { return static_cast<std::size_t>(i); }
  int node(int place) const { return drawing_.edges[at(ring_[at(place % count_)])].start; }
  const Eigen::Vector2d& point(int vertex) const { return drawing_.vertices[at(vertex)]; }
  int from(EdgeUse use) const {
    const QuadEdge& edge = drawing_.edges[at(use.edge.value)];
    return use.reversed ? edge.end : edge.start;
  }
  int to(EdgeUse use) const { return from({use.edge, !use.reversed}); }

  EdgeId add_edge(int start, int end) {
    drawing_.edges.push_back({start, end});
    return EdgeId(static_cast<int>(drawing_.edges.size()) - 1);
  }

  /// How many pieces of the ring face a side.
  int length(const std::array<int, 4>& begins, int side) const {
    return (begins[at((side + 1) % 4)] - begins[at(side)] + count_ - 1) % count_ + 1;
  }

  /// Where spokes begin: near to the corners, with an odd number of pieces between them.
  std::array<int, 4> best_places() const {
    std::optional<std::array<int, 4>> best;
    double least = 1e300;
    for (int a = 0; a < count_; ++a)
      for (int b = a + 1; b < a + count_; b += 2)
        for (int c = b + 1; c < a + count_; c += 2)
          for (int d = c + 1; d < a + count_; d += 2) {
            const std::array<int, 4> places = {a, b, c, d};
            if ((a + count_ - d) % 2 == 0) continue;
            double sum = 0;
            for (int i = 0; i < 4; ++i) sum += (point(node(places[at(i)])) - point(i)).squaredNorm();
            if (sum < least) best = places, least = sum;
          }
    if (!best)
      throw Error(ErrorCode::unsupported, "a branch's outline is divided in an odd number of pieces");
    for (int& place : *best) place %= count_;
    return *best;
  }

  void add_quad(const std::array<EdgeUse, 4>& sides) { drawing_.quads.push_back({region_, sides}); }

  static EdgeUse back(EdgeUse use) { return {use.edge, !use.reversed}; }

  /// Between two spokes, pieces of the ring and the side that they face.
  void fill(EdgeUse first, const std::vector<EdgeUse>& pieces, EdgeUse last, EdgeUse side) {
    if (pieces.size() == 1) {
      add_quad({side, back(last), back(pieces.front()), first});
      return;
    }
    // A strip beside the ring; what is left faces the side likewise, with two pieces fewer.
    const int count = static_cast<int>(pieces.size());
    std::vector<EdgeUse> uprights = {first};
    for (int i = 1; i < count; ++i) {
      const int foot = from(pieces[at(i)]);
      const int made = static_cast<int>(drawing_.vertices.size());
      drawing_.vertices.push_back(
          between(point(foot), point(from(side)), point(to(side)), static_cast<double>(i) / count));
      uprights.push_back({add_edge(foot, made), false});
    }
    uprights.push_back(last);
    std::vector<EdgeUse> tops;
    for (int i = 0; i < count; ++i) {
      const EdgeUse top = {add_edge(to(uprights[at(i)]), to(uprights[at(i + 1)])), false};
      add_quad({top, back(uprights[at(i + 1)]), back(pieces[at(i)]), uprights[at(i)]});
      tops.push_back(top);
    }
    fill(back(tops.front()), {tops.begin() + 1, tops.end() - 1}, tops.back(), side);
  }

  /// Above a foot on the ring, nearer to the side's corner than in proportion, so that the angle there is no
  /// narrow one.
  static Eigen::Vector2d between(const Eigen::Vector2d& foot, const Eigen::Vector2d& low,
                                 const Eigen::Vector2d& high, double share) {
    const double length = (high - low).norm();
    const Eigen::Vector2d along = (high - low) / length, way = foot - low;
    const double gap = std::abs(along.x() * way.y() - along.y() * way.x());
    const double nearer = std::min(share < 0.5 ? share : 1 - share, nearest_share * gap / length);
    const Eigen::Vector2d facing = low + (share < 0.5 ? nearer : 1 - nearer) * (high - low);
    return foot + above_ring * (facing - foot);
  }

  /// Of the gap between ring and side: how far from the corner a node faces the side, and how far above the
  /// ring it is.
  static constexpr double nearest_share = 0.75, above_ring = 0.45;
  int region_;
  const std::vector<int>& ring_;
  Quadrangulation& drawing_;
  int count_;
};

}  // namespace

void add_frame(int region, const std::vector<int>& ring, Quadrangulation& drawing) {
  FrameMaker(region, ring, drawing).make();
}

}  // namespace isopatch::segmentation
