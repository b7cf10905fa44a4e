#include "verification/parts/internal/step_file.hpp"

#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <Interface_Static.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <stdexcept>
#include <vector>

namespace isopatch::parts {
namespace {

constexpr double on_the_face = 1e-5;  // mm; faces of splines are as near to their points

TopoDS_Shape face_at(const TopoDS_Shape& solid, const FaceName& wanted) {
  std::vector<TopoDS_Shape> found;
  const TopoDS_Shape point = BRepBuilderAPI_MakeVertex(wanted.on).Shape();
  for (TopExp_Explorer faces(solid, TopAbs_FACE); faces.More(); faces.Next())
    if (BRepExtrema_DistShapeShape(point, faces.Current()).Value() < on_the_face)
      found.push_back(faces.Current());
  if (found.size() == 1) return found.front();
  throw std::runtime_error(std::to_string(found.size()) + " faces are where '" + wanted.name + "' should be");
}

}  // namespace

void write_step(const Part& part, const std::string& name, const std::string& path) {
  STEPCAFControl_Writer writer;
  Interface_Static::SetIVal("write.stepcaf.subshapes.name", 1);
  Handle(TDocStd_Document) document = new TDocStd_Document("BinXCAF");
  const Handle(XCAFDoc_ShapeTool) shapes = XCAFDoc_DocumentTool::ShapeTool(document->Main());
  std::vector<Body> bodies = {{part.name.empty() ? name : part.name, part.solid, part.faces}};
  bodies.insert(bodies.end(), part.others.begin(), part.others.end());
  for (const Body& body : bodies) {
    const TDF_Label label = shapes->AddShape(body.solid, false);
    TDataStd_Name::Set(label, body.name.c_str());
    for (const FaceName& face : body.faces)
      TDataStd_Name::Set(shapes->AddSubShape(label, face_at(body.solid, face)), face.name.c_str());
  }
  writer.SetNameMode(true);
  if (!writer.Transfer(document, STEPControl_AsIs) || writer.Write(path.c_str()) != IFSelect_RetDone)
    throw std::runtime_error("cannot write " + path);
}

}  // namespace isopatch::parts
