#include "segmentation/sweeps/swept_cells.hpp"

#include <utility>

#include "geometry/base/error.hpp"
#include "segmentation/sweeps/internal/filleted_cells.hpp"
#include "segmentation/sweeps/internal/roofed_cells.hpp"
#include "segmentation/sweeps/stack.hpp"

namespace isopatch::segmentation {
namespace {

SweptCells swept_along(const geometry::Brep& solid, const SweepFrame& frame,
                       const QuadrangulationOptions& options) {
  const Stack stack(solid, frame, {}, options);
  return {stack.complex(), frame.along, stack.quadrilaterals(), stack.levels()};
}

}  // namespace

SweptCells swept_with(const geometry::Brep& solid, const SweepFrame& frame, const std::vector<Line>& lines,
                      const std::vector<double>& heights, const std::vector<std::array<double, 2>>& kept_free,
                      const QuadrangulationOptions& options) {
  if (has_roofs(solid, frame)) return roofed_cells_with(solid, frame, lines, heights);
  Stack stack(solid, frame, lines, options);
  for (const double height : heights) stack.divide_at(height);
  return {stack.complex(kept_free), frame.along, stack.quadrilaterals(), stack.levels()};
}

std::optional<SweptCells> swept_cells(const geometry::Brep& solid, const QuadrangulationOptions& options) {
  std::optional<SweptCells> best;
  std::optional<Error> refusal;
  for (const SweepFrame& frame : sweep_frames(solid)) {
    try {
      SweptCells made = swept_along(solid, frame, options);
      if (!best || made.complex.cells.size() < best->complex.cells.size()) best = std::move(made);
    } catch (const Error& error) {
      if (error.code() == ErrorCode::internal) throw;
      refusal = error;
    }
  }
  if (!best) best = roofed_cells(solid, options);
  if (!best && refusal) throw *refusal;
  if (!best) return filleted_cells(solid, options);
  return best;
}

}  // namespace isopatch::segmentation
