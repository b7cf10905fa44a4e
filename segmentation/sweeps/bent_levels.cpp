#include "segmentation/sweeps/internal/bent_levels.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "segmentation/sweeps/internal/straight_wall.hpp"

namespace isopatch::segmentation {
namespace {

using Range = std::array<double, 2>;

class LevelBender {
 public:
  LevelBender(const geometry::Brep& solid, const SweepFrame& frame, const Quadrangulation& quads,
              const MovingDrawing& moving, const Layers& layers)
      : frame_(frame),
        quads_(quads),
        moving_(moving),
        layers_(layers),
        tolerance_(1e-7 * solid.size()),
        heights_(layers.levels) {}

  Rounding make(std::vector<Range> kept_free) {
    std::sort(kept_free.begin(), kept_free.end());
    for (const Range& range : kept_free) move_out_of(range);
    for (std::size_t level = 0; level < heights_.size(); ++level)
      if (heights_[level] != layers_.levels[level]) bend(static_cast<int>(level));
    return std::move(made_);
  }

 private:
  /// Half of the levels below the range, half above, evenly between it and the next level.
  void move_out_of(const Range& range) {
    std::vector<std::size_t> down, up;
    for (std::size_t level = 1; level + 1 < heights_.size(); ++level)
      if (heights_[level] > range[0] && heights_[level] < range[1])
        (2 * heights_[level] < range[0] + range[1] ? down : up).push_back(level);
    const auto spread = [&](const std::vector<std::size_t>& levels, double low, double high) {
      for (std::size_t i = 0; i < levels.size(); ++i)
        heights_[levels[i]] =
            low + static_cast<double>(i + 1) / static_cast<double>(levels.size() + 1) * (high - low);
    };
    if (!down.empty() && heights_[down.front() - 1] < range[0])
      spread(down, heights_[down.front() - 1], range[0]);
    if (!up.empty() && heights_[up.back() + 1] > range[1]) spread(up, range[1], heights_[up.back() + 1]);
  }

  void bend(int level) {
    const std::set<int> fixed = fixed_at(level);
    const double by = heights_[static_cast<std::size_t>(level)] - height(level);
    const Eigen::Vector3d way = by * frame_.along;
    std::set<int> moved;
    for (std::size_t q = 0; q < quads_.quads.size(); ++q)
      if (is_at(q, level))
        for_edges(q, [&](const QuadEdge& edge) {
          for (const int vertex : {edge.start, edge.end})
            if (!fixed.contains(vertex)) moved.insert(vertex);
        });
    for (const int vertex : moved)
      made_.vertices[{vertex, level}] = moving_.place(vertex, height(level)) + way;
    for (int e = 0; e < static_cast<int>(quads_.edges.size()); ++e) {
      const QuadEdge& edge = quads_.edges[static_cast<std::size_t>(e)];
      if (!moved.contains(edge.start) || !moved.contains(edge.end)) continue;
      const geometry::NurbsCurve curve = moving_.curve(e, height(level));
      made_.level_edges.emplace(
          Rounding::Flat{e, level},
          geometry::NurbsCurve(curve.knots(), curve.control_points().colwise() + way, curve.weights()));
    }
  }

  /// Vertices of floors, of walls that change their slope there, and of curved walls with one of these.
  std::set<int> fixed_at(int level) const {
    std::set<int> result;
    for (std::size_t q = 0; q < quads_.quads.size(); ++q)
      for (const Layer& layer : layers_.columns[q])
        if ((layer.low == level && layer.bottom) || (layer.high == level && layer.top))
          for_edges(q, [&](const QuadEdge& edge) { result.insert({edge.start, edge.end}); });
    for (int v = 0; v < static_cast<int>(quads_.vertices.size()); ++v)
      for (const double kink : moving_.kinks_at(v))
        if (std::abs(kink - height(level)) < tolerance_) result.insert(v);
    for (bool changed = true; changed;) {
      changed = false;
      for (int e = 0; e < static_cast<int>(quads_.edges.size()); ++e) {
        const QuadEdge& edge = quads_.edges[static_cast<std::size_t>(e)];
        if (edge.profile_edge < 0 || result.contains(edge.start) == result.contains(edge.end) ||
            is_segment(moving_.curve(e, height(level))))
          continue;
        result.insert({edge.start, edge.end});
        changed = true;
      }
    }
    return result;
  }

  bool is_at(std::size_t quad, int level) const {
    const std::vector<Layer>& column = layers_.columns[quad];
    return std::any_of(column.begin(), column.end(),
                       [&](const Layer& layer) { return layer.low == level || layer.high == level; });
  }

  template <class Take>
  void for_edges(std::size_t quad, const Take& take) const {
    for (const geometry::EdgeUse& side : quads_.quads[quad].sides)
      take(quads_.edges[static_cast<std::size_t>(side.edge.value)]);
  }

  double height(int level) const { return layers_.levels[static_cast<std::size_t>(level)]; }

  const SweepFrame& frame_;
  const Quadrangulation& quads_;
  const MovingDrawing& moving_;
  const Layers& layers_;
  double tolerance_;
  std::vector<double> heights_;  // by level, where it may move
  Rounding made_;
};

}  // namespace

Rounding bent_levels(const geometry::Brep& solid, const SweepFrame& frame, const Quadrangulation& quads,
                     const MovingDrawing& moving, const Layers& layers,
                     const std::vector<std::array<double, 2>>& kept_free) {
  return LevelBender(solid, frame, quads, moving, layers).make(kept_free);
}

}  // namespace isopatch::segmentation
