#include "segmentation/sweeps/swept_cells.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

#include "geometry/base/error.hpp"
#include "segmentation/profiles/quadrangulate.hpp"
#include "segmentation/sweeps/internal/column_complex.hpp"
#include "segmentation/sweeps/internal/column_volume.hpp"

namespace isopatch::segmentation {
namespace {

/// What is seen along a direction that is not the stack's looks like one and leaves something out.
void require_whole(const geometry::Brep& solid, double volume) {
  if (std::abs(volume - solid.volume()) > 1e-5 * solid.volume())
    throw Error(ErrorCode::unsupported, fmt::format("{:.3g} of {:.3g} m^3 are no part of the stack",
                                                    solid.volume() - volume, solid.volume()));
}

SweptCells swept_along(const geometry::Brep& solid, const SweepFrame& frame,
                       const QuadrangulationOptions& options) {
  const SweptDrawing drawing = swept_drawing(solid, frame);
  const Quadrangulation quads = quadrangulate(drawing.profile, options);
  const MovingDrawing moving(solid, frame, drawing, quads);
  const Layers columns = layers(quads, drawing.slabs, moving, 1e-7 * solid.size());
  SweptCells result{column_complex(solid, frame, quads, moving, columns), frame.along,
                    static_cast<int>(quads.quads.size()), static_cast<int>(columns.levels.size())};
  require_whole(solid, column_volume(frame, quads, moving, columns));
  return result;
}

}  // namespace

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
  if (!best && refusal) throw *refusal;
  return best;
}

}  // namespace isopatch::segmentation
