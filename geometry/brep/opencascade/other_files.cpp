#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <IGESControl_Controller.hxx>
#include <IGESControl_Reader.hxx>
#include <IGESControl_Writer.hxx>
#include <Interface_Static.hxx>

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "geometry/brep/opencascade/internal/exchange.hpp"
#include "geometry/brep/opencascade/internal/scaled_shape.hpp"

namespace isopatch::geometry {

std::vector<FileShape> read_iges(const std::filesystem::path& path) {
  IGESControl_Reader reader;
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
    throw Error(ErrorCode::bad_format, fmt::format("{}: this is no complete IGES file", path.string()));
  reader.TransferRoots();
  const TopoDS_Shape shape = reader.OneShape();
  if (shape.IsNull())
    throw Error(ErrorCode::bad_format, fmt::format("{}: the IGES file holds no shape", path.string()));
  return {{shape, "", {}, {}}};
}

std::vector<FileShape> read_native(const std::filesystem::path& path) {
  TopoDS_Shape shape;
  const BRep_Builder builder;
  if (!BRepTools::Read(shape, path.c_str(), builder) || shape.IsNull())
    throw Error(ErrorCode::bad_format,
                fmt::format("{}: this is no complete OpenCASCADE file", path.string()));
  return {{shape, "", {}, {}}};
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
