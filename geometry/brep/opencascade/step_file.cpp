#include <IFSelect_ReturnStatus.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "geometry/brep/opencascade/internal/exchange.hpp"
#include "geometry/brep/opencascade/internal/scaled_shape.hpp"

namespace isopatch::geometry {
namespace {

/// A document of shapes with names and colours, closed at the end.
class Document {
 public:
  Document() { XCAFApp_Application::GetApplication()->NewDocument("BinXCAF", document_); }
  ~Document() { XCAFApp_Application::GetApplication()->Close(document_); }
  Document(const Document&) = delete;
  Document& operator=(const Document&) = delete;

  Handle(TDocStd_Document) & handle() { return document_; }
  Handle(XCAFDoc_ShapeTool) shapes() const { return XCAFDoc_DocumentTool::ShapeTool(document_->Main()); }
  Handle(XCAFDoc_ColorTool) colours() const { return XCAFDoc_DocumentTool::ColorTool(document_->Main()); }

 private:
  Handle(TDocStd_Document) document_;
};

std::string utf8(const TCollection_ExtendedString& text) {
  std::string result(static_cast<std::size_t>(text.LengthOfCString()) + 1, '\0');
  Standard_PCharacter target = result.data();
  result.resize(static_cast<std::size_t>(text.ToUTF8CString(target)));
  return result;
}

// What programs write where they have no name to give.
bool says_nothing(const std::string& name) {
  return name == "NONE" || name == "''" || name == "Face" || name == "SOLID" || name == "COMPOUND";
}

std::string name_at(const TDF_Label& label) {
  Handle(TDataStd_Name) attribute;
  if (label.IsNull() || !label.FindAttribute(TDataStd_Name::GetID(), attribute)) return "";
  std::string name = utf8(attribute->Get());
  return says_nothing(name) ? "" : name;
}

std::optional<Colour> colour_at(const Handle(XCAFDoc_ColorTool) & tool, const TopoDS_Shape& shape) {
  Quantity_Color found;
  for (const XCAFDoc_ColorType type : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen}) {
    if (!tool->GetColor(shape, type, found)) continue;
    Colour colour{};
    found.Values(colour[0], colour[1], colour[2], Quantity_TOC_sRGB);
    return colour;
  }
  return std::nullopt;
}

// The label of a face wherever it stands in an assembly.
TDF_Label label_of(const Handle(XCAFDoc_ShapeTool) & tool, const TopoDS_Shape& face) {
  TDF_Label label;
  if (tool->Search(face, label, true, true, true)) return label;
  if (tool->Search(face.Located(TopLoc_Location()), label, true, true, true)) return label;
  return {};
}

FileShape file_shape(const std::shared_ptr<Document>& document, const TDF_Label& label) {
  FileShape result;
  result.shape = document->shapes()->GetShape(label);
  result.name = name_at(label);
  result.name_of = [document](const TopoDS_Face& face) {
    return name_at(label_of(document->shapes(), face));
  };
  const std::optional<Colour> of_all = colour_at(document->colours(), result.shape);
  result.colour_of = [document, of_all](const TopoDS_Face& face) {
    const auto own = colour_at(document->colours(), face);
    return own ? own : of_all;
  };
  return result;
}

}  // namespace

std::vector<FileShape> read_step(const std::filesystem::path& path) {
  const auto document = std::make_shared<Document>();
  STEPCAFControl_Controller::Init();
  Interface_Static::SetIVal("read.stepcaf.subshapes.name", 1);
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  STEPCAFControl_Reader reader;
  reader.SetColorMode(true);
  reader.SetNameMode(true);
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone)
    throw Error(ErrorCode::bad_format, fmt::format("{}: this is no complete STEP file", path.string()));
  if (!reader.Transfer(document->handle()))
    throw Error(ErrorCode::bad_format, fmt::format("{}: the STEP file holds no shape", path.string()));
  TDF_LabelSequence labels;
  document->shapes()->GetFreeShapes(labels);
  std::vector<FileShape> result;
  for (const TDF_Label& label : labels) result.push_back(file_shape(document, label));
  return result;
}

void write_step(const std::filesystem::path& path, const ShapeKernel& kernel, const std::string& unit) {
  Document document;
  const ScaledShape made = scaled_shape(kernel, 1e-3);
  const auto shapes = document.shapes();
  const auto colours = document.colours();
  const TDF_Label solid = shapes->AddShape(made.shape, false);
  const std::vector<BrepFace>& faces = kernel.tables().faces;
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (faces[i].name.empty() && !faces[i].colour) continue;
    const TDF_Label label = shapes->AddSubShape(solid, made.faces[i]);
    if (!faces[i].name.empty())
      TDataStd_Name::Set(label, TCollection_ExtendedString(faces[i].name.c_str(), true));
    if (const auto& colour = faces[i].colour)
      colours->SetColor(label, Quantity_Color((*colour)[0], (*colour)[1], (*colour)[2], Quantity_TOC_sRGB),
                        XCAFDoc_ColorSurf);
  }
  // The writer looks at these when it is made, and they exist once its library is initialized.
  STEPCAFControl_Controller::Init();
  Interface_Static::SetIVal("write.stepcaf.subshapes.name", 1);
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  Interface_Static::SetCVal("write.step.unit", unit == "in" ? "INCH" : unit == "m" ? "M" : "MM");
  STEPCAFControl_Writer writer;
  writer.SetColorMode(true);
  writer.SetNameMode(true);
  if (!writer.Transfer(document.handle(), STEPControl_ManifoldSolidBrep) ||
      writer.Write(path.c_str()) != IFSelect_RetDone)
    throw Error(ErrorCode::io, fmt::format("{}: the STEP file could not be written", path.string()));
}

}  // namespace isopatch::geometry
