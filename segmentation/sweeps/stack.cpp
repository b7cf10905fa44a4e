#include "segmentation/sweeps/stack.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "geometry/base/error.hpp"
#include "segmentation/profiles/divide_side.hpp"
#include "segmentation/sweeps/internal/bent_levels.hpp"
#include "segmentation/sweeps/internal/column_complex.hpp"
#include "segmentation/sweeps/internal/column_volume.hpp"
#include "segmentation/sweeps/internal/divided_drawing.hpp"
#include "segmentation/sweeps/internal/straight_wall.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::PlaneSurface;

}  // namespace

bool is_stack(const Brep& solid, const SweepFrame& frame) {
  try {
    const SweptDrawing drawing = swept_drawing(solid, frame);
    if (!frame.inclined.empty()) return true;  // what moves has no volume to compare before it is divided
    double volume = 0;
    for (std::size_t r = 0; r < drawing.slabs.size(); ++r)
      for (const Slab& slab : drawing.slabs[r])
        volume += drawing.sheet.area(FaceId(static_cast<int>(r))) * (slab.high - slab.low);
    return std::abs(volume - solid.volume()) < 1e-5 * solid.volume();
  } catch (const Error& error) {
    if (error.code() == ErrorCode::internal) throw;
    return false;
  }
}

struct Stack::Parts {
  Parts(const Brep& given, SweepFrame along, const std::vector<Line>& lines,
        const QuadrangulationOptions& options)
      : solid(given),
        frame(std::move(along)),
        divided(divided_drawing(given, frame, lines, options)),
        asked(divided.quads.quads.size()) {}

  MovingDrawing moving() const { return {solid, frame, drawing, quads}; }
  Layers layers(const MovingDrawing& at) const {
    return segmentation::layers(quads, drawing.slabs, at, asked, 1e-7 * solid.size());
  }

  const Brep& solid;
  SweepFrame frame;
  DividedDrawing divided;
  SweptDrawing& drawing = divided.drawing;
  Quadrangulation& quads = divided.quads;
  std::vector<std::vector<double>> asked;  // heights of further levels, by quadrilateral
};

Stack::Stack(const Brep& solid, SweepFrame frame, const std::vector<Line>& lines,
             const QuadrangulationOptions& options)
    : parts_(std::make_unique<Parts>(solid, std::move(frame), lines, options)) {}
Stack::Stack(Stack&&) noexcept = default;
Stack& Stack::operator=(Stack&&) noexcept = default;
Stack::~Stack() = default;

const SweepFrame& Stack::frame() const {
  return parts_->frame;
}

int Stack::quadrilaterals() const {
  return static_cast<int>(parts_->quads.quads.size());
}

int Stack::levels() const {
  return static_cast<int>(parts_->layers(parts_->moving()).levels.size());
}

namespace {

/// Finds sides of a stack's hexahedra in a plane.
class SideFinder {
 public:
  SideFinder(const Quadrangulation& quads, const MovingDrawing& moving, const Layers& layers,
             const PlaneSurface& plane, double tolerance)
      : quads_(quads), moving_(moving), layers_(layers), plane_(plane), tolerance_(tolerance) {}

  std::vector<StackSide> walls() {
    for (std::size_t q = 0; q < quads_.quads.size(); ++q)
      for (const geometry::EdgeUse& use : quads_.quads[q].sides) {
        const QuadEdge& edge = quads_.edges[static_cast<std::size_t>(use.edge.value)];
        for (const Layer& layer : layers_.columns[q]) {
          const double low = height(layer.low), high = height(layer.high);
          const Eigen::Vector3d a = moving_.place(edge.start, low), b = moving_.place(edge.end, low);
          add({a, b, moving_.place(edge.end, high), moving_.place(edge.start, high)}, static_cast<int>(q),
              use.edge.value, -1);
        }
      }
    return std::move(result_);
  }

  std::vector<StackSide> floors() {
    for (std::size_t q = 0; q < quads_.quads.size(); ++q) {
      const auto& sides = quads_.quads[q].sides;
      for (const Layer& layer : layers_.columns[q])
        for (const int level : {layer.low, layer.high}) {
          const auto corner = [&](std::size_t k) {
            const QuadEdge& edge = quads_.edges[static_cast<std::size_t>(sides[k].edge.value)];
            return moving_.place(sides[k].reversed ? edge.end : edge.start, height(level));
          };
          const bool straight = std::all_of(sides.begin(), sides.end(), [&](const geometry::EdgeUse& use) {
            return is_segment(moving_.curve(use.edge.value, height(level)));
          });
          if (straight)
            add({corner(0), corner(1), corner(2), corner(3)}, static_cast<int>(q), sides[0].edge.value,
                sides[1].edge.value);
        }
    }
    return std::move(result_);
  }

 private:
  double height(int level) const { return layers_.levels[static_cast<std::size_t>(level)]; }

  void add(const std::array<Eigen::Vector3d, 4>& corners, int quad, int first, int second) {
    std::array<Eigen::Vector2d, 4> at;
    for (std::size_t k = 0; k < 4; ++k) {
      if (std::abs((corners[k] - plane_.origin).dot(plane_.normal())) > tolerance_) return;
      at[k] = plane_.domain_point(corners[k]);
    }
    const Eigen::Vector2d along = at[1] - at[0];
    const bool turned = std::abs(along.x()) < std::abs(along.y());
    for (std::size_t k = 0; k < 4; ++k) {
      const Eigen::Vector2d step = at[(k + 1) % 4] - at[k];
      if (std::abs(step[(k % 2 == 0) == turned ? 0 : 1]) > tolerance_) return;
    }
    StackSide side{at[0].cwiseMin(at[2]), at[0].cwiseMax(at[2]), quad, {first, second}};
    if (turned) std::swap(side.edges[0], side.edges[1]);
    if ((side.high - side.low).minCoeff() > tolerance_) result_.push_back(side);
  }

  const Quadrangulation& quads_;
  const MovingDrawing& moving_;
  const Layers& layers_;
  const PlaneSurface& plane_;
  double tolerance_;
  std::vector<StackSide> result_;
};

}  // namespace

std::vector<StackSide> Stack::sides_on(const PlaneSurface& plane, double tolerance) const {
  const MovingDrawing moving = parts_->moving();
  const Layers layers = parts_->layers(moving);
  SideFinder finder(parts_->quads, moving, layers, plane, tolerance);
  return std::abs(plane.normal().dot(parts_->frame.along)) > 0.5 ? finder.floors() : finder.walls();
}

std::vector<Line> Stack::lines_on(const PlaneSurface& plane, double tolerance) const {
  const MovingDrawing moving = parts_->moving();
  const Layers layers = parts_->layers(moving);
  std::map<int, std::pair<double, int>> found;  // height, and quadrilaterals beside it
  for (std::size_t q = 0; q < parts_->quads.quads.size(); ++q)
    for (const Layer& layer : layers.columns[q])
      for (const int level : {layer.low, layer.high}) {
        const double height = layers.levels[static_cast<std::size_t>(level)];
        if (std::abs((plane.origin - parts_->frame.point(Eigen::Vector2d::Zero(), height))
                         .dot(parts_->frame.along)) > tolerance)
          continue;
        for (const geometry::EdgeUse& use : parts_->quads.quads[q].sides) {
          found[use.edge.value].first = height;
          ++found[use.edge.value].second;
        }
      }
  std::vector<Line> result;
  for (const auto& [edge, at] : found) {
    const geometry::NurbsCurve curve = moving.curve(edge, at.first);
    if (at.second == 2 && is_segment(curve))
      result.push_back({curve.control_points().col(0), curve.control_points().col(1)});
  }
  return result;
}

void Stack::divide(const PlaneSurface& plane, const StackSide& side, int axis, double share) {
  const auto i = static_cast<std::size_t>(axis);
  const Eigen::Vector2d across = (1 - share) * side.low + share * side.high;
  Eigen::Vector2d at = (side.low + side.high) / 2;
  at[axis] = across[axis];
  const Eigen::Vector3d place = plane.point(at);
  Parts& parts = *parts_;
  if (side.edges[i] < 0) {
    parts.asked[static_cast<std::size_t>(side.quad)].push_back(parts.frame.height(place));
    return;
  }
  const QuadEdge& edge = parts.quads.edges[static_cast<std::size_t>(side.edges[i])];
  const MovingDrawing moving = parts.moving();
  const double height = parts.frame.height(place);
  const auto along = [&](int vertex) { return plane.domain_point(moving.place(vertex, height))[axis]; };
  const double start = along(edge.start), end = along(edge.end);
  DividedQuads made =
      divide_side(parts.drawing.profile, parts.quads, side.edges[i], (across[axis] - start) / (end - start));
  std::vector<std::vector<double>> asked;
  for (const int parent : made.parent) asked.push_back(parts.asked[static_cast<std::size_t>(parent)]);
  parts.quads = std::move(made.quads);
  parts.asked = std::move(asked);
}

void Stack::divide_at(double height) {
  for (std::vector<double>& heights : parts_->asked) heights.push_back(height);
}

geometry::CellComplex Stack::complex(const std::vector<std::array<double, 2>>& kept_free) const {
  const MovingDrawing moving = parts_->moving();
  const Layers layers = parts_->layers(moving);
  require_whole(parts_->solid, parts_->frame, parts_->quads, moving, layers);
  return column_complex(parts_->solid, parts_->frame, parts_->quads, moving, layers,
                        bent_levels(parts_->solid, parts_->frame, parts_->quads, moving, layers, kept_free));
}

}  // namespace isopatch::segmentation
