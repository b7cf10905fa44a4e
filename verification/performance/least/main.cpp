// The least number of hexahedra that a solid's graph allows, all edges taken as convex: a line for each file
// of solids, "-" where the graph has too many vertices to count or no count.

#include <fmt/format.h>

#include <string>

#include "geometry/base/error.hpp"
#include "geometry/brep/read_brep.hpp"
#include "segmentation/decomposition/combinatorics/hexahedra_count.hpp"
#include "segmentation/decomposition/cutting/cell_sides.hpp"
#include "segmentation/decomposition/prepare.hpp"

namespace isopatch::verification {
namespace {

constexpr int most_vertices = 14;  // tenfold time with every two more

std::string least(const std::string& file) {
  const geometry::BrepFile solid = geometry::read_brep(file);
  const geometry::CellComplex whole = segmentation::prepared(solid.brep);
  const segmentation::CellGraph graph =
      cell_sides(segmentation::CellShapes(solid.brep, whole), geometry::CellId(0)).graph;
  if (graph.vertex_count > most_vertices) return fmt::format("-  # {} vertices", graph.vertex_count);
  return fmt::format("{}", segmentation::HexahedraCount().minimum(graph));
}

}  // namespace
}  // namespace isopatch::verification

int main(int count, char** files) {
  for (int i = 1; i < count; ++i) {
    try {
      fmt::print("{}\n", isopatch::verification::least(files[i]));
    } catch (const isopatch::Error& error) {
      fmt::print("-  # {}\n", error.what());
    }
  }
}
