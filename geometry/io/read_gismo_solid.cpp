#include "geometry/io/read_gismo_solid.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "geometry/io/internal/gismo_elements.hpp"
#include "geometry/io/reader_limits.hpp"

namespace isopatch::geometry {
namespace {

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
    result.surface = spline_surface(required_child(xml_, node, "Geometry", name), name);
    const pugi::xml_node domain = required_child(xml_, node, "PlanarDomain", name);
    for (const pugi::xml_node loop : domain.children("CurveLoop")) {
      const std::string loop_name = fmt::format("{}, loop {}", name, result.loops.size());
      std::vector<NurbsCurve> curves;
      for (const pugi::xml_node curve : loop.children("Geometry"))
        curves.push_back(domain_curve(curve, fmt::format("{}, curve {}", loop_name, curves.size())));
      if (curves.empty()) xml_.fail(loop, fmt::format("{} has no curve", loop_name));
      result.loops.push_back(std::move(curves));
    }
    if (result.loops.empty()) xml_.fail(domain, fmt::format("{} has no loop", name));
    return result;
  }

  NurbsSurface spline_surface(pugi::xml_node geometry, const std::string& name) const {
    const bool rational = is_rational(geometry, "TensorBSpline2", "TensorNurbs2", name);
    const pugi::xml_node outer = required_child(xml_, geometry, "Basis", name);
    auto knots = given_knots<2>(xml_, rational ? required_child(xml_, outer, "Basis", name) : outer, name);
    return spline<2>(geometry, rational ? outer : pugi::xml_node(), std::move(knots), 3, name);
  }

  NurbsCurve domain_curve(pugi::xml_node geometry, const std::string& name) const {
    const bool rational = is_rational(geometry, "BSpline", "NURBS", name);
    const pugi::xml_node outer = required_child(xml_, geometry, "Basis", name);
    const pugi::xml_node basis = rational ? required_child(xml_, outer, "Basis", name) : outer;
    std::array<GivenKnots, 1> knots = {
        given_knots(xml_, required_child(xml_, basis, "KnotVector", name), name)};
    return spline<1>(geometry, rational ? outer : pugi::xml_node(), std::move(knots), 2, name);
  }

  template <std::size_t D>
  Nurbs<static_cast<int>(D)> spline(pugi::xml_node geometry, pugi::xml_node rational_basis,
                                    std::array<GivenKnots, D> knots, int coordinates,
                                    const std::string& name) const {
    std::int64_t count = 1;
    for (const GivenKnots& given : knots) {
      const auto functions = static_cast<std::int64_t>(given.knots.size()) - given.degree - 1;
      if (functions <= given.degree || count > max_control_points / functions)
        throw Error(ErrorCode::bad_format,
                    fmt::format("{}:{}: {}: {} knots do not suit degree {}", xml_.source(), given.line, name,
                                given.knots.size(), given.degree));
      count *= functions;
    }
    Eigen::Matrix4Xd points = control_points(geometry, rational_basis, coordinates, count, name);
    std::int64_t inner = 1;
    for (GivenKnots& given : knots) {
      join_pieces(given, points, inner);
      inner *= static_cast<std::int64_t>(given.knots.size()) - given.degree - 1;
    }
    typename Nurbs<static_cast<int>(D)>::KnotVectors checked;
    for (std::size_t d = 0; d < D; ++d) checked[d] = knot_vector(xml_, knots[d], name);
    return located(xml_.source(), xml_.line(geometry), name, [&] {
      return Nurbs<static_cast<int>(D)>(std::move(checked), points.topRows<3>(), points.row(3).transpose());
    });
  }

  // Some files part a spline at a knot of multiplicity degree + 1 and say the points there twice; once is
  // enough. `inner` control points of the directions before run faster.
  static void join_pieces(GivenKnots& given, Eigen::Matrix4Xd& points, std::int64_t inner) {
    const auto order = static_cast<std::size_t>(given.degree) + 1;
    for (std::size_t i = order; i + 2 * order <= given.knots.size(); ++i) {
      if (given.knots[i] != given.knots[i + order - 1]) continue;
      const auto size = static_cast<std::int64_t>(given.knots.size() - order);
      const auto repeated =
          static_cast<std::int64_t>(i);  // the control point that begins the piece behind the knot
      std::vector<std::int64_t> kept;
      bool equal = true;
      for (std::int64_t k = 0; k < points.cols(); ++k) {
        if (k / inner % size == repeated)
          equal = equal && points.col(k) == points.col(k - inner);
        else
          kept.push_back(k);
      }
      if (!equal) continue;
      points = Eigen::Matrix4Xd(points(Eigen::all, kept));
      given.knots.erase(given.knots.begin() + static_cast<std::ptrdiff_t>(i));
    }
  }

  bool is_rational(pugi::xml_node geometry, std::string_view plain, std::string_view rational,
                   const std::string& name) const {
    const std::string_view type = geometry.attribute("type").value();
    if (type != plain && type != rational)
      xml_.fail(geometry,
                fmt::format("{} is of type {}; {} and {} are supported", name, quoted(type), plain, rational),
                ErrorCode::unsupported);
    return type == rational;
  }

  // Points, with a third coordinate 0 if they have two, and weights: (4, count).
  Eigen::Matrix4Xd control_points(pugi::xml_node geometry, pugi::xml_node rational_basis, int coordinates,
                                  std::int64_t count, const std::string& name) const {
    const pugi::xml_node node = required_child(xml_, geometry, "coefs", name);
    if (const int dimension = xml_.integer_attribute(node, "geoDim", 1, 1000); dimension != coordinates)
      xml_.fail(
          node,
          fmt::format("{} has control points in {} dimensions; {} are needed", name, dimension, coordinates),
          ErrorCode::unsupported);
    // Read first: that many numbers must be there before memory is asked for them.
    const Eigen::MatrixXd given = numbers(xml_, node, coordinates, count, name + ", control point");
    Eigen::Matrix4Xd result = Eigen::Matrix4Xd::Zero(4, count);
    result.topRows(coordinates) = given;
    result.row(3).setOnes();
    if (rational_basis)
      result.row(3) =
          numbers(xml_, required_child(xml_, rational_basis, "weights", name), 1, count, name + ", weight");
    return result;
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
    while (!scanner.at_end()) values.push_back(scanner.fraction("a coordinate"));
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
      face.corners.resize(
          static_cast<std::size_t>(scanner.integer("the number of corners of " + what, 1, 10'000)));
      for (int& corner : face.corners) corner = scanner.integer("a corner of " + what, 0, vertices - 1);
      const int id = scanner.integer("the surface of " + what, -1, max_id);
      if (id >= 0) {
        const auto found = surfaces_.find(id);
        if (found == surfaces_.end())
          scanner.fail(fmt::format("{} lies on surface {}, which the file lacks", what, id));
        face.surface = found->second;
      } else if (face.corners.size() < 3) {
        scanner.fail(
            fmt::format("{} has {} corners; without a surface it needs three", what, face.corners.size()));
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
        std::vector<int> volume(
            static_cast<std::size_t>(scanner.integer("the number of faces of " + what, 1, faces)));
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
