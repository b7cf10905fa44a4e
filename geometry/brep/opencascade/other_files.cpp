#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESControl_Writer.hxx>
#include <IGESGeom_BoundedSurface.hxx>
#include <IGESGeom_TrimmedSurface.hxx>
#include <IGESSolid_Face.hxx>
#include <IGESSolid_ManifoldSolid.hxx>
#include <Interface_Static.hxx>
#include <XSControl_WorkSession.hxx>

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "geometry/brep/opencascade/internal/exchange.hpp"
#include "geometry/brep/opencascade/internal/scaled_shape.hpp"
#include "geometry/brep/opencascade/internal/transfer_remarks.hpp"

namespace isopatch::geometry {
namespace {

// Trimmed and bounded surfaces, faces, solids.
bool bounding_entity(const Standard_Transient& entity) {
  const auto& type = *entity.DynamicType();
  for (const auto& kind : {STANDARD_TYPE(IGESGeom_TrimmedSurface), STANDARD_TYPE(IGESGeom_BoundedSurface),
                           STANDARD_TYPE(IGESSolid_Face), STANDARD_TYPE(IGESSolid_ManifoldSolid)})
    if (type.SubType(kind)) return true;
  return false;
}

}  // namespace

FileShapes read_iges(const KernelSource& source) {
  IGESControl_Reader reader;
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  if (reader.ReadFile(source.path.c_str()) != IFSelect_RetDone)
    throw Error(ErrorCode::bad_format,
                fmt::format("{}: this is no complete IGES file", source.path.string()));
  reader.TransferRoots();
  const TopoDS_Shape shape = reader.OneShape();
  if (shape.IsNull())
    throw Error(ErrorCode::bad_format, fmt::format("{}: the IGES file holds no shape", source.path.string()));
  FileShapes result{{{.shape = shape}}};
  add_remarks(*reader.WS(), bounding_entity, result);
  return result;
}

FileShapes read_native(const KernelSource& source) {
  TopoDS_Shape shape;
  const BRep_Builder builder;
  if (!BRepTools::Read(shape, source.path.c_str(), builder) || shape.IsNull())
    throw Error(ErrorCode::bad_format,
                fmt::format("{}: this is no complete OpenCASCADE file", source.path.string()));
  return {{{.shape = shape}}};
}

void write_iges(const std::filesystem::path& path, const ShapeKernel& kernel, const std::string& unit) {
  IGESControl_Controller::Init();
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  IGESControl_Writer writer(unit == "in" ? "IN" : unit == "m" ? "M" : "MM", 1);  // 1: solids as solids
  if (!writer.AddShape(scaled_shape(kernel, 1e-3).shape))
    throw Error(ErrorCode::io, fmt::format("{}: the solid cannot be said in IGES", path.string()));
  writer.ComputeModel();
  if (!writer.Write(path.c_str()))
    throw Error(ErrorCode::io, fmt::format("{}: the IGES file could not be written", path.string()));
}

void write_native(const std::filesystem::path& path, const ShapeKernel& kernel, const std::string& unit) {
  const double metres = unit == "in" ? 0.0254 : unit == "m" ? 1 : 1e-3;
  if (!BRepTools::Write(scaled_shape(kernel, metres).shape, path.c_str()))
    throw Error(ErrorCode::io, fmt::format("{}: the file could not be written", path.string()));
}

}  // namespace isopatch::geometry
