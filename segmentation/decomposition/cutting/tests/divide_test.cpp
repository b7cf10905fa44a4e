#include <gtest/gtest.h>

#include "geometry/brep/cell_solids.hpp"
#include "geometry/brep/make_brep.hpp"
#include "segmentation/decomposition/cutting/auxiliary_curve.hpp"
#include "segmentation/decomposition/cutting/cutting_surface.hpp"
#include "segmentation/decomposition/cutting/divide.hpp"
#include "segmentation/decomposition/cutting/tests/sample_polyhedra.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::CellComplex;
using geometry::CellId;
using geometry::EdgeUse;

// A prism of height 1 over an L of area 3; vertices i below, i + 6 above; concave at (1, 1).
geometry::Brep l_prism() {
  return geometry::make_brep(samples::prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 1));
}

EdgeId edge_between(const CellComplex& complex, VertexId a, VertexId b) {
  for (std::size_t e = 0; e < complex.edges.size(); ++e)
    if (const auto& edge = complex.edges[e]; std::minmax(edge.start, edge.end) == std::minmax(a, b))
      return EdgeId(static_cast<int>(e));
  throw std::runtime_error("no such edge");
}

TEST(Divide, CutsAnLIntoTwoBlocks) {
  const geometry::Brep source = l_prism();
  CellComplex complex = one_cell(source);
  const double tolerance = 1e-9;
  const auto add = [&](FaceId face, VertexId from, VertexId to) {
    const auto curve = auxiliary_curve(CellShapes(source, complex), face, from, to, tolerance);
    EXPECT_TRUE(curve.has_value());
    return divide_face(complex, face, from, to, complex.add_curve(curve->curve));
  };
  const EdgeId below = add(FaceId(0), VertexId(3), VertexId(0));
  const EdgeId above = add(FaceId(1), VertexId(6), VertexId(9));
  const EdgeId side = edge_between(complex, VertexId(0), VertexId(6));
  const EdgeId inner = edge_between(complex, VertexId(3), VertexId(9));
  const auto use = [&](EdgeId edge, VertexId from) {
    return EdgeUse{edge, complex.edge(edge).start != from};
  };
  const std::vector<EdgeUse> walk = {use(below, VertexId(3)), use(side, VertexId(0)), use(above, VertexId(6)),
                                     use(inner, VertexId(9))};
  const auto surface = cutting_surface(CellShapes(source, complex),
                                       {{walk[0]}, {walk[1]}, {walk[2]}, {walk[3]}}, tolerance, false);
  ASSERT_TRUE(surface.has_value());
  const DividedCell divided = divide_cell(complex, CellId(0), walk, complex.add_surface(surface->surface));
  const auto solids = cell_solids(source, complex, {CellId(0), divided.other});
  ASSERT_EQ(solids.size(), 2U);
  for (const auto& solid : solids) {
    EXPECT_NEAR(solid.volume(), 1.5, 1e-12);
    EXPECT_EQ(solid.faces().size(), 6U);
    EXPECT_EQ(solid.edges().size(), 12U);
    EXPECT_EQ(solid.vertices().cols(), 8);
  }
}

}  // namespace
}  // namespace isopatch::segmentation
