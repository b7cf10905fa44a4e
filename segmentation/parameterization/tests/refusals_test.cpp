#include <gtest/gtest.h>

#include <filesystem>

#include "geometry/base/atomic_file.hpp"
#include "geometry/brep/make_brep.hpp"
#include "geometry/brep/solid_error.hpp"
#include "segmentation/parameterization/assemble_model.hpp"
#include "segmentation/parameterization/read_blocks.hpp"
#include "segmentation/parameterization/tests/checks.hpp"
#include "segmentation/parameterization/tests/step_text.hpp"

namespace isopatch::segmentation {
namespace {

using test::ThrowsError;

/// Reads blocks from a file that is written for the purpose.
auto blocks_of(const std::string& name, const std::string& text) {
  return [=] {
    const auto path = std::filesystem::temp_directory_path() / (name + ".step");
    write_file(path, text);
    read_blocks({.files = {path}});
  };
}

TEST(Refusals, AWholeCylinderIsClosedOnItself) {
  EXPECT_THAT(
      blocks_of("shaft", test::step_cylinder(5, 20)),
      ThrowsError(ErrorCode::unsupported,
                  {"solid 'part', face 0 (cylinder) is closed on itself",
                   "along the edge from (5, 0, 0) mm to (5, 0, 20) mm", "cut the solid along its axis",
                   "2 vertices, 3 edges and 3 faces", "isopatch segment cuts solids"}));
  try {
    blocks_of("shaft", test::step_cylinder(5, 20))();
  } catch (const geometry::SolidError& error) {
    ASSERT_EQ(error.fault().faces.size(), 1u);
    EXPECT_EQ(error.fault().edges.size(), 1u);
  }
}

TEST(Refusals, AFaceWithTwoCornersSaysHowToCut) {
  EXPECT_THAT(
      blocks_of("half", test::step_half_cylinder(5, 20)),
      ThrowsError(ErrorCode::unsupported, {"solid 'part', face 2 has 2 corners (vertices", "Cut the solid"}));
}

TEST(Refusals, AHoleIsToBeCutThroughFirst) {
  EXPECT_THAT(blocks_of("ring", test::step_square_ring()),
              ThrowsError(ErrorCode::unsupported, {"solid 'part', face 0 (plane) has 1 hole (2 outlines)",
                                                   "Cut the solid through the hole first"}));
}

TEST(Refusals, ATriangleAndAPentagonAreNamedByTheirVertices) {
  geometry::Polyhedron prism;
  prism.vertices.resize(3, 6);
  prism.vertices << 0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 1, 1;
  prism.faces = {{0, 2, 1}, {3, 4, 5}, {0, 1, 4, 3}, {1, 2, 5, 4}, {2, 0, 3, 5}};
  EXPECT_THAT(
      [&] {
        hex_model({{geometry::make_brep(prism), "prism"}});
      },
      ThrowsError(ErrorCode::unsupported,
                  {"face 0 has 3 corners (vertices ", "makes three faces with four edges"}));
}

}  // namespace
}  // namespace isopatch::segmentation
