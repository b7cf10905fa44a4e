#include "geometry/io/read_gismo_solid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "geometry/io/internal/gismo_elements.hpp"
#include "geometry/io/reader_limits.hpp"

namespace isopatch::geometry {
namespace {

constexpr int max_id = 2'000'000'000;

bool is_trimmed_surface(pugi::xml_node node) {
  return std::string_view(node.name()) == "TrimSurface" ||
         std::string_view(node.attribute("type").value()) == "TrimSurface";
}

/// A face of a `Solid`: its corners and, unless the surface is to be made from them, the surface.
struct ListedFace {
  std::vector<int> corners;
  std::optional<TrimmedSurface> surface;
};

class SolidReader {
 public:
  SolidReader(std::string_view text, const std::string& source) : xml_(text, source) {}

  std::vector<SolidBoundary> read() {
    const pugi::xml_node root = xml_.root();
    if (std::string_view(root.name()) != "xml")
      xml_.fail(root, fmt::format("the root element is <{}>; G+Smo files have <xml>", root.name()));
    read_surfaces(root);
    std::vector<SolidBoundary> result;
    for (const pugi::xml_node solid : root.children("Solid"))
      for (SolidBoundary& boundary : solids(solid)) result.push_back(std::move(boundary));
    if (result.empty()) result.push_back(all_surfaces());
    if (result.size() > 1)
      for (std::size_t i = 0; i < result.size(); ++i) result[i].name = fmt::format("volume {}", i);
    return result;
  }

 private:
  void read_surfaces(pugi::xml_node root) {
    for (const pugi::xml_node node : root.children()) {
      if (!is_trimmed_surface(node)) continue;
      const int id = node.attribute("id") ? xml_.integer_attribute(node, "id", 0, max_id)
                                          : static_cast<int>(surfaces_.size());
      if (!surfaces_.emplace(id, surface(node, fmt::format("trimmed surface {}", id))).second)
        xml_.fail(node, fmt::format("a second trimmed surface with id {}", id));
    }
  }

  SolidBoundary all_surfaces() const {
    if (surfaces_.empty())
      xml_.fail(xml_.root(), "no Solid and no TrimSurface element", ErrorCode::unsupported);
    SolidBoundary result;
    for (const auto& [id, surface] : surfaces_) result.surfaces.emplace_back(surface);
    return result;
  }

  TrimmedSurface surface(pugi::xml_node node, const std::string& name) const {
    TrimmedSurface result;
    result.surface = spline<2>(required_child(xml_, node, "Geometry", name), 3, name);
    const pugi::xml_node domain = required_child(xml_, node, "PlanarDomain", name);
    for (const pugi::xml_node loop : domain.children("CurveLoop")) {
      const std::string loop_name = fmt::format("{}, loop {}", name, result.loops.size());
      std::vector<NurbsCurve> curves;
      for (const pugi::xml_node curve : loop.children("Geometry"))
        curves.push_back(spline<1>(curve, 2, fmt::format("{}, curve {}", loop_name, curves.size())));
      if (curves.empty()) xml_.fail(loop, fmt::format("{} has no curve", loop_name));
      result.loops.push_back(std::move(curves));
    }
    if (result.loops.empty()) xml_.fail(domain, fmt::format("{} has no loop", name));
    return result;
  }

  // A curve or surface; points in the plane get a third coordinate 0.
  template <int D>
  Nurbs<D> spline(pugi::xml_node geometry, int coordinates, const std::string& name) const {
    const std::string_view type = geometry.attribute("type").value();
    const std::string_view plain = D == 1 ? "BSpline" : "TensorBSpline2";
    const std::string_view with_weights = D == 1 ? "NURBS" : "TensorNurbs2";
    const bool rational = type == with_weights || (D == 1 && type == "Nurbs");
    if (!rational && type != plain)
      xml_.fail(geometry, fmt::format("{} is of type {}; {} and {} are supported", name, quoted(type), plain, with_weights),
                ErrorCode::unsupported);
    const pugi::xml_node outer = required_child(xml_, geometry, "Basis", name);
    const pugi::xml_node basis = rational ? required_child(xml_, outer, "Basis", name) : outer;
    typename Nurbs<D>::KnotVectors knots;
    if constexpr (D == 1)
      knots[0] = knot_vector(xml_, required_child(xml_, basis, "KnotVector", name), name);
    else
      knots = knot_vectors<D>(xml_, basis, name);
    std::int64_t count = 1;
    for (const KnotVector& k : knots) count *= k.size();
    if (count > max_control_points) xml_.fail(basis, fmt::format("{}: more than {} control points", name, max_control_points));
    const pugi::xml_node coefficients = required_child(xml_, geometry, "coefs", name);
    if (const int dimension = xml_.integer_attribute(coefficients, "geoDim", 1, 1000); dimension != coordinates)
      xml_.fail(coefficients, fmt::format("{} has control points in {} dimensions; {} are needed", name, dimension, coordinates),
                ErrorCode::unsupported);
    Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, count);
    points.topRows(coordinates) = numbers(xml_, coefficients, coordinates, count, name + ", control point");
    Eigen::VectorXd weights = Eigen::VectorXd::Ones(count);
    if (rational)
      weights = numbers(xml_, required_child(xml_, outer, "weights", name), 1, count, name + ", weight").transpose();
    return located(xml_.source(), xml_.line(coefficients), name,
                   [&] { return Nurbs<D>(std::move(knots), std::move(points), std::move(weights)); });
  }

  std::vector<SolidBoundary> solids(pugi::xml_node solid) const {
    const Eigen::Matrix3Xd vertices = points(required_child(xml_, solid, "Vertex", "the solid"));
    const std::vector<ListedFace> faces =
        listed_faces(required_child(xml_, solid, "Face", "the solid"), static_cast<int>(vertices.cols()));
    std::vector<SolidBoundary> result;
    for (const std::vector<int>& volume : volumes(solid.child("Volume"), static_cast<int>(faces.size()))) {
      SolidBoundary boundary;
      boundary.corners.vertices = vertices;
      for (const int face : volume) {
        boundary.corners.faces.push_back(faces[static_cast<std::size_t>(face)].corners);
        boundary.surfaces.push_back(faces[static_cast<std::size_t>(face)].surface);
      }
      result.push_back(std::move(boundary));
    }
    return result;
  }

  Eigen::Matrix3Xd points(pugi::xml_node node) const {
    const std::string content = xml_.content(node);
    TextScanner scanner(content, xml_.source(), xml_.line(node));
    std::vector<double> values;
    while (!scanner.at_end()) values.push_back(scanner.number("a coordinate"));
    if (values.size() % 3 != 0 || values.empty())
      xml_.fail(node, fmt::format("{} coordinates; a vertex has three", values.size()));
    return Eigen::Map<const Eigen::Matrix3Xd>(values.data(), 3, static_cast<Eigen::Index>(values.size() / 3));
  }

  std::vector<ListedFace> listed_faces(pugi::xml_node node, int vertices) const {
    const std::string content = xml_.content(node);
    TextScanner scanner(content, xml_.source(), xml_.line(node));
    std::vector<ListedFace> result;
    while (!scanner.at_end()) {
      const std::string what = fmt::format("face {}", result.size());
      ListedFace face;
      face.corners.resize(static_cast<std::size_t>(scanner.integer("the number of corners of " + what, 1, 10'000)));
      for (int& corner : face.corners) corner = scanner.integer("a corner of " + what, 0, vertices - 1);
      const int id = scanner.integer("the surface of " + what, -1, max_id);
      if (id >= 0) {
        const auto found = surfaces_.find(id);
        if (found == surfaces_.end()) scanner.fail(fmt::format("{} lies on surface {}, which the file lacks", what, id));
        face.surface = found->second;
      } else if (face.corners.size() < 3) {
        scanner.fail(fmt::format("{} has {} corners; without a surface it needs three", what, face.corners.size()));
      }
      result.push_back(std::move(face));
    }
    return result;
  }

  // The faces of each volume, increasing; all in one where there is no list.
  std::vector<std::vector<int>> volumes(pugi::xml_node node, int faces) const {
    std::vector<std::vector<int>> result;
    if (node) {
      const std::string content = xml_.content(node);
      TextScanner scanner(content, xml_.source(), xml_.line(node));
      while (!scanner.at_end()) {
        const std::string what = fmt::format("volume {}", result.size());
        std::vector<int> volume(static_cast<std::size_t>(scanner.integer("the number of faces of " + what, 1, faces)));
        for (int& face : volume) face = scanner.integer("a face of " + what, 0, faces - 1);
        std::sort(volume.begin(), volume.end());
        result.push_back(std::move(volume));
      }
    }
    if (result.empty()) {
      result.emplace_back();
      for (int i = 0; i < faces; ++i) result[0].push_back(i);
    }
    return result;
  }

  XmlText xml_;
  std::map<int, TrimmedSurface> surfaces_;
};

}  // namespace

bool is_gismo_solid(std::string_view text) {
  return text.find("TensorBSpline3") == text.npos && text.find("TensorNurbs3") == text.npos &&
         (text.find("<Solid") != text.npos || text.find("TrimSurface") != text.npos);
}

std::vector<SolidBoundary> read_gismo_solids(std::string_view text, const std::string& source) {
  return SolidReader(text, source).read();
}

}  // namespace isopatch::geometry
