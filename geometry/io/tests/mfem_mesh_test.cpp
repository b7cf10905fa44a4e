#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <sstream>

#include "geometry/face_match.hpp"
#include "geometry/io/read_mfem_mesh.hpp"
#include "geometry/io/tests/sample_patches.hpp"

namespace isopatch::geometry {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

PatchSet read_mfem_text(const std::string& text) {
  return read_mfem_mesh(text, "a.mesh");
}

// Two bricks side by side in x, written by hand: control points at x 0 1 3 7 (first) and 7 8 10 (second), y 0
// 1 4 9, z 0 2. The second brick's first direction is +y, its second -x, its third +z. Vertices (numbers
// chosen so that edges run both ways and one is listed against its knot vector):
//   x = 0: 3 (y0 z0) 7 (y1 z0) 8 (y0 z1) 2 (y1 z1)
//   x = 7: 5 (y0 z0) 0 (y1 z0) 1 (y0 z1) 9 (y1 z1)
//   x = 10: 4 (y0 z0) 6 (y1 z0) 10 (y0 z1) 11 (y1 z1)
const std::string two_bricks = R"(MFEM NURBS mesh v1.0
# written by hand
dimension
3

elements
2
1 5  3 5 0 7  8 1 9 2
2 5  4 6 0 5  10 11 9 1

boundary
3
4 3  3 7 2 8
2 3  6 4 10 11
2 3  0 6 11 9

edges
20
0  3 5
0  7 0
0  8 1
0  2 9
1  3 7
1  5 0
1  8 2
1  1 9
1  4 6
1  10 11
3  5 4
3  0 6
3  1 10
3  9 11
2  3 8
2  5 1
2  7 2
2  0 9
2  4 10
2  6 11

vertices
12

knotvectors
4
2 4 0 0 0 0.3 1 1 1
2 4 0 0 0 0.6 1 1 1
1 2 0 0 1 1
2 3 0 0 0 1 1 1

unitweights

FiniteElementSpace
FiniteElementCollection: NURBS
VDim: 3
Ordering: 1

)";

struct Lattice {
  std::vector<double> x, y, z;
  Eigen::Vector3d operator()(std::size_t i, std::size_t j, std::size_t k) const { return {x[i], y[j], z[k]}; }
};

// The coefficients in MFEM's numbering, each group listed by hand.
std::string hand_numbered_points() {
  std::string text =
      "7 9 0\n7 0 2\n0 9 2\n0 0 0\n10 0 0\n7 0 0\n10 9 0\n0 9 0\n0 0 2\n7 9 2\n10 0 2\n10 9 2\n";
  // Edges run from the lower vertex: 3-5 and 8-1 differ in sense.
  text += "1 0 0\n3 0 0\n";    // 3 -> 5: x up
  text += "3 9 0\n1 9 0\n";    // 0 -> 7: x down
  text += "3 0 2\n1 0 2\n";    // 1 -> 8: x down
  text += "1 9 2\n3 9 2\n";    // 2 -> 9: x up
  text += "0 1 0\n0 4 0\n";    // 3 -> 7: y up
  text += "7 4 0\n7 1 0\n";    // 0 -> 5: y down
  text += "0 4 2\n0 1 2\n";    // 2 -> 8: y down
  text += "7 1 2\n7 4 2\n";    // 1 -> 9: y up
  text += "10 1 0\n10 4 0\n";  // 4 -> 6
  text += "10 1 2\n10 4 2\n";  // 10 -> 11
  text += "8 0 0\n8 9 0\n8 0 2\n8 9 2\n";
  // Faces: the first brick's low z, first axis from vertex 7 to 0 (x up), second from 7 to 3 (y down).
  text += "1 4 0\n3 4 0\n1 1 0\n3 1 0\n";
  // Its four lateral faces have z with two coefficients: nothing inside. Then high z, from 8 to 1 and 8 to 2.
  text += "1 1 2\n3 1 2\n1 4 2\n3 4 2\n";
  // The second brick's low z: from 5 to 0 (y up); high z: from 10 to 11 (y up).
  text += "8 1 0\n8 4 0\n8 1 2\n8 4 2\n";
  return text;
}

// Control points of a patch whose lattice index (i, j, k) lies at place(i, j, k).
template <class Place>
Eigen::Matrix3Xd points_at(const std::array<int, 3>& n, Place place) {
  Eigen::Matrix3Xd result(3, n[0] * n[1] * n[2]);
  int c = 0;
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i)
        result.col(c++) =
            place(static_cast<std::size_t>(i), static_cast<std::size_t>(j), static_cast<std::size_t>(k));
  return result;
}

void expect_two_bricks(const PatchSet& found) {
  const Lattice left{{0, 1, 3, 7}, {0, 1, 4, 9}, {0, 2}};
  const Lattice right{{7, 8, 10}, {0, 1, 4, 9}, {0, 2}};
  ASSERT_EQ(found.patches.size(), 2u);
  EXPECT_EQ(found.patches[0].control_points(), points_at({4, 4, 2}, left));
  EXPECT_EQ(found.patches[1].control_points(),
            points_at({4, 3, 2}, [&](auto i, auto j, auto k) { return right(2 - j, i, k); }));
  EXPECT_EQ(found.patches[0].knots(0).knots()[3], 0.3);
  EXPECT_EQ(found.patches[0].knots(1).knots()[3], 0.6);
  EXPECT_EQ(found.patches[1].knots(0).knots()[3], 0.6);
}

TEST(MfemMesh, ReadsTwoPatchesNumberedByHand) {
  const PatchSet found = read_mfem_text(two_bricks + hand_numbered_points());
  expect_two_bricks(found);
  ASSERT_EQ(found.boundaries.size(), 2u);
  EXPECT_EQ(found.boundaries[0].name, "attribute 2");
  EXPECT_THAT(found.boundaries[0].faces,
              ElementsAre(PatchFace{PatchId(1), Side::south}, PatchFace{PatchId(1), Side::east}));
  EXPECT_EQ(found.boundaries[1].name, "attribute 4");
  EXPECT_THAT(found.boundaries[1].faces, ElementsAre(PatchFace{PatchId(0), Side::west}));
  ASSERT_EQ(found.interfaces.size(), 1u);
  EXPECT_EQ(found.interfaces[0].first, (PatchFace{PatchId(0), Side::east}));
  EXPECT_EQ(found.interfaces[0].second, (PatchFace{PatchId(1), Side::north}));
  EXPECT_EQ(connect(found).interfaces().size(), 1u);
}

TEST(MfemMesh, KnotVectorsListedAgainstTheirPatchAreTurned) {
  std::string text = two_bricks + hand_numbered_points();
  for (const auto& [from, to] :
       {std::pair{"0  3 5", "0  5 3"}, {"0  7 0", "0  0 7"}, {"0  8 1", "0  1 8"}, {"0  2 9", "0  9 2"}})
    text = replaced(text, from, to);
  const PatchSet found = read_mfem_text(text);
  EXPECT_EQ(found.patches[0].control_points(),
            read_mfem_text(two_bricks + hand_numbered_points()).patches[0].control_points());
  EXPECT_EQ(found.patches[0].knots(0).knots()[3], 0.7);
}

// A mesh of two random lattices that share a face in a given orientation, numbered by where things are
// instead of by index arithmetic.
class TwoCubes {
 public:
  TwoCubes(unsigned seed) : random_(seed) {
    std::shuffle(vertex_.begin(), vertex_.end(), random_);
    for (auto& line : line_) {
      line = {0};
      for (int i = 0; i < 4; ++i) line.push_back(line.back() + std::uniform_int_distribution(1, 9)(random_));
    }
    // A second block follows in x with the same number of coefficients.
    for (int i = 0; i < 4; ++i)
      line_[0].push_back(line_[0].back() + std::uniform_int_distribution(1, 9)(random_));
    // Proper rotations of a cube: images of the local axes.
    const std::array<std::array<int, 3>, 6> orders = {
        {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
    for (int p = 0; p < 2; ++p) {
      const int order = std::uniform_int_distribution(0, 5)(random_);
      axis_[p] = orders[static_cast<std::size_t>(order)];
      flip_[p] = {static_cast<bool>(random_() % 2), static_cast<bool>(random_() % 2), false};
      flip_[p][2] = flip_[p][0] ^ flip_[p][1] ^ (order > 2);
    }
  }

  // Where the local index (i, j, k) of a patch lies.
  Eigen::Vector3d place(int patch, std::array<int, 3> local) const {
    Eigen::Vector3d x;
    for (std::size_t d = 0; d < 3; ++d) {
      const auto a = static_cast<std::size_t>(axis_[patch][d]);
      int index = flip_[patch][d] ? 4 - local[d] : local[d];
      if (a == 0) index += 4 * patch;
      x[static_cast<int>(a)] = line_[a][static_cast<std::size_t>(index)];
    }
    return x;
  }

  Eigen::Matrix3Xd points(int patch) const {
    return points_at({5, 5, 5}, [&](auto i, auto j, auto k) {
      return place(patch, {static_cast<int>(i), static_cast<int>(j), static_cast<int>(k)});
    });
  }

  std::string text() {
    std::string elements = "elements\n2\n";
    for (int p = 0; p < 2; ++p) {
      elements += "1 5";
      for (const auto& c : hex) elements += fmt::format(" {}", vertex(p, c));
      elements += "\n";
    }
    std::map<std::pair<int, int>, std::pair<Eigen::Vector3d, Eigen::Vector3d>> edges;
    std::map<int, Eigen::Vector3d> corners;
    for (int p = 0; p < 2; ++p)
      for (std::size_t a = 0; a < 8; ++a)
        for (std::size_t b = 0; b < 8; ++b) {
          corners[vertex(p, hex[a])] = corner(p, hex[a]);
          const int differ = (hex[a][0] != hex[b][0]) + (hex[a][1] != hex[b][1]) + (hex[a][2] != hex[b][2]);
          if (differ == 1 && vertex(p, hex[a]) < vertex(p, hex[b]))
            edges[{vertex(p, hex[a]), vertex(p, hex[b])}] = {corner(p, hex[a]), corner(p, hex[b])};
        }
    std::vector<std::pair<int, int>> order;
    for (const auto& entry : edges) order.push_back(entry.first);
    std::shuffle(order.begin(), order.end(), random_);
    std::string edge_text = fmt::format("edges\n{}\n", order.size());
    std::string coefficients;
    for (const auto& [v, x] : corners) coefficients += line_of(x);
    for (const auto& e : order) {
      edge_text += random_() % 2 ? fmt::format("0 {} {}\n", e.first, e.second)
                                 : fmt::format("0 {} {}\n", e.second, e.first);
      for (int i = 1; i < 4; ++i) coefficients += line_of(on_lattice(edges[e].first, {{edges[e].second, i}}));
    }
    coefficients += faces() + insides();
    return "MFEM NURBS mesh v1.0\ndimension\n3\n" + elements + "boundary\n0\n" + edge_text +
           "vertices\n12\nknotvectors\n1\n2 5 0 0 0 1 3 4 4 4\nunitweights\nFiniteElementSpace\n"
           "FiniteElementCollection: NURBS2\nVDim: 3\nOrdering: 1\n\n" +
           coefficients;
  }

 private:
  using Corner = std::array<int, 3>;
  inline static const std::array<Corner, 8> hex = {
      {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};

  static std::string line_of(const Eigen::Vector3d& x) { return fmt::format("{} {} {}\n", x[0], x[1], x[2]); }
  Eigen::Vector3d corner(int p, const Corner& c) const { return place(p, {4 * c[0], 4 * c[1], 4 * c[2]}); }
  int vertex(int p, const Corner& c) const {
    const Eigen::Vector3d x = corner(p, c);
    const int ix = x[0] == line_[0][0] ? 0 : x[0] == line_[0][4] ? 1 : 2;
    return vertex_[static_cast<std::size_t>(ix + 3 * (x[1] > 0) + 6 * (x[2] > 0))];
  }
  std::size_t index(std::size_t axis, double x) const {
    return static_cast<std::size_t>(std::find(line_[axis].begin(), line_[axis].end(), x) -
                                    line_[axis].begin());
  }
  // From a corner, so many steps towards each of the others.
  Eigen::Vector3d on_lattice(const Eigen::Vector3d& from,
                             const std::vector<std::pair<Eigen::Vector3d, int>>& steps) const {
    Eigen::Vector3d x = from;
    for (const auto& [to, count] : steps)
      for (std::size_t a = 0; a < 3; ++a) {
        const auto d = static_cast<int>(a);
        if (to[d] == from[d]) continue;
        const std::size_t begin = index(a, from[d]);
        x[d] = line_[a][to[d] > from[d] ? begin + static_cast<std::size_t>(count)
                                        : begin - static_cast<std::size_t>(count)];
      }
    return x;
  }
  std::string faces() const {
    constexpr std::array<std::array<std::size_t, 4>, 6> quads = {
        {{3, 2, 1, 0}, {0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {4, 5, 6, 7}}};
    std::string result;
    std::set<std::set<int>> seen;
    for (int p = 0; p < 2; ++p)
      for (const auto& q : quads) {
        std::set<int> key;
        for (const std::size_t v : q) key.insert(vertex(p, hex[v]));
        if (!seen.insert(key).second) continue;
        for (int b = 1; b < 4; ++b)
          for (int a = 1; a < 4; ++a)
            result += line_of(
                on_lattice(corner(p, hex[q[0]]), {{corner(p, hex[q[1]]), a}, {corner(p, hex[q[3]]), b}}));
      }
    return result;
  }
  std::string insides() const {
    std::string result;
    for (int p = 0; p < 2; ++p)
      for (int k = 1; k < 4; ++k)
        for (int j = 1; j < 4; ++j)
          for (int i = 1; i < 4; ++i) result += line_of(place(p, {i, j, k}));
    return result;
  }

  std::mt19937 random_;
  std::array<int, 12> vertex_ = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11};
  std::array<std::vector<double>, 3> line_;
  std::array<std::array<int, 3>, 2> axis_;
  std::array<std::array<bool, 3>, 2> flip_;
};

TEST(MfemMesh, NumberingFollowsEveryOrientationOfNeighbours) {
  for (unsigned seed = 0; seed < 300; ++seed) {
    TwoCubes cubes(seed);
    const PatchSet found = read_mfem_text(cubes.text());
    ASSERT_EQ(found.patches.size(), 2u);
    for (int p = 0; p < 2; ++p)
      ASSERT_EQ(found.patches[static_cast<std::size_t>(p)].control_points(), cubes.points(p)) << seed;
    ASSERT_EQ(found.interfaces.size(), 1u);
    const auto corner = [&](const PatchFace& face, const Parameter<2>& at) -> Eigen::Vector3d {
      const NurbsSurface surface =
          face_surface(found.patches[static_cast<std::size_t>(face.patch.value)], face.side);
      return surface.point(unscaled(surface, at));
    };
    const StatedInterface& stated = found.interfaces[0];
    for (const auto& at : {Parameter<2>(0, 0), Parameter<2>(1, 0), Parameter<2>(0, 1)})
      ASSERT_EQ(corner(stated.first, at), corner(stated.second, stated.orientation(at))) << seed;
  }
}

TEST(MfemMesh, ReadsCoefficientsPatchByPatchAndAxisByAxis) {
  const PatchSet numbered = read_mfem_text(two_bricks + hand_numbered_points());
  std::string by_patch = "NURBS_patches\n";
  for (std::size_t p = 0; p < 2; ++p) {
    by_patch += fmt::format("\n# patch {}\n\n", p);
    for (const auto& x : numbered.patches[p].control_points().colwise())
      by_patch += fmt::format("{} {} {}\n", x[0], x[1], x[2]);
  }
  expect_two_bricks(read_mfem_text(two_bricks + by_patch));
  std::istringstream points(hand_numbered_points());
  std::array<std::string, 3> axes;
  std::string word;
  for (std::size_t n = 0; points >> word; ++n) axes[n % 3] += word + "\n";
  expect_two_bricks(
      read_mfem_text(replaced(two_bricks, "Ordering: 1", "Ordering: 0") + axes[0] + axes[1] + axes[2]));
}

std::string with_own_patches(const std::vector<NurbsVolume>& patches, const std::string& kind) {
  std::string text = two_bricks.substr(0, two_bricks.find("edges")) + "edges\n0\n\nvertices\n12\n\npatches\n";
  for (const NurbsVolume& patch : patches) {
    text += "\nknotvectors\n3\n";
    for (const KnotVector& k : patch.knots())
      text += fmt::format("{} {} {}\n", k.degree(), k.size(), fmt::join(k.knots(), " "));
    text += "dimension\n3\n" + kind + "\n";
    Eigen::Matrix4Xd h = patch.homogeneous();
    if (kind == "controlpoints_cartesian") h.topRows<3>() = patch.control_points();
    for (Eigen::Index i = 0; i < h.cols(); ++i)
      text += fmt::format("{} {} {} {}\n", h(0, i), h(1, i), h(2, i), h(3, i));
  }
  return text;
}

TEST(MfemMesh, ReadsPatchesWithTheirOwnControlPoints) {
  std::mt19937 random(5);
  const std::vector<NurbsVolume> patches = {random_patch(random), random_patch(random)};
  const PatchSet cartesian = read_mfem_text(with_own_patches(patches, "controlpoints_cartesian"));
  ASSERT_EQ(cartesian.patches.size(), 2u);
  for (std::size_t p = 0; p < 2; ++p) EXPECT_TRUE(same_bits(cartesian.patches[p], patches[p]));
  for (const char* kind : {"controlpoints", "controlpoints_homogeneous"})
    EXPECT_LT((read_mfem_text(with_own_patches(patches, kind)).patches[1].control_points() -
               patches[1].control_points())
                  .norm(),
              1e-15 * patches[1].control_points().norm());
  EXPECT_EQ(cartesian.boundaries.size(), 2u);
}

TEST(MfemMesh, ReadsWeights) {
  std::string weights = "weights\n";
  for (int i = 0; i < 48; ++i) weights += fmt::format("{}\n", 1 + i);
  const PatchSet found =
      read_mfem_text(replaced(two_bricks, "unitweights", weights) + hand_numbered_points());
  expect_two_bricks(found);
  // Vertex 3 is the first corner of patch 0, vertex 4 of patch 1, vertex 9 the last but one corner of both.
  EXPECT_EQ(found.patches[0].weights()[0], 4);
  EXPECT_EQ(found.patches[1].weights()[0], 5);
  EXPECT_EQ(found.patches[0].weights()[31], 10);
}

// What version 1.1 says about later refinements changes no patch.
TEST(MfemMesh, ReadsVersionsWithSpacing) {
  for (const char* spacing : {"spacing\n0\n", "spacing\n2\n0 1 0 2 0.5 0.25\n# the other\n3 2 3 0 7 8 9\n",
                              "refinements\n1 2 3\nknotvector_refinements\n1 2\n2 2 3\n0\n1 4\nspacing\n0\n"})
    expect_two_bricks(read_mfem_text(
        replaced(replaced(two_bricks, "v1.0", "v1.1"), "unitweights", spacing + std::string("unitweights")) +
        hand_numbered_points()));
  EXPECT_THAT(error_of([] {
                read_mfem_text(
                    replaced(replaced(two_bricks, "v1.0", "v1.1"), "unitweights", "spacing\n1\n4 1 0 0\n"));
              }),
              HasSubstr("the knot vector of a spacing formula is '4', outside 0 .. 3"));
}

TEST(MfemMesh, ErrorsNameFileLineAndCause) {
  const std::string good = two_bricks + hand_numbered_points();
  ASSERT_EQ(error_of([&] { read_mfem_text(good); }), "no error");
  const std::vector<std::array<std::string, 3>> cases = {
      {"v1.0", "v2.0", "unsupported: a.mesh:1: version 'v2.0'; v1.0 and v1.1 are supported"},
      {"v1.0", "v1.1", "bad_format: a.mesh:50: 'unitweights' found where 'spacing' is expected"},
      {"dimension\n3", "dimension\n2",
       "unsupported: a.mesh:4: a mesh of dimension 2; volumes (dimension 3) are needed"},
      {"1 5  3", "1 3  3", "unsupported: a.mesh:8: geometry type 3; 5 (cube) is supported here"},
      {"elements\n2", "elements\n999999999",
       "bad_format: a.mesh:7: the number of elements (patches) is '999999999', outside 1 .. 10000"},
      {"4 6 0 5", "4 6 0 1", "unsupported: a.mesh:7: elements: patch 1 has a vertex twice"},
      {"3 5 0 7", "3 5 0 12", "bad_format: a.mesh:41: 12 vertices, but an element has vertex 12"},
      {"vertices\n12", "vertices\n13", "bad_format: a.mesh:41: vertex 12 belongs to no element"},
      {"4 3  3 7 2 8", "4 3  5 0 9 1",
       "unsupported: a.mesh:13: this boundary element lies between two patches"},
      {"4 3  3 7 2 8", "4 3  3 7 2 9", "bad_format: a.mesh:13: this boundary element is no face of a patch"},
      {"0  3 5\n", "0  3 4\n", "bad_format: a.mesh:17: edges: patch 0 has edge 3 5, which is not listed"},
      {"0  3 5\n", "0  7 0\n", "bad_format: a.mesh:17: edges: edge 7 0 is listed twice"},
      {"0  3 5\n", "4  3 5\n", "bad_format: a.mesh:17: edges: edge 3 5 has knot vector 4, but there are 4"},
      {"0  3 5\n", "1  3 5\n",
       "bad_format: a.mesh:17: edges: patch 0, direction 0: its edges have different knot vectors"},
      {"2 4 0 0 0 0.3", "2 999999999 0 0 0 0.3",
       "bad_format: a.mesh:45: the number of control points of knot vector 0 is '999999999'"},
      {"2 4 0 0 0 0.3", "2 4 0 0 0 -0.3",
       "bad_format: a.mesh:45: knot vector 0: knot vector: knot 3 (-0.3) is smaller than"},
      {"unitweights", "mesh_elements",
       "unsupported: a.mesh:50: 'mesh_elements' found where 'weights' is expected"},
      {"unitweights", "weights", "bad_format: a.mesh:50: 48 coefficients are announced"},
      {"VDim: 3", "VDim: 2", "unsupported: a.mesh:54: VDim must be 3"},
      {"7 9 0\n", "7 9 nan\n", "bad_format: a.mesh:57: a coordinate is 'nan'; it must be finite"},
      {"7 9 0\n", "7 9 0 0\n", "bad_format: a.mesh:104: '2' follows the last control point"},
      {"8 4 2\n", "8 4", "bad_format: a.mesh:104: the data end where a coordinate is expected"},
  };
  for (const auto& [from, to, says] : cases) {
    std::string text = good;
    if (from == "8 4 2\n")
      text.resize(text.size() - 2);
    else
      text = replaced(text, from, to);
    EXPECT_THAT(error_of([&] { read_mfem_text(text); }), HasSubstr(says)) << from << " -> " << to;
  }
}

}  // namespace
}  // namespace isopatch::geometry
