#include "geometry/named_faces.hpp"

#include <gtest/gtest.h>

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/tests/test_patches.hpp"

namespace isopatch::geometry {
namespace {

TEST(NamedFaces, AreThoseOfTheBoundary) {
  const PatchFace first{PatchId(0), Side::front}, second{PatchId(1), Side::front},
      end{PatchId(1), Side::east};
  const MultiPatch model =
      connect({{test::box_between({0, 0, 0}, {1, 1, 1}), test::box_between({1, 0, 0}, {2, 1, 1})},
               {{"x_max", {end}}, {"z_min", {first, second}}},
               {}});
  EXPECT_EQ(named_faces(model, "x_max"), std::vector{end});
  EXPECT_EQ(named_faces(model, "z_min"), (std::vector{first, second}));
  EXPECT_ERROR(named_faces(model, "x_mx"), ErrorCode::invalid_argument, "did you mean 'x_max'");
}

}  // namespace
}  // namespace isopatch::geometry
