#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <numbers>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/error.hpp"
#include "geometry/brep/read_brep.hpp"

namespace isopatch::geometry {
namespace {

namespace fs = std::filesystem;
using testing::AllOf;
using testing::HasSubstr;

constexpr std::string_view head = R"(ISO-10303-21;
HEADER;
FILE_DESCRIPTION((''),'2;1');
FILE_NAME('','',(''),(''),'','','');
FILE_SCHEMA(('AUTOMOTIVE_DESIGN { 1 0 10303 214 1 1 1 1 }'));
ENDSEC;
DATA;
#1=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));
#2=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));
#3=(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNIT_ASSIGNED_CONTEXT((#1,#2))REPRESENTATION_CONTEXT('',''));
#4=APPLICATION_CONTEXT('');
#5=PRODUCT_CONTEXT('',#4,'mechanical');
#6=PRODUCT('ball','ball','',(#5));
#7=PRODUCT_DEFINITION_FORMATION('','',#6);
#8=PRODUCT_DEFINITION_CONTEXT('part definition',#4,'design');
#9=PRODUCT_DEFINITION('design','',#7,#8);
#10=PRODUCT_DEFINITION_SHAPE('','',#9);
#11=SHAPE_DEFINITION_REPRESENTATION(#10,#12);
#12=ADVANCED_BREP_SHAPE_REPRESENTATION('',(#13),#3);
#13=MANIFOLD_SOLID_BREP('',#14);
#14=CLOSED_SHELL('',(#15,#16));
#20=CARTESIAN_POINT('',(0.,0.,0.));
#21=DIRECTION('',(0.,0.,1.));
#22=DIRECTION('',(1.,0.,0.));
#23=DIRECTION('',(-1.,0.,0.));
#24=AXIS2_PLACEMENT_3D('',#20,#21,#22);
#25=SPHERICAL_SURFACE('',#24,5.);
#26=CARTESIAN_POINT('',(3.,0.,0.));
#27=AXIS2_PLACEMENT_3D('',#26,#22,#21);
#28=CIRCLE('',#27,4.);
#29=CARTESIAN_POINT('',(3.,0.,4.));
#30=VERTEX_POINT('',#29);
#31=EDGE_CURVE('',#30,#30,#28,.T.);
#32=ORIENTED_EDGE('',*,*,#31,.T.);
#33=ORIENTED_EDGE('',*,*,#31,.F.);
#34=EDGE_LOOP('',(#32));
#35=EDGE_LOOP('',(#33));
#36=FACE_BOUND('',#34,.T.);
#37=FACE_BOUND('',#35,.T.);
#38=AXIS2_PLACEMENT_3D('',#26,#23,#21);
)";

/// A ball of radius 5 cut at x = 3 by a circle that goes around neither pole of its surface.
/// @param faces  #15, of the sphere, and #16, of the plane
fs::path cut_ball(const std::string& name, const std::string& faces) {
  const fs::path path = fs::path(testing::TempDir()) / name;
  write_file(path, std::string(head) + faces + "ENDSEC;\nEND-ISO-10303-21;\n");
  return path;
}

TEST(FaceSides, ACapOfABallIsReadAsItIs) {
  const fs::path path =
      cut_ball("isopatch_cap.step",
               "#39=PLANE('',#38);\n"
               "#15=ADVANCED_FACE('',(#36),#25,.T.);\n#16=ADVANCED_FACE('',(#37),#39,.T.);\n");
  const double volume = std::numbers::pi * 4 / 3 * 13;  // h^2 (3 r - h) pi / 3 with h = 2
  EXPECT_NEAR(read_brep(path).brep.volume(), 1e-9 * volume, 1e-15 * volume);
  fs::remove(path);
}

TEST(FaceSides, ABallWithoutACapIsRefusedSinceTheLibraryTakesTheCap) {
  const fs::path path =
      cut_ball("isopatch_ball.step",
               "#39=PLANE('',#27);\n"
               "#15=ADVANCED_FACE('',(#37),#25,.T.);\n#16=ADVANCED_FACE('',(#36),#39,.T.);\n");
  try {
    read_brep(path);
    FAIL() << "a volume of " << read_brep(path).brep.volume();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_format);
    EXPECT_THAT(error.what(), AllOf(HasSubstr("#15 = ADVANCED_FACE of 'ball'"), HasSubstr("other side")));
  }
  fs::remove(path);
}

}  // namespace
}  // namespace isopatch::geometry
