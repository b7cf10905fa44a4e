#include <gtest/gtest.h>

#include "geometry/brep/cell_solids.hpp"
#include "geometry/hex/hex_topology.hpp"
#include "segmentation/decomposition/blocks.hpp"
#include "segmentation/decomposition/decompose.hpp"
#include "segmentation/decomposition/tests/sample_polyhedra.hpp"
#include "segmentation/parameterization/assemble_model.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Polyhedron;

struct Case {
  const char* name;
  Polyhedron solid;
  int hexahedra;  ///< wanted at most
};

class Decompose : public testing::TestWithParam<Case> {};

TEST_P(Decompose, MakesHexahedraThatFillTheSolidAndMeetSideToSide) {
  const geometry::Brep solid = geometry::make_brep(GetParam().solid);
  const Decomposition result = decompose(solid, GetParam().name);
  EXPECT_LE(result.report.hexahedra, GetParam().hexahedra);
  const std::vector<geometry::BrepFile> parts = blocks({solid, GetParam().name, 0}, result);
  double volume = 0;
  for (const geometry::BrepFile& part : parts) {
    EXPECT_GT(part.brep.volume(), 0);
    volume += part.brep.volume();
  }
  EXPECT_NEAR(volume, solid.volume(), 1e-12 * solid.volume());
  const HexModel model = hex_model(parts);  // throws for what is no hexahedron
  EXPECT_TRUE(model.topology.t_joints.empty());
  // As many outer faces as the cells have that are parts of the solid's.
  std::size_t outer = 0, wanted = 0;
  for (const geometry::HexFace& face : model.topology.faces) outer += face.uses.size() == 1 ? 1 : 0;
  for (const geometry::Cell& cell : result.complex.cells)
    for (const geometry::CellFaceUse& use : cell.faces) wanted += result.complex.face(use.face).origin ? 1 : 0;
  EXPECT_EQ(outer, wanted);
}

INSTANTIATE_TEST_SUITE_P(Solids, Decompose,
                         testing::Values(Case{"tetrahedron", samples::tetrahedron(), 4},
                                         Case{"prism", samples::prism({{0, 0}, {1, 0}, {0, 1}}, 1), 3},
                                         Case{"pyramid", samples::pyramid(4), 8},
                                         Case{"l_shape", samples::l_shape(), 2},
                                         Case{"house", samples::house(), 5},
                                         Case{"pyramid_6", samples::pyramid(6), 16}),
                         [](const auto& info) { return std::string(info.param.name); });

}  // namespace
}  // namespace isopatch::segmentation
