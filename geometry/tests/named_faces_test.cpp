#include "geometry/named_faces.hpp"

#include <gtest/gtest.h>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/models/box.hpp"

namespace isopatch::geometry {
namespace {

TEST(NamedFaces, AreThoseOfTheBoundary) {
  const MultiPatch model = connect(box_model({.size = {2, 1, 1}, .patches = {2, 1, 1}}));
  EXPECT_EQ(named_faces(model, "x_max"), (std::vector<PatchFace>{{PatchId(1), Side::east}}));
  EXPECT_EQ(named_faces(model, "z_min").size(), 2u);
  EXPECT_ERROR(named_faces(model, "x_mx"), ErrorCode::invalid_argument, "did you mean 'x_max'");
}

}  // namespace
}  // namespace isopatch::geometry
