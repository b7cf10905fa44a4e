#include "geometry/io/read_3mf.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <array>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "geometry/base/error.hpp"
#include "geometry/io/coordinate_grain.hpp"
#include "geometry/io/internal/xml_text.hpp"
#include "geometry/io/internal/zip_archive.hpp"

namespace isopatch::geometry {
namespace {

constexpr const char* relationships = "_rels/.rels";
constexpr std::size_t most_corners = 60'000'000;
constexpr std::size_t most_levels = 100;
constexpr int most_objects = 100'000;
constexpr std::string_view model_relationship =
    "http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel";

/// An element's name without the prefix of its namespace.
std::string_view local_name(const char* name) {
  const std::string_view whole = name;
  const auto colon = whole.find(':');
  return colon == whole.npos ? whole : whole.substr(colon + 1);
}

std::vector<pugi::xml_node> children(pugi::xml_node node, std::string_view name) {
  std::vector<pugi::xml_node> result;
  for (const pugi::xml_node child : node.children())
    if (local_name(child.name()) == name) result.push_back(child);
  return result;
}

pugi::xml_node child(pugi::xml_node node, std::string_view name) {
  for (const pugi::xml_node found : node.children())
    if (local_name(found.name()) == name) return found;
  return {};
}

/// An attribute of whatever namespace: "p:path".
std::string attribute(pugi::xml_node node, std::string_view name) {
  for (const pugi::xml_attribute found : node.attributes())
    if (local_name(found.name()) == name) return found.value();
  return "";
}

/// Parts are named from the root of the package.
std::string part_name(std::string path) {
  path.erase(0, path.find_first_not_of('/'));
  return path;
}

double unit_of(const XmlText& xml, pugi::xml_node model) {
  static const std::map<std::string, double> units = {
      {"", 1e-3},       {"micron", 1e-6}, {"millimeter", 1e-3}, {"centimeter", 1e-2},
      {"inch", 0.0254}, {"foot", 0.3048}, {"meter", 1}};
  const auto found = units.find(model.attribute("unit").value());
  if (found == units.end())
    xml.fail(model, fmt::format("unit = \"{}\" is none of micron, millimeter, centimeter, inch, foot, meter",
                                model.attribute("unit").value()));
  return found->second;
}

double number_in(const XmlText& xml, pugi::xml_node node, const char* name, CoordinateGrain& grain) {
  const std::string_view word = node.attribute(name).value();
  TextScanner scanner(word, xml.source());
  try {
    const double value = scanner.number(name);
    if (!scanner.at_end()) throw Error(ErrorCode::bad_format, "more than a number");
    grain.add(word, value);
    return value;
  } catch (const Error&) {
    xml.fail(node, fmt::format("{} = \"{}\" is no number", name, word));
  }
}

/// "m00 m01 m02 m10 ... m32": points are rows, multiplied from the left.
Eigen::Affine3d placement(const XmlText& xml, pugi::xml_node node) {
  Eigen::Affine3d result = Eigen::Affine3d::Identity();
  const std::string_view words = node.attribute("transform").value();
  if (words.empty()) return result;
  TextScanner scanner(words, xml.source());
  try {
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 3; ++column) result.matrix()(column, row) = scanner.number("transform");
    if (!scanner.at_end()) throw Error(ErrorCode::bad_format, "more than twelve");
  } catch (const Error&) {
    xml.fail(node, fmt::format("transform = \"{}\" is no twelve numbers", words));
  }
  return result;
}

/// A model part: its XML and its objects.
struct Part {
  std::string text;  // that the XML was parsed from
  std::unique_ptr<XmlText> xml;
  std::map<std::string, pugi::xml_node> objects;
};

class Package {
 public:
  Package(std::string_view bytes, const std::string& source) : archive_(bytes, source), source_(source) {}

  MeasuredTriangles read() {
    const std::string root = root_part();
    const Part& part = this->part(root);
    const pugi::xml_node model = part.xml->root();
    result_.metres = unit_of(*part.xml, model);
    const auto items = children(child(model, "build"), "item");
    for (const pugi::xml_node item : items)
      place(path_of(item, root), attribute(item, "objectid"), placement(*part.xml, item), item, part);
    if (items.empty())
      for (const auto& [id, object] : part.objects)
        if (const std::string type = object.attribute("type").value(); type.empty() || type == "model")
          place(root, id, Eigen::Affine3d::Identity(), object, part);
    return finished();
  }

 private:
  std::string root_part() const {
    const std::string text = archive_.content(relationships);
    const XmlText xml(text, fmt::format("{}: {}", source_, relationships));
    for (const pugi::xml_node relation : children(xml.root(), "Relationship"))
      if (relation.attribute("Type").value() == model_relationship)
        return part_name(relation.attribute("Target").value());
    xml.fail(xml.root(), "the package has no 3D model");
  }

  static std::string path_of(pugi::xml_node node, const std::string& here) {
    const std::string path = attribute(node, "path");
    return path.empty() ? here : part_name(path);
  }

  const Part& part(const std::string& name) {
    const auto known = parts_.find(name);
    if (known != parts_.end()) return known->second;
    Part& made = parts_[name];
    made.text = archive_.content(name);
    made.xml = std::make_unique<XmlText>(made.text, fmt::format("{}: {}", source_, name));
    if (local_name(made.xml->root().name()) != "model")
      made.xml->fail(made.xml->root(), "the root element is not <model>");
    for (const pugi::xml_node object : children(child(made.xml->root(), "resources"), "object"))
      if (!made.objects.emplace(object.attribute("id").value(), object).second)
        made.xml->fail(object, fmt::format("a second object with id {}", object.attribute("id").value()));
    return made;
  }

  /// Adds an object, whose components may be objects in turn.
  void place(const std::string& path, const std::string& id, const Eigen::Affine3d& where,
             pugi::xml_node asking, const Part& from) {
    const Part& part = this->part(path);
    const auto object = part.objects.find(id);
    if (object == part.objects.end())
      from.xml->fail(asking, fmt::format("there is no object with id '{}'", id));
    if (!open_.emplace(path, id).second)
      from.xml->fail(asking, fmt::format("object {} is a component of itself", id));
    if (open_.size() > most_levels)
      refuse(*from.xml, asking, "components of components, more than 100 levels");
    if (++placed_ > most_objects) refuse(*from.xml, asking, "more than 100,000 objects once all are placed");
    const pugi::xml_node mesh = child(object->second, "mesh");
    if (mesh) add_mesh(*part.xml, mesh, where);
    for (const pugi::xml_node component : children(child(object->second, "components"), "component"))
      place(path_of(component, path), attribute(component, "objectid"),
            where * placement(*part.xml, component), component, part);
    open_.erase({path, id});
  }

  void add_mesh(const XmlText& xml, pugi::xml_node mesh, const Eigen::Affine3d& where) {
    const auto first = static_cast<std::int64_t>(vertices_.size());
    for (const pugi::xml_node vertex : children(child(mesh, "vertices"), "vertex")) {
      Eigen::Vector3d point;
      for (int i = 0; i < 3; ++i)
        point[i] = number_in(xml, vertex, std::array{"x", "y", "z"}[static_cast<std::size_t>(i)], grain_);
      vertices_.push_back(where * point);
      if (vertices_.size() > most_corners) refuse(xml, vertex, "more than 60 million vertices");
    }
    const int count = static_cast<int>(static_cast<std::int64_t>(vertices_.size()) - first);
    // A mirror image turns triangles inside out.
    const bool mirrored = where.linear().determinant() < 0;
    for (const pugi::xml_node triangle : children(child(mesh, "triangles"), "triangle")) {
      Eigen::Vector3i corners;
      for (int i = 0; i < 3; ++i)
        corners[i] = static_cast<int>(first) +
                     xml.integer_attribute(
                         triangle, std::array{"v1", "v2", "v3"}[static_cast<std::size_t>(i)], 0, count - 1);
      if (mirrored) std::swap(corners[1], corners[2]);
      triangles_.push_back(corners);
      if (triangles_.size() > most_corners / 3) refuse(xml, triangle, "more than 20 million triangles");
    }
  }

  MeasuredTriangles finished() {
    if (triangles_.empty())
      throw Error(ErrorCode::bad_format,
                  fmt::format("{}: the package has no triangles to be built", source_));
    result_.mesh.vertices.resize(3, static_cast<Eigen::Index>(vertices_.size()));
    for (std::size_t i = 0; i < vertices_.size(); ++i)
      result_.mesh.vertices.col(static_cast<Eigen::Index>(i)) = vertices_[i];
    result_.mesh.triangles.resize(3, static_cast<Eigen::Index>(triangles_.size()));
    for (std::size_t i = 0; i < triangles_.size(); ++i)
      result_.mesh.triangles.col(static_cast<Eigen::Index>(i)) = triangles_[i];
    result_.mesh.grain = grain_.step();
    return std::move(result_);
  }

  [[noreturn]] static void refuse(const XmlText& xml, pugi::xml_node node, const std::string& message) {
    xml.fail(node, message, ErrorCode::unsupported);
  }

  ZipArchive archive_;
  std::string source_;
  std::map<std::string, Part> parts_;
  std::set<std::pair<std::string, std::string>> open_;  // objects that are being placed
  int placed_ = 0;
  std::vector<Eigen::Vector3d> vertices_;
  std::vector<Eigen::Vector3i> triangles_;
  CoordinateGrain grain_;
  MeasuredTriangles result_;
};

}  // namespace

MeasuredTriangles read_3mf(std::string_view bytes, const std::string& source) {
  return Package(bytes, source).read();
}

}  // namespace isopatch::geometry
