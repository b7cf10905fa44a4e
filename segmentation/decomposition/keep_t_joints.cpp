#include "segmentation/decomposition/keep_t_joints.hpp"

#include <map>
#include <utility>
#include <vector>

#include "segmentation/decomposition/combinatorics/base_solid.hpp"
#include "segmentation/decomposition/templates.hpp"
#include "segmentation/decomposition/whole_sides.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Cell;
using geometry::CellComplex;
using geometry::CellId;

std::vector<CellId> all_cells(const CellComplex& complex) {
  std::vector<CellId> result;
  for (std::size_t c = 0; c < complex.cells.size(); ++c) result.emplace_back(static_cast<int>(c));
  return result;
}

bool is_hexahedron(const CellSides& sides) {
  const auto base = base_solid(sides.graph);
  return base && base->kind == BaseKind::hexahedron;
}

/// The cell with copies of its faces and edges, so that dividing it divides nothing of its neighbours.
Cell apart(CellComplex& complex, Cell cell) {
  std::map<EdgeId, EdgeId> copies;
  for (geometry::CellFaceUse& use : cell.faces) {
    geometry::CellFace face = complex.face(use.face);
    for (geometry::EdgeUse& edge : face.loop) {
      const auto [copy, fresh] = copies.try_emplace(edge.edge);
      if (fresh) {
        copy->second = EdgeId(static_cast<int>(complex.edges.size()));
        complex.edges.push_back(geometry::CellEdge(complex.edge(edge.edge)));
      }
      edge.edge = copy->second;
    }
    use.face = complex.add_face(std::move(face));
  }
  return cell;
}

}  // namespace

CellComplex keep_t_joints(const geometry::Brep& source, CellComplex complex, double tolerance,
                          const SideOptions& options) {
  make_sides_whole(source, complex, all_cells(complex), options);
  std::vector<Cell> hexahedra, others;
  for (const CellId id : all_cells(complex)) {
    Cell cell = complex.cell(id);
    if (is_hexahedron(cell_sides(CellShapes(source, complex), id, options)))
      hexahedra.push_back(std::move(cell));
    else
      others.push_back(apart(complex, std::move(cell)));
  }
  complex.cells = std::move(others);
  if (!complex.cells.empty()) complex = hexahedral(source, std::move(complex), tolerance);
  complex.cells.insert(complex.cells.end(), hexahedra.begin(), hexahedra.end());
  return complex;
}

}  // namespace isopatch::segmentation
