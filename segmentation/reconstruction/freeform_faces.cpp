#include "segmentation/reconstruction/internal/freeform_faces.hpp"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "geometry/base/error.hpp"
#include "segmentation/reconstruction/internal/chord_error.hpp"
#include "segmentation/reconstruction/internal/fit_surface.hpp"
#include "segmentation/reconstruction/internal/freeform_edges.hpp"
#include "segmentation/reconstruction/internal/region_map.hpp"
#include "segmentation/reconstruction/internal/ruled_strip.hpp"
#include "segmentation/reconstruction/internal/steady_curve.hpp"

namespace isopatch::segmentation {
namespace {

// Weight in the fit of an edge as long as the distance between inner vertices; an inner vertex has 1. Edges
// count for more since two faces share them.
constexpr double edge_weight = 4;
// How far a fitted surface may be off the vertices: this share of the chord error (being nearer says nothing
// of the solid), and at most this share of the size.
constexpr double chord_share = 0.02, most_off = 1e-4;
// Edges are off their faces by this share of the size at most.
constexpr double widest_edge_gap = 1e-3;

[[noreturn]] void refuse_freeform(const geometry::TriangleMesh& mesh, const Region& region,
                                  const std::string& why) {
  Eigen::Vector3d middle = Eigen::Vector3d::Zero();
  for (const int t : region.triangles)
    middle += mesh.vertices.col(mesh.triangles(0, t)) / double(region.triangles.size());
  throw Error(
      ErrorCode::unsupported,
      fmt::format("a face of {} triangles and {:.4g} m^2 around ({:.6g}, {:.6g}, {:.6g}) m is no plane, "
                  "cylinder, cone, sphere or torus, and as a freeform face {}",
                  region.triangles.size(), region.area, middle.x(), middle.y(), middle.z(), why));
}

/// A freeform face that its edges trim.
class TrimmedFace {
 public:
  TrimmedFace(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
              const Wireframe& wires, Regions& regions, int region)
      : mesh_(mesh), neighbours_(neighbours), wires_(wires), regions_(regions), region_(region) {}

  void make(double tolerance, double size) {
    Region& region = regions_.regions[static_cast<std::size_t>(region_)];
    const auto map = region_map(mesh_, neighbours_, regions_, region_, corners());
    if (!map) refuse_freeform(mesh_, region, "it has no border, or one that touches itself");
    const PlacedPoints points = placed(*map);
    const double chord = chord_error(mesh_, neighbours_, regions_, region_);
    const FittedSurface fit =
        fit_surface(points, std::max(tolerance, std::min(chord_share * chord, most_off * size)));
    const auto inside = static_cast<Eigen::Index>(map->vertices.size());
    const double off = fit.off.head(inside).maxCoeff(),
                 off_edges = fit.off.tail(fit.off.size() - inside).maxCoeff(), allowed = tolerance + chord;
    if (off > allowed || off_edges > std::max(allowed, widest_edge_gap * size))
      refuse_freeform(
          mesh_, region,
          fmt::format("it comes no nearer to its vertices than {:.2g} m, where triangles are within "
                      "{:.2g} m of a smooth surface; divide it along its sharpest bends",
                      std::max(off, off_edges), allowed));
    region.spline = fit.surface;
    region.reversed = false;
  }

 private:
  /// Vertices of the mesh in which an edge of the face ends.
  std::vector<int> corners() const {
    std::vector<int> result;
    for (const auto& loop : wires_.loops[static_cast<std::size_t>(region_)])
      for (const geometry::EdgeUse& use : loop)
        for (const int v : {edge(use).of_mesh.front(), edge(use).of_mesh.back()})
          if (v >= 0) result.push_back(v);
    return result;
  }
  const WireEdge& edge(const geometry::EdgeUse& use) const {
    return wires_.edges[static_cast<std::size_t>(use.edge.value)];
  }

  /// The region's vertices, then points of its edges.
  PlacedPoints placed(const RegionMap& map) const {
    std::map<int, Eigen::Index> number;
    for (std::size_t i = 0; i < map.vertices.size(); ++i)
      number.emplace(map.vertices[i], static_cast<Eigen::Index>(i));
    const auto inside = static_cast<Eigen::Index>(map.vertices.size());
    PlacedPoints result{mesh_.vertices(Eigen::all, map.vertices), map.places, Eigen::VectorXd::Ones(inside)};
    const double spacing =
        std::sqrt(regions_.regions[static_cast<std::size_t>(region_)].area / double(inside));
    for (const auto& loop : wires_.loops[static_cast<std::size_t>(region_)])
      for (const geometry::EdgeUse& use : loop) {
        const Eigen::Matrix3Xd points = points_along(edge(use));
        const Eigen::Matrix2Xd places = places_along(edge(use), points, map.places, number);
        const Eigen::Index known = result.points.cols();
        result.points.conservativeResize(3, known + points.cols());
        result.places.conservativeResize(2, known + points.cols());
        result.points.rightCols(points.cols()) = points;
        result.places.rightCols(points.cols()) = places;
        result.weights.conservativeResize(result.points.cols());
        const double length =
            (points.rightCols(points.cols() - 1) - points.leftCols(points.cols() - 1)).colwise().norm().sum();
        result.weights.tail(points.cols())
            .setConstant(edge_weight * length / spacing / double(points.cols()));
      }
    return result;
  }

  /// Between those of the edge's vertices of the mesh, by length.
  static Eigen::Matrix2Xd places_along(const WireEdge& edge, const Eigen::Matrix3Xd& points,
                                       const Eigen::Matrix2Xd& places,
                                       const std::map<int, Eigen::Index>& number) {
    std::vector<double> way{0}, known;
    std::vector<Eigen::Index> columns;
    for (std::size_t i = 0; i < edge.points.size(); ++i) {
      if (i > 0) way.push_back(way.back() + (edge.points[i] - edge.points[i - 1]).norm());
      const auto found = number.find(edge.of_mesh[i]);
      if (found == number.end()) continue;
      known.push_back(way[i]);
      columns.push_back(found->second);
    }
    Eigen::Matrix2Xd result(2, points.cols());
    if (columns.empty()) columns.push_back(0);
    if (columns.size() == 1) return places.col(columns.front()).replicate(1, points.cols());
    double at = 0, length = 0;
    for (Eigen::Index i = 1; i < points.cols(); ++i) length += (points.col(i) - points.col(i - 1)).norm();
    std::size_t k = 1;
    for (Eigen::Index i = 0; i < points.cols(); ++i) {
      if (i > 0) at += (points.col(i) - points.col(i - 1)).norm() * way.back() / length;
      while (k + 1 < known.size() && known[k] < at) ++k;
      const double share = std::clamp((at - known[k - 1]) / (known[k] - known[k - 1]), 0.0, 1.0);
      result.col(i) = (1 - share) * places.col(columns[k - 1]) + share * places.col(columns[k]);
    }
    return result;
  }

  const geometry::TriangleMesh& mesh_;
  const geometry::MeshNeighbours& neighbours_;
  const Wireframe& wires_;
  Regions& regions_;
  int region_;
};

/// Edges of freeform faces have no waves between the vertices that they run along.
void require_steady_edges(const geometry::TriangleMesh& mesh, const Wireframe& wires,
                          const Regions& regions) {
  for (const WireEdge& edge : wires.edges) {
    if (!edge.curve || edge.points.size() < 2) continue;
    const Eigen::Map<const Eigen::Matrix3Xd> polygon(edge.points.front().data(), 3,
                                                     static_cast<Eigen::Index>(edge.points.size()));
    for (const int r : edge.regions) {
      const Region& region = regions.regions[static_cast<std::size_t>(r)];
      if (region.carrier) continue;
      const Eigen::Matrix3Xd line = points_along(edge);
      if (waviness(line, polygon) > most_waviness)
        refuse_freeform(
            mesh, region,
            fmt::format("an edge of it has waves between its vertices: {:.3g} m of curve for "
                        "{:.3g} m of edges of triangles; more triangles along it would tell its way",
                        length_of(line), length_of(polygon)));
    }
  }
}

}  // namespace

void add_freeform_faces(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                        Wireframe& wires, Regions& regions, double tolerance, double size,
                        const Progress& progress) {
  const auto is_open = [&](std::size_t r) {
    return !regions.regions[r].carrier && !regions.regions[r].spline;
  };
  for (std::size_t r = 0; r < regions.regions.size(); ++r) {
    if (!is_open(r)) continue;
    const auto strip = ruled_strip(mesh, neighbours, wires, regions, static_cast<int>(r), tolerance);
    if (!strip) continue;
    regions.regions[r].spline = strip->surface;
    regions.regions[r].reversed = false;
    for (std::size_t i = 0; i < 4; ++i)
      wires.edges[static_cast<std::size_t>(strip->edges[i])].curve = strip->curves[i];
  }
  add_freeform_edges(wires, regions, tolerance, size);
  require_steady_edges(mesh, wires, regions);
  for (std::size_t r = 0; r < regions.regions.size(); ++r) {
    progress("fitting freeform faces", double(r) / double(regions.regions.size()));
    if (is_open(r)) TrimmedFace(mesh, neighbours, wires, regions, static_cast<int>(r)).make(tolerance, size);
  }
}

}  // namespace isopatch::segmentation
