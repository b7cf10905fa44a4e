#include "segmentation/turned/internal/end_drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/brep/overlay.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;

/// Turned faces that end in an edge of the sheet: two where one goes on in the other.
std::vector<FaceId> faces_at(const Brep& solid, const TurnedFrame& frame, const Brep& sheet, EdgeId edge) {
  const Eigen::Vector3d middle = sheet.point(edge, 0.45);
  std::vector<FaceId> result;
  for (const FaceId face : frame.faces) {
    const geometry::FaceProjection nearest = solid.project(face, middle);
    if (nearest.distance < 1e-6 * solid.size() && solid.contains(face, nearest.uv)) result.push_back(face);
  }
  return result;
}

/// Of a point that lies in one of the ends, in the half-plane at angle 0.
Eigen::Vector3d in_first_end(const TurnedFrame& frame, const Eigen::Vector3d& point) {
  return frame.point(frame.flat(point), 0);
}

}  // namespace

EndDrawing end_drawing(const Brep& solid, const TurnedFrame& frame,
                       const std::vector<std::array<Eigen::Vector3d, 2>>& lines) {
  std::vector<std::array<Eigen::Vector3d, 2>> flat;
  for (const auto& [start, end] : lines)
    flat.push_back({in_first_end(frame, start), in_first_end(frame, end)});
  // From its back the half-plane is seen with the distance from the axis to the right.
  EndDrawing result{geometry::overlay(solid, frame.first, frame.origin, -frame.y, {}, flat).sheet, {}, {}};
  const Brep& sheet = result.sheet;
  std::vector<int> ends(static_cast<std::size_t>(sheet.vertices().cols()));
  for (const geometry::BrepEdge& edge : sheet.edges())
    for (const VertexId end : {edge.start, edge.end}) ++ends[static_cast<std::size_t>(end.value)];
  for (const auto vertex : sheet.vertices().colwise()) result.half.vertices.push_back(frame.flat(vertex));
  std::vector<int> uses(sheet.edges().size());
  for (const geometry::BrepFace& face : sheet.faces()) {
    for (const auto& loop : face.loops)
      for (const geometry::EdgeUse& use : loop) ++uses[static_cast<std::size_t>(use.edge.value)];
    result.regions.push_back({face.loops, true});
  }
  for (std::size_t e = 0; e < sheet.edges().size(); ++e) {
    const geometry::BrepEdge& edge = sheet.edges()[e];
    HalfCurve curve;
    curve.edge = EdgeId(static_cast<int>(e));
    if (edge.start != edge.end || ends[static_cast<std::size_t>(edge.start.value)] > 2) {
      curve.start = edge.start.value;
      curve.end = edge.end.value;
    }
    if (uses[e] == 1) curve.faces = faces_at(solid, frame, sheet, *curve.edge);
    if (uses[e] == 1 && curve.faces.empty())
      throw Error(ErrorCode::unsupported,
                  fmt::format("its end at edge {} is divided where no face is", edge.start.value));
    result.half.curves.push_back(std::move(curve));
  }
  return result;
}

}  // namespace isopatch::segmentation
