#include "segmentation/profiles/quadrangulate.hpp"

#include <gtest/gtest.h>

#include "segmentation/profiles/tests/drawing.hpp"

namespace isopatch::segmentation {
namespace {

using namespace drawings;

TEST(Quadrangulate, ProfilesVerticesComeFirst) {
  const Profile profile = l_shape();
  const Quadrangulation quads = quadrangulate(profile);
  ASSERT_GE(quads.vertices.size(), profile.vertices.size());
  for (std::size_t v = 0; v < profile.vertices.size(); ++v) EXPECT_EQ(quads.vertices[v], profile.vertices[v]);
}

}  // namespace
}  // namespace isopatch::segmentation
