#include "segmentation/reconstruction/internal/dented_planes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <set>
#include <utility>
#include <vector>

namespace isopatch::segmentation {
namespace {

// Facets of a plane are within 3 degrees of it.
constexpr double widest_dent = 0.05;
// The strips of a round turn by a half, one and a half, ... of one angle: what turns by less of the next turn
// than this is no strip.
constexpr double strip_share = 0.15;
// No round has as many strips that they turn by less.
constexpr double flat = 1.7e-3;  // rad, a tenth of a degree
// Planes with dents have this share of the whole area: small facets of gently curved surfaces are flat as
// well.
constexpr double face_share = 5e-3;
// What bends away behind a facet, and not what its own rounding turns by.
constexpr double least_bend = 1e-6;
// A plane has this many times the area of a facet around a dent's vertex.
constexpr double plane_over_vertex = 20;
// Depth of a dent at one vertex, and of a flat one, as shares of the size.
constexpr double deepest = 5e-4, deepest_flat = 5e-5;
// More facets than this around a vertex are no dent.
constexpr std::size_t most_around = 12;

class DentFiller {
 public:
  DentFiller(const geometry::TriangleMesh& mesh, Facets& facets, double tolerance)
      : mesh_(mesh),
        facets_(facets.facets),
        tolerance_(tolerance),
        size_(geometry::diagonal(mesh)),
        least_area_(face_share * geometry::area(mesh)),
        owner_(facets_.size()),
        is_done_(facets_.size(), false) {
    std::iota(owner_.begin(), owner_.end(), 0);
  }

  /// By facet: the plane that it belongs to.
  const std::vector<int>& fill() {
    std::vector<int> order(owner_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) { return area(a) > area(b); });
    for (const int f : order) {
      if (is_free(f) && area(f) >= least_area_) take_neighbours(f);
      is_done_[static_cast<std::size_t>(f)] = true;
    }
    return owner_;
  }

 private:
  const Facet& facet(int f) const { return facets_[static_cast<std::size_t>(f)]; }
  double area(int f) const { return facet(f).area; }
  int& owner(int f) { return owner_[static_cast<std::size_t>(f)]; }
  /// Whether it may be given to a plane: larger ones have kept their own.
  bool is_free(int f) { return owner(f) == f && !is_done_[static_cast<std::size_t>(f)]; }

  double height(int plane, int vertex) const {
    return std::abs(facet(plane).normal.dot(mesh_.vertices.col(vertex) - facet(plane).middle));
  }
  double turn(int a, int b) const {
    return std::atan2(facet(a).normal.cross(facet(b).normal).norm(), facet(a).normal.dot(facet(b).normal));
  }

  void take_neighbours(int plane) {
    std::vector<int> taken{plane};
    for (std::size_t next = 0; next < taken.size(); ++next)
      for (const FacetLink& link : facet(taken[next]).links) {
        if (is_free(link.other) && link.other != plane && is_dent(plane, link.other)) {
          owner(link.other) = plane;
          taken.push_back(link.other);
        }
      }
    std::map<int, std::vector<int>> off = leaning(plane, taken);
    for (const auto& [vertex, around] : off)
      if (around.size() <= most_around && is_vertex_dent(plane, vertex, around))
        for (const int f : around) owner(f) = plane;
  }

  bool is_dent(int plane, int f) {
    const double own = turn(plane, f);
    if (!(own < widest_dent)) return false;
    const double allowed = own < flat ? std::fmax(tolerance_, deepest_flat * size_) : tolerance_;
    for (const int v : facet(f).vertices)
      if (!(height(plane, v) <= allowed)) return false;
    if (own < flat) return true;
    double behind = 0;
    bool bends = false;
    for (const FacetLink& link : facet(f).links) {
      if (owner(link.other) == plane || !(link.angle < most_smooth)) continue;
      const double further = turn(plane, link.other);
      if (further < least_bend) continue;
      bends = true;
      behind = std::fmax(behind, further);
    }
    return !bends || own <= strip_share * behind;
  }

  /// By vertex off the plane: free facets with it that lean from the plane a little, some of which are beside
  /// it.
  std::map<int, std::vector<int>> leaning(int plane, const std::vector<int>& taken) {
    std::map<int, std::vector<int>> result;
    std::set<int> done;
    std::vector<int> open;
    const auto offer = [&](int from) {
      for (const FacetLink& link : facet(from).links)
        if (is_free(link.other) && link.other != plane &&
            area(link.other) * plane_over_vertex < area(plane) && turn(plane, link.other) < widest_dent &&
            facet(link.other).vertices.size() <= 4 && done.insert(link.other).second)
          open.push_back(link.other);
    };
    for (const int f : taken) offer(f);
    // One step further: facets that meet the plane in a vertex alone.
    const std::vector<int> beside = open;
    for (const int f : beside) offer(f);
    for (const int f : open)
      for (const int v : facet(f).vertices)
        if (height(plane, v) > tolerance_) result[v].push_back(f);
    return result;
  }

  bool is_vertex_dent(int plane, int vertex, const std::vector<int>& around) {
    if (!(height(plane, vertex) <= deepest * size_)) return false;
    for (const int f : around) {
      if (!is_free(f)) return false;
      for (const int v : facet(f).vertices)
        if (v != vertex && height(plane, v) > tolerance_) return false;
      // What goes on from there in the same direction is a face of its own.
      for (const FacetLink& link : facet(f).links)
        if (owner(link.other) != plane && link.angle < most_smooth &&
            std::find(around.begin(), around.end(), link.other) == around.end())
          return false;
    }
    return true;
  }

  // Beyond this edges are creases.
  static constexpr double most_smooth = 0.5;

  const geometry::TriangleMesh& mesh_;
  const std::vector<Facet>& facets_;
  double tolerance_, size_, least_area_;
  std::vector<int> owner_;
  std::vector<bool> is_done_;
};

}  // namespace

Facets without_dents(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                     Facets facets, double tolerance) {
  const std::vector<int> owner = DentFiller(mesh, facets, tolerance).fill();
  bool is_dented = false;
  for (std::size_t f = 0; f < owner.size(); ++f) is_dented = is_dented || owner[f] != static_cast<int>(f);
  if (!is_dented) return facets;
  std::vector<int> number(owner.size(), -1);
  Facets result;
  for (std::size_t f = 0; f < owner.size(); ++f)
    if (owner[f] == static_cast<int>(f)) {
      number[f] = static_cast<int>(result.facets.size());
      result.facets.push_back(facets.facets[f]);
    }
  for (std::size_t f = 0; f < owner.size(); ++f) {
    const Facet& dent = facets.facets[f];
    if (owner[f] == static_cast<int>(f)) continue;
    Facet& plane = result.facets[static_cast<std::size_t>(number[static_cast<std::size_t>(owner[f])])];
    plane.triangles.insert(plane.triangles.end(), dent.triangles.begin(), dent.triangles.end());
    plane.vertices.insert(plane.vertices.end(), dent.vertices.begin(), dent.vertices.end());
    plane.area += dent.area;
  }
  for (Facet& facet : result.facets) {
    std::sort(facet.vertices.begin(), facet.vertices.end());
    facet.vertices.erase(std::unique(facet.vertices.begin(), facet.vertices.end()), facet.vertices.end());
  }
  result.of_triangle.reserve(facets.of_triangle.size());
  for (const int f : facets.of_triangle)
    result.of_triangle.push_back(number[static_cast<std::size_t>(owner[static_cast<std::size_t>(f)])]);
  link_facets(mesh, neighbours, result);
  return result;
}

}  // namespace isopatch::segmentation
