// Writes OpenCASCADE files again as STEP, IGES or OpenCASCADE files.
//
// Each line of the standard input is FROM TO SCHEMA UNIT SHAPE: SCHEMA AP203, AP214IS or AP242DIS (STEP) and
// solids or faces (IGES); UNIT as the library names it; SHAPE solids, shells (without solids),
// loose (faces of their own edges), nested (compounds in compounds) or open (the last face left out).
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <iostream>
#include <sstream>

namespace {

TopoDS_Compound collected(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind, bool copy, bool leave_last_out) {
  const BRep_Builder builder;
  TopoDS_Compound result;
  builder.MakeCompound(result);
  TopoDS_Shape before;
  for (TopExp_Explorer it(shape, kind); it.More(); it.Next()) {
    if (!before.IsNull()) builder.Add(result, before);
    before = copy ? BRepBuilderAPI_Copy(it.Current()).Shape() : it.Current();
  }
  if (!leave_last_out) builder.Add(result, before);
  return result;
}

TopoDS_Shape arranged(const TopoDS_Shape& shape, const std::string& how) {
  if (how == "shells") return collected(shape, TopAbs_SHELL, false, false);
  if (how == "loose") return collected(shape, TopAbs_FACE, true, false);
  if (how == "open") return collected(shape, TopAbs_FACE, false, true);
  if (how != "nested") return collected(shape, TopAbs_SOLID, false, false);
  const BRep_Builder builder;
  TopoDS_Shape result = collected(shape, TopAbs_SOLID, false, false);
  for (int i = 0; i < 3; ++i) {
    TopoDS_Compound outer;
    builder.MakeCompound(outer);
    builder.Add(outer, result);
    result = outer;
  }
  return result;
}

bool write(const TopoDS_Shape& shape, const std::string& to, const std::string& schema, const char* unit) {
  if (to.ends_with(".brep")) return BRepTools::Write(shape, to.c_str());
  if (to.ends_with(".igs")) {
    IGESControl_Writer writer(unit, schema == "solids" ? 1 : 0);
    writer.AddShape(shape);
    writer.ComputeModel();
    return writer.Write(to.c_str());
  }
  Interface_Static::SetCVal("write.step.schema", schema.c_str());
  Interface_Static::SetCVal("write.step.unit", unit);
  STEPControl_Writer writer;
  writer.Model(true);  // so that the schema counts
  return writer.Transfer(shape, STEPControl_AsIs) == IFSelect_RetDone &&
         writer.Write(to.c_str()) == IFSelect_RetDone;
}

}  // namespace

int main() {
  STEPControl_Controller::Init();
  IGESControl_Controller::Init();
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  int failures = 0;
  for (std::string line; std::getline(std::cin, line);) {
    std::istringstream words(line);
    std::string from, to, schema, unit, how;
    words >> from >> to >> schema >> unit >> how;
    TopoDS_Shape shape;
    if (BRepTools::Read(shape, from.c_str(), BRep_Builder()) &&
        write(arranged(shape, how), to, schema, unit.c_str()))
      continue;
    std::cerr << "could not write " << to << '\n';
    ++failures;
  }
  return failures == 0 ? 0 : 1;
}
