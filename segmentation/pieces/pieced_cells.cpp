#include "segmentation/pieces/pieced_cells.hpp"

#include <algorithm>
#include <utility>

#include "geometry/base/error.hpp"
#include "segmentation/pieces/internal/cut_into_stacks.hpp"
#include "segmentation/pieces/internal/meeting.hpp"
#include "segmentation/pieces/internal/socket.hpp"
#include "segmentation/pieces/joined_complex.hpp"

namespace isopatch::segmentation {
namespace {

PiecedCells cells_of(const geometry::Brep& solid, const std::vector<Piece>& pieces,
                     bool with_sockets = false) {
  PiecedCells result;
  std::vector<ComplexOfPiece> complexes;
  for (MetPiece& met : met_pieces(pieces, with_sockets)) {
    const Piece& piece = pieces[complexes.size()];
    result.pieces.push_back({met.along, piece.turned, static_cast<int>(met.complex.cells.size())});
    complexes.push_back({std::move(met.complex), piece.origin});
  }
  result.complex = joined_complex(complexes, 1e-6 * solid.size());
  return result;
}

/// What is round on a piece whose other side is divided otherwise, as a piece of its own on a socket.
std::optional<PiecedCells> cells_on_sockets(const geometry::Brep& solid, const std::vector<Piece>& pieces) {
  for (const std::vector<Piece>& way : cut_once_more(pieces)) {
    if (std::none_of(way.begin(), way.end(), [](const Piece& piece) { return socket_of(piece).has_value(); }))
      continue;
    try {
      return cells_of(solid, way, true);
    } catch (const Error& error) {
      if (error.code() == ErrorCode::internal) throw;
    }
  }
  return std::nullopt;
}

}  // namespace

std::optional<PiecedCells> pieced_cells(const geometry::Brep& solid,
                                        const std::vector<geometry::PlaneSurface>& cuts, double seconds) {
  std::optional<PiecedCells> best;
  std::optional<Error> refusal;
  constexpr std::size_t most_ways = 4;
  const std::vector<std::vector<Piece>> ways = ways_to_cut(solid, cuts, seconds);
  for (std::size_t w = 0; w < std::min(ways.size(), most_ways); ++w) {
    try {
      PiecedCells made = cells_of(solid, ways[w]);
      if (!best || made.complex.cells.size() < best->complex.cells.size()) best = std::move(made);
    } catch (const Error& error) {
      if (error.code() == ErrorCode::internal) throw;
      refusal = error;
    }
  }
  for (std::size_t w = 0; w < std::min(ways.size(), most_ways) && !best; ++w)
    best = cells_on_sockets(solid, ways[w]);
  if (!best && refusal) throw *refusal;
  return best;
}

}  // namespace isopatch::segmentation
