#include "segmentation/reconstruction/internal/solid_of_regions.hpp"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "segmentation/reconstruction/internal/carrier_distance.hpp"
#include "segmentation/reconstruction/internal/freeform_faces.hpp"
#include "segmentation/reconstruction/internal/meeting_point.hpp"
#include "segmentation/reconstruction/internal/seams.hpp"
#include "segmentation/reconstruction/internal/wireframe.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Carrier;
using geometry::CarrierSolid;

constexpr int edge_intervals = CarrierSolid::points_of_edge - 1;
constexpr int most_edge_pieces = 16;
// A vertex of the mesh is off the corner by some tolerances, which are shares of the size.
constexpr double farthest_corner = 1e-4;

/// Of those that are not freeform.
std::vector<Carrier> carriers_of(const Regions& regions, const std::vector<int>& numbers) {
  std::vector<Carrier> result;
  for (const int r : numbers)
    if (const auto& carrier = regions.regions[static_cast<std::size_t>(r)].carrier)
      result.push_back(*carrier);
  return result;
}

/// Points at even distances along a polygon.
Eigen::Matrix3Xd evenly(const std::vector<Eigen::Vector3d>& polygon, int intervals) {
  std::vector<double> length{0};
  for (std::size_t i = 1; i < polygon.size(); ++i)
    length.push_back(length.back() + (polygon[i] - polygon[i - 1]).norm());
  Eigen::Matrix3Xd result(3, intervals + 1);
  std::size_t at = 1;
  for (int k = 0; k <= intervals; ++k) {
    const double wanted = length.back() * k / intervals;
    while (at + 1 < polygon.size() && length[at] < wanted) ++at;
    const double piece = length[at] - length[at - 1];
    const double share = piece > 0 ? std::clamp((wanted - length[at - 1]) / piece, 0.0, 1.0) : 0;
    result.col(k) = polygon[at - 1] + share * (polygon[at] - polygon[at - 1]);
  }
  result.col(0) = polygon.front();
  result.col(intervals) = polygon.back();
  return result;
}

/// Corners move to where their surfaces meet. They were near it; where many surfaces touch in one point, it
/// may be found elsewhere.
void sharpen_corners(Wireframe& wires, const Regions& regions, double size) {
  for (std::size_t v = 0; v < wires.vertices.size(); ++v) {
    const Eigen::Vector3d sharp =
        meeting_point(carriers_of(regions, wires.regions_at[v]), wires.vertices[v], size);
    if ((sharp - wires.vertices[v]).norm() <= farthest_corner * size) wires.vertices[v] = sharp;
  }
  for (WireEdge& edge : wires.edges) {
    edge.points.front() = wires.vertices[static_cast<std::size_t>(edge.start)];
    edge.points.back() = wires.vertices[static_cast<std::size_t>(edge.end)];
    const std::vector<Carrier> both = carriers_of(regions, {edge.regions[0], edge.regions[1]});
    if (both.size() == 1)
      for (std::size_t i = 1; i + 1 < edge.points.size(); ++i)
        edge.points[i] = meeting_point(both, edge.points[i], size);
  }
}

/// The normal of the planes that both ends of an edge are in, if these are parallel.
std::optional<Eigen::Vector3d> between_planes(const Wireframe& wires, const Regions& regions,
                                              const WireEdge& edge) {
  for (const int a : wires.regions_at[static_cast<std::size_t>(edge.start)])
    for (const int b : wires.regions_at[static_cast<std::size_t>(edge.end)]) {
      const auto &first = regions.regions[static_cast<std::size_t>(a)].carrier,
                 &second = regions.regions[static_cast<std::size_t>(b)].carrier;
      if (!first || !second || first->kind != geometry::SurfaceKind::plane ||
          second->kind != geometry::SurfaceKind::plane)
        continue;
      const double rise = first->axis.dot(edge.points.back() - edge.points.front());
      if (first->axis.cross(second->axis).norm() < 1e-12 &&
          std::abs(rise) > 0.999 * (edge.points.back() - edge.points.front()).norm())
        return first->axis;
    }
  return std::nullopt;
}

/// Straight edges of freeform faces that run at right angles from one plane to another do so exactly: what
/// lies over each other is to be drawn as one.
void make_upright(Wireframe& wires, const Regions& regions, double tolerance) {
  for (WireEdge& edge : wires.edges) {
    if (edge.points.size() < 2 || carriers_of(regions, {edge.regions[0], edge.regions[1]}).size() == 2)
      continue;
    const auto up = between_planes(wires, regions, edge);
    if (!up) continue;
    const Eigen::Vector3d way = edge.points.back() - edge.points.front(), aside = way - *up * up->dot(way);
    const bool straight = std::all_of(edge.points.begin(), edge.points.end(), [&](const Eigen::Vector3d& p) {
      return way.cross(p - edge.points.front()).norm() <= tolerance * way.norm();
    });
    if (aside.norm() > tolerance || !straight) continue;
    edge.points.front() += aside / 2;
    for (const Carrier& carrier : carriers_of(regions, {edge.regions[0], edge.regions[1]})) {
      const CarrierDistance off = carrier_distance(carrier, edge.points.front());
      const Eigen::Vector3d flat = off.gradient - *up * up->dot(off.gradient);
      edge.points.front() -= off.value * flat;
    }
    const double height = up->dot(way);
    edge.points = {edge.points.front(), edge.points.front() + height * *up};
    edge.of_mesh = {edge.of_mesh.front(), edge.of_mesh.back()};
    wires.vertices[static_cast<std::size_t>(edge.start)] = edge.points.front();
    wires.vertices[static_cast<std::size_t>(edge.end)] = edge.points.back();
  }
  for (WireEdge& edge : wires.edges) {
    edge.points.front() = wires.vertices[static_cast<std::size_t>(edge.start)];
    edge.points.back() = wires.vertices[static_cast<std::size_t>(edge.end)];
  }
}

Eigen::Matrix3Xd along(const geometry::NurbsCurve& curve) {
  Eigen::Matrix3Xd points(3, edge_intervals + 1);
  const geometry::Parameter<1> low = curve.low(), high = curve.high();
  for (int i = 0; i <= edge_intervals; ++i)
    points.col(i) = curve.point(low + (high - low) * i / edge_intervals);
  return points;
}

/// Many points where the two surfaces meet.
Eigen::Matrix3Xd exact_points(const WireEdge& edge, const Regions& regions, double size) {
  if (edge.points.empty()) return {};
  if (edge.curve) return along(*edge.curve);
  if (edge.on_carrier.cols() > 0) return edge.on_carrier;
  const bool seam = edge.regions[0] == edge.regions[1];
  const int pieces = std::clamp(static_cast<int>(edge.points.size()) / 8, 1, most_edge_pieces);
  Eigen::Matrix3Xd points = evenly(edge.points, seam ? edge_intervals : pieces * edge_intervals);
  if (seam) {
    for (Eigen::Index i = 0; i < points.cols(); ++i) points.col(i) = edge.points[static_cast<std::size_t>(i)];
    return points;
  }
  const std::vector<Carrier> both = carriers_of(regions, {edge.regions[0], edge.regions[1]});
  for (Eigen::Index i = 1; i + 1 < points.cols(); ++i)
    points.col(i) = meeting_point(both, points.col(i), size);
  return points;
}

}  // namespace

std::vector<std::string> face_names(const Regions& regions) {
  std::map<std::string, int> count;
  std::vector<std::string> result;
  for (const Region& region : regions.regions) {
    const std::string kind = region.carrier ? geometry::name(region.carrier->kind) : "freeform";
    result.push_back(fmt::format("{}_{}", kind, ++count[kind]));
  }
  return result;
}

CarrierSolid solid_of_regions(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                              Regions& regions, double tolerance, const Progress& progress) {
  const double size = geometry::diagonal(mesh);
  Wireframe wires = wireframe(mesh, neighbours, regions);
  sharpen_corners(wires, regions, size);
  make_upright(wires, regions, tolerance);
  add_seams(wires, regions, mesh, size);
  add_freeform_faces(mesh, neighbours, wires, regions, tolerance, size, progress);
  CarrierSolid solid;
  solid.vertices.resize(3, static_cast<Eigen::Index>(wires.vertices.size()));
  for (std::size_t v = 0; v < wires.vertices.size(); ++v)
    solid.vertices.col(static_cast<Eigen::Index>(v)) = wires.vertices[v];
  for (const WireEdge& edge : wires.edges)
    solid.edges.push_back(
        {VertexId(edge.start), VertexId(edge.end), exact_points(edge, regions, size), edge.curve});
  const std::vector<std::string> names = face_names(regions);
  for (std::size_t r = 0; r < regions.regions.size(); ++r)
    solid.faces.push_back({names[r], regions.regions[r].carrier.value_or(Carrier{}),
                           regions.regions[r].reversed, wires.loops[r], regions.regions[r].spline});
  return solid;
}

}  // namespace isopatch::segmentation
