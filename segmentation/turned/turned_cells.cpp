#include "segmentation/turned/turned_cells.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "geometry/base/error.hpp"
#include "segmentation/sweeps/require_all_of.hpp"
#include "segmentation/turned/internal/turned_complex.hpp"

namespace isopatch::segmentation {
namespace {

/// Quarters of a whole turn, or as many as prisms have sides. Of less, as many as have 90 degrees or less;
/// where they meet at the axis, pairs of them, each around one hexahedron with 120 degrees or less at the
/// axis.
int sectors_of(const TurnedFrame& frame, bool reaches_axis) {
  if (frame.is_whole()) return frame.sides > 0 ? frame.sides : 4;
  const double quarters = frame.sweep / (std::numbers::pi / 2);
  return reaches_axis ? 2 * static_cast<int>(std::ceil(0.75 * quarters - 1e-9))
                      : static_cast<int>(std::ceil(quarters - 1e-9));
}

TurnedCells cells_of(const geometry::Brep& solid, const TurnedFrame& frame, const TurnedDrawing& drawing,
                     int sectors) {
  TurnedCells result{turned_complex(solid, frame, drawing, sectors), frame.along, frame.sweep,
                     static_cast<int>(drawing.quads.quads.size()), sectors};
  for (const std::vector<int>& column : drawing.columns)
    result.along_axis += static_cast<int>(column.size()) * (frame.is_whole() ? 1 : sectors / 2);
  require_all_of(solid, result.complex);
  return result;
}

/// Turns the frame, so that a direction is in the middle of its first sector.
void begin_beside(const Eigen::Vector3d& direction, int sectors, TurnedFrame& frame) {
  const double angle = frame.angle(frame.origin + direction) - std::numbers::pi / sectors;
  const Eigen::Vector3d x = std::cos(angle) * frame.x + std::sin(angle) * frame.y;
  frame.y = frame.along.cross(x);
  frame.x = x;
}

}  // namespace

bool is_turned(const geometry::Brep& solid) {
  return turned_frame(solid).has_value();
}

std::optional<Eigen::Vector3d> turned_about(const geometry::Brep& solid) {
  std::optional<TurnedFrame> frame = turned_frame(solid);
  if (!frame) frame = prismatic_frame(solid);
  return frame ? std::optional(frame->along) : std::nullopt;
}

std::optional<TurnedCells> turned_cells(const geometry::Brep& solid,
                                        const std::vector<std::array<Eigen::Vector3d, 2>>& lines,
                                        const QuadrangulationOptions& options) {
  std::optional<TurnedFrame> frame = turned_frame(solid);
  if (!frame) frame = prismatic_frame(solid);
  if (!frame) return std::nullopt;
  const TurnedDrawing drawing = turned_drawing(solid, *frame, lines, options);
  const int sectors = sectors_of(*frame, !drawing.columns.empty());
  return cells_of(solid, *frame, drawing, sectors);
}

std::optional<TurnedCells> turned_cells(const geometry::Brep& solid, const TurnedRequest& request,
                                        const QuadrangulationOptions& options) {
  std::optional<TurnedFrame> frame = turned_frame(solid);
  if (!frame || !frame->is_whole()) return std::nullopt;
  begin_beside(request.towards, request.sectors, *frame);
  const TurnedDrawing drawing = turned_drawing(solid, *frame, request, options);
  if (!drawing.columns.empty() && request.sectors != 4)
    throw Error(ErrorCode::unsupported, "a turned solid that reaches its axis is divided in quarters");
  return cells_of(solid, *frame, drawing, request.sectors);
}

}  // namespace isopatch::segmentation
