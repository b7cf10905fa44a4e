#include "segmentation/reconstruction/internal/chance_planes.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace isopatch::segmentation {
namespace {

using geometry::TriangleSide;

// A plane of more triangles is no chance.
constexpr std::size_t few_triangles = 8;
// One of so many times the area of the triangles beside it is a face, unless its border says otherwise.
constexpr double face_ratio = 10;
// One of so many is a face whatever its border is like: tangent rounds around a plane bend its border as
// well.
constexpr double largest_ratio = 50;
// A border that turns by more in a vertex of the mesh has a corner there.
constexpr double border_corner = 0.8;  // rad, 46 degrees

/// What a plane has in common with one freeform face.
struct SmoothBorder {
  std::map<int, int> next;  ///< along the plane's border, vertices
  double length = 0;        ///< m
  double area = 0;          ///< of the triangles across, m^2
};

class ChancePlanes {
 public:
  ChancePlanes(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
               const Regions& regions, Angle smooth, double tolerance)
      : mesh_(mesh),
        neighbours_(neighbours),
        regions_(regions),
        least_cosine_(std::cos(smooth.radians())),
        tolerance_(tolerance) {}

  /// The freeform region that a plane belongs to, -1 for none.
  int belongs_to(int plane) const {
    const Region& region = regions_.regions[static_cast<std::size_t>(plane)];
    if (!region.carrier || region.carrier->kind != geometry::SurfaceKind::plane ||
        region.triangles.size() > few_triangles)
      return -1;
    double smooth_length = 0;
    const std::map<int, SmoothBorder> borders = smooth_borders(region, smooth_length);
    int best = -1;
    double longest = 0;
    for (const auto& [other, border] : borders) {
      if (regions_.regions[static_cast<std::size_t>(other)].area < region.area || border.length < longest)
        continue;
      const double mean = border.area / double(border.next.size());
      const bool is_small = region.area < face_ratio * mean && 2 * border.length > smooth_length;
      if (!is_small && !(region.area < largest_ratio * mean && is_bent(border))) continue;
      best = other;
      longest = border.length;
    }
    return best;
  }

 private:
  Eigen::Vector3d point(int v) const { return mesh_.vertices.col(v); }

  /// By freeform region.
  std::map<int, SmoothBorder> smooth_borders(const Region& region, double& smooth_length) const {
    std::map<int, SmoothBorder> result;
    const int own = regions_.of_triangle[static_cast<std::size_t>(region.triangles.front())];
    for (const int t : region.triangles)
      for (int i = 0; i < 3; ++i) {
        const TriangleSide across =
            neighbours_.across[static_cast<std::size_t>(t)][static_cast<std::size_t>(i)];
        const int other = regions_.of_triangle[static_cast<std::size_t>(across.triangle)];
        const Eigen::Vector3d there = geometry::area_vector(mesh_, across.triangle);
        if (other == own || !(there.dot(region.carrier->axis) > least_cosine_ * there.norm())) continue;
        const int a = mesh_.triangles(i, t), b = mesh_.triangles((i + 1) % 3, t);
        const double length = (point(b) - point(a)).norm();
        smooth_length += length;
        if (regions_.regions[static_cast<std::size_t>(other)].carrier) continue;
        SmoothBorder& border = result[other];
        border.next[a] = b;
        border.length += length;
        border.area += there.norm() / 2;
      }
    return result;
  }

  /// Whether a piece between corners is no line.
  bool is_bent(const SmoothBorder& border) const {
    for (const auto& [a, b] : border.next) {
      const auto after = border.next.find(b);
      if (after == border.next.end()) continue;
      const Eigen::Vector3d first = point(b) - point(a), second = point(after->second) - point(b);
      const double turn = std::atan2(first.cross(second).norm(), first.dot(second));
      if (turn < border_corner && turn * std::fmin(first.norm(), second.norm()) > tolerance_) return true;
    }
    return false;
  }

  const geometry::TriangleMesh& mesh_;
  const geometry::MeshNeighbours& neighbours_;
  const Regions& regions_;
  double least_cosine_, tolerance_;
};

}  // namespace

Regions without_chance_planes(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                              Regions regions, Angle smooth, double tolerance) {
  const ChancePlanes planes(mesh, neighbours, regions, smooth, tolerance);
  std::vector<std::pair<std::size_t, std::size_t>> moves;
  for (std::size_t r = 0; r < regions.regions.size(); ++r)
    if (const int other = planes.belongs_to(static_cast<int>(r)); other >= 0)
      moves.emplace_back(r, static_cast<std::size_t>(other));
  for (const auto& [from, to] : moves) {
    Region &plane = regions.regions[from], &freeform = regions.regions[to];
    freeform.triangles.insert(freeform.triangles.end(), plane.triangles.begin(), plane.triangles.end());
    freeform.area += plane.area;
    plane.triangles.clear();
  }
  std::erase_if(regions.regions, [](const Region& region) { return region.triangles.empty(); });
  for (std::size_t r = 0; r < regions.regions.size(); ++r)
    for (const int t : regions.regions[r].triangles)
      regions.of_triangle[static_cast<std::size_t>(t)] = static_cast<int>(r);
  return regions;
}

}  // namespace isopatch::segmentation
