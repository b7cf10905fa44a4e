#include "segmentation/decomposition/known_shape.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/base/error.hpp"
#include "geometry/base/stopwatch.hpp"
#include "geometry/brep/require_solid.hpp"
#include "segmentation/decomposition/prepare.hpp"
#include "segmentation/sweeps/in_the_way.hpp"
#include "segmentation/sweeps/rounds.hpp"
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

/// "face 3 (torus), face 5 'rim' (cone)", the first few.
std::string listed(const geometry::Brep& solid, const std::vector<FaceId>& faces) {
  constexpr std::size_t most = 4;
  std::string text;
  for (std::size_t i = 0; i < std::min(most, faces.size()); ++i)
    text += fmt::format("{}{} ({})", i == 0 ? "" : ", ", describe(solid, faces[i]),
                        name(solid.face(faces[i]).kind));
  return faces.size() > most ? fmt::format("{} and {} more", text, faces.size() - most) : text;
}

/// Why a solid is no stack: what is in the way along its best direction, and whether it could be left out.
std::string no_stack(const geometry::Brep& solid, const DecompositionOptions& options) {
  const std::optional<InTheWay> least = least_in_the_way(solid);
  if (!least) return "it has no plane face, so nothing to sweep from";
  if (least->faces.empty()) return fmt::format("along {} it has no two floors", direction_text(least->along));
  const std::string what =
      fmt::format("along {}, where the fewest are in the way, {} {} neither across nor along it: {}",
                  direction_text(least->along), least->faces.size(),
                  least->faces.size() == 1 ? "face is" : "faces are", listed(solid, least->faces));
  const Rounds rounds = rounds_in_the_way(solid, solid.size());
  const double share = 1.01 * rounds.largest_radius / solid.size();
  const bool small = share < options.largest_blend;
  if (rounds.faces.empty() || (options.blends == Blends::remove && small)) return what;
  return fmt::format(
      "{}. These are rounds of {:.3g} m at most: with blends = \"remove\"{} they are taken off, "
      "and the rest is swept",
      what, rounds.largest_radius, small ? "" : fmt::format(" and largest_blend = {:.2g}", share));
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
    if (!swept) {
      result.no_stack = no_stack(solid, options);
      return result;
    }
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
