#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "geometry/base/error.hpp"
#include "geometry/io/read_gismo_solid.hpp"
#include "geometry/io/read_off.hpp"
#include "geometry/io/tests/sample_patches.hpp"
#include "geometry/io/write_gismo_solid.hpp"

namespace isopatch::geometry {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

const std::string tetrahedron = R"(OFF
# a tetrahedron
4 4 6
0 0 0
1 0 0
0 1 0
0 0 1e0
3 0 2 1
3 0 1 3 255 0 0
3 1 2 3
3 2 0 3
)";

TEST(Off, PointsAndPolygonsAreRead) {
  const Polyhedron read = read_off(tetrahedron, "t.off");
  ASSERT_EQ(read.vertices.cols(), 4);
  EXPECT_EQ(read.vertices.col(3), Eigen::Vector3d(0, 0, 1));
  ASSERT_EQ(read.faces.size(), 4u);
  EXPECT_THAT(read.faces[1], ElementsAre(0, 1, 3));
}

TEST(Off, WriteReadKeepsEveryBit) {
  Polyhedron given = read_off(tetrahedron, "t.off");
  given.vertices.col(1) << 1.0 / 3, -1e-17, 1e300;
  const Polyhedron again = read_off(to_off(given), "again.off");
  EXPECT_EQ(again.vertices, given.vertices);
  EXPECT_EQ(again.faces, given.faces);
}

TEST(Off, BreachesNameTheLine) {
  const auto refusal = [](const std::string& text) { return error_of([&] { read_off(text, "t.off"); }); };
  EXPECT_THAT(refusal(replaced(tetrahedron, "OFF", "COFF")), HasSubstr("t.off:1: 'COFF' found where 'OFF'"));
  EXPECT_THAT(refusal(replaced(tetrahedron, "3 1 2 3", "3 1 2 4")),
              HasSubstr("t.off:10: a corner of face 2 is '4'"));
  EXPECT_THAT(refusal(replaced(tetrahedron, "3 1 2 3", "2 1 2")),
              HasSubstr("t.off:10: the corners of face 2"));
  EXPECT_THAT(refusal(replaced(tetrahedron, "0 1 0", "0 x 0")), HasSubstr("t.off:6: 'x' is not a number"));
  EXPECT_THAT(refusal(replaced(tetrahedron, "4 4 6", "4 99999999 6")), HasSubstr("are announced"));
  EXPECT_THAT(refusal(tetrahedron + "5"), HasSubstr("follows the last face"));
}

/// A triangle as a trimmed surface; degree 1 but for the first curve, which is parted at its middle.
std::string trimmed(int id) {
  return "<TrimSurface id=\"" + std::to_string(id) + R"(">
<Geometry type="TensorBSpline2">
<Basis type="TensorBSplineBasis2">
<Basis type="BSplineBasis" index="0"><KnotVector degree="1">0 0 1 1</KnotVector></Basis>
<Basis type="BSplineBasis" index="1"><KnotVector degree="1">0 0 1 1</KnotVector></Basis>
</Basis>
<coefs geoDim="3">0 0 0 2 0 0 0 2 0 2 2 1</coefs>
</Geometry>
<PlanarDomain><CurveLoop index="0">
<Geometry type="BSpline"><Basis type="BSplineBasis"><KnotVector degree="1">0 0 .5 .5 1 1</KnotVector></Basis>
<coefs geoDim="2">0 0  .25 0  .25 0  1 0</coefs></Geometry>
<Geometry type="BSpline"><Basis type="BSplineBasis"><KnotVector degree="1">0 0 1 1</KnotVector></Basis>
<coefs geoDim="2">1 0 1 1</coefs></Geometry>
<Geometry type="BSpline"><Basis type="BSplineBasis"><KnotVector degree="1">0 0 1 1</KnotVector></Basis>
<coefs geoDim="2">1 1 0 0</coefs></Geometry>
</CurveLoop></PlanarDomain>
</TrimSurface>
)";
}

const std::string solid_element = R"(<Solid vertices="5" faces="5" volumes="2" id="0">
<Vertex>0 0 0  1 0 0  0 1 0  0 0 1  -1/2 0 0</Vertex>
<Face>
3 0 2 1 7
3 0 1 3 7
3 1 2 3 7
3 2 0 3 -1
3 0 3 4 -1
</Face>
<Volume>4 3 0 1 2
2 4 3</Volume>
</Solid>
)";

std::string file(const std::string& content) {
  return "<?xml version=\"1.0\"?>\n<xml>\n" + content + "</xml>\n";
}

TEST(GismoSolid, VolumesAreReadFaceByFace) {
  const auto solids = read_gismo_solids(file(trimmed(7) + solid_element), "s.xml");
  ASSERT_EQ(solids.size(), 2u);
  EXPECT_EQ(solids[1].name, "volume 1");
  ASSERT_EQ(solids[0].surfaces.size(), 4u);
  EXPECT_TRUE(solids[0].surfaces[0]);
  EXPECT_FALSE(solids[0].surfaces[3]);
  EXPECT_THAT(solids[1].corners.faces[1], ElementsAre(0, 3, 4));
  EXPECT_EQ(solids[0].corners.vertices(0, 4), -0.5);
}

TEST(GismoSolid, SurfacesAloneMakeOneSolid) {
  const auto solids = read_gismo_solids(file(trimmed(0) + trimmed(4)), "s.xml");
  ASSERT_EQ(solids.size(), 1u);
  ASSERT_EQ(solids[0].surfaces.size(), 2u);
  const TrimmedSurface& surface = *solids[0].surfaces[1];
  EXPECT_EQ(surface.surface.point({1, 1}), Eigen::Vector3d(2, 2, 1));
  ASSERT_EQ(surface.loops[0].size(), 3u);
  // The pieces of the first curve have become one.
  EXPECT_EQ(surface.loops[0][0].size(), 3);
  EXPECT_EQ(surface.loops[0][0].point(Parameter<1>(0.5)), Eigen::Vector3d(0.25, 0, 0));
  EXPECT_EQ(surface.loops[0][0].point(Parameter<1>(0.75)), Eigen::Vector3d(0.625, 0, 0));
}

TEST(GismoSolid, WriteReadKeepsEveryBit) {
  SolidBoundary given = read_gismo_solids(file(trimmed(7) + solid_element), "s.xml")[0];
  TrimmedSurface& first = *given.surfaces[0];
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(4);
  weights(2) = 1.0 / 3;
  first.surface = NurbsSurface(first.surface.knots(), first.surface.control_points(), weights);
  first.loops[0][1] =
      NurbsCurve(first.loops[0][1].knots(), first.loops[0][1].control_points(), weights.tail<2>());
  const auto again = read_gismo_solids(to_gismo_solid(given), "again.xml");
  ASSERT_EQ(again.size(), 1u);
  EXPECT_EQ(again[0].corners.vertices, given.corners.vertices);
  EXPECT_EQ(again[0].corners.faces, given.corners.faces);
  ASSERT_EQ(again[0].surfaces.size(), given.surfaces.size());
  EXPECT_FALSE(again[0].surfaces[3]);
  for (std::size_t f = 0; f < 3; ++f) {
    const TrimmedSurface &a = *given.surfaces[f], &b = *again[0].surfaces[f];
    EXPECT_EQ(a.surface.control_points(), b.surface.control_points());
    EXPECT_EQ(a.surface.weights(), b.surface.weights());
    ASSERT_EQ(a.loops.size(), b.loops.size());
    ASSERT_EQ(a.loops[0].size(), b.loops[0].size());
    for (std::size_t i = 0; i < a.loops[0].size(); ++i) {
      EXPECT_EQ(a.loops[0][i].knots(), b.loops[0][i].knots());
      EXPECT_EQ(a.loops[0][i].control_points(), b.loops[0][i].control_points());
      EXPECT_EQ(a.loops[0][i].weights(), b.loops[0][i].weights());
    }
  }
}

TEST(GismoSolid, PartedCurvesThatDoNotMeetAreRefused) {
  const std::string text = replaced(file(trimmed(0)), ".25 0  .25 0", ".25 0  .26 0");
  EXPECT_THAT(
      error_of([&] { read_gismo_solids(text, "s.xml"); }),
      AllOf(HasSubstr("bad_format"), HasSubstr("loop 0, curve 0"), HasSubstr("repeated more than degree")));
}

TEST(GismoSolid, WithoutVolumesAllFacesAreOne) {
  const std::string text = file(trimmed(7) + solid_element);
  const std::size_t from = text.find("<Volume>"), to = text.find("</Volume>") + 9;
  const auto solids = read_gismo_solids(std::string(text).erase(from, to - from), "s.xml");
  ASSERT_EQ(solids.size(), 1u);
  EXPECT_EQ(solids[0].name, "");
  EXPECT_EQ(solids[0].corners.faces.size(), 5u);
}

TEST(GismoSolid, BreachesNameFileLineAndCause) {
  const std::string good = file(trimmed(7) + solid_element);
  const auto expect = [&](const std::string& from, const std::string& to, const std::string& says) {
    EXPECT_THAT(error_of([&] { read_gismo_solids(replaced(good, from, to), "s.xml"); }), HasSubstr(says))
        << from << " -> " << to;
  };
  EXPECT_THAT(error_of([] { read_gismo_solids("<a/>", "s.xml"); }),
              HasSubstr("bad_format: s.xml:1: the root element is <a>"));
  EXPECT_THAT(error_of([] { read_gismo_solids("<xml/>", "s.xml"); }),
              HasSubstr("unsupported: s.xml:1: no Solid and no TrimSurface element"));
  EXPECT_THAT(error_of([] { read_gismo_solids(file(trimmed(3) + trimmed(3)), "s.xml"); }),
              HasSubstr("a second trimmed surface with id 3"));
  expect("3 2 0 3 -1", "2 2 0 -1", "bad_format: s.xml:26: face 3 has 2 corners; without a surface it needs");
  expect("3 0 1 3 7", "3 0 1 3 8", "face 1 lies on surface 8, which the file lacks");
  expect("3 0 1 3 7", "3 0 1 5 7", "a corner of face 1 is '5', outside 0 .. 4");
  expect("-1/2 0 0", "-1/2 0", "14 coordinates; a vertex has three");
  expect("-1/2 0 0", "-1/0 0 0", "a coordinate is '-1/0'; it must be finite");
  expect("2 4 3</Volume>", "2 4 5</Volume>", "a face of volume 1 is '5'");
  expect("<Vertex>", "<Vertices>", "broken XML");
  expect("TensorBSpline2", "TensorBSpline1", "unsupported: s.xml:4: trimmed surface 7 is of type");
  expect("geoDim=\"3\"", "geoDim=\"2\"", "control points in 2 dimensions; 3 are needed");
  expect("0 0 .5 .5 1 1", "0 0 1", "3 knots do not suit degree 1");
  expect("index=\"1\"", "index=\"0\"", "direction 0 is given twice");
  const std::string curves = good.substr(good.find("<Geometry type=\"BSpline\""));
  expect(curves.substr(0, curves.find("</CurveLoop>")), "", "trimmed surface 7, loop 0 has no curve");
  const std::string domain = good.substr(good.find("<CurveLoop"));
  expect(domain.substr(0, domain.find("</PlanarDomain>")), "", "trimmed surface 7 has no loop");
}

TEST(GismoSolid, IsToldFromVolumePatches) {
  EXPECT_TRUE(is_gismo_solid(file(solid_element)));
  EXPECT_TRUE(is_gismo_solid(file(trimmed(0))));
  EXPECT_FALSE(is_gismo_solid(file("<Geometry type=\"TensorBSpline3\"/>")));
}

TEST(GismoSolid, BreachesNameTheLine) {
  const auto refusal = [](const std::string& from, const std::string& to) {
    return error_of(
        [&] { read_gismo_solids(replaced(file(trimmed(7) + solid_element), from, to), "s.xml"); });
  };
  EXPECT_THAT(refusal("3 0 1 3 7", "3 0 1 9 7"),
              AllOf(HasSubstr("s.xml:"), HasSubstr("a corner of face 1 is '9'")));
  EXPECT_THAT(refusal("3 0 1 3 7", "3 0 1 3 8"), HasSubstr("face 1 lies on surface 8, which the file lacks"));
  EXPECT_THAT(refusal("2 4 3", "2 4 5"), HasSubstr("a face of volume 1 is '5'"));
  EXPECT_THAT(refusal("-1/2", "-1/0"), HasSubstr("must be finite"));
  EXPECT_THAT(refusal("0 0  1 0 0", "0 0  1 0"), HasSubstr("a vertex has three"));
  EXPECT_THAT(refusal("<coefs geoDim=\"3\">0", "<coefs geoDim=\"2\">0"),
              HasSubstr("in 2 dimensions; 3 are needed"));
  EXPECT_THAT(refusal("TensorBSpline2", "TensorHBSpline2"), HasSubstr("TensorNurbs2 are supported"));
  EXPECT_THAT(refusal("2 2 1</coefs>", "2 2</coefs>"), HasSubstr("trimmed surface 7"));
  EXPECT_THAT(error_of([] { read_gismo_solids(file(""), "s.xml"); }),
              HasSubstr("no Solid and no TrimSurface"));
}

}  // namespace
}  // namespace isopatch::geometry
