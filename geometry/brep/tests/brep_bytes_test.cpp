#include "geometry/brep/brep_bytes.hpp"

#include <gtest/gtest.h>

#include "geometry/base/error.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/brep/brep_graph.hpp"
#include "geometry/brep/make_brep.hpp"
#include "geometry/topology/tests/sample_solids.hpp"

namespace isopatch::geometry {
namespace {

std::vector<BrepFile> sample_bodies() {
  return {{make_brep(test::l_shape()), "bracket", 0}, {make_brep(test::prism(5)), "nut\n#2", 1.0 / 3}};
}

TEST(BrepBytes, BodiesComeBackBitForBit) {
  const std::vector<BrepFile> given = sample_bodies();
  const std::vector<BrepFile> back = bodies_from_bytes(to_bytes(given));
  ASSERT_EQ(back.size(), 2u);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(back[i].name, given[i].name);
    EXPECT_EQ(back[i].largest_correction, given[i].largest_correction);
    const Brep &a = given[i].brep, &b = back[i].brep;
    EXPECT_EQ(a.vertices(), b.vertices());
    ASSERT_EQ(a.faces().size(), b.faces().size());
    ASSERT_EQ(a.edges().size(), b.edges().size());
    EXPECT_EQ(a.volume(), b.volume());
    for (std::size_t f = 0; f < a.faces().size(); ++f) {
      EXPECT_EQ(a.faces()[f].loops, b.faces()[f].loops);
      EXPECT_EQ(a.area(FaceId(static_cast<int>(f))), b.area(FaceId(static_cast<int>(f))));
    }
  }
}

TEST(BrepBytes, NoBodiesAreBytesToo) {
  EXPECT_TRUE(bodies_from_bytes(to_bytes({})).empty());
}

TEST(BrepBytes, BytesThatHaveChangedNeverReachTheLibrary) {
  const std::string bytes = to_bytes(sample_bodies());
  for (const std::size_t at : {std::size_t(3), bytes.size() / 2, bytes.size() - 1}) {
    std::string changed = bytes;
    changed[at] = static_cast<char>(changed[at] ^ 1);
    EXPECT_ERROR(bodies_from_bytes(changed), ErrorCode::bad_format, "hold no solids");
  }
  EXPECT_ERROR(bodies_from_bytes(bytes.substr(0, bytes.size() / 2)), ErrorCode::bad_format, "hold no solids");
  EXPECT_ERROR(bodies_from_bytes(""), ErrorCode::bad_format, "hold no solids");
}

}  // namespace
}  // namespace isopatch::geometry
