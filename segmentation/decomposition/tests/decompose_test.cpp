#include "segmentation/decomposition/decompose.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/brep/cell_solids.hpp"
#include "geometry/brep/make_brep.hpp"
#include "geometry/brep/read_brep.hpp"
#include "segmentation/decomposition/blocks.hpp"
#include "segmentation/decomposition/combinatorics/base_solid.hpp"
#include "segmentation/decomposition/cutting/cell_sides.hpp"
#include "segmentation/decomposition/cutting/tests/sample_polyhedra.hpp"
#include "segmentation/decomposition/cutting_error.hpp"
#include "segmentation/decomposition/prospect.hpp"
#include "segmentation/decomposition/star_cells.hpp"

namespace isopatch::segmentation {
namespace {

/// What holds for every decomposition: hexahedra that fill the solid, meet side to side, and whose outer
/// faces are the solid's, face by face.
void expect_sound(const geometry::BrepFile& solid, const Decomposition& result) {
  const std::vector<geometry::BrepFile> parts = blocks(solid, result);
  ASSERT_EQ(static_cast<int>(parts.size()), result.report.hexahedra);
  double volume = 0;
  for (const geometry::BrepFile& part : parts) {
    EXPECT_GT(part.brep.volume(), 0);
    volume += part.brep.volume();
  }
  EXPECT_NEAR(volume, solid.brep.volume(),
              1e-9 * solid.brep.volume());  // planes are exact, curved edges to that
  double area = 0;
  std::map<FaceId, int> uses;
  for (std::size_t c = 0; c < result.complex.cells.size(); ++c) {
    const geometry::CellId cell(static_cast<int>(c));
    const CellSides sides = cell_sides(CellShapes(solid.brep, result.complex), cell);
    const auto base = base_solid(sides.graph);
    ASSERT_TRUE(base && base->kind == BaseKind::hexahedron);
    for (const auto& side : sides.faces) EXPECT_EQ(side.size(), 1U);
    for (const auto& edge : sides.edges) EXPECT_EQ(edge.size(), 1U);
    const auto& faces = result.complex.cells[c].faces;
    for (std::size_t f = 0; f < faces.size(); ++f) {
      ++uses[faces[f].face];
      if (result.complex.face(faces[f].face).origin) area += parts[c].brep.area(FaceId(static_cast<int>(f)));
    }
  }
  for (const auto& [face, count] : uses) EXPECT_EQ(count, result.complex.face(face).origin ? 1 : 2);
  EXPECT_NEAR(area, solid.brep.area(), 1e-9 * solid.brep.area());
}

struct Sample {
  const char* name;
  geometry::Polyhedron solid;
  int hexahedra;  ///< at most; what cuts make of it by hand
};

class Decompose : public testing::TestWithParam<Sample> {};

TEST_P(Decompose, MakesFewHexahedraThatFillTheSolidAndMeetSideToSide) {
  const geometry::BrepFile solid{geometry::make_brep(GetParam().solid), GetParam().name, 0};
  const Decomposition result = decompose(solid.brep, solid.name);
  EXPECT_LE(result.report.hexahedra, GetParam().hexahedra);
  EXPECT_FALSE(result.report.by_tetrahedra);
  expect_sound(solid, result);
}

INSTANTIATE_TEST_SUITE_P(
    Solids, Decompose,
    testing::Values(
        Sample{"tetrahedron", samples::pyramid(3), 4},
        Sample{"prism", samples::prism({{0, 0}, {1, 0}, {0, 1}}, 1), 3},
        Sample{"pyramid", samples::pyramid(4), 8}, Sample{"l_shape", samples::l_shape(), 2},
        Sample{"house", samples::house(), 2}, Sample{"pyramid_6", samples::pyramid(6), 16},
        Sample{"t_shape", samples::prism({{0, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 3}, {1, 3}, {1, 1}, {0, 1}}, 1),
               5}),
    [](const auto& info) { return std::string(info.param.name); });

TEST(Decompose, MergesTheTrianglesOfAPlaneFace) {
  geometry::Polyhedron box = samples::prism({{0, 0}, {2, 0}, {2, 1}, {0, 1}}, 1);
  box.faces.erase(box.faces.begin() + 1);  // the top in two
  box.faces.push_back({4, 5, 6});
  box.faces.push_back({4, 6, 7});
  const geometry::BrepFile solid{geometry::make_brep(box), "box", 0};
  const Decomposition result = decompose(solid.brep, solid.name);
  EXPECT_EQ(result.report.hexahedra, 1);
  expect_sound(solid, result);
}

TEST(Decompose, CutsFreeFacesOfSixCorners) {
  geometry::Polyhedron l = samples::prism({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}}, 1);
  l.vertices(2, 6) += 0.2;  // the top is no plane any more, and bounded by six straight edges
  const geometry::BrepFile solid{geometry::make_brep(l), "l", 0};
  ASSERT_EQ(solid.brep.faces()[1].kind, geometry::SurfaceKind::spline);
  const Decomposition result = decompose(solid.brep, solid.name);
  EXPECT_EQ(result.report.hexahedra, 2);
  double volume = 0;
  for (const geometry::BrepFile& part : blocks(solid, result)) volume += part.brep.volume();
  EXPECT_NEAR(volume, solid.brep.volume(), 1e-6 * solid.brep.volume());
}

TEST(Decompose, CutsHexahedraThatNoPatchFollows) {
  geometry::Polyhedron dart = samples::prism({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1);
  dart.vertices.col(6) << 0.3, 0.3, 1;  // the top has a corner of more than 180 degrees there
  const geometry::BrepFile solid{geometry::make_brep(dart), "dart", 0};
  EXPECT_FALSE(corners_open(solid.brep));
  const Decomposition result = decompose(solid.brep, solid.name);
  EXPECT_GE(result.report.cells, 2);
  double volume = 0;
  for (const geometry::BrepFile& part : blocks(solid, result)) {
    EXPECT_TRUE(corners_open(part.brep));
    volume += part.brep.volume();
  }
  EXPECT_NEAR(volume, solid.brep.volume(), 1e-6 * solid.brep.volume());
  EXPECT_TRUE(corners_open(geometry::make_brep(samples::prism({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1))));
}

TEST(Decompose, CutsSolidsWhoseSidesMeetTwice) {
  // Half a pot: its rim and the plane that halves it share two edges.
  const geometry::BrepFile solid{geometry::make_brep(samples::half_pot()), "pot", 0};
  const Prospect before = prospect(solid.brep);
  EXPECT_FALSE(before.refusal);
  EXPECT_EQ(before.sides, 9);  // the rim in two
  const Decomposition result = decompose(solid.brep, solid.name);
  EXPECT_FALSE(result.report.by_tetrahedra);
  EXPECT_LE(result.report.hexahedra, 12);
  expect_sound(solid, result);
}

TEST(StarCells, AreTetrahedraThatFillTheCellAndMeetAtItsFaces) {
  const geometry::Brep solid = geometry::make_brep(samples::pyramid(4));
  const geometry::CellComplex stars = star_cells(solid, geometry::one_cell(solid));
  ASSERT_EQ(stars.cells.size(), 8U);  // one for each edge of the base and one for each triangle
  std::vector<geometry::CellId> all;
  for (int c = 0; c < 8; ++c) all.emplace_back(c);
  double volume = 0;
  for (const geometry::Brep& cell : cell_solids(solid, stars, all)) {
    EXPECT_EQ(cell.faces().size(), 4U);
    volume += cell.volume();
  }
  EXPECT_NEAR(volume, solid.volume(), 1e-12);
  std::map<FaceId, int> uses;
  for (const geometry::Cell& cell : stars.cells)
    for (const geometry::CellFaceUse& use : cell.faces) ++uses[use.face];
  for (const auto& [face, count] : uses) EXPECT_EQ(count, stars.face(face).origin ? 1 : 2);
}

TEST(Decompose, SweepsStacksUnlessCutsAreAskedFor) {
  // A square frame.
  geometry::Polyhedron frame;
  frame.vertices.resize(3, 16);
  const std::array<std::array<double, 2>, 4> corners = {{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};
  for (int level = 0; level < 2; ++level)
    for (int i = 0; i < 4; ++i) {
      const auto [x, y] = corners[static_cast<std::size_t>(i)];
      frame.vertices.col(8 * level + i) << 3 * x, 3 * y, level;
      frame.vertices.col(8 * level + 4 + i) << 1 + x, 1 + y, level;
    }
  for (int i = 0; i < 4; ++i) {
    const int j = (i + 1) % 4;
    frame.faces.push_back({i, i + 4, j + 4, j});
    frame.faces.push_back({8 + i, 8 + j, 12 + j, 12 + i});
    frame.faces.push_back({i, j, 8 + j, 8 + i});
    frame.faces.push_back({4 + j, 4 + i, 12 + i, 12 + j});
  }
  const geometry::BrepFile solid{geometry::make_brep(frame), "frame", 0};
  const Decomposition swept = decompose(solid.brep, solid.name);
  EXPECT_EQ(swept.report.seen_as, "swept along z: 4 quadrilaterals between 2 levels");
  EXPECT_EQ(swept.report.hexahedra, 4);
  expect_sound(solid, swept);
  EXPECT_EQ(prospect(solid.brep).seen_as, "swept along z");
  EXPECT_ERROR(decompose(solid.brep, solid.name, {.method = Method::cuts}), ErrorCode::not_contractible,
               "1 hole leads through it");
}

TEST(Decompose, GivesUpInTime) {
  DecompositionOptions options;
  options.method = Method::cuts;
  options.time_limit = 1e-9;
  const geometry::Brep solid = geometry::make_brep(samples::l_shape());
  EXPECT_ERROR(decompose(solid, "l", options), ErrorCode::unsupported, "time_limit");
}

TEST(Decompose, KeepsThePartsAsTheyWereCutAndWhereSidesMetInParts) {
  // Three arms: the cuts through both concave edges of the trunk end in the same side.
  const geometry::Brep solid = geometry::make_brep(samples::prism(
      {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {2, 2}, {2, 3}, {1, 3}, {1, 4}, {3, 4}, {3, 5}, {0, 5}}, 1));
  const Decomposition result = decompose(solid, "e", {.method = Method::cuts});
  EXPECT_EQ(static_cast<int>(result.parts.cells.size()), result.report.cells);
  EXPECT_GT(result.report.hexahedra, result.report.cells);
  ASSERT_GT(result.t_joints.size(), 0U);
  EXPECT_EQ(static_cast<int>(result.t_joints.size()), result.report.t_joints);
  for (const PartedSide& side : result.t_joints) {
    EXPECT_FALSE(side.inside.empty());
    // A T-joint of arms over a plane polygon is an upright edge.
    for (const EdgeId id : side.inside) {
      const geometry::CellEdge& edge = result.parts.edge(id);
      const Eigen::Vector3d along = result.parts.vertex(edge.end) - result.parts.vertex(edge.start);
      EXPECT_NEAR(std::abs(along[2]), 1, 1e-12);
    }
  }
}

TEST(Decompose, ShowsWhatItHadCutWhenItGivesUp) {
  const geometry::Brep solid = geometry::make_brep(samples::l_shape());
  DecompositionOptions options;
  options.method = Method::cuts;
  options.time_limit = 1e-9;
  try {
    decompose(solid, "l", options);
    FAIL();
  } catch (const CuttingError& error) {
    ASSERT_EQ(error.parts().size(), 1U);
    EXPECT_FALSE(error.parts()[0].finished);
    EXPECT_NEAR(error.parts()[0].solid.volume(), solid.volume(), 1e-12);
    ASSERT_EQ(error.parts()[0].lines.size(), 1U);  // the concave edge
    EXPECT_EQ(error.fault().edges.size(), 1U);
  }
}

TEST(Decompose, TellsHowFarItIs) {
  const geometry::Brep solid = geometry::make_brep(samples::l_shape());
  std::vector<std::string> told;
  decompose(solid, "l", {.method = Method::cuts},
            {[&](std::string_view phase, double) { told.emplace_back(phase); }});
  ASSERT_GT(told.size(), 2U);
  EXPECT_EQ(told[0], "cutting 'l'");
  EXPECT_EQ(told[1].rfind("cutting 'l'\t0 cuts, 1 part unfinished, 0 of 60 s", 0), 0U) << told[1];
}

TEST(Decompose, KeepsTJointsIfAsked) {
  DecompositionOptions options;
  options.t_joints = TJoints::keep;
  options.method = Method::cuts;
  const std::vector<std::pair<const char*, std::vector<std::array<double, 2>>>> outlines = {
      {"e", {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {2, 2}, {2, 3}, {1, 3}, {1, 4}, {3, 4}, {3, 5}, {0, 5}}},
      {"triangle", {{0, 0}, {1, 0}, {0, 1}}},
      {"pentagon", {{0, 0}, {2, 0}, {3, 2}, {1, 3}, {-1, 2}}},
      {"arrow", {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {0.5, 3}}},
      // Its trunk is a prism over five corners, and two arms meet parts of a side of it.
      {"fork", {{0, 0}, {3, 0}, {3, 1}, {1, 1}, {1, 2}, {3, 2}, {3, 3}, {0, 3}, {-1, 1.5}}}};
  for (const auto& [name, outline] : outlines) {
    SCOPED_TRACE(name);
    const geometry::BrepFile solid{geometry::make_brep(samples::prism(outline, 1)), name, 0};
    const Decomposition result = decompose(solid.brep, name, options);
    EXPECT_TRUE(result.report.t_joints_kept);
    EXPECT_EQ(result.report.further_cuts, 0);
    double volume = 0, named = 0, surface = 0;
    for (const geometry::BrepFile& part : blocks(solid, result)) {
      EXPECT_EQ(part.brep.faces().size(), 6U);
      EXPECT_EQ(part.brep.edges().size(), 12U);
      volume += part.brep.volume();
      for (std::size_t f = 0; f < part.brep.faces().size(); ++f)
        if (const FaceId face(static_cast<int>(f)); !part.brep.face(face).name.empty())
          named += part.brep.area(face);
    }
    EXPECT_NEAR(volume, solid.brep.volume(), 1e-9);
    // A side that others cover in part has the name of a face that is left of it.
    for (std::size_t f = 0; f < solid.brep.faces().size(); ++f)
      surface += solid.brep.area(FaceId(static_cast<int>(f)));
    EXPECT_GE(named, surface - 1e-9);
    for (std::size_t c = 0; c < result.complex.cells.size(); ++c) {
      const CellSides sides =
          cell_sides(CellShapes(solid.brep, result.complex), geometry::CellId(static_cast<int>(c)));
      const auto base = base_solid(sides.graph);
      EXPECT_TRUE(base && base->kind == BaseKind::hexahedron);
    }
  }
  // Four parts, three of which meet the trunk.
  const geometry::Brep e = geometry::make_brep(samples::prism(outlines[0].second, 1));
  EXPECT_EQ(decompose(e, "e", options).report.hexahedra, 4);
}

TEST(Decompose, DividesLayersByThemselvesIfTJointsAreKept) {
  // A rib on a plate, along one of its directions: three blocks at least where they meet side to side.
  const geometry::BrepFile solid{geometry::make_brep(samples::prism(
                                     {{0, 0}, {3, 0}, {3, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}}, 1)),
                                 "rib", 0};
  DecompositionOptions options;
  options.t_joints = TJoints::keep;
  const Decomposition kept = decompose(solid.brep, solid.name, options);
  EXPECT_TRUE(kept.report.t_joints_kept);
  EXPECT_EQ(kept.report.hexahedra, 2);
  EXPECT_EQ(kept.report.seen_as, "swept along y: 2 quadrilaterals between 3 levels, each divided by itself");
  EXPECT_GE(decompose(solid.brep, solid.name).report.hexahedra, 3);
  double volume = 0;
  for (const geometry::BrepFile& part : blocks(solid, kept)) volume += part.brep.volume();
  EXPECT_NEAR(volume, solid.brep.volume(), 1e-9);
}

TEST(Prospect, CountsSidesAndConcaveEdgesOrRefuses) {
  const Prospect l = prospect(geometry::make_brep(samples::l_shape()));
  EXPECT_FALSE(l.refusal);
  EXPECT_EQ(l.sides, 8);
  EXPECT_EQ(l.concave.size(), 1U);
  EXPECT_TRUE(l.blunt.empty());
  const Prospect house = prospect(geometry::make_brep(samples::house()));
  EXPECT_TRUE(house.concave.empty());
  const Prospect notched = prospect(geometry::make_brep(samples::house_with_a_bent_notch()));
  ASSERT_TRUE(notched.refusal);
  EXPECT_EQ(notched.refusal->code(), ErrorCode::not_three_connected);
  EXPECT_EQ(notched.refusal->fault().faces.size(), 2U);
}

TEST(Decompose, NamesTheFacesOfAGraphThatIsNotThreeConnected) {
  const geometry::Brep solid = geometry::make_brep(samples::house_with_a_bent_notch());
  EXPECT_ERROR(decompose(solid, "notched", {}), ErrorCode::not_three_connected,
               "solid 'notched': its edge graph is not 3-connected: face 5 and face 6 meet in vertex 3");
}

TEST(Decompose, EndsOnRandomConvexSolids) {
  DecompositionOptions options;
  options.time_limit = 2;  // what is found after that would be better, and no sounder
  for (unsigned seed = 1; seed <= 5; ++seed) {
    SCOPED_TRACE(seed);
    const geometry::BrepFile solid{geometry::make_brep(samples::random_hull(6, seed)), "hull", 0};
    expect_sound(solid, decompose(solid.brep, solid.name, options));
  }
}

TEST(Decompose, LeavesSimpleSolidsToTheirTemplateIfNothingIsBetter) {
  // A cube with a corner cut off, obliquely: 10 vertices with three edges each.
  geometry::Polyhedron solid;
  solid.vertices.resize(3, 10);
  solid.vertices << 0, 2, 2, 0, 0, 2, 0, 2, 1.2, 2,  //
      0, 0, 2, 2, 0, 0, 2, 0.9, 2, 2,                //
      0, 0, 0, 0, 2, 2, 2, 2, 2, 1.1;
  solid.faces = {{0, 3, 2, 1},    {0, 1, 5, 4},    {0, 4, 6, 3}, {4, 5, 7, 8, 6},
                 {1, 2, 9, 7, 5}, {2, 3, 6, 8, 9}, {7, 9, 8}};
  const geometry::BrepFile file{geometry::make_brep(solid), "corner", 0};
  const Decomposition result = decompose(file.brep, file.name);
  EXPECT_LE(result.report.hexahedra, 10);
  EXPECT_FALSE(result.report.by_tetrahedra);
  expect_sound(file, result);
}

TEST(Decompose, RefusesOptionsOutOfRange) {
  const geometry::Brep solid = geometry::make_brep(samples::l_shape());
  DecompositionOptions options;
  options.cut.smallest_angle = Angle::degrees(50);
  EXPECT_ERROR(decompose(solid, "l", options), ErrorCode::invalid_argument, "smallest_angle");
  options = {};
  options.max_cells = 0;
  EXPECT_ERROR(decompose(solid, "l", options), ErrorCode::invalid_argument, "max_cells");
}

/// Models by others.
class DecomposeModel : public testing::TestWithParam<const char*> {};

TEST_P(DecomposeModel, EndsInHexahedra) {
  const char* folder = std::getenv("ISOPATCH_DATA");
  const std::filesystem::path path = std::filesystem::path(folder ? folder : "") / GetParam();
  if (!folder || !std::filesystem::exists(path)) GTEST_SKIP() << "no " << path;
  const geometry::BrepFile solid = geometry::read_brep(path);
  const Decomposition result = decompose(solid.brep, solid.name);
  expect_sound(solid, result);
}

INSTANTIATE_TEST_SUITE_P(Models, DecomposeModel,
                         testing::Values("solids/ffoLshapeCut.xml", "solids/ffoTriBiPyramid.xml",
                                         "solids/house.off", "solids/E_triangulated.off",
                                         "models/7-connected.step", "models/block_fillet1.step",
                                         "models/three_concave_edge.step", "models/conjoined_twins.step"));

}  // namespace
}  // namespace isopatch::segmentation
