#include "segmentation/decomposition/known_shape.hpp"

#include <fmt/format.h>

#include <cmath>

#include "geometry/base/error.hpp"
#include "geometry/base/stopwatch.hpp"
#include "segmentation/decomposition/prepare.hpp"
#include "segmentation/pieces/pieced_cells.hpp"
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

/// "4 pieces swept along z, y, z and x".
std::string text_of(const PiecedCells& cells) {
  std::string text = fmt::format("{} pieces swept along", cells.pieces.size());
  for (std::size_t p = 0; p < cells.pieces.size(); ++p)
    text += fmt::format("{}{}", p == 0 ? " " : p + 1 < cells.pieces.size() ? ", " : " and ",
                        direction_text(cells.pieces[p].along));
  return text;
}

Decomposition known_cells(const geometry::CellComplex& complex, std::string seen_as) {
  Decomposition result{complex, complex, {}, {}};
  result.report.cells = result.report.hexahedra = static_cast<int>(complex.cells.size());
  result.report.seen_as = std::move(seen_as);
  return result;
}

std::optional<Decomposition> swept_or_pieced(const geometry::Brep& solid, std::string& why_not) {
  try {
    if (const auto swept = swept_cells(solid)) return known_cells(swept->complex, text_of(*swept));
  } catch (const Error& error) {
    if (error.code() == ErrorCode::internal) throw;
    why_not = error.what();
  }
  if (const auto pieced = pieced_cells(solid)) return known_cells(pieced->complex, text_of(*pieced));
  return std::nullopt;
}

}  // namespace

KnownShape known_shape(const geometry::Brep& solid, const DecompositionOptions& options) {
  const Stopwatch watch;
  KnownShape result;
  if (options.method == Method::cuts || options.t_joints == TJoints::keep) return result;
  if (planes_are_divided(solid)) return result;
  try {
    result.decomposition = swept_or_pieced(solid, result.why_not);
    if (result.decomposition) result.decomposition->report.seconds = watch.seconds();
  } catch (const Error& error) {
    if (error.code() == ErrorCode::internal) throw;
    result.why_not = error.what();
  }
  return result;
}

}  // namespace isopatch::segmentation
