#include "segmentation/decomposition/star_pieces.hpp"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/brep/hexahedra_quality.hpp"
#include "geometry/brep/make_brep.hpp"
#include "segmentation/decomposition/decompose.hpp"
#include "segmentation/decomposition/prospect.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;

struct Ring {
  double radius, height;
};

/// Turned about z in 16 sectors of triangles, which are in no plane with others, between two points of the
/// axis.
Brep turned_triangles(double bottom, const std::vector<Ring>& rings, double top) {
  const int around = 16, count = static_cast<int>(rings.size());
  geometry::Polyhedron solid;
  solid.vertices.resize(3, count * around + 2);
  const auto at = [&](int ring, int i) { return ring * around + i % around; };
  for (int r = 0; r < count; ++r)
    for (int i = 0; i < around; ++i) {
      const double turn = i * 2 * std::numbers::pi / around, wave = 1 + 0.01 * ((r + i) % 2);
      const Ring& ring = rings[static_cast<std::size_t>(r)];
      solid.vertices.col(at(r, i)) << wave * ring.radius * std::cos(turn),
          wave * ring.radius * std::sin(turn), ring.height + 0.002 * (i % 3);
    }
  solid.vertices.col(count * around) << 0, 0, bottom;
  solid.vertices.col(count * around + 1) << 0, 0, top;
  for (int i = 0; i < around; ++i) {
    solid.faces.push_back({count * around, at(0, i + 1), at(0, i)});
    for (int r = 0; r + 1 < count; ++r) {
      solid.faces.push_back({at(r, i), at(r, i + 1), at(r + 1, i + 1)});
      solid.faces.push_back({at(r, i), at(r + 1, i + 1), at(r + 1, i)});
    }
    solid.faces.push_back({count * around + 1, at(count - 1, i), at(count - 1, i + 1)});
  }
  return geometry::make_brep(solid);
}

Brep ball() {
  std::vector<Ring> rings;
  for (int r = 1; r < 9; ++r)
    rings.push_back({std::sin(r * std::numbers::pi / 9), -std::cos(r * std::numbers::pi / 9)});
  return turned_triangles(-1, rings, 1);
}

/// What sees its foot does not see the underside of its cap.
Brep mushroom() {
  return turned_triangles(
      -1.02, {{0.3, -1}, {0.1, -0.6}, {0.1, -0.3}, {0.1, 0}, {0.6, -0.2}, {0.9, 0}, {0.7, 0.4}, {0.3, 0.6}},
      0.7);
}

// Searched by cuts alone, which end at once; that no stack is found takes much longer.
const DecompositionOptions quickly = {.method = Method::cuts};

double volume_of_tetrahedra(const geometry::CellComplex& complex) {
  double result = 0;
  for (const geometry::Cell& cell : complex.cells) {
    EXPECT_EQ(cell.faces.size(), 4U);
    std::set<VertexId> corners;
    for (const geometry::CellFaceUse& use : cell.faces)
      for (const geometry::EdgeUse& edge : complex.face(use.face).loop) corners.insert(complex.from(edge));
    EXPECT_EQ(corners.size(), 4U);
    Eigen::Matrix<double, 3, 4> places;
    Eigen::Index column = 0;
    for (const VertexId corner : corners) places.col(column++) = complex.vertex(corner);
    const Eigen::Matrix3d edges = places.rightCols<3>().colwise() - places.col(0);
    result += std::abs(edges.determinant()) / 6;
  }
  return result;
}

std::map<FaceId, int> uses_of_faces(const geometry::CellComplex& complex) {
  std::map<FaceId, int> result;
  for (const geometry::Cell& cell : complex.cells)
    for (const geometry::CellFaceUse& use : cell.faces) ++result[use.face];
  return result;
}

void expect_sound(const Brep& solid, const StarPieces& stars) {
  // Of the absolute volumes, so none is turned inside out.
  EXPECT_NEAR(volume_of_tetrahedra(stars.complex), solid.volume(), 1e-9 * solid.volume());
  std::set<FaceId> origins;
  for (const auto& [face, count] : uses_of_faces(stars.complex)) {
    const auto& origin = stars.complex.face(face).origin;
    EXPECT_EQ(count, origin ? 1 : 2);
    if (origin) origins.insert(*origin);
  }
  EXPECT_EQ(origins.size(), solid.faces().size());
}

TEST(StarPieces, AreOneWhereAPointSeesAll) {
  const Brep solid = ball();
  const auto stars = star_pieces(solid);
  ASSERT_TRUE(stars);
  EXPECT_EQ(stars->pieces, 1);
  EXPECT_EQ(stars->complex.cells.size(), solid.faces().size());
  expect_sound(solid, *stars);
}

TEST(StarPieces, AreCutWhereNoneDoes) {
  const Brep solid = mushroom();
  const auto stars = star_pieces(solid);
  ASSERT_TRUE(stars);
  EXPECT_EQ(stars->pieces, 2);
  expect_sound(solid, *stars);
}

TEST(StarPieces, AreNoneOfFewTriangles) {
  const Brep few = turned_triangles(-1, {{1, -0.5}, {1, 0.5}}, 1);
  EXPECT_EQ(few.faces().size(), 64U);
  EXPECT_FALSE(star_pieces(few));
}

TEST(KeptTriangles, AreFourHexahedraForEachTetrahedron) {
  const Decomposition result = decompose(mushroom(), "mushroom", quickly);
  EXPECT_EQ(result.report.seen_as.find("its triangles as they are, around 2 points"), 0U)
      << result.report.seen_as;
  EXPECT_EQ(result.complex.cells.size(), 4 * star_pieces(mushroom())->complex.cells.size());
  EXPECT_GT(geometry::least_quality(result.complex), 0);
}

TEST(KeptTriangles, AreForetold) {
  const Prospect found = prospect(ball(), quickly);
  EXPECT_FALSE(found.refusal);
  EXPECT_NE(found.seen_as.find("isopatch reconstruct"), std::string::npos) << found.seen_as;
}

// Twelve thin folds take more pieces than are tried.
TEST(KeptTriangles, AreRefusedWhereTooManyPiecesWouldBe) {
  std::vector<Ring> bellows;
  for (int r = 0; r < 25; ++r) bellows.push_back({r % 2 == 1 ? 1 : 0.1, 0.02 * r});
  EXPECT_ERROR(decompose(turned_triangles(-0.02, bellows, 0.5), "bellows", quickly), ErrorCode::unsupported,
               "800 of its 800 sides are triangles");
}

}  // namespace
}  // namespace isopatch::segmentation
