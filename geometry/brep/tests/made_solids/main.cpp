// Solids of another program, for tests: OpenCASCADE's own, written as STEP files in mm into a folder. The
// names are those of geometry/brep/tests/made_solids.hpp, which says what they are.

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepBuilderAPI_NurbsConvert.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepLib.hxx>
#include <BRepOffsetAPI_MakePipeShell.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeHalfSpace.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRepPrimAPI_MakeRevol.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Geom2d_Line.hxx>
#include <Geom_CylindricalSurface.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <STEPControl_Writer.hxx>
#include <TCollection_AsciiString.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <cmath>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/brep/tests/made_solids/branched.hpp"
#include "geometry/brep/tests/made_solids/closed_faces.hpp"
#include "geometry/brep/tests/made_solids/crossed.hpp"
#include "geometry/brep/tests/made_solids/drilled.hpp"
#include "geometry/brep/tests/made_solids/rounds.hpp"
#include "geometry/brep/tests/made_solids/slotted.hpp"
#include "geometry/brep/tests/made_solids/stacks.hpp"
#include "geometry/brep/tests/made_solids/turned.hpp"

namespace {

TopoDS_Shape block(double x, double y, double z) {
  return BRepPrimAPI_MakeBox(x, y, z).Shape();
}

TopoDS_Shape drilled_block() {
  const TopoDS_Shape drill = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(15, 10, -1), gp::DZ()), 5, 12).Shape();
  return BRepAlgoAPI_Cut(block(30, 20, 10), drill).Shape();
}

// A cylinder along y takes a quarter of itself off the upper edge at x = 0.
TopoDS_Shape grooved_block() {
  const TopoDS_Shape tool = BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(0, -1, 10), gp::DY()), 5, 22).Shape();
  return BRepAlgoAPI_Cut(block(30, 20, 10), tool).Shape();
}

TopoDS_Shape notched_block() {
  const TopoDS_Shape tool = BRepPrimAPI_MakeBox(gp_Pnt(10, -1, 5), 10, 6, 6).Shape();
  return BRepAlgoAPI_Cut(block(30, 20, 10), tool).Shape();
}

bool is_along(const TopoDS_Edge& edge, double x, double y, double z) {
  double first = 0, last = 0;
  const Handle(Geom_Curve) curve = BRep_Tool::Curve(edge, first, last);
  const gp_Pnt middle = curve->Value((first + last) / 2);
  return middle.Distance(gp_Pnt(x, y, z)) < 1e-9;
}

TopoDS_Shape rounded(const TopoDS_Shape& shape, const std::function<bool(const TopoDS_Edge&)>& is_chosen) {
  BRepFilletAPI_MakeFillet fillet(shape);
  for (TopExp_Explorer edges(shape, TopAbs_EDGE); edges.More(); edges.Next())
    if (is_chosen(TopoDS::Edge(edges.Current()))) fillet.Add(3, TopoDS::Edge(edges.Current()));
  return fillet.Shape();
}

TopoDS_Shape block_with_a_round_edge() {
  return rounded(block(30, 20, 10), [](const TopoDS_Edge& edge) { return is_along(edge, 15, 0, 10); });
}

TopoDS_Shape block_with_a_round_corner() {
  return rounded(block(30, 20, 10), [](const TopoDS_Edge& edge) {
    return is_along(edge, 15, 0, 10) || is_along(edge, 0, 10, 10) || is_along(edge, 0, 0, 5);
  });
}

// A tube of radius 2 along a helix of radius 10 and pitch 8, two turns: its surfaces are splines.
TopoDS_Shape spring() {
  const double turns = 2, pitch = 8, radius = 10, tau = 2 * std::acos(-1.0);
  const Handle(Geom_CylindricalSurface) around = new Geom_CylindricalSurface(gp_Ax3(gp::XOY()), radius);
  const Handle(Geom2d_Line) rising = new Geom2d_Line(gp_Pnt2d(0, 0), gp_Dir2d(tau, pitch));
  const TopoDS_Edge edge = BRepBuilderAPI_MakeEdge(rising, around, 0, turns * std::hypot(tau, pitch)).Edge();
  BRepLib::BuildCurve3d(edge);
  const TopoDS_Wire helix = BRepBuilderAPI_MakeWire(edge).Wire();
  const gp_Circ section(gp_Ax2(gp_Pnt(radius, 0, 0), gp_Dir(0, tau * radius, pitch)), 2);
  BRepOffsetAPI_MakePipeShell pipe(helix);
  pipe.SetMode(true);  // the section turns with the curve's own frame
  pipe.Add(BRepBuilderAPI_MakeWire(BRepBuilderAPI_MakeEdge(section).Edge()).Wire());
  pipe.Build();
  if (!pipe.MakeSolid()) throw std::runtime_error("the spring is no solid");
  return pipe.Shape();
}

// The outlines of pieces: lines, and arcs counter-clockwise around an axis.
TopoDS_Edge line(const gp_Pnt& from, const gp_Pnt& to) {
  return BRepBuilderAPI_MakeEdge(from, to).Edge();
}
TopoDS_Edge arc(const gp_Ax2& around, const gp_Pnt& from, const gp_Pnt& to) {
  return BRepBuilderAPI_MakeEdge(gp_Circ(around, from.Distance(around.Location())), from, to).Edge();
}
TopoDS_Face face_of(const std::vector<TopoDS_Edge>& outline) {
  BRepBuilderAPI_MakeWire wire;
  for (const TopoDS_Edge& edge : outline) wire.Add(edge);
  return BRepBuilderAPI_MakeFace(wire.Wire()).Face();
}

gp_Pnt at_angle(double radius, double degrees) {
  const double angle = degrees * std::acos(-1.0) / 180;
  return {radius * std::cos(angle), radius * std::sin(angle), 0};
}

// A sector of a ring of radii 5 and 8, from 10 degrees on.
TopoDS_Face sector(double degrees) {
  const gp_Pnt a = at_angle(5, 10), b = at_angle(8, 10), c = at_angle(8, 10 + degrees),
               d = at_angle(5, 10 + degrees);
  const gp_Ax2 up(gp_Pnt(0, 0, 0), gp::DZ());
  return face_of({line(a, b), arc(up, b, c), line(c, d), arc(up, a, d)});
}

TopoDS_Shape raised(const TopoDS_Face& face, double height) {
  return BRepPrimAPI_MakePrism(face, gp_Vec(0, 0, height)).Shape();
}

// The drilled block in four pieces, by planes through the bore's axis and the block's upright edges.
TopoDS_Shape drilled_quarters() {
  const std::vector<gp_Pnt> corners{{0, 0, 0}, {30, 0, 0}, {30, 20, 0}, {0, 20, 0}};
  const gp_Pnt center(15, 10, 0);
  const auto on_bore = [&](const gp_Pnt& corner) {
    return center.Translated(5 * gp_Vec(center, corner).Normalized());
  };
  const BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  for (std::size_t i = 0; i < 4; ++i) {
    const gp_Pnt &a = corners[i], &b = corners[(i + 1) % 4];
    const gp_Pnt inner_a = on_bore(a), inner_b = on_bore(b);
    builder.Add(all, raised(face_of({line(a, b), line(b, inner_b),
                                     arc(gp_Ax2(center, gp::DZ()), inner_a, inner_b), line(inner_a, a)}),
                            10));
  }
  return all;
}

// A quarter of a ring under an oblique plane: z = 6 + x / 4 + y / 8 on top.
TopoDS_Shape oblique_ring() {
  const gp_Pln plane(gp_Pnt(0, 0, 6), gp_Dir(-0.25, -0.125, 1));
  const TopoDS_Shape above =
      BRepPrimAPI_MakeHalfSpace(BRepBuilderAPI_MakeFace(plane, -50, 50, -50, 50).Face(), gp_Pnt(0, 0, 100))
          .Solid();
  return BRepAlgoAPI_Cut(raised(sector(90), 20), above).Shape();
}

TopoDS_Shape turned(const TopoDS_Face& face, double degrees) {
  return BRepPrimAPI_MakeRevol(face, gp::OZ(), degrees * std::acos(-1.0) / 180).Shape();
}

// A quarter of a conical ring: radii 6 and 8 below, 3 and 4 above, height 5.
TopoDS_Shape cone_quarter() {
  const gp_Pnt a(6, 0, 0), b(8, 0, 0), c(4, 0, 5), d(3, 0, 5);
  return turned(face_of({line(a, b), line(b, c), line(c, d), line(d, a)}), 90);
}

// A piece of a spherical shell of radii 5 and 7: 90 degrees of longitude, latitudes from 10 to 60 degrees.
TopoDS_Shape shell_piece() {
  const auto at = [](double radius, double degrees) {
    const gp_Pnt p = at_angle(radius, degrees);
    return gp_Pnt(p.X(), 0, p.Y());
  };
  const gp_Ax2 around(gp_Pnt(0, 0, 0), gp_Dir(0, -1, 0));
  const gp_Pnt a = at(5, 10), b = at(7, 10), c = at(7, 60), d = at(5, 60);
  return turned(face_of({line(a, b), arc(around, b, c), line(c, d), arc(around, a, d)}), 90);
}

// A piece of a bent pipe: a quarter of a ring of radii 1 and 2 turned by 60 degrees at a distance of 6.
TopoDS_Shape elbow_piece() {
  const gp_Pnt center(6, 0, 0);
  const gp_Ax2 around(center, gp_Dir(0, -1, 0));
  const gp_Pnt a(7, 0, 0), b(8, 0, 0), c(6, 0, 2), d(6, 0, 1);
  return turned(face_of({line(a, b), arc(around, b, c), line(c, d), arc(around, a, d)}), 60);
}

void write(const TopoDS_Shape& shape, const std::string& path) {
  STEPControl_Writer writer;
  if (writer.Transfer(shape, STEPControl_AsIs) != IFSelect_RetDone ||
      writer.Write(path.c_str()) != IFSelect_RetDone)
    throw std::runtime_error("cannot write " + path);
}

// A grey plate with a red top, and a blue pin on it.
void write_named(const std::string& path) {
  Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
  const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  const Handle(XCAFDoc_ColorTool) colours = XCAFDoc_DocumentTool::ColorTool(document->Main());
  const auto colour = [](double r, double g, double b) { return Quantity_Color(r, g, b, Quantity_TOC_sRGB); };
  const auto add = [&](const TopoDS_Shape& shape, const char* name, const Quantity_Color& of_all) {
    const TDF_Label label = shapes->AddShape(shape, false);
    TDataStd_Name::Set(label, name);
    colours->SetColor(label, of_all, XCAFDoc_ColorSurf);
    return label;
  };
  BRepPrimAPI_MakeBox plate(30, 20, 10);
  const TDF_Label label = add(plate.Solid(), "plate", colour(0.5, 0.5, 0.5));
  const TDF_Label top = shapes->AddSubShape(label, plate.TopFace());
  colours->SetColor(top, colour(1, 0, 0.4), XCAFDoc_ColorSurf);
  TDataStd_Name::Set(top, "top of the plate");
  add(BRepPrimAPI_MakeCylinder(gp_Ax2(gp_Pnt(15, 10, 20), gp::DZ()), 5, 12).Shape(), "pin",
      colour(0.2, 0.4, 0.6));
  STEPCAFControl_Writer writer;
  writer.SetNameMode(true);
  writer.SetColorMode(true);
  if (!writer.Transfer(document, STEPControl_AsIs) || writer.Write(path.c_str()) != IFSelect_RetDone)
    throw std::runtime_error("cannot write " + path);
}

void write_all(const std::string& folder) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  STEPControl_Writer initializes_the_settings;
  Interface_Static::SetIVal("write.stepcaf.subshapes.name", 1);
  const auto in_folder = [&](const char* name) { return folder + "/" + name + ".step"; };
  write(block(30, 20, 10), in_folder("block"));
  write(BRepPrimAPI_MakeCylinder(5, 12).Shape(), in_folder("cylinder"));
  write(BRepPrimAPI_MakeCone(8, 3, 12).Shape(), in_folder("cone"));
  write(BRepPrimAPI_MakeSphere(7).Shape(), in_folder("sphere"));
  write(BRepPrimAPI_MakeTorus(10, 3).Shape(), in_folder("torus"));
  write(drilled_block(), in_folder("drilled"));
  write(grooved_block(), in_folder("grooved"));
  write(notched_block(), in_folder("notched"));
  write(block_with_a_round_edge(), in_folder("round_edge"));
  write(block_with_a_round_corner(), in_folder("round_corner"));
  write(spring(), in_folder("spring"));
  for (const auto& [name, shape] : stacks()) write(shape, in_folder(name.c_str()));
  for (const auto& [name, shape] : branched()) write(shape, in_folder(name.c_str()));
  for (const auto& [name, shape] : closed_faces()) write(shape, in_folder(name.c_str()));
  for (const auto& [name, shape] : crossed()) write(shape, in_folder(name.c_str()));
  for (const auto& [name, shape] : drilled()) write(shape, in_folder(name.c_str()));
  for (const auto& [name, shape] : slotted()) write(shape, in_folder(name.c_str()));
  for (const auto& [name, shape] : rounds()) write(shape, in_folder(name.c_str()));
  for (const auto& [name, shape] : turned_solids()) write(shape, in_folder(name.c_str()));
  write(drilled_quarters(), in_folder("drilled_quarters"));
  write(raised(sector(90), 4), in_folder("ring_quarter"));
  write(raised(sector(150), 4), in_folder("ring_150"));
  write(oblique_ring(), in_folder("oblique_ring"));
  write(cone_quarter(), in_folder("cone_quarter"));
  write(shell_piece(), in_folder("shell_piece"));
  write(elbow_piece(), in_folder("elbow_piece"));
  // Nothing but splines, as some programs write them.
  const auto write_splines = [&](const TopoDS_Shape& shape, const char* name) {
    write(BRepBuilderAPI_NurbsConvert(shape, true).Shape(), in_folder(name));
  };
  write_splines(drilled_block(), "drilled_splines");
  write_splines(BRepPrimAPI_MakeCylinder(5, 12).Shape(), "cylinder_splines");
  write_splines(BRepPrimAPI_MakeCone(8, 3, 12).Shape(), "cone_splines");
  write_splines(BRepPrimAPI_MakeSphere(7).Shape(), "sphere_splines");
  write_splines(BRepPrimAPI_MakeTorus(10, 3).Shape(), "torus_splines");
  write_splines(grooved_block(), "grooved_splines");
  write_splines(block_with_a_round_corner(), "round_corner_splines");
  write_splines(oblique_ring(), "oblique_ring_splines");
  write_splines(elbow_piece(), "elbow_piece_splines");
  write_named(in_folder("named"));
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 2) {
    std::cerr << "usage: isopatch_made_solids FOLDER\n";
    return 2;
  }
  try {
    write_all(arguments[1]);
  } catch (const Standard_Failure& failure) {
    std::cerr << failure.GetMessageString() << "\n";
    return 1;
  } catch (const std::exception& error) {
    std::cerr << error.what() << "\n";
    return 1;
  }
  return 0;
}
