#include "geometry/brep/tests/made_solids/drilled.hpp"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Fuse.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <cmath>
#include <numbers>
#include <vector>

namespace {

struct Drill {
  gp_Pnt from;
  gp_Dir along;
  double radius, length;
};

// A block of 60 x 40 x 40.
TopoDS_Shape block_with(const std::vector<Drill>& drills) {
  TopoDS_Shape result = BRepPrimAPI_MakeBox(60, 40, 40).Shape();
  for (const Drill& drill : drills)
    result =
        BRepAlgoAPI_Cut(
            result,
            BRepPrimAPI_MakeCylinder(gp_Ax2(drill.from, drill.along), drill.radius, drill.length).Shape())
            .Shape();
  return result;
}

// Likewise, with a tip of 118 degrees at the end of the first.
TopoDS_Shape block_with_tip(const std::vector<Drill>& drills) {
  const Drill& first = drills.front();
  const gp_Ax2 end(first.from.Translated(gp_Vec(first.along) * first.length), first.along);
  const double depth = first.radius / std::tan(59 * std::numbers::pi / 180);
  return BRepAlgoAPI_Cut(block_with(drills), BRepPrimAPI_MakeCone(end, first.radius, 0, depth).Shape())
      .Shape();
}

// A vee of 90 degrees with its relief and a slot along each side, two bores up into the slots: along y a
// stack but for these, along z one with walls of 45 degrees.
TopoDS_Shape vee_block() {
  constexpr double half[][2] = {{30, 0},  {30, 14}, {20, 14}, {20, 22}, {30, 22},
                                {30, 50}, {26, 50}, {2, 26},  {2, 20}};
  BRepBuilderAPI_MakePolygon outline;
  for (const auto& corner : half) outline.Add(gp_Pnt(corner[0], 0, corner[1]));
  for (int i = 8; i >= 0; --i) outline.Add(gp_Pnt(-half[i][0], 0, half[i][1]));
  outline.Close();
  TopoDS_Shape result =
      BRepPrimAPI_MakePrism(BRepBuilderAPI_MakeFace(outline.Wire()).Face(), gp_Vec(0, 50, 0)).Shape();
  for (const double x : {-25.0, 25.0})
    result = BRepAlgoAPI_Cut(result,
                             BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(x, 25, -1), gp::DZ()), 2.5, 16).Shape())
                 .Shape();
  return result;
}

TopoDS_Shape drilled(const TopoDS_Shape& blank, const Drill& drill) {
  const gp_Ax2 axis(drill.from, drill.along);
  return BRepAlgoAPI_Cut(blank, BRepPrimAPI_MakeCylinder(axis, drill.radius, drill.length).Shape()).Shape();
}

// A bar that is round but for a flat above, bored along y, with a hole from the flat into the bore.
TopoDS_Shape greased_bar() {
  const TopoDS_Shape bar = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, 0, 0), gp::DY()), 20, 30).Shape();
  const TopoDS_Shape flatted =
      BRepAlgoAPI_Cut(bar, BRepPrimAPI_MakeBox(gp_Pnt(-30, -1, 17), 60, 40, 20).Shape()).Shape();
  return drilled(drilled(flatted, {{0, -1, 0}, gp::DY(), 11, 32}), {{0, 15, 0}, gp::DZ(), 3, 20});
}

// A hub of radius 16 on a disc, a keyway in its bore, a hole from outside through the keyway's floor.
TopoDS_Shape keyed_hub() {
  const TopoDS_Shape hub = BRepPrimAPI_MakeCylinder(16, 30).Shape();
  const TopoDS_Shape outside = BRepAlgoAPI_Fuse(hub, BRepPrimAPI_MakeCylinder(34, 10).Shape()).Shape();
  const TopoDS_Shape bored = drilled(outside, {{0, 0, -1}, gp::DZ(), 8, 32});
  const TopoDS_Shape keyed =
      BRepAlgoAPI_Cut(bored, BRepPrimAPI_MakeBox(gp_Pnt(0, -2.5, -1), 10.3, 5, 32).Shape()).Shape();
  return drilled(keyed, {{0, 0, 20}, gp::DX(), 2.1, 20});
}

}  // namespace

std::map<std::string, TopoDS_Shape> drilled() {
  const Drill gallery{{-1, 20, 20}, gp::DX(), 8, 62};
  return {
      {"port", block_with({gallery, {{30, 20, 20}, gp::DZ(), 5, 21}})},
      {"ports", block_with({gallery, {{30, 20, -1}, gp::DZ(), 5, 42}})},
      {"three_bores",
       block_with({gallery, {{30, -1, 20}, gp::DY(), 5, 42}, {{30, 20, -1}, gp::DZ(), 4, 42}})},
      {"sunk_port", block_with({gallery, {{30, 20, 20}, gp::DZ(), 4, 21}, {{30, 20, 34}, gp::DZ(), 7, 7}})},
      {"blind_bore", block_with({gallery, {{30, 20, 33}, gp::DZ(), 4, 8}})},
      {"port_beside", block_with({gallery, {{30, 22, 20}, gp::DZ(), 5, 21}})},
      {"vee_block", vee_block()},
      {"greased_bar", greased_bar()},
      {"keyed_hub", keyed_hub()},
      {"tipped_bore", block_with_tip({{{30, 20, 41}, gp::DZ().Reversed(), 6, 27}})},
      {"tipped_gallery", block_with_tip({{{-1, 20, 20}, gp::DX(), 7, 40}, {{45, 6, -1}, gp::DZ(), 3, 42}})},
      {"wide_port", block_with({gallery, {{30, 20, 20}, gp::DZ(), 9, 21}})},
  };
}
