#include "segmentation/decomposition/known_shape.hpp"

#include <fmt/format.h>

#include <cmath>

#include "geometry/base/error.hpp"
#include "geometry/base/stopwatch.hpp"
#include "segmentation/decomposition/prepare.hpp"
#include "segmentation/sweeps/swept_cells.hpp"
#include "segmentation/turned/turned_cells.hpp"

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

std::string text_of(const TurnedCells& turned) {
  const std::string column =
      turned.along_axis > 0 ? fmt::format(", {} along the axis", turned.along_axis) : std::string();
  return fmt::format("turned about {}: {} quadrilateral{} in {} sector{}{}", direction_text(turned.about),
                     turned.quadrilaterals, turned.quadrilaterals == 1 ? "" : "s", turned.sectors,
                     turned.sectors == 1 ? "" : "s", column);
}

/// Keeps cells if they are fewer than those known.
template <class Cells>
void take(const std::optional<Cells>& cells, KnownShape& known) {
  if (!cells) return;
  std::optional<Decomposition>& best = known.decomposition;
  const int count = static_cast<int>(cells->complex.cells.size());
  if (best && best->report.hexahedra <= count) return;
  best.emplace(Decomposition{cells->complex, cells->complex, {}, {}});
  best->report.cells = best->report.hexahedra = count;
  best->report.seen_as = text_of(*cells);
}

/// One way of looking at a solid; what refuses leaves its reason.
template <class Look>
void look(const Look& at, KnownShape& known) {
  try {
    take(at(), known);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::internal) throw;
    known.why_not = error.what();
  }
}

}  // namespace

KnownShape known_shape(const geometry::Brep& solid, const DecompositionOptions& options) {
  const Stopwatch watch;
  KnownShape result;
  if (options.method == Method::cuts || options.t_joints == TJoints::keep) return result;
  if (!planes_are_divided(solid)) look([&] { return swept_cells(solid); }, result);
  look([&] { return turned_cells(solid); }, result);
  if (result.decomposition) result.decomposition->report.seconds = watch.seconds();
  return result;
}

}  // namespace isopatch::segmentation
