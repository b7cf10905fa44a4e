#include "segmentation/decomposition/cutting/plane_section.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/brep/cell_solids.hpp"
#include "geometry/brep/make_brep.hpp"
#include "segmentation/decomposition/cutting/cut_cell.hpp"
#include "segmentation/decomposition/cutting/inside.hpp"
#include "segmentation/decomposition/cutting/tests/sample_polyhedra.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::CellComplex;
using geometry::CellId;

struct OneCell {
  explicit OneCell(const geometry::Polyhedron& solid)
      : source(geometry::make_brep(solid)), complex(one_cell(source)) {
    sides = cell_sides(CellShapes(source, complex), CellId(0));
  }
  EdgeId concave() const {
    const auto& edges = sides.graph.edges;
    const auto found = std::find_if(edges.begin(), edges.end(),
                                    [](const auto& edge) { return edge.kind == EdgeKind::non_convex; });
    return EdgeId(static_cast<int>(found - edges.begin()));
  }
  geometry::Brep source;
  CellComplex complex;
  CellSides sides;
};

TEST(CellSides, KnowAnglesAndCorners) {
  const OneCell cell(samples::l_shape());
  EXPECT_EQ(cell.sides.graph.vertex_count, 12);
  EXPECT_EQ(cell.sides.graph.faces.size(), 8U);
  EXPECT_EQ(non_convex_count(cell.sides.graph), 1);
  EXPECT_NEAR(cell.sides.graph.edge(cell.concave()).angle->degrees(), 270, 1e-9);
}

TEST(PlaneSections, ThroughAConcaveEdgeContinueBothSidesAndReachTheCorners) {
  const OneCell cell(samples::l_shape());
  const auto sections =
      plane_sections(CellShapes(cell.source, cell.complex), cell.sides, cell.concave(), 1e-9);
  // The planes of both sides, to new vertices, and those through the three outer edges that can be seen.
  const auto count = [&](bool extends, int auxiliary) {
    return std::count_if(sections.begin(), sections.end(), [&](const SpacedLoop& section) {
      return section.loop.extends() == extends && section.loop.auxiliary_vertices() == auxiliary;
    });
  };
  EXPECT_EQ(count(true, 2), 2);
  EXPECT_EQ(count(false, 0), 3);
  for (const SpacedLoop& section : sections) EXPECT_EQ(section.loop.length(), 4);
}

TEST(PlaneSections, CutIntoPiecesThatAddUp) {
  const OneCell cell(samples::l_shape());
  for (const SpacedLoop& section :
       plane_sections(CellShapes(cell.source, cell.complex), cell.sides, cell.concave(), 1e-9)) {
    const CutAttempt attempt =
        cut_cell(cell.source, cell.complex, CellId(0), cell.sides, {section.loop, {}, section.places});
    ASSERT_TRUE(attempt.cut) << attempt.refusal;
    const auto solids =
        cell_solids(cell.source, attempt.cut->complex, {attempt.cut->left, attempt.cut->right});
    EXPECT_NEAR(solids[0].volume() + solids[1].volume(), 3, 1e-12);
    // A side that is continued is one side of its piece, though it has two faces.
    const CellShapes shapes(cell.source, attempt.cut->complex);
    std::size_t in_parts = 0;
    for (const CellId piece : {attempt.cut->left, attempt.cut->right})
      for (const auto& side : cell_sides(shapes, piece).faces) in_parts += side.size() - 1;
    EXPECT_EQ(in_parts, section.loop.extends() ? 1U : 0U);
  }
}

TEST(CutCell, RefusesWhatLeavesTheCellOrIsTooThin) {
  const OneCell cell(samples::l_shape());
  // Across the notch: from (2, 1) to (1, 2) outside of the L.
  const CellIncidence incidence(cell.sides.graph);
  const auto vertex = [&](double x, double y, double z) {
    for (std::size_t v = 0; v < cell.sides.vertices.size(); ++v)
      if ((cell.complex.vertex(cell.sides.vertices[v]) - Eigen::Vector3d(x, y, z)).norm() < 1e-9)
        return LoopPlace::at(VertexId(static_cast<int>(v)));
    return LoopPlace();
  };
  const CuttingLoop loop = loop_through(cell.sides.graph, incidence,
                                        {vertex(2, 1, 0), vertex(1, 2, 0), vertex(1, 2, 1), vertex(2, 1, 1)});
  const CutAttempt attempt = cut_cell(cell.source, cell.complex, CellId(0), cell.sides, {loop});
  EXPECT_FALSE(attempt.cut);
  EXPECT_NE(attempt.refusal.find("leave"), std::string::npos) << attempt.refusal;
}

TEST(WindingNumber, IsOneInsideAndNoneOutside) {
  const OneCell cell(samples::l_shape());
  const Eigen::Matrix3Xd boundary = boundary_triangles(CellShapes(cell.source, cell.complex), CellId(0));
  EXPECT_NEAR(winding_number(boundary, {0.5, 1.5, 0.5}), 1, 1e-12);
  EXPECT_NEAR(winding_number(boundary, {1.5, 1.5, 0.5}), 0, 1e-12);
}

}  // namespace
}  // namespace isopatch::segmentation
