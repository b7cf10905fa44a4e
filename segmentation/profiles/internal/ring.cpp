#include "segmentation/profiles/internal/ring.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>

#include "segmentation/profiles/internal/cell_shape.hpp"
#include "segmentation/profiles/internal/triangulate.hpp"
#include "segmentation/profiles/internal/window.hpp"

namespace isopatch::segmentation::planar {

using Eigen::Vector2d;
using std::numbers::pi;

double room_along(const Vector2d& corner, const Vector2d& way, double half_angle,
                  const std::vector<Vector2d>& outline) {
  const double sine = 0.95 * std::sin(half_angle);
  double result = refused;
  for (const Vector2d& point : outline) {
    const Vector2d to = point - corner;
    const double along = to.dot(way), root = along * along - to.squaredNorm() * (1 - sine * sine);
    if (along > 0 && root >= 0) result = std::min(result, to.squaredNorm() / (along + std::sqrt(root)));
  }
  return result;
}

namespace {

/// Quadrilaterals inside an outline, and what they leave.
struct Ring {
  CellMesh mesh;
  std::vector<int> inner;  ///< nodes around what is left, one for each corner
  int region = -1;
};

/// @param share  of the room before each corner that the ring takes
std::optional<Ring> ring_inside(const std::vector<Curve>& curves, const CellMesh& region,
                                const std::vector<bool>& shared, double share) {
  constexpr double straight = 120 * pi / 180;
  std::vector<int> cells(region.cells.size());
  std::iota(cells.begin(), cells.end(), 0);
  const auto loops = loops_of(curves, region, Neighbours(region), cells, shared);
  if (loops.size() != 1 || loops.front().size() < 4) return std::nullopt;
  const std::vector<Place>& places = loops.front();
  const std::size_t count = places.size();
  std::vector<SideShape> shapes;
  std::vector<Vector2d> outline;
  for (const Place& place : places) {
    if (place.link.curve < 0 || !shared[static_cast<std::size_t>(place.link.curve)]) return std::nullopt;
    shapes.push_back(side_shape(curves, region.nodes, place.link));
    for (int s = 0; s + 1 < SideShape::samples; ++s) outline.push_back(shapes.back().point(s));
  }
  Ring result{{region.nodes, {}}, {}, region.cells.front().region};
  for (std::size_t i = 0; i < count; ++i) {
    const double out = shapes[i].start_direction, in = shapes[(i + count - 1) % count].end_direction + pi;
    const double half = angle_between(out, in) / 2;
    if (2 * half < straight) return std::nullopt;
    const Vector2d corner = region.nodes[places[i].node].point,
                   way(std::cos(out + half), std::sin(out + half));
    const double room = room_along(corner, way, half, outline);
    if (!(room < refused)) return std::nullopt;
    result.inner.push_back(static_cast<int>(result.mesh.nodes.size()));
    result.mesh.nodes.push_back({corner + share * room * way, false, -1, 0});
  }
  for (std::size_t i = 0; i < count; ++i) {
    const int from = result.inner[i], next = result.inner[(i + 1) % count];
    const Side& side = places[i].link;
    result.mesh.cells.push_back(
        {result.region, 4, {side, Side{side.to, next}, Side{next, from}, Side{from, side.from}}});
  }
  return result;
}

using Quads = std::vector<std::array<int, 4>>;

/// All ways to divide a polygon, of an even number of corners, into quadrilaterals by its chords.
std::vector<Quads> ways_to_divide(const std::vector<int>& polygon) {
  if (polygon.size() == 2) return {{}};
  std::vector<Quads> result;
  const auto part = [&](std::size_t from, std::size_t to) {
    std::vector<int> corners;
    for (std::size_t k = from; k <= to; ++k) corners.push_back(polygon[k % polygon.size()]);
    return ways_to_divide(corners);
  };
  // What lies beyond the other sides of the quadrilateral on the first side is even in number too.
  for (std::size_t i = 2; i < polygon.size(); i += 2)
    for (std::size_t j = i + 1; j < polygon.size(); j += 2)
      for (const Quads& right : part(1, i))
        for (const Quads& top : part(i, j))
          for (const Quads& left : part(j, polygon.size())) {
            Quads all = {{polygon[0], polygon[1], polygon[i], polygon[j]}};
            for (const Quads* more : {&right, &top, &left}) all.insert(all.end(), more->begin(), more->end());
            result.push_back(std::move(all));
          }
  return result;
}

}  // namespace

std::optional<CellMesh> ring_start(const std::vector<Curve>& curves, const CellMesh& region,
                                   const std::vector<bool>& shared) {
  constexpr double share = 0.4;
  std::optional<Ring> ring = ring_inside(curves, region, shared, share);
  if (!ring || ring->inner.size() < 5) return std::nullopt;
  std::vector<Vector2d> points;
  for (const Node& node : ring->mesh.nodes) points.push_back(node.point);
  const auto core = triangulate(points, {ring->inner});
  if (!core) return std::nullopt;
  for (const std::array<int, 3>& c : *core)
    ring->mesh.cells.push_back(
        {ring->region, 3, {Side{c[0], c[1]}, Side{c[1], c[2]}, Side{c[2], c[0]}, Side{}}});
  return std::move(ring->mesh);
}

std::vector<CellMesh> rings_around_quads(const std::vector<Curve>& curves, const CellMesh& region,
                                         const std::vector<bool>& shared) {
  constexpr std::size_t most = 8;  // corners, which have 12 ways
  std::vector<CellMesh> result;
  for (const double share : {0.4, 0.7}) {
    const std::optional<Ring> ring = ring_inside(curves, region, shared, share);
    if (!ring || ring->inner.size() % 2 != 0 || ring->inner.size() > most) return {};
    for (const Quads& way : ways_to_divide(ring->inner)) {
      CellMesh mesh = ring->mesh;
      for (const std::array<int, 4>& c : way)
        mesh.cells.push_back(
            {ring->region, 4, {Side{c[0], c[1]}, Side{c[1], c[2]}, Side{c[2], c[3]}, Side{c[3], c[0]}}});
      result.push_back(std::move(mesh));
    }
  }
  return result;
}

}  // namespace isopatch::segmentation::planar
