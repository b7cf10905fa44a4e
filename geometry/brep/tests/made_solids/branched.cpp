#include "geometry/brep/tests/made_solids/branched.hpp"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <TopExp_Explorer.hxx>
#include <cmath>
#include <numbers>
#include <utility>

namespace {

// All in one piece, faces that continue each other merged.
TopoDS_Shape merged(const TopoDS_Shape& shape) {
  ShapeUpgrade_UnifySameDomain unify(shape);
  unify.Build();
  return TopExp_Explorer(unify.Shape(), TopAbs_SOLID).Current();
}

TopoDS_Shape rod(const gp_Pnt& from, const gp_Dir& along, double radius, double length) {
  return BRepPrimAPI_MakeCylinder(gp_Ax2(from, along), radius, length).Shape();
}

TopoDS_Shape both(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  return merged(BRepAlgoAPI_Fuse(a, b).Shape());
}

TopoDS_Shape cut(const TopoDS_Shape& a, const TopoDS_Shape& b) {
  return merged(BRepAlgoAPI_Cut(a, b).Shape());
}

TopoDS_Shape bar() {
  return rod({0, 0, 0}, gp::DX(), 10, 60);
}

TopoDS_Shape tube() {
  return cut(bar(), rod({-1, 0, 0}, gp::DX(), 7, 62));
}

// A slot for a key with round ends, 4 deep.
TopoDS_Shape key() {
  const TopoDS_Shape middle = BRepPrimAPI_MakeBox(gp_Pnt(25, -3, 6), 12, 6, 10).Shape();
  return both(both(middle, rod({25, 0, 6}, gp::DZ(), 3, 10)), rod({37, 0, 6}, gp::DZ(), 3, 10));
}

// Turned about z, with a groove inside and four holes into it, one through the seams.
TopoDS_Shape grooved_bushing() {
  BRepBuilderAPI_MakePolygon outline;
  for (const auto& [radius, height] : {std::pair(15, 0),
                                       {30, 0},
                                       {30, 6},
                                       {22, 6},
                                       {22, 40},
                                       {15, 40},
                                       {15, 27},
                                       {17, 27},
                                       {17, 20},
                                       {15, 20}})
    outline.Add(gp_Pnt(radius, 0, height));
  outline.Close();
  TopoDS_Shape result =
      BRepPrimAPI_MakeRevol(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp::OZ()).Shape();
  for (int i = 0; i < 4; ++i) {
    const gp_Dir way(std::cos(i * std::numbers::pi / 2), std::sin(i * std::numbers::pi / 2), 0);
    result = BRepAlgoAPI_Cut(result, rod({0, 0, 23.5}, way, 2, 25)).Shape();
  }
  return merged(result);
}

}  // namespace

std::map<std::string, TopoDS_Shape> branched() {
  const TopoDS_Shape boss = rod({30, 0, 0}, gp::DZ(), 5, 20);
  return {
      {"bossed_bar", both(bar(), boss)},
      {"bossed_oblique", both(rod({0, 0, 0}, gp_Dir(2, 3, 6), 10, 60),
                              rod({60. / 7, 90. / 7, 180. / 7}, gp_Dir(3, -2, 0), 5, 20))},
      {"tapped_boss", cut(both(bar(), boss), rod({30, 0, 15}, gp::DZ(), 2, 6))},
      {"two_bosses", both(both(bar(), rod({15, 0, 0}, gp::DZ(), 4, 20)), rod({42, 0, 0}, gp::DY(), 6, 15))},
      {"cross_bored", cut(bar(), rod({30, 0, -15}, gp::DZ(), 4, 30))},
      {"beside_the_axis", cut(bar(), rod({30, 2, -15}, gp::DZ(), 3, 30))},
      {"oil_bore", cut(tube(), rod({30, 0, 0}, gp::DZ(), 3, 30))},
      {"pinned_tube", cut(tube(), rod({30, 0, -15}, gp::DZ(), 3, 30))},
      {"sunk_bar", cut(bar(), rod({30, 0, 7}, gp::DZ(), 4, 10))},
      {"keyed_bar", cut(bar(), key())},
      {"grooved_bushing", grooved_bushing()},
      {"tee", cut(both(bar(), rod({30, 0, 0}, gp::DZ(), 6, 20)),
                  both(rod({-1, 0, 0}, gp::DX(), 7, 62), rod({30, 0, 0}, gp::DZ(), 4, 22)))},
      {"bolted_cap",
       cut(cut(cut(both(bar(), rod({0, 0, 0}, gp::DX(), 25, 6)), rod({-1, 0, 0}, gp::DX(), 7, 62)),
               rod({-1, 18, 0}, gp::DX(), 2.5, 8)),
           rod({-1, 0, 18}, gp::DX(), 2.5, 8))},
      {"bolted_close",
       cut(cut(cut(cut(cut(both(rod({0, 0, 0}, gp::DX(), 25, 6), rod({-1, 0, 0}, gp::DX(), 15.5, 1)),
                           rod({-2, 0, 0}, gp::DX(), 8, 10)),
                       rod({-1, 19, 0}, gp::DX(), 2.8, 8)),
                   rod({-1, -19, 0}, gp::DX(), 2.8, 8)),
               rod({-1, 0, 19}, gp::DX(), 2.8, 8)),
           rod({-1, 0, -19}, gp::DX(), 2.8, 8))},
      {"oil_bores_at_120", cut(cut(cut(tube(), rod({30, 0, 0}, gp::DZ(), 3, 30)),
                                   rod({30, 0, 0}, gp_Dir(0, std::sqrt(0.75), -0.5), 3, 30)),
                               rod({20, 0, 0}, gp_Dir(0, -std::sqrt(0.75), -0.5), 3, 30))},
      {"boss_near_the_end", both(bar(), rod({6, 0, 0}, gp::DZ(), 5, 20))},
      {"boss_at_the_end", both(bar(), rod({5.3, 0, 0}, gp::DZ(), 5, 20))},
      {"wide_boss", both(bar(), rod({30, 0, 0}, gp::DZ(), 8, 20))},
  };
}
