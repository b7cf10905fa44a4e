#include "segmentation/pieces/pieces_apart.hpp"

#include <algorithm>
#include <utility>

#include "geometry/base/error.hpp"
#include "segmentation/pieces/internal/cut_into_stacks.hpp"
#include "segmentation/pieces/joined_complex.hpp"
#include "segmentation/sweeps/swept_cells.hpp"
#include "segmentation/turned/turned_cells.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::PlaneSurface;

/// A piece by itself.
struct DividedPiece {
  geometry::CellComplex complex;
  Eigen::Vector3d along;
};

DividedPiece divided(const Piece& piece) {
  if (piece.turned)
    if (std::optional<TurnedCells> cells = turned_cells(piece.brep))
      return {std::move(cells->complex), cells->about};
  if (std::optional<SweptCells> cells = swept_cells(piece.brep))
    return {std::move(cells->complex), cells->along};
  throw Error(ErrorCode::unsupported, "a piece of it is neither swept nor turned");
}

PiecedCells cells_apart(const Brep& solid, const std::vector<Piece>& pieces) {
  PiecedCells result;
  std::vector<ComplexOfPiece> complexes;
  for (const Piece& piece : pieces) {
    DividedPiece cells = divided(piece);
    result.pieces.push_back({cells.along, piece.turned, static_cast<int>(cells.complex.cells.size())});
    complexes.push_back({std::move(cells.complex), piece.origin});
  }
  result.complex = joined_complex(complexes, 1e-6 * solid.size(), CutSides::in_parts);
  return result;
}

}  // namespace

std::optional<PiecedCells> pieces_apart(const Brep& solid, const std::vector<PlaneSurface>& cuts,
                                        double seconds) {
  std::optional<PiecedCells> best;
  std::optional<Error> refusal;
  constexpr std::size_t most_ways = 4;
  const std::vector<std::vector<Piece>> ways = ways_to_cut(solid, cuts, seconds);
  for (std::size_t w = 0; w < std::min(ways.size(), most_ways); ++w) {
    try {
      PiecedCells made = cells_apart(solid, ways[w]);
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
