#include "geometry/brep/tests/made_solids/drilled.hpp"

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
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
      {"wide_port", block_with({gallery, {{30, 20, 20}, gp::DZ(), 9, 21}})},
  };
}
