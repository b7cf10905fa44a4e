#include "segmentation/decomposition/known_shape.hpp"

#include <fmt/format.h>

#include <cmath>

#include "geometry/base/error.hpp"
#include "geometry/base/stopwatch.hpp"
#include "segmentation/decomposition/prepare.hpp"
#include "segmentation/sweeps/swept_cells.hpp"

namespace isopatch::segmentation {
namespace {

/// "z" where it is an axis, "(0.6, 0, 0.8)" elsewhere.
std::string direction_text(const Eigen::Vector3d& direction) {
  for (int i = 0; i < 3; ++i)
    if (std::abs(direction[i]) > 1 - 1e-12) return std::string(1, "xyz"[i]);
  return fmt::format("({:.3g}, {:.3g}, {:.3g})", direction.x(), direction.y(), direction.z());
}

/// Whether planes come in several faces, as of triangulations: their outlines would all be drawn.
bool planes_are_divided(const geometry::Brep& solid) {
  try {
    const geometry::CellComplex merged = prepared(solid);
    return merged.cells.front().faces.size() < solid.faces().size();
  } catch (const Error&) {
    return false;  // faces with holes or seams are of no triangulation
  }
}

std::string text_of(const SweptCells& swept) {
  return fmt::format("swept along {}: {} quadrilateral{} between {} levels", direction_text(swept.along),
                     swept.quadrilaterals, swept.quadrilaterals == 1 ? "" : "s", swept.levels);
}

}  // namespace

KnownShape known_shape(const geometry::Brep& solid, const DecompositionOptions& options) {
  const Stopwatch watch;
  KnownShape result;
  if (options.method == Method::cuts || options.t_joints == TJoints::keep) return result;
  if (planes_are_divided(solid)) return result;
  try {
    const std::optional<SweptCells> swept = swept_cells(solid);
    if (!swept) return result;
    Decomposition& made = result.decomposition.emplace(Decomposition{swept->complex, swept->complex, {}, {}});
    made.report.cells = made.report.hexahedra = static_cast<int>(made.complex.cells.size());
    made.report.seen_as = text_of(*swept);
    made.report.seconds = watch.seconds();
  } catch (const Error& error) {
    if (error.code() == ErrorCode::internal) throw;
    result.why_not = error.what();
  }
  return result;
}

}  // namespace isopatch::segmentation
