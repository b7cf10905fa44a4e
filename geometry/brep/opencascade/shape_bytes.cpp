#include <BRep_Builder.hxx>
#include <BinTools.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Iterator.hxx>
#include <TopoDS_Vertex.hxx>
#include <nlohmann/json.hpp>
#include <sstream>

#include "geometry/base/error.hpp"
#include "geometry/brep/opencascade/internal/exchange.hpp"

// One line of JSON says what the shapes are called and which of their faces and vertices is which; the shapes
// follow as the library itself stores them, which keeps every bit.
namespace isopatch::geometry {
namespace {

using Json = nlohmann::json;

TopTools_IndexedMapOfShape parts_of(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape result;
  for (TopExp_Explorer it(shape, kind); it.More(); it.Next()) result.Add(it.Current());
  return result;
}

Json body_json(const KernelSolid& body, const ShapeInput& input) {
  const TopTools_IndexedMapOfShape known = parts_of(input.shape, TopAbs_FACE);
  const TopTools_IndexedMapOfShape known_vertices = parts_of(input.shape, TopAbs_VERTEX);
  Json faces = Json::array();
  for (std::size_t f = 0; f < input.faces.size(); ++f) {
    Json colour;
    if (!input.colours.empty() && input.colours[f]) colour = *input.colours[f];
    faces.push_back({known.FindIndex(input.faces[f]), input.names.empty() ? "" : input.names[f], colour});
  }
  Json vertices = Json::array();
  for (const TopoDS_Vertex& vertex : input.vertices) vertices.push_back(known_vertices.FindIndex(vertex));
  return {{"name", body.name},
          {"correction", body.largest_correction},
          {"metres", input.metres},
          {"vertices", vertices},
          {"faces", faces}};
}

ShapeInput input_of(const TopoDS_Shape& shape, const Json& said) {
  ShapeInput input;
  input.shape = shape;
  input.metres = said.at("metres");
  std::vector<TopoDS_Face> known;
  TopTools_IndexedMapOfShape seen;
  for (TopExp_Explorer it(shape, TopAbs_FACE); it.More(); it.Next())
    if (static_cast<std::size_t>(seen.Add(it.Current())) > known.size())
      known.push_back(TopoDS::Face(it.Current()));
  const TopTools_IndexedMapOfShape vertices = parts_of(shape, TopAbs_VERTEX);
  for (const Json& number : said.at("vertices"))
    input.vertices.push_back(TopoDS::Vertex(vertices.FindKey(number.get<int>())));
  for (const Json& face : said.at("faces")) {
    input.faces.push_back(known.at(face.at(0).get<std::size_t>() - 1));
    input.names.push_back(face.at(1));
    input.colours.push_back(face.at(2).is_null() ? std::nullopt : std::optional(face.at(2).get<Colour>()));
  }
  return input;
}

}  // namespace

std::string bytes_of(const std::vector<KernelSolid>& bodies) {
  const BRep_Builder builder;
  TopoDS_Compound all;
  builder.MakeCompound(all);
  Json said = Json::array();
  for (const KernelSolid& body : bodies) {
    const ShapeInput& input = dynamic_cast<const ShapeKernel&>(*body.kernel).input();
    said.push_back(body_json(body, input));
    builder.Add(all, input.shape);
  }
  std::ostringstream out;
  out << said.dump(-1, ' ', false, Json::error_handler_t::replace) << '\n';
  BinTools::Write(all, out);
  return std::move(out).str();
}

std::vector<KernelSolid> bodies_of_bytes(const std::string& bytes) {
  std::istringstream in(bytes);
  std::string line;
  std::getline(in, line);
  const Json said = Json::parse(line);
  TopoDS_Shape all;
  BinTools::Read(all, in);
  std::vector<KernelSolid> result;
  std::size_t i = 0;
  if (all.IsNull()) throw Error(ErrorCode::internal, "solids handed on by another process cannot be read");
  for (TopoDS_Iterator it(all); it.More(); it.Next(), ++i)
    result.push_back({std::make_shared<ShapeKernel>(input_of(it.Value(), said.at(i))), said[i].at("name"),
                      said[i].at("correction")});
  return result;
}

}  // namespace isopatch::geometry
