#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/io/read_g2.hpp"
#include "geometry/io/tests/sample_patches.hpp"

namespace isopatch::geometry {
namespace {

using testing::HasSubstr;

PatchSet read_g2_text(const std::string& text) {
  return read_g2(text, "a.g2");
}

std::string g2_of(const NurbsVolume& patch) {
  std::string text = fmt::format("700 1 0 0\n3 {:d}\n", patch.is_rational());
  for (const KnotVector& k : patch.knots())
    text += fmt::format("{} {}\n{}\n", k.size(), k.degree() + 1, fmt::join(k.knots(), " "));
  const Eigen::Matrix4Xd h = patch.homogeneous();
  for (Eigen::Index i = 0; i < h.cols(); ++i)
    text += patch.is_rational() ? fmt::format("{} {} {} {}\n", h(0, i), h(1, i), h(2, i), h(3, i))
                                : fmt::format("{} {} {}\n", h(0, i), h(1, i), h(2, i));
  return text + "\n";
}

TEST(G2, ReadsWhatTheFormatSays) {
  // A brick 2 x 3 x 5 with four extra integers in its header, as written with a colour.
  const PatchSet found = read_g2_text(
      "700 1 0 4 255 0 0 255\n3 0\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n"
      "0 0 0 2 0 0 0 3 0 2 3 0 0 0 5 2 0 5 0 3 5 2 3 5\n");
  ASSERT_EQ(found.patches.size(), 1u);
  EXPECT_EQ(found.patches[0].point({0.5, 1, 0.2}), Eigen::Vector3d(1, 3, 1));
}

TEST(G2, RandomPatchesComeBack) {
  std::mt19937 random(2);
  for (int round = 0; round < 30; ++round) {
    const NurbsVolume a = random_patch(random);
    const NurbsVolume b = random_patch(random);
    const PatchSet found = read_g2_text(g2_of(a) + g2_of(b));
    ASSERT_EQ(found.patches.size(), 2u);
    EXPECT_EQ(found.patches[1].knots(), b.knots());
    EXPECT_EQ(found.patches[1].weights(), b.weights());
    // One multiplication and one division by the weight.
    const auto error = (found.patches[1].control_points() - b.control_points()).array().abs();
    EXPECT_TRUE((error <= 4e-16 * b.control_points().array().abs()).all());
  }
}

TEST(G2, ErrorsNameFileLineAndCause) {
  const std::string good = g2_of(NurbsVolume());
  ASSERT_EQ(error_of([&] { read_g2_text(good); }), "no error");
  const std::vector<std::array<std::string, 3>> cases = {
      {"700", "200",
       "unsupported: a.g2:1: object of type 200 (SplineSurface); the solver needs volumes: type 700"},
      {"700", "777", "unsupported: a.g2:1: object of type 777 (unknown to this version)"},
      {"3 0\n", "2 0\n", "unsupported: a.g2:2: patch 0 has control points in 2 dimensions"},
      {"3 0\n", "3 2\n", "bad_format: a.g2:2: the rational flag of patch 0 is '2', outside 0 .. 1"},
      {"2 2\n", "99999999 2\n", "bad_format: a.g2:3: 100000001 knots of patch 0, direction 0 are announced"},
      {"2 2\n", "2 22\n",
       "bad_format: a.g2:3: the order (degree + 1) of patch 0, direction 0 is '22', outside 2 .. 21"},
      {"0 0 1 1\n2", "0 1 0 1\n2",
       "bad_format: a.g2:3: patch 0, direction 0: knot vector: knot 2 (0) is smaller"},
      {"1 1 1\n", "1 1 inf\n", "bad_format: a.g2:16: a coefficient of patch 0 is 'inf'; it must be finite"},
      {"1 1 1\n", "1 1\n", "bad_format: a.g2:18: the data end where a coefficient of patch 0 is expected"},
      {"1 1 1\n", "1 1 1 x\n",
       "bad_format: a.g2:16: 'x' is not an integer, where an object's type is expected"},
      {"3 0\n", "3 1\n", "bad_format: a.g2:8: 8 control points of patch 0 are announced"},
  };
  for (const auto& [from, to, says] : cases)
    EXPECT_THAT(error_of([&, f = from, t = to] { read_g2_text(replaced(good, f, t)); }), HasSubstr(says));
  EXPECT_THAT(error_of([] { read_g2_text(" \n"); }), HasSubstr("the file is empty"));
}

TEST(G2, RefusesWeightsThatAreNotPositive) {
  const std::string text =
      "700 1 0 0\n3 1\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n2 2\n0 0 1 1\n"
      "0 0 0 0\n 1 0 0 1\n 0 1 0 1\n 1 1 0 1\n 0 0 1 1\n 1 0 1 1\n 0 1 1 1\n 1 1 1 1\n";
  EXPECT_THAT(error_of([&] { read_g2_text(text); }),
              HasSubstr("bad_format: a.g2:9: weight 0 of patch 0 is 0"));
  EXPECT_THAT(error_of([&] { read_g2_text(replaced(text, "0 0 0 0", "0 0 0 -1")); }),
              HasSubstr("weight 0 of patch 0 is -1"));
}

}  // namespace
}  // namespace isopatch::geometry
