// Solids of another program, for tests: OpenCASCADE's own, written as STEP files in mm into a folder. The
// names are those of geometry/brep/tests/made_solids.hpp, which says what they are.

#include <BRepAlgoAPI_Cut.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakeWire.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepLib.hxx>
#include <BRepOffsetAPI_MakePipeShell.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
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
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <cmath>
#include <functional>
#include <iostream>
#include <stdexcept>
#include <string>

#include "geometry/brep/tests/made_solids/stacks.hpp"

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
