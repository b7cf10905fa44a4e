#include "segmentation/pieces/internal/piece.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <utility>

#include "segmentation/sweeps/stack.hpp"
#include "segmentation/turned/turned_cells.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;

bool is_parallel(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return a.cross(b).norm() < 1e-7;
}

/// Whether a face made by a cut is a wall whose sides can be those of hexahedra: all its edges run along the
/// stack or across it.
bool is_ruled_off(const Brep& brep, FaceId face, const Eigen::Vector3d& along) {
  for (const auto& loop : brep.face(face).loops)
    for (const geometry::EdgeUse& use : loop) {
      if (brep.edge(use.edge).kind != geometry::CurveKind::line) return false;
      const Eigen::Vector3d direction = brep.tangent(use.edge, 0).normalized();
      if (!is_parallel(direction, along) && std::abs(direction.dot(along)) > 1e-7) return false;
    }
  return true;
}

int faults_along(const Piece& piece, const Eigen::Vector3d& along, const std::vector<SweepFrame>& frames) {
  int result = static_cast<int>(neither_floor_nor_wall(piece.brep, along).size());
  for (const FaceId face : cut_faces(piece))
    if (!is_parallel(plane_of(piece.brep, face).normal(), along) && !is_ruled_off(piece.brep, face, along))
      ++result;
  const auto frame = std::find_if(frames.begin(), frames.end(), [&](const SweepFrame& candidate) {
    return is_parallel(candidate.along, along);
  });
  if (result == 0 && (frame == frames.end() || !is_stack(piece.brep, *frame))) ++result;
  return result;
}

}  // namespace

std::vector<FaceId> cut_faces(const Piece& piece) {
  std::vector<FaceId> result;
  for (std::size_t f = 0; f < piece.origin.size(); ++f)
    if (!piece.origin[f]) result.emplace_back(static_cast<int>(f));
  return result;
}

geometry::PlaneSurface plane_of(const Brep& brep, FaceId face) {
  const geometry::Carrier plane = *brep.carrier(face);
  const Eigen::Vector3d normal = brep.outward_normal(face, brep.domain(face).low);
  const Eigen::Vector3d x = normal.unitOrthogonal();
  return {plane.origin, x, normal.cross(x)};
}

Piece seen(Brep brep, std::vector<std::optional<FaceId>> origin) {
  Piece result{std::move(brep), std::move(origin), {}, false, std::numeric_limits<int>::max()};
  const std::vector<SweepFrame> frames = sweep_frames(result.brep);
  for (const Eigen::Vector3d& along : floor_directions(result.brep)) {
    const int faults = faults_along(result, along, frames);
    if (faults >= result.faults) continue;
    result.faults = faults;
    for (const SweepFrame& frame : frames)
      if (is_parallel(frame.along, along)) result.frame = frame;
  }
  result.turned = result.faults > 0 && is_turned(result.brep);
  if (result.turned) result.faults = 0;
  return result;
}

}  // namespace isopatch::segmentation
