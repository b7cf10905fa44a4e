#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "segmentation/profiles/tests/drawing.hpp"

namespace isopatch::segmentation::drawings {

/// A star-shaped outline of lines and arcs with round and polygonal holes, some of them filled by a region of
/// their own.
class RandomDrawing {
 public:
  explicit RandomDrawing(unsigned seed) : random_(seed) {}

  Profile draw() {
    Drawing drawing;
    std::vector<std::vector<int>> loops = {outline(drawing, {0, 0}, 4, 6, 5 + pick(8), true)};
    std::vector<std::vector<int>> filled;
    std::vector<std::pair<Vector2d, double>> holes;
    for (int wanted = pick(5), tries = 0; wanted > 0 && tries < 30; ++tries) {
      const double radius = between(0.2, 0.6), angle = between(0, 2 * std::numbers::pi),
                   off = between(0, 1.4);
      const Vector2d centre(off * std::cos(angle), off * std::sin(angle));
      const bool free = std::all_of(holes.begin(), holes.end(), [&](const auto& hole) {
        return (hole.first - centre).norm() > hole.second + radius + 0.08;
      });
      if (!free) continue;
      holes.emplace_back(centre, radius);
      --wanted;
      std::vector<int> loop;
      if (pick(2) == 0)
        loop = {drawing.circle(centre, radius, between(0, 6))};
      else
        loop = outline(drawing, centre, 0.6 * radius, radius, 3 + pick(4), pick(2) == 0);
      loops.push_back(Drawing::backwards(loop));
      if (pick(3) == 0) filled.push_back(loop);
    }
    drawing.region(loops);
    for (const std::vector<int>& loop : filled) drawing.region({loop});
    return drawing.profile;
  }

 private:
  int pick(int number) { return static_cast<int>(random_() % static_cast<unsigned>(number)); }
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(random_()) / 4294967295.0;
  }

  /// Corners at random distances in even directions; some sides are arcs that bulge a little.
  std::vector<int> outline(Drawing& drawing, const Vector2d& centre, double least, double most, int corners,
                           bool arcs) {
    std::vector<int> vertices, result;
    const double turn = between(0, 6);
    for (int i = 0; i < corners; ++i) {
      const double angle = turn + 2 * std::numbers::pi * (i + between(-0.2, 0.2)) / corners,
                   radius = between(least, most);
      vertices.push_back(
          drawing.vertex(centre.x() + radius * std::cos(angle), centre.y() + radius * std::sin(angle)));
    }
    for (int i = 0; i < corners; ++i) {
      const int a = vertices[i], b = vertices[(i + 1) % corners];
      const Vector2d from = drawing.profile.vertices[a], to = drawing.profile.vertices[b];
      const Vector2d inward = Vector2d(from.y() - to.y(), to.x() - from.x()) / 2;
      if (arcs && least > 1 && pick(3) == 0)
        result.push_back(drawing.arc(a, b, (from + to) / 2 + between(1, 3) * inward));
      else
        result.push_back(drawing.line(a, b));
    }
    return result;
  }

  std::mt19937 random_;
};

}  // namespace isopatch::segmentation::drawings
