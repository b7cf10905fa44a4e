#include "geometry/io/read_gismo_xml.hpp"

#include <fmt/format.h>

#include <array>
#include <map>
#include <utility>
#include <vector>

#include "geometry/io/internal/gismo_elements.hpp"
#include "geometry/io/internal/xml_text.hpp"
#include "geometry/io/reader_limits.hpp"

namespace isopatch::geometry {
namespace {

class GismoReader {
 public:
  GismoReader(std::string_view text, const std::string& source) : xml_(text, source) {}

  PatchSet read() {
    const pugi::xml_node root = xml_.root();
    if (std::string_view(root.name()) != "xml")
      xml_.fail(root, fmt::format("the root element is <{}>; G+Smo files have <xml>", root.name()));
    const pugi::xml_node multi_patch = root.child("MultiPatch");
    if (const pugi::xml_node second = multi_patch.next_sibling("MultiPatch"))
      xml_.fail(second, "a second MultiPatch element; keep the one to use", ErrorCode::unsupported);
    if (multi_patch) {
      read_listed(multi_patch);
      read_interfaces(multi_patch);
      read_boundaries(multi_patch);
    } else {
      read_all();
    }
    if (result_.patches.empty())
      xml_.fail(root, "no volume patch; Geometry elements of type TensorBSpline3 or TensorNurbs3 are needed",
                ErrorCode::unsupported);
    return std::move(result_);
  }

 private:
  static bool is_volume(pugi::xml_node geometry) {
    const std::string_view type = geometry.attribute("type").value();
    return !type.empty() && type.back() == '3';
  }

  void read_all() {
    for (const pugi::xml_node geometry : xml_.root().children("Geometry"))
      if (is_volume(geometry)) add_patch(geometry);
  }

  // A geometry of the file by its id, found once for all.
  std::map<int, pugi::xml_node> geometries_by_id() const {
    std::map<int, pugi::xml_node> result;
    for (const pugi::xml_node geometry : xml_.root().children("Geometry")) {
      if (!geometry.attribute("id")) continue;
      const int id = xml_.integer_attribute(geometry, "id", 0, max_id);
      if (!result.emplace(id, geometry).second)
        xml_.fail(geometry, fmt::format("a second Geometry with id {}", id));
    }
    return result;
  }

  void read_listed(pugi::xml_node multi_patch) {
    const pugi::xml_node patches = multi_patch.child("patches");
    if (!patches) xml_.fail(multi_patch, "the MultiPatch element lacks its <patches>");
    const auto geometries = geometries_by_id();
    for (const int id : listed_ids(patches)) {
      const auto found = geometries.find(id);
      if (found == geometries.end())
        xml_.fail(patches, fmt::format("patch id {} is listed, but no Geometry has it", id));
      if (!patch_of_id_.emplace(id, PatchId(static_cast<int>(result_.patches.size()))).second)
        xml_.fail(patches, fmt::format("patch id {} is listed twice", id));
      add_patch(found->second);
    }
  }

  std::vector<int> listed_ids(pugi::xml_node patches) const {
    const std::string_view type = patches.attribute("type").value();
    const std::string content = xml_.content(patches);
    TextScanner scanner(content, xml_.source(), xml_.line(patches));
    std::vector<int> ids;
    if (type == "id_range") {
      const int first = scanner.integer("the first patch id", 0, max_id);
      const int last = scanner.integer("the last patch id", first, max_id);
      scanner.expect_end("the range of patch ids");
      if (last - first >= max_patches) scanner.fail(fmt::format("more than {} patches", max_patches));
      for (int id = first; id <= last; ++id) ids.push_back(id);
    } else if (type == "id_index") {
      while (!scanner.at_end()) ids.push_back(scanner.integer("a patch id", 0, max_id));
    } else {
      xml_.fail(patches, fmt::format("patches of type {}; id_range and id_index are supported", quoted(type)),
                ErrorCode::unsupported);
    }
    return ids;
  }

  void add_patch(pugi::xml_node geometry) {
    if (result_.patches.size() == max_patches)
      xml_.fail(geometry, fmt::format("more than {} patches", max_patches));
    result_.patches.push_back(patch(geometry));
  }

  std::string patch_name(pugi::xml_node geometry) const {
    const pugi::xml_attribute id = geometry.attribute("id");
    return fmt::format("patch {}{}", result_.patches.size(), id ? fmt::format(" (id {})", id.value()) : "");
  }

  NurbsVolume patch(pugi::xml_node geometry) const {
    const std::string_view type = geometry.attribute("type").value();
    const std::string name = patch_name(geometry);
    const bool rational = type == "TensorNurbs3";
    if (!rational && type != "TensorBSpline3")
      xml_.fail(geometry,
                fmt::format("{} is of type {}; volumes of type TensorBSpline3 and TensorNurbs3 are supported",
                            name, quoted(type)),
                ErrorCode::unsupported);
    const pugi::xml_node outer = required_child(xml_, geometry, "Basis", name);
    const pugi::xml_node weights_node =
        rational ? required_child(xml_, outer, "weights", name) : pugi::xml_node();
    const pugi::xml_node basis = rational ? required_child(xml_, outer, "Basis", name) : outer;
    const auto given = given_knots<3>(xml_, basis, name);
    NurbsVolume::KnotVectors knots;
    for (std::size_t d = 0; d < 3; ++d)
      knots[d] = knot_vector(xml_, given[d], fmt::format("{}, direction {}", name, d));
    const auto count = located(xml_.source(), xml_.line(basis), name,
                               [&] { return checked_control_points(knots[0], knots[1], knots[2]); });
    const pugi::xml_node coefficients = required_child(xml_, geometry, "coefs", name);
    if (const int dimension = xml_.integer_attribute(coefficients, "geoDim", 1, 1000); dimension != 3)
      xml_.fail(coefficients,
                fmt::format("{} has control points in {} dimensions; 3 are needed", name, dimension),
                ErrorCode::unsupported);
    const Eigen::MatrixXd points = numbers(xml_, coefficients, 3, count, name + ", control point");
    Eigen::VectorXd weights = Eigen::VectorXd::Ones(count);
    if (rational) weights = numbers(xml_, weights_node, 1, count, name + ", weight").transpose();
    return located(xml_.source(), xml_.line(rational ? weights_node : coefficients), name,
                   [&] { return NurbsVolume(std::move(knots), points, std::move(weights)); });
  }

  PatchFace face(TextScanner& scanner) const {
    const int id = scanner.integer("a patch id", 0, max_id);
    const auto found = patch_of_id_.find(id);
    if (found == patch_of_id_.end()) scanner.fail(fmt::format("there is no patch with id {}", id));
    const int side = scanner.integer("a side", 1, 6);
    return {found->second, static_cast<Side>(side - 1)};
  }

  // On which direction of the second patch each of the first falls, and whether both run the same way.
  FaceOrientation orientation(TextScanner& scanner, Side first, Side second) const {
    std::array<int, 3> image{};
    std::array<bool, 3> same_way{};
    for (int& direction : image) direction = scanner.integer("a direction of an interface", 0, 2);
    for (bool& flag : same_way) flag = scanner.integer("an orientation of an interface", 0, 1) == 1;
    const auto on_first = tangents(first), on_second = tangents(second);
    const int s = image[static_cast<std::size_t>(on_first[0])];
    const int t = image[static_cast<std::size_t>(on_first[1])];
    if (s == t || s == direction(second) || t == direction(second))
      scanner.fail(fmt::format("directions {} {} {} of an interface do not take side {} to side {}", image[0],
                               image[1], image[2], static_cast<int>(first) + 1,
                               static_cast<int>(second) + 1));
    const bool flip_s = !same_way[static_cast<std::size_t>(on_first[0])];
    const bool flip_t = !same_way[static_cast<std::size_t>(on_first[1])];
    if (s == on_second[0]) return {false, flip_s, flip_t};
    return {true, flip_t, flip_s};
  }

  void read_interfaces(pugi::xml_node multi_patch) {
    for (const pugi::xml_node node : multi_patch.children("interfaces")) {
      const std::string content = xml_.content(node);
      TextScanner scanner(content, xml_.source(), xml_.line(node));
      while (!scanner.at_end()) {
        const PatchFace first = face(scanner);
        const PatchFace second = face(scanner);
        result_.interfaces.push_back({first, second, orientation(scanner, first.side, second.side)});
      }
    }
  }

  void read_boundaries(pugi::xml_node multi_patch) {
    for (const pugi::xml_node node : multi_patch.children("boundary")) {
      const std::string content = xml_.content(node);
      TextScanner scanner(content, xml_.source(), xml_.line(node));
      Boundary boundary{node.attribute("name").value(), {}};
      while (!scanner.at_end()) boundary.faces.push_back(face(scanner));
      if (!boundary.name.empty()) add_boundary(std::move(boundary));
    }
  }

  void add_boundary(Boundary boundary) {
    for (Boundary& known : result_.boundaries)
      if (known.name == boundary.name) {
        known.faces.insert(known.faces.end(), boundary.faces.begin(), boundary.faces.end());
        return;
      }
    result_.boundaries.push_back(std::move(boundary));
  }

  XmlText xml_;
  std::map<int, PatchId> patch_of_id_;
  PatchSet result_;
};

}  // namespace

PatchSet read_gismo_xml(std::string_view text, const std::string& source) {
  return GismoReader(text, source).read();
}

}  // namespace isopatch::geometry
