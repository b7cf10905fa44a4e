#include "segmentation/decomposition/known_shape.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>
#include <vector>

#include "geometry/base/error.hpp"
#include "geometry/base/stopwatch.hpp"
#include "segmentation/decomposition/prepare.hpp"
#include "segmentation/pieces/mirrored_cells.hpp"
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
    text += fmt::format("{}{}",
                        p == 0                        ? " "
                        : p + 1 < cells.pieces.size() ? ", "
                                                      : " and ",
                        direction_text(cells.pieces[p].along));
  return text;
}

/// Hexahedra that were found without a search.
struct KnownCells {
  geometry::CellComplex complex;
  std::string seen_as;
};

std::optional<KnownCells> pieces_of(const geometry::Brep& solid,
                                    const std::vector<geometry::PlaneSurface>& cuts) {
  std::optional<PiecedCells> pieced = pieced_cells(solid, cuts);
  if (!pieced) return std::nullopt;
  std::string text = text_of(*pieced);
  return KnownCells{std::move(pieced->complex), std::move(text)};
}

/// @param why_not  gets what stopped a sweep of a solid that looks swept
std::optional<KnownCells> swept_or_pieced(const geometry::Brep& solid, std::string& why_not) {
  try {
    if (std::optional<SweptCells> swept = swept_cells(solid)) {
      std::string text = text_of(*swept);
      return KnownCells{std::move(swept->complex), std::move(text)};
    }
  } catch (const Error& error) {
    if (error.code() == ErrorCode::internal) throw;
    why_not = error.what();
  }
  return pieces_of(solid, {});
}

/// With the cuts given; nothing else will do.
KnownCells as_given(const geometry::Brep& solid, const std::vector<geometry::PlaneSurface>& cuts) {
  std::string why_not;
  std::optional<KnownCells> made = cuts.empty() ? swept_or_pieced(solid, why_not) : pieces_of(solid, cuts);
  if (!made)
    throw Error(
        ErrorCode::unsupported,
        fmt::format("{} come to no pieces that can be swept{}{}; give cuts where its pieces join, or "
                    "none, so that it is cut along loops",
                    cuts.empty() ? "its halves" : "the cuts given", why_not.empty() ? "" : ": ", why_not));
  return std::move(*made);
}

KnownCells by_hand(const geometry::Brep& solid, const DecompositionOptions& options) {
  std::vector<geometry::PlaneSurface> cuts;
  for (const GivenPlane& cut : options.cuts) cuts.push_back(plane_of(solid, cut));
  if (!options.symmetry) return as_given(solid, cuts);
  std::string halves;
  geometry::CellComplex complex =
      mirrored_cells(solid, plane_of(solid, *options.symmetry), [&](const geometry::Brep& half) {
        KnownCells made = as_given(half, cuts);
        halves += (halves.empty() ? "" : "; ") + made.seen_as;
        return std::move(made.complex);
      });
  return {std::move(complex), "one half mirrored, " + halves};
}

Decomposition decomposition_of(KnownCells cells, double seconds) {
  Decomposition result{cells.complex, cells.complex, {}, {}};
  result.report.cells = result.report.hexahedra = static_cast<int>(cells.complex.cells.size());
  result.report.seen_as = std::move(cells.seen_as);
  result.report.seconds = seconds;
  return result;
}

}  // namespace

KnownShape known_shape(const geometry::Brep& solid, const DecompositionOptions& options) {
  const Stopwatch watch;
  KnownShape result;
  if (is_cut_by_hand(options)) {
    result.decomposition = decomposition_of(by_hand(solid, options), watch.seconds());
    return result;
  }
  if (options.method == Method::cuts || options.t_joints == TJoints::keep) return result;
  if (planes_are_divided(solid)) return result;
  try {
    if (std::optional<KnownCells> made = swept_or_pieced(solid, result.why_not))
      result.decomposition = decomposition_of(std::move(*made), watch.seconds());
  } catch (const Error& error) {
    if (error.code() == ErrorCode::internal) throw;
    result.why_not = error.what();
  }
  return result;
}

}  // namespace isopatch::segmentation
