// Solids that cannot be cut, or only just: each is refused with its reason and the entity that it is about,
// or works.

#include <algorithm>
#include <string>

#include "app/tests/program_fixture.hpp"
#include "geometry/brep/tests/made_solids.hpp"

namespace isopatch::app {
namespace {

using testing::ContainsRegex;
using testing::Not;

/// Vertices, and faces by their vertices.
std::string off_file(const std::string& vertices, const std::string& faces) {
  const auto lines = [](const std::string& text) { return std::count(text.begin(), text.end(), '\n'); };
  return "OFF\n" + std::to_string(lines(vertices)) + " " + std::to_string(lines(faces)) + " 0\n" + vertices +
         faces;
}

const std::string box_vertices = "0 0 0\n2 0 0\n2 1 0\n0 1 0\n0 0 1\n2 0 1\n2 1 1\n0 1 1\n";
const std::string l_vertices =
    "0 0 0\n2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n0 0 1\n2 0 1\n2 1 1\n1 1 1\n1 2 1\n0 2 1\n";

/// An L, 2 wide and 1 thick, whose corner at (2, 1) is cut off, over a length along both sides.
std::string l_with_a_cut_corner(const std::string& before, const std::string& after) {
  std::string vertices;
  for (const char* height : {"0", "1"})
    for (const std::string& place : {std::string("0 0"), std::string("2 0"), before, after,
                                     std::string("1 1"), std::string("1 2"), std::string("0 2")})
      vertices += place + " " + height + "\n";
  return off_file(
      vertices,
      "7 6 5 4 3 2 1 0\n7 7 8 9 10 11 12 13\n4 0 1 8 7\n4 1 2 9 8\n4 2 3 10 9\n4 3 4 11 10\n4 4 5 12 11\n"
      "4 5 6 13 12\n4 6 0 7 13\n");
}

class BadSolids : public Program {
 protected:
  int segment(const std::string& text) {
    write_file(folder_ / "part.off", text);
    return run({"segment", (folder_ / "part.off").string(), "-o", (folder_ / "blocks").string()});
  }
  int segment_made(const std::string& name) {
    return run({"segment", geometry::test::made_solid(name).string(), "--method", "cuts", "-o",
                (folder_ / "blocks").string()});
  }
  /// Of a study on part.off, clamped below and pulled above.
  json solved() {
    EXPECT_EQ(
        run_text("[model]\nfile = \"part.off\"\n[[material]]\nname = \"steel\"\n[[support]]\nfaces = [\"face "
                 "0\"]\ndisplacement = [0, 0, 0]\n[[load]]\nfaces = [\"face 1\"]\ntraction = [0, 0, 1e6]\n",
                 {"-q"}),
        0)
        << err_;
    return json::parse(read_file(results() / "summary.json"));
  }
  void expect_certified(double volume) {
    const json summary = solved();
    EXPECT_EQ(summary["parameterization"]["certified"], true);
    EXPECT_NEAR(summary["model"]["volume"].get<double>(), volume, 1e-9 * volume);
  }
};

TEST_F(BadSolids, ThatAreOpenAreRefusedWithTheEdge) {
  EXPECT_EQ(segment(off_file(box_vertices, "4 0 3 2 1\n4 4 5 6 7\n4 0 1 5 4\n4 1 2 6 5\n4 2 3 7 6\n")), 2);
  EXPECT_THAT(
      err_,
      HasSubstr(
          "the edge between vertex 0 at (0, 0, 0) m and vertex 3 at (0, 1, 0) m belongs to one face only"));
  EXPECT_FALSE(fs::exists(folder_ / "blocks" / "block_0.step"));
}

// A house with a notch in its ridge: both halves of the roof meet at its two ends.
TEST_F(BadSolids, ThatAreNotThreeConnectedAreRefusedWithThePair) {
  EXPECT_EQ(
      segment(off_file(
          "0 0 0\n0 2 0\n0 2 1\n0 1 2\n0 0 1\n3 0 0\n3 2 0\n3 2 1\n3 1 2\n3 0 1\n1 1 2\n2 1 2\n1.5 0.5 "
          "1.5\n1.5 1.5 1.5\n",
          "5 0 4 3 2 1\n5 5 6 7 8 9\n4 0 1 6 5\n4 1 2 7 6\n4 0 5 9 4\n7 2 3 10 13 11 8 7\n7 9 8 11 12 10 3 "
          "4\n3 10 12 13\n3 11 13 12\n")),
      2);
  EXPECT_THAT(err_, HasSubstr("not 3-connected: face 5 and face 6 meet in vertex 3 at (0, 1, 2) m and in "
                              "vertex 11 at (2, 1, 2) m without "
                              "the edge between them"));
  EXPECT_THAT(err_, HasSubstr("cut the solid there"));
}

// The edge between the sides 2 and 3 has 180 degrees, and a vertex on the top has two edges only.
TEST_F(BadSolids, WithFlatEdgesAndCornersAreCut) {
  ASSERT_EQ(
      segment(off_file(
          "0 0 0\n1 0 0\n2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n0 0 1\n1 0 1\n2 0 1\n2 1 1\n1 1 1\n1 2 1\n0 2 "
          "1\n",
          "7 6 5 4 3 2 1 0\n7 7 8 9 10 11 12 13\n4 0 1 8 7\n4 1 2 9 8\n4 2 3 10 9\n4 3 4 11 10\n4 4 5 12 "
          "11\n4 5 6 13 12\n4 6 0 7 13\n")),
      0)
      << err_;
  EXPECT_THAT(out_, HasSubstr("2 hexahedra"));
  expect_certified(3);
  ASSERT_EQ(
      segment(off_file(
          l_vertices + "1 0 1\n",
          "6 5 4 3 2 1 0\n7 6 12 7 8 9 10 11\n5 0 1 7 12 6\n4 1 2 8 7\n4 2 3 9 8\n4 3 4 10 9\n4 4 5 11 10\n"
          "4 5 0 6 11\n")),
      0)
      << err_;
  EXPECT_THAT(out_, HasSubstr("2 hexahedra"));
  expect_certified(3);
}

TEST_F(BadSolids, WithASliverOfAFaceAreCut) {
  ASSERT_EQ(segment(l_with_a_cut_corner("2 0.9999", "1.9999 1")), 0) << err_;
  expect_certified(3 - 0.5e-8);
}

TEST_F(BadSolids, WithAnEdgeShorterThanTheToleranceAreRefusedWithItsVertices) {
  EXPECT_EQ(segment(l_with_a_cut_corner("2 0.999999999", "1.999999999 1")), 2);
  EXPECT_THAT(err_, HasSubstr("an edge of face 0 has no length: vertex 3 at (2, 1, 0) m and vertex 2 at (2, "
                              "1, 0) m; merge them"));
}

/// An L of which one corner of the top is cut off, over a length along all three edges.
std::string l_without_a_corner(const std::string& less_than_2, const std::string& less_than_1) {
  return off_file("0 0 0\n2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n0 0 1\n2 0 1\n" + less_than_2 +
                      " 1 1\n1 1 1\n1 2 1\n0 2 1\n2 " + less_than_1 + " 1\n2 1 " + less_than_1 + "\n",
                  "6 5 4 3 2 1 0\n7 6 7 12 8 9 10 11\n4 0 1 7 6\n5 1 2 13 12 7\n5 2 3 9 8 13\n4 3 4 10 "
                  "9\n4 4 5 11 10\n4 5 0 6 11\n3 8 12 13\n");
}

TEST_F(BadSolids, WithEdgesShorterThanWhatCountsAsContactOfBodiesAreCut) {
  // 1e-3 m where sides of other bodies within 2e-3 m would be one.
  EXPECT_EQ(segment(l_without_a_corner("1.999", "0.999")), 0) << err_;
  expect_certified(3 - 1e-9 / 6);
}

TEST_F(BadSolids, WithEdgesAsShortAsAPointAreRefusedWithTheEdge) {
  EXPECT_EQ(segment(l_without_a_corner("1.9999999", "0.9999999")), 2);
  EXPECT_THAT(err_,
              ContainsRegex("edge [0-9]+ from .*is only 1.41e-07 m long.*remove it in the CAD program"));
}

TEST_F(BadSolids, WithFacesThatTheCutsDoNotKnowAreRefusedWithTheFace) {
  for (const char* name : {"cylinder", "cone", "torus"}) {
    EXPECT_EQ(segment_made(name), 2);
    EXPECT_THAT(err_, ContainsRegex("face 0 is bounded by the closed edge [0-9]+; cut the solid through it"))
        << name;
  }
  for (const char* name : {"sphere", "spring"}) {
    EXPECT_EQ(segment_made(name), 2);
    EXPECT_THAT(err_, ContainsRegex("face 0 is closed on itself along edge [0-9]+; cut the solid through it"))
        << name;
  }
  EXPECT_EQ(segment_made("drilled"), 2);
  EXPECT_THAT(err_, ContainsRegex("face [0-9]+ has 2 outlines; one is needed"));
  EXPECT_THAT(err_, Not(HasSubstr("bug")));
}

}  // namespace
}  // namespace isopatch::app
