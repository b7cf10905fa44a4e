#include "segmentation/decomposition/keep_t_joints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "geometry/base/error.hpp"
#include "segmentation/decomposition/combinatorics/base_solid.hpp"
#include "segmentation/decomposition/templates.hpp"
#include "segmentation/decomposition/whole_sides.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Cell;
using geometry::CellComplex;
using geometry::CellFaceUse;

constexpr const char* instead = "; remove the T-joints instead (t_joints = \"remove\")";

bool is_whole(const CellSides& sides) {
  const auto one = [](const auto& pieces) { return pieces.size() == 1; };
  return std::all_of(sides.faces.begin(), sides.faces.end(), one) &&
         std::all_of(sides.edges.begin(), sides.edges.end(), one);
}

/// Of two sides that share a face one must lie in the other.
void require_nested(const std::vector<CellSides>& cells) {
  std::map<FaceId, std::size_t> parted;  // faces of sides in parts, with the cell
  for (std::size_t c = 0; c < cells.size(); ++c)
    for (const auto& side : cells[c].faces) {
      if (side.size() < 2) continue;
      for (const CellFaceUse& use : side)
        if (const auto [other, fresh] = parted.try_emplace(use.face, c); !fresh)
          throw Error(ErrorCode::unsupported,
                      fmt::format("sides of parts {} and {} overlap, and neither lies in the other{}",
                                  other->second, c, instead));
    }
}

/// Cells that are hexahedra, and those that are none.
struct Sorted {
  std::vector<Cell> hexahedra, others;
};

Sorted sorted(const CellComplex& complex, const std::vector<CellSides>& sides) {
  Sorted result;
  for (std::size_t c = 0; c < complex.cells.size(); ++c) {
    const auto base = base_solid(sides[c].graph);
    const bool hexahedron = base && base->kind == BaseKind::hexahedron;
    if (!hexahedron && !is_whole(sides[c]))
      throw Error(
          ErrorCode::unsupported,
          fmt::format("part {} is no hexahedron and meets others in parts of its sides{}", c, instead));
    (hexahedron ? result.hexahedra : result.others).push_back(complex.cells[c]);
  }
  return result;
}

/// Hexahedra get copies of the faces that they share with others, which are going to be divided.
void part_from_others(CellComplex& complex, Sorted& cells) {
  std::set<FaceId> divided;
  for (const Cell& cell : cells.others)
    for (const CellFaceUse& use : cell.faces) divided.insert(use.face);
  for (Cell& cell : cells.hexahedra)
    for (CellFaceUse& use : cell.faces) {
      if (!divided.contains(use.face)) continue;
      complex.faces.push_back(geometry::CellFace(complex.face(use.face)));
      use.face = FaceId(static_cast<int>(complex.faces.size()) - 1);
    }
}

}  // namespace

CellComplex keep_t_joints(const geometry::Brep& source, CellComplex complex, double tolerance,
                          const SideOptions& options) {
  std::vector<CellSides> sides;
  for (std::size_t c = 0; c < complex.cells.size(); ++c)
    sides.push_back(cell_sides(CellShapes(source, complex), geometry::CellId(static_cast<int>(c)), options));
  require_nested(sides);
  Sorted cells = sorted(complex, sides);
  part_from_others(complex, cells);
  complex.cells = std::move(cells.others);
  if (!complex.cells.empty()) complex = hexahedral(source, std::move(complex), tolerance);
  const std::size_t divided = complex.cells.size();
  complex.cells.insert(complex.cells.end(), cells.hexahedra.begin(), cells.hexahedra.end());
  std::vector<geometry::CellId> whole;
  for (std::size_t c = divided; c < complex.cells.size(); ++c) whole.emplace_back(static_cast<int>(c));
  make_sides_whole(source, complex, whole, options);
  return complex;
}

}  // namespace isopatch::segmentation
