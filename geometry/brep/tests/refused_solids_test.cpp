#include <gtest/gtest.h>

#include <filesystem>
#include <string>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/brep/edge_angles.hpp"
#include "geometry/brep/make_brep.hpp"
#include "geometry/brep/read_brep.hpp"
#include "geometry/brep/solid_on_carriers.hpp"
#include "geometry/brep/tests/made_solids.hpp"
#include "geometry/io/write_gismo_solid.hpp"
#include "geometry/topology/tests/sample_solids.hpp"

namespace isopatch::geometry {
namespace {

TEST(MakeBrep, OutlinesThatCrossThemselvesAreRefusedWithThePlace) {
  Polyhedron bow = test::block(2, 2, 1);  // the corners 1 and 3 of both floors exchanged
  bow.faces[0] = {0, 3, 2, 1};
  bow.faces[1] = {4, 5, 6, 7};
  EXPECT_ERROR(make_brep(bow), ErrorCode::invalid_argument,
               "the outline of face 0 with the vertices 0, 3, 2, 1 crosses itself at (1, 1, 0) m");
}

TEST(BrepOptions, OutOfRangeIsNamed) {
  const Brep block = make_brep(test::block(1, 1, 1));
  EXPECT_ERROR(tessellate(block, {.chord = 0}), ErrorCode::invalid_argument, "chord is 0; it must lie in");
  EXPECT_ERROR(tessellate(block, {.chord = std::nan("")}), ErrorCode::invalid_argument, "chord is nan");
  EXPECT_ERROR(tessellate(block, {.turn = Angle::degrees(91)}), ErrorCode::invalid_argument,
               "turn is 91 degrees; it must lie in (0, 90]");
  EXPECT_ERROR(edge_angles(block, EdgeId(0), {.samples = 4}), ErrorCode::invalid_argument,
               "samples is 4; at least 5");
  EXPECT_ERROR(edge_angles(block, EdgeId(0), {.flat = Angle::degrees(45)}), ErrorCode::invalid_argument,
               "flat is 45 degrees; it must lie in (0, 45)");
  EXPECT_ERROR(read_brep("absent.off", {.length_unit = -1}), ErrorCode::invalid_argument,
               "length_unit is -1; it must be positive");
}

TEST(ReadOneBrep, SeveralBodiesAreNamed) {
  EXPECT_ERROR(read_brep(test::made_solid("named")), ErrorCode::unsupported, "2 solids (0 plate, 1 pin)");
}

TEST(ReadGismoSolid, SurfacesOfSomeFacesAreNotEnough) {
  SolidBoundary half{"", test::block(1, 1, 1), {}};
  half.surfaces.resize(6);
  const auto line = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return NurbsCurve({KnotVector()},
                      (Eigen::Matrix3Xd(3, 2) << a.x(), b.x(), a.y(), b.y(), 0, 0).finished());
  };
  half.surfaces[2] = TrimmedSurface{
      "", {}, {{line({0, 0}, {1, 0}), line({1, 0}, {1, 1}), line({1, 1}, {0, 1}), line({0, 1}, {0, 0})}}};
  const std::filesystem::path path = std::filesystem::path(testing::TempDir()) / "isopatch_half_solid.xml";
  write_file(path, to_gismo_solid(half));
  EXPECT_ERROR(read_brep(path), ErrorCode::unsupported,
               "1 of 6 faces have surfaces; give them to all faces or to none");
  write_file(path, "<xml><Geometry type=\"TensorBSpline3\"/></xml>");
  EXPECT_ERROR(read_brep(path), ErrorCode::unsupported, "no Solid and no TrimSurface in the file");
  std::filesystem::remove(path);
}

TEST(CarrierSolid, BreachesAreNamed) {
  CarrierSolid plate;
  plate.vertices = Eigen::Matrix3Xd::Zero(3, 2);
  plate.edges = {{VertexId(0), VertexId(1), Eigen::Matrix3Xd::Zero(3, 33), {}}};
  plate.faces = {{"top",
                  {SurfaceKind::plane, {}, Eigen::Vector3d::UnitZ(), 0, 0, {}},
                  false,
                  {{{EdgeId(0), false}}},
                  {}}};
  CarrierSolid wrong = plate;
  wrong.edges[0].end = VertexId(2);
  EXPECT_ERROR(make_brep(wrong, 1e-9), ErrorCode::invalid_argument, "vertex 2 is none of 2");
  wrong = plate;
  wrong.edges[0].points = Eigen::Matrix3Xd::Zero(3, 64);  // one less than twice 32 and 1
  EXPECT_ERROR(make_brep(wrong, 1e-9), ErrorCode::invalid_argument, "an edge has 64 points");
  wrong = plate;
  wrong.faces[0].carrier.kind = SurfaceKind::spline;
  EXPECT_ERROR(make_brep(wrong, 1e-9), ErrorCode::invalid_argument, "face 'top' has no carrier");
  wrong = plate;
  wrong.faces[0].loops[0][0].edge = EdgeId(1);
  EXPECT_ERROR(make_brep(wrong, 1e-9), ErrorCode::invalid_argument, "edge 1 is none of 1");
}

}  // namespace
}  // namespace isopatch::geometry
