#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/io/read_mfem_mesh.hpp"
#include "geometry/io/tests/sample_patches.hpp"

namespace isopatch::geometry {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

// Written by hand: a brick of 1 x 2 x 1, and on its side x = 1 two of 1 x 1 x 1, which divide that side in
// two: its vertices 8 and 9 have none of the first brick's. Degrees are 1 along x, 2 along y and z.
// Coefficients: 16 vertices, then the insides of edges, faces and patches, without those of the divided side
// and its edges.
const std::string three_bricks = R"(MFEM NURBS NC-patch mesh v1.0
dimension
3

# rank attr geom ref_type nodes/children
elements
3
0 1 5 0  0 1 2 3  4 5 6 7
0 1 5 0  1 10 11 8  5 13 14 9
0 1 5 0  8 11 12 2  9 14 15 6

boundary
2
7 3  3 0 4 7
8 3  10 11 14 13

vertex_to_knotspan
2
8 1 0 1 2 6 5
9 1 1 1 2 6 5

coordinates
16
3
0 0 0  1 0 0  1 2 0  0 2 0
0 0 1  1 0 1  1 2 1  0 2 1
1 1 0  1 1 1
2 0 0  2 1 0  2 2 0
2 0 1  2 1 1  2 2 1

edges
30
0 0 1
0 3 2
0 4 5
0 7 6
1 0 3
1 1 2
1 4 7
1 5 6
2 0 4
2 1 5
2 2 6
2 3 7
3 1 10
3 8 11
3 5 13
3 9 14
4 1 8
4 10 11
4 5 9
4 13 14
2 8 9
2 10 13
2 11 14
3 2 12
3 6 15
5 8 2
5 11 12
5 9 6
5 14 15
2 12 15
)";
const std::string their_coefficients = R"(
knotvectors
6
1 2  0 0 1 1
2 5  0 0 0 0.5 0.5 1 1 1
2 3  0 0 0 1 1 1
1 2  0 0 1 1
2 3  0 0 0 1 1 1
2 3  0 0 0 1 1 1

spacing
0

unitweights
MFEM FiniteElementSpace v1.0
FiniteElementCollection: NURBS
VDim: 3
Ordering: 1
End: MFEM FiniteElementSpace v1.0
0 0 0  1 0 0  1 2 0  0 2 0
0 0 1  1 0 1  1 2 1  0 2 1
1 1 0  1 1 1
2 0 0  2 1 0  2 2 0
2 0 1  2 1 1  2 2 1
0 .5 0  0 1 0  0 1.5 0
0 .5 1  0 1 1  0 1.5 1
0 0 .5  1 0 .5  1 2 .5  0 2 .5
1 .5 0  2 .5 0  1 .5 1  2 .5 1
1 1 .5  2 0 .5  2 1 .5
1 1.5 0  2 1.5 0  1 1.5 1  2 1.5 1
2 2 .5
0 1.5 .5  0 1 .5  0 .5 .5
2 .5 .5  1 .5 .5
2 1.5 .5  1 1.5 .5
mfem_mesh_end
)";

std::string numbered() {
  return three_bricks + their_coefficients;
}

TEST(MfemNcPatchMesh, FacesHaveTheCoefficientsOfThoseThatDivideThem) {
  const PatchSet found = read_mfem_mesh(numbered(), "a.mesh");
  ASSERT_EQ(found.patches.size(), 3u);
  const std::array<Vector3d, 3> low = {Vector3d(0, 0, 0), Vector3d(1, 0, 0), Vector3d(1, 1, 0)};
  const std::array<Vector3d, 3> size = {Vector3d(1, 2, 1), Vector3d(1, 1, 1), Vector3d(1, 1, 1)};
  for (std::size_t p = 0; p < 3; ++p)
    for (const Vector3d& at : {Vector3d(0, 0, 0), Vector3d(1, 1, 1), Vector3d(1, 0.2, 0.3),
                               Vector3d(0.4, 0.7, 0.1), Vector3d(0, 0.9, 0.6)})
      EXPECT_LT((found.patches[p].point(at) - (low[p] + size[p].cwiseProduct(at))).norm(), 1e-14)
          << p << ": " << at.transpose();
  EXPECT_EQ(found.interfaces.size(), 1u);  // the two small bricks
  EXPECT_EQ(found.boundaries.size(), 2u);
  const MultiPatch model = connect(found, {.keep_non_matching = true});
  EXPECT_EQ(model.non_matching().size(), 2u);
  EXPECT_EQ(model.bodies().size(), 1u);
}

// The same divided face by its corners in another order: its lines run along the other direction.
TEST(MfemNcPatchMesh, DividedFacesMayBeStatedAlongEitherDirection) {
  const std::string turned = replaced(replaced(numbered(), "8 1 0 1 2 6 5", "8 0 1 1 5 6 2"),  //
                                      "9 1 1 1 2 6 5", "9 1 1 1 5 6 2");
  const PatchSet expected = read_mfem_mesh(numbered(), "a.mesh"), found = read_mfem_mesh(turned, "a.mesh");
  ASSERT_EQ(found.patches.size(), expected.patches.size());
  for (std::size_t p = 0; p < found.patches.size(); ++p)
    EXPECT_TRUE(same_bits(found.patches[p], expected.patches[p])) << p;
}

TEST(MfemNcPatchMesh, ErrorsNameFileLineAndCause) {
  ASSERT_EQ(error_of([] { read_mfem_mesh(numbered(), "a.mesh"); }), "no error");
  const std::vector<std::array<std::string, 3>> cases = {
      {"mesh v1.0", "mesh v1.1", "version 'v1.1'; v1.0 of NC-patch meshes is supported"},
      {"0 1 5 0  0 1 2 3", "0 1 5 3  0 1 2 3", "elements (patches) that are divided into others"},
      {"8 1 0 1 2 6 5", "8 1 0 1 2 6 99", "16 vertices, but vertex 99 is named"},
      {"8 1 0 1 2 6 5", "8 3 0 1 2 6 5", "vertex 8 lies behind the last knot span"},
      {"9 1 1 1 2 6 5", "9 1 0 1 2 6 5", "vertex 9 lies where another one does"},
      {"9 1 1 1 2 6 5", "9 2 1 1 2 6 5", "that are no grid"},
      {"8 1 0 1 2 6 5", "8 1 0 1 6 2 5", "that are no grid"},
      {"8 1 0 1 2 6 5", "8 1 0 0 2 6 5", "the edge 0 2 of a divided face is not listed"},
      {"9 1 1 1 2 6 5", "15 1 1 1 2 6 5",
       "a divided face meets no face of a patch with the vertices 1, 8, 5 and 15"},
      {"8 11 12 2  9 14 15 6", "8 11 12 2  14 9 15 6",
       "vertices of a face in another order than its neighbour"},
      {"0 1 2 3  4 5 6 7", "8 11 3 0  9 14 7 4", "patch 2 has a face that two other patches share"},
      {"coordinates\n16\n3", "coordinates\n16\n2", "vertices must have three coordinates"},
      {"coordinates\n", "vertex_parents\n", "divided after they had been made"},
      {"2 3  0 0 0 1 1 1\n\nspacing", "2 4  0 0 0 0.5 1 1 1\n\nspacing",
       "has a side with other numbers of coefficients"}};
  for (const auto& [from, to, message] : cases)
    EXPECT_THAT(error_of([&] { read_mfem_mesh(replaced(numbered(), from, to), "a.mesh"); }),
                HasSubstr(message))
        << from;
}

}  // namespace
}  // namespace isopatch::geometry
