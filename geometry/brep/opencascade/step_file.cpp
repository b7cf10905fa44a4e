#include <BRep_Builder.hxx>
#include <IFSelect_ReturnStatus.hxx>
#include <Interface_Static.hxx>
#include <Quantity_Color.hxx>
#include <STEPCAFControl_Controller.hxx>
#include <STEPCAFControl_Reader.hxx>
#include <STEPCAFControl_Writer.hxx>
#include <StepShape_FaceBasedSurfaceModel.hxx>
#include <StepShape_FaceSurface.hxx>
#include <StepShape_ShellBasedSurfaceModel.hxx>
#include <StepShape_SolidModel.hxx>
#include <TCollection_ExtendedString.hxx>
#include <TDF_LabelSequence.hxx>
#include <TDataStd_Name.hxx>
#include <TDocStd_Document.hxx>
#include <TopExp_Explorer.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <XCAFApp_Application.hxx>
#include <XCAFDoc_ColorTool.hxx>
#include <XCAFDoc_DocumentTool.hxx>
#include <XCAFDoc_ShapeTool.hxx>
#include <XSControl_WorkSession.hxx>
#include <istream>
#include <streambuf>

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "geometry/brep/opencascade/internal/exchange.hpp"
#include "geometry/brep/opencascade/internal/face_sides.hpp"
#include "geometry/brep/opencascade/internal/scaled_shape.hpp"
#include "geometry/brep/opencascade/internal/transfer_remarks.hpp"
#include "geometry/brep/placeholder_name.hpp"

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

/// A text as a stream, without a copy.
class TextStream : private std::streambuf, public std::istream {
 public:
  explicit TextStream(std::string_view text) : std::istream(static_cast<std::streambuf*>(this)) {
    char* begin = const_cast<char*>(text.data());
    setg(begin, begin, begin + text.size());
  }
};

std::string utf8(const TCollection_ExtendedString& text) {
  std::string result(static_cast<std::size_t>(text.LengthOfCString()) + 1, '\0');
  Standard_PCharacter target = result.data();
  result.resize(static_cast<std::size_t>(text.ToUTF8CString(target)));
  return result;
}

std::string name_at(const TDF_Label& label) {
  Handle(TDataStd_Name) attribute;
  if (label.IsNull() || !label.FindAttribute(TDataStd_Name::GetID(), attribute)) return "";
  std::string name = utf8(attribute->Get());
  name.erase(name.find_last_not_of(" \t\r\n") + 1);
  name.erase(0, name.find_first_not_of(" \t\r\n"));
  return is_placeholder_name(name) ? "" : name;
}

std::optional<Colour> colour_at(const TDF_Label& label) {
  Quantity_Color found;
  for (const XCAFDoc_ColorType type : {XCAFDoc_ColorSurf, XCAFDoc_ColorGen}) {
    if (label.IsNull() || !XCAFDoc_DocumentTool::ColorTool(label)->GetColor(label, type, found)) continue;
    Colour colour{};
    found.Values(colour[0], colour[1], colour[2], Quantity_TOC_sRGB);
    return colour;
  }
  return std::nullopt;
}

using ColourChoice = std::optional<Colour>;

ColourChoice first_of(const ColourChoice& first, const ColourChoice& second) {
  return first ? first : second;
}

/// Follows assemblies down to their parts, each as often as it is placed.
class AssemblyWalk {
 public:
  explicit AssemblyWalk(const std::shared_ptr<Document>& document)
      : document_(document), tool_(document->shapes()) {}

  void visit(const TDF_Label& label, const TopLoc_Location& location, const ColourChoice& of_place,
             int depth = 0) {
    if (depth > deepest) return;
    if (XCAFDoc_ShapeTool::IsReference(label)) {
      TDF_Label part;
      XCAFDoc_ShapeTool::GetReferredShape(label, part);
      visit(part, location * XCAFDoc_ShapeTool::GetLocation(label), first_of(colour_at(label), of_place),
            depth + 1);
    } else if (XCAFDoc_ShapeTool::IsAssembly(label)) {
      TDF_LabelSequence parts;
      XCAFDoc_ShapeTool::GetComponents(label, parts);
      const ColourChoice own = first_of(of_place, colour_at(label));
      for (const TDF_Label& part : parts) visit(part, location, own, depth + 1);
    } else {
      add_part(label, location, of_place);
    }
  }

  std::vector<FileShape> shapes;

 private:
  static constexpr int deepest = 100;

  // Solids and shells of their own may have names and colours below the part's.
  void add_part(const TDF_Label& label, const TopLoc_Location& location, const ColourChoice& of_place) {
    const TopoDS_Shape part = XCAFDoc_ShapeTool::GetShape(label);
    if (part.IsNull()) return;
    const std::string name = name_at(label);
    const ColourChoice of_part = first_of(of_place, colour_at(label));
    std::vector<TopoDS_Shape> bodies;
    for (const auto& [kind, avoid] : {std::pair(TopAbs_SOLID, TopAbs_SHAPE), {TopAbs_SHELL, TopAbs_SOLID}})
      for (TopExp_Explorer it(part, kind, avoid); it.More(); it.Next()) bodies.push_back(it.Current());
    const bool several = bodies.size() > 1;
    if (TopExp_Explorer(part, TopAbs_FACE, TopAbs_SHELL).More() || bodies.empty())
      add(label, loose_part(part), location, name, of_part);
    for (const TopoDS_Shape& body : bodies) {
      const TDF_Label own = label_below(label, body);
      const std::string own_name = name_at(own);
      add(label, body, location, own_name.empty() || (!several && !name.empty()) ? name : own_name,
          first_of(of_place, first_of(colour_at(own), of_part)));
    }
  }

  /// What of a part belongs to no solid and no shell.
  static TopoDS_Shape loose_part(const TopoDS_Shape& part) {
    const BRep_Builder builder;
    TopoDS_Compound loose;
    builder.MakeCompound(loose);
    for (const auto& [kind, avoid] :
         {std::pair(TopAbs_FACE, TopAbs_SHELL), {TopAbs_EDGE, TopAbs_FACE}, {TopAbs_VERTEX, TopAbs_EDGE}})
      for (TopExp_Explorer it(part, kind, avoid); it.More(); it.Next()) builder.Add(loose, it.Current());
    return loose;
  }

  void add(const TDF_Label& label, const TopoDS_Shape& shape, const TopLoc_Location& location,
           const std::string& name, const ColourChoice& colour) {
    FileShape result{.shape = shape.Moved(location), .name = name};
    const TopLoc_Location back = location.Inverted();
    result.words_of = [tool = tool_, document = document_, label, back, colour](const TopoDS_Face& face) {
      const TDF_Label own = label_below(label, face.Moved(back));
      return FaceWords{name_at(own), first_of(colour_at(own), colour)};
    };
    shapes.push_back(std::move(result));
  }

  static TDF_Label label_below(const TDF_Label& part, const TopoDS_Shape& shape) {
    TDF_Label found;
    XCAFDoc_DocumentTool::ShapeTool(part)->FindSubShape(part, shape, found);
    return found;
  }

  std::shared_ptr<Document> document_;
  Handle(XCAFDoc_ShapeTool) tool_;
};

bool is_body_or_face(const Standard_Transient& entity) {
  const auto& type = *entity.DynamicType();
  return type.SubType(STANDARD_TYPE(StepShape_SolidModel)) ||
         type.SubType(STANDARD_TYPE(StepShape_ShellBasedSurfaceModel)) ||
         type.SubType(STANDARD_TYPE(StepShape_FaceBasedSurfaceModel)) ||
         type.SubType(STANDARD_TYPE(StepShape_FaceSurface));
}

}  // namespace

FileShapes read_step(const KernelSource& source) {
  const auto document = std::make_shared<Document>();
  STEPCAFControl_Controller::Init();
  Interface_Static::SetIVal("read.stepcaf.subshapes.name", 1);
  Interface_Static::SetCVal("xstep.cascade.unit", "MM");
  STEPCAFControl_Reader reader;
  reader.SetColorMode(true);
  reader.SetNameMode(true);
  TextStream text(source.text);
  if (reader.ChangeReader().ReadStream(source.path.filename().c_str(), text) != IFSelect_RetDone)
    throw Error(ErrorCode::bad_format,
                fmt::format("{}: this is no complete STEP file", source.path.string()));
  FileShapes result;
  if (reader.Transfer(document->handle())) {
    TDF_LabelSequence labels;
    document->shapes()->GetFreeShapes(labels);
    AssemblyWalk walk(document);
    for (const TDF_Label& label : labels) walk.visit(label, {}, std::nullopt);
    result.shapes = std::move(walk.shapes);
  }
  add_remarks(*reader.Reader().WS(), is_body_or_face, result);
  add_swapped_sides(*reader.Reader().WS(), result);
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
