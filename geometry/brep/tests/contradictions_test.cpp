#include "geometry/brep/contradictions.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/tests/data_file.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/brep/check_brep.hpp"
#include "geometry/brep/make_brep.hpp"
#include "geometry/brep/read_brep.hpp"
#include "geometry/brep/tests/altered_kernel.hpp"
#include "geometry/brep/tests/step_text.hpp"
#include "geometry/topology/tests/sample_solids.hpp"

namespace isopatch::geometry {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

/// A block of 1 x 2 x 2 whose face at high x lies off its edges.
Brep block_with_a_face_off(double off) {
  const fs::path path =
      fs::path(testing::TempDir()) /
      (std::string(testing::UnitTest::GetInstance()->current_test_info()->name()) + ".step");
  test::StepText step;
  const std::vector<int> faces = test::block(step, {1, 2, 2}, off);
  write_file(path, step.file(faces, "m"));
  const Brep brep = read_brep(path).brep;
  fs::remove(path);
  return brep;
}

TEST(Contradictions, AFaceOffItsEdgesIsNamedWithEdgePlaceAndSize) {
  const Brep brep = block_with_a_face_off(0.24);
  const BrepReport report = check(brep);
  EXPECT_EQ(report.stage, BrepStage::repair);
  EXPECT_NEAR(report.largest_gap, 0.24, 1e-9);
  EXPECT_EQ(report.gap.face, FaceId(5));
  EXPECT_NEAR(report.gap.place.x(), 1, 1e-9);
  ASSERT_EQ(report.contradictions.size(), 1u);
  EXPECT_THAT(report.contradictions[0].text, HasSubstr("face 5 lies 0.24 m (0.08 of the size) off its edge"));
  EXPECT_THAT(report.findings, testing::Contains(report.contradictions[0].text));
}

TEST(Contradictions, TheErrorMarksTheFaceAndItsEdge) {
  const Brep brep = block_with_a_face_off(0.24);
  try {
    require_sound(brep);
    FAIL() << "no error";
  } catch (const SolidError& error) {
    EXPECT_EQ(error.code(), ErrorCode::not_manifold);
    EXPECT_THAT(error.what(), HasSubstr("face 5 lies 0.24 m"));
    ASSERT_EQ(error.fault().faces.size(), 1u);
    EXPECT_EQ(error.fault().faces[0].number, 5);
    EXPECT_EQ(error.fault().edges.size(), 1u);
    EXPECT_EQ(error.fault().points.size(), 1u);
  }
}

TEST(Contradictions, AVolumeThatTrianglesRefuteIsOne) {
  const auto contradictions_of = [](double factor, const Eigen::Vector3d& moved) {
    return check(test::altered(make_brep(test::block(1, 2, 3)),
                               [&](test::Altered& altered) {
                                 altered.volume_factor = factor;
                                 altered.triangles_moved_by = moved;
                               }))
        .contradictions;
  };
  EXPECT_TRUE(contradictions_of(1, {0, 0, 0}).empty());
  EXPECT_TRUE(contradictions_of(1.001, {0, 0, 0}).empty());  // triangles explain as much
  const auto found = contradictions_of(1.1, {0, 0, 0});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_THAT(found[0].text,
              HasSubstr("the volume is 6.6 m^3 by quadrature over the faces and 6 m^3 by triangles"));
  // Triangles that lie far off their own face say nothing about it.
  EXPECT_TRUE(contradictions_of(1, {0.5, 0.5, 0.5}).empty());
}

TEST(Contradictions, LoopsThatAreOpenOrEncloseNothingAreNamed) {
  const Brep block = make_brep(test::block(1, 2, 3));
  const auto texts = [&](const auto& change) {
    std::vector<std::string> result;
    for (const Contradiction& found : check(test::altered(block, change)).contradictions)
      result.push_back(found.text);
    return result;
  };
  EXPECT_THAT(texts([](test::Altered& altered) { altered.tables.faces[2].loops[0].pop_back(); }),
              testing::Contains(HasSubstr("a loop of face 2 is open: edge")));
  EXPECT_THAT(texts([](test::Altered& altered) {
                const EdgeUse there = altered.tables.faces[2].loops[0][0];
                const EdgeUse back = altered.tables.faces[2].loops[0][1];
                BrepEdge& edge = altered.tables.edges[static_cast<std::size_t>(back.edge.value)];
                const BrepEdge& first = altered.tables.edges[static_cast<std::size_t>(there.edge.value)];
                edge.start = there.reversed == back.reversed ? first.end : first.start;
                edge.end = there.reversed == back.reversed ? first.start : first.end;
                altered.tables.faces[2].loops[0] = {there, back};
              }),
              testing::Contains(HasSubstr("a loop of face 2 encloses nothing: it is the straight edges")));
  EXPECT_THAT(texts([](test::Altered& altered) { altered.tables.vertices.col(3).x() += 0.5; }),
              testing::Contains(testing::AllOf(HasSubstr("vertex 3"), HasSubstr("lies 0.5 m"),
                                               HasSubstr("off the end of edge"))));
}

TEST(Contradictions, TheToleranceIsAnOption) {
  const Brep brep = block_with_a_face_off(0.03);  // 0.01 of the size of 3
  EXPECT_EQ(check(brep).stage, BrepStage::repair);
  EXPECT_EQ(check(brep, {.soundness = {.gap = 0.011}}).stage, BrepStage::parameterization);
  EXPECT_EQ(isopatch::test::message_of([&] { require_sound(brep, {.gap = 0.011}); }), "no error");
  EXPECT_ERROR(check(brep, {.soundness = {.gap = 0}}), ErrorCode::invalid_argument, "gap is 0");
  EXPECT_EQ(check(block_with_a_face_off(0.01)).stage, BrepStage::parameterization);
}

TEST(Contradictions, SoundSolidsHaveNone) {
  for (const Polyhedron& solid :
       {test::block(1, 2, 3), test::l_shape(), test::triangulated_torus(7, 5), test::random_hull(12, 3)})
    EXPECT_EQ(isopatch::test::message_of([&] { require_sound(make_brep(solid)); }), "no error");
}

TEST(Contradictions, AnOpenBoundaryIsRefusedAsSuch) {
  Polyhedron open = test::block(1, 1, 1);
  open.faces.pop_back();
  const Brep brep = make_brep(open, {.accept_open = true});
  EXPECT_ERROR(require_sound(brep), ErrorCode::not_manifold, "one face only");
  EXPECT_EQ(check(brep).stage, BrepStage::repair);
}

// Each loop of a tetrahedron, by hand; one face more on two of its edges makes nothing that closes.
TEST(Contradictions, ShellsHaveTheirOwnCharacteristics) {
  const EdgeGraph ball = edge_graph(4, {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}});
  ASSERT_EQ(shell_characteristics(ball).size(), 1u);
  EXPECT_EQ(shell_characteristics(ball)[0].value, 2);
  const Polyhedron ring = test::triangulated_torus(7, 5);
  std::vector<std::vector<int>> both = ring.faces;
  for (const auto& face : {std::vector{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}) {
    std::vector<int> moved = face;
    for (int& corner : moved) corner += 35;
    both.push_back(moved);
  }
  const auto shells = shell_characteristics(edge_graph(39, both));
  ASSERT_EQ(shells.size(), 2u);
  EXPECT_EQ(shells[0].value, 0);
  EXPECT_EQ(shells[1].value, 2);
  EXPECT_EQ(shells[1].faces.size(), 4u);
  EXPECT_EQ(shells[1].faces.front(), FaceId(70));
}

// Faces that were fitted one by one leave the widest gaps that are usable.
TEST(Contradictions, SolidsThatWereSewnWithinTheToleranceOfSewingHaveNone) {
  const fs::path folder = isopatch::test::data_file("chair_stand/solids");
  ISOPATCH_NEEDS(folder);
  for (const auto& entry : fs::directory_iterator(folder)) {
    if (entry.path().extension() != ".xml") continue;
    SCOPED_TRACE(entry.path().filename().string());
    EXPECT_EQ(isopatch::test::message_of([&] { require_sound(read_brep(entry.path()).brep); }), "no error");
  }
}

}  // namespace
}  // namespace isopatch::geometry
