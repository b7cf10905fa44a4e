#include "segmentation/decomposition/conforming.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "geometry/brep/cell_solids.hpp"
#include "geometry/brep/make_brep.hpp"
#include "segmentation/decomposition/chords.hpp"
#include "segmentation/decomposition/cutting/plane_section.hpp"
#include "segmentation/decomposition/cutting/tests/sample_polyhedra.hpp"
#include "segmentation/decomposition/hexahedra_to_come.hpp"
#include "segmentation/decomposition/templates.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::CellComplex;
using geometry::CellId;

std::vector<CellSides> all_sides(const geometry::Brep& solid, const CellComplex& complex) {
  std::vector<CellSides> sides;
  for (std::size_t c = 0; c < complex.cells.size(); ++c)
    sides.push_back(cell_sides(CellShapes(solid, complex), CellId(static_cast<int>(c))));
  return sides;
}

/// A T over [0, 3] x [0, 3]: a bar below, a stem above.
geometry::Brep t_shape() {
  return geometry::make_brep(
      samples::prism({{0, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 3}, {1, 3}, {1, 1}, {0, 1}}, 1));
}

/// Cut through its first concave edge along y = 1, the top of the bar: two hexahedra which meet in a part of
/// the bar's side.
CellComplex bar_and_stem(const geometry::Brep& solid) {
  const CellComplex whole = geometry::one_cell(solid);
  const CellSides sides = cell_sides(CellShapes(solid, whole), CellId(0));
  for (std::size_t e = 0; e < sides.graph.edges.size(); ++e) {
    if (sides.graph.edges[e].kind != EdgeKind::non_convex) continue;
    for (const SpacedLoop& section :
         plane_sections(CellShapes(solid, whole), sides, EdgeId(static_cast<int>(e)), 1e-9)) {
      CutAttempt attempt = cut_cell(solid, whole, CellId(0), sides, {section.loop, {}, section.places});
      if (!attempt.cut) continue;
      const auto pieces = all_sides(solid, attempt.cut->complex);
      if (pieces[0].graph.vertex_count == 8 && pieces[1].graph.vertex_count == 8) return attempt.cut->complex;
    }
  }
  ADD_FAILURE() << "no cut along the bar";
  return whole;
}

TEST(Chords, AreWhereASideMeetsOthersInParts) {
  const geometry::Brep solid = t_shape();
  const CellComplex complex = bar_and_stem(solid);
  const CellShapes shapes(solid, complex);
  int with = 0;
  for (const CellSides& sides : all_sides(solid, complex)) {
    const std::vector<Chord> chords = chords_of(shapes, sides);
    if (chords.empty()) continue;
    ++with;
    ASSERT_EQ(chords.size(), 2U);  // both upright edges of the stem end in the bar's side
    for (const Chord& chord : chords) {
      EXPECT_TRUE(chord.across);
      for (const VertexId end : {chord.from, chord.to}) {
        const auto place = place_of(complex, sides, end);
        ASSERT_TRUE(place);
        EXPECT_TRUE(place->auxiliary());
        EXPECT_NEAR(complex.vertex(end).y(), 1, 1e-12);
      }
    }
  }
  EXPECT_EQ(with, 1);
}

TEST(Conforming, CarriesBothChordsThroughTheBar) {
  const geometry::Brep solid = t_shape();
  const ConformingAttempt attempt = conforming(solid, {bar_and_stem(solid)});
  ASSERT_TRUE(attempt.best) << attempt.refusal;
  EXPECT_EQ(attempt.best->further_cuts, 2);
  EXPECT_EQ(attempt.best->hexahedra, 4);  // the bar in three, and the stem
  for (const CellSides& sides : all_sides(solid, attempt.best->complex))
    for (const auto& side : sides.faces) EXPECT_EQ(side.size(), 1U);
}

TEST(Conforming, TakesTheBetterOfTwoStarts) {
  const geometry::Brep wedge = geometry::make_brep(samples::prism({{0, 0}, {2, 0}, {2, 1}, {0, 1}}, 1));
  const CellComplex box = geometry::one_cell(wedge);
  const CellSides sides = cell_sides(CellShapes(wedge, box), CellId(0));
  // Along the diagonal of bottom and top: two prisms.
  const CellIncidence incidence(sides.graph);
  const auto at = [&](double x, double y, double z) {
    for (std::size_t v = 0; v < sides.vertices.size(); ++v)
      if ((box.vertex(sides.vertices[v]) - Eigen::Vector3d(x, y, z)).norm() < 1e-12)
        return LoopPlace::at(VertexId(static_cast<int>(v)));
    return LoopPlace();
  };
  const CutAttempt halves =
      cut_cell(wedge, box, CellId(0), sides,
               {loop_through(sides.graph, incidence, {at(0, 0, 0), at(2, 1, 0), at(2, 1, 1), at(0, 0, 1)})});
  ASSERT_TRUE(halves.cut) << halves.refusal;
  const ConformingAttempt attempt = conforming(wedge, {halves.cut->complex, box});
  ASSERT_TRUE(attempt.best);
  EXPECT_EQ(attempt.best->start, 1U);
  EXPECT_EQ(attempt.best->hexahedra, 1);
  const ConformingAttempt prisms = conforming(wedge, {halves.cut->complex});
  ASSERT_TRUE(prisms.best);
  EXPECT_EQ(prisms.best->hexahedra, 6);
}

TEST(Conforming, SaysWhyThereIsNone) {
  const geometry::Brep solid = t_shape();
  const ConformingAttempt attempt = conforming(solid, {bar_and_stem(solid)}, {.max_hexahedra = 3});
  EXPECT_FALSE(attempt.best);
  EXPECT_EQ(attempt.refusal, "more than 3 hexahedra would come of it");
}

TEST(HexahedraToCome, IsWhatTemplatesMake) {
  for (const geometry::Polyhedron& polyhedron :
       {samples::pyramid(3), samples::prism({{0, 0}, {1, 0}, {0, 1}}, 1), samples::house(),
        samples::prism({{0, 0}, {2, 0}, {3, 1}, {2, 2}, {0, 2}, {-1, 1}}, 1),
        samples::prism({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1)}) {
    const geometry::Brep solid = geometry::make_brep(polyhedron);
    const CellComplex whole = geometry::one_cell(solid);
    const double expected = hexahedra_to_come(whole, all_sides(solid, whole));
    EXPECT_EQ(expected, double(hexahedral(solid, whole, 1e-9).cells.size()));
  }
  // A prism divides the edges of a hexahedron beside it, but not those along itself.
  const geometry::Brep solid = t_shape();
  const ConformingAttempt attempt = conforming(solid, {bar_and_stem(solid)});
  ASSERT_TRUE(attempt.best);
  EXPECT_EQ(attempt.best->hexahedra, double(hexahedral(solid, attempt.best->complex, 1e-9).cells.size()));
}

}  // namespace
}  // namespace isopatch::segmentation
