#include "segmentation/reconstruction/internal/facets.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <numeric>

#include "geometry/base/dense_matrices.hpp"

namespace isopatch::segmentation {
namespace {

/// The plane through points that come one after the other.
class GrowingPlane {
 public:
  GrowingPlane(const Eigen::Vector3d& normal, const Eigen::Vector3d& point)
      : normal_(normal), first_(point), middle_(point) {}

  void add(const Eigen::Vector3d& point) {
    const Eigen::Vector3d way = point - first_;
    sum_ += way;
    squares_ += way * way.transpose();
    if (++count_ == next_) fit();
  }
  void fit() {
    next_ = 2 * count_;
    if (count_ < 4) return;
    const Eigen::Vector3d mean = sum_ / count_;
    const Eigen::Matrix3d spread = squares_ - count_ * mean * mean.transpose();
    const Eigen::Vector3d found = principal_axes(spread).axes.col(0);
    middle_ = first_ + mean;
    normal_ = found.dot(normal_) < 0 ? Eigen::Vector3d(-found) : found;
  }
  double distance(const Eigen::Vector3d& point) const { return std::abs(normal_.dot(point - middle_)); }
  const Eigen::Vector3d& normal() const { return normal_; }

 private:
  Eigen::Vector3d normal_, first_, middle_, sum_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d squares_ = Eigen::Matrix3d::Zero();
  int count_ = 0, next_ = 8;
};

class FacetMaker {
 public:
  FacetMaker(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours, double tolerance)
      : mesh_(mesh),
        neighbours_(neighbours),
        tolerance_(tolerance),
        seen_(static_cast<std::size_t>(mesh.vertices.cols()), -1) {
    result_.of_triangle.assign(static_cast<std::size_t>(mesh.triangles.cols()), -1);
  }

  Facets make() {
    std::vector<Eigen::Vector3d> normals;
    for (Eigen::Index t = 0; t < mesh_.triangles.cols(); ++t)
      normals.push_back(geometry::area_vector(mesh_, t));
    std::vector<int> order(normals.size());
    std::iota(order.begin(), order.end(), 0);
    std::vector<double> areas;
    for (const auto& n : normals) areas.push_back(n.norm());
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
      return areas[static_cast<std::size_t>(a)] > areas[static_cast<std::size_t>(b)];
    });
    for (const int t : order)
      if (result_.of_triangle[static_cast<std::size_t>(t)] < 0) grow(t, normals);
    link_facets(mesh_, neighbours_, result_);
    return std::move(result_);
  }

 private:
  Eigen::Vector3d vertex(int t, int corner) const {
    return mesh_.vertices.col(mesh_.triangles(corner % 3, t));
  }

  void add_vertices(int t, Facet& facet, GrowingPlane& plane) {
    for (int i = 0; i < 3; ++i) {
      const int v = mesh_.triangles(i, t);
      if (seen_[static_cast<std::size_t>(v)] == number()) continue;
      seen_[static_cast<std::size_t>(v)] = number();
      facet.vertices.push_back(v);
      plane.add(mesh_.vertices.col(v));
    }
  }
  int number() const { return static_cast<int>(result_.facets.size()); }

  void grow(int seed, const std::vector<Eigen::Vector3d>& normals) {
    Facet facet;
    GrowingPlane plane(normals[static_cast<std::size_t>(seed)].stableNormalized(), vertex(seed, 0));
    result_.of_triangle[static_cast<std::size_t>(seed)] = number();
    facet.triangles.push_back(seed);
    add_vertices(seed, facet, plane);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t next = 0; next < facet.triangles.size(); ++next) {
      const int t = facet.triangles[next];
      sum += normals[static_cast<std::size_t>(t)];
      for (const geometry::TriangleSide& side : neighbours_.across[static_cast<std::size_t>(t)]) {
        if (side.triangle < 0 || result_.of_triangle[static_cast<std::size_t>(side.triangle)] >= 0) continue;
        if (!(plane.distance(vertex(side.triangle, side.side + 2)) <= tolerance_)) continue;
        const Eigen::Vector3d& normal = normals[static_cast<std::size_t>(side.triangle)];
        // A triangle of next to no height may lean anywhere.
        const double length =
            (vertex(side.triangle, side.side) - vertex(side.triangle, side.side + 1)).norm();
        if (!(normal.dot(plane.normal()) > 0.5 * normal.norm()) && normal.norm() > 4 * tolerance_ * length)
          continue;
        result_.of_triangle[static_cast<std::size_t>(side.triangle)] = number();
        facet.triangles.push_back(side.triangle);
        add_vertices(side.triangle, facet, plane);
      }
    }
    finish(facet, sum, plane);
    result_.facets.push_back(std::move(facet));
  }

  void finish(Facet& facet, const Eigen::Vector3d& sum, GrowingPlane& plane) const {
    facet.area = sum.norm() / 2;
    facet.normal = sum.stableNormalized();
    if (facet.vertices.size() > 3) {
      plane.fit();
      facet.normal = plane.normal().dot(sum) < 0 ? Eigen::Vector3d(-plane.normal()) : plane.normal();
    }
    // A ring of a torus may be plane; the middle of its vertices is not on it.
    const bool small = facet.triangles.size() <= 2;
    facet.middle.setZero();
    for (std::size_t i = 0; i < (small ? facet.vertices.size() : 3); ++i)
      facet.middle += mesh_.vertices.col(facet.vertices[i]) / (small ? double(facet.vertices.size()) : 3.0);
  }

  const geometry::TriangleMesh& mesh_;
  const geometry::MeshNeighbours& neighbours_;
  double tolerance_;
  std::vector<int> seen_;  ///< by vertex: the last facet that has it
  Facets result_;
};

}  // namespace

void link_facets(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                 Facets& facets) {
  const auto vertex = [&](int t, int corner) { return mesh.vertices.col(mesh.triangles(corner % 3, t)); };
  for (std::size_t f = 0; f < facets.facets.size(); ++f) {
    std::vector<FacetLink>& links = facets.facets[f].links;
    links.clear();
    for (const int t : facets.facets[f].triangles)
      for (const geometry::TriangleSide& side : neighbours.across[static_cast<std::size_t>(t)]) {
        if (side.triangle < 0) continue;
        const int other = facets.of_triangle[static_cast<std::size_t>(side.triangle)];
        if (other == static_cast<int>(f)) continue;
        links.push_back({other, 0, vertex(side.triangle, side.side) - vertex(side.triangle, side.side + 1)});
      }
    std::stable_sort(links.begin(), links.end(),
                     [](const FacetLink& a, const FacetLink& b) { return a.other < b.other; });
    std::size_t kept = 0;
    for (const FacetLink& link : links)
      if (kept > 0 && links[kept - 1].other == link.other)
        links[kept - 1].edge += link.edge;
      else
        links[kept++] = link;
    links.resize(kept);
    for (FacetLink& link : links) {
      const Eigen::Vector3d &a = facets.facets[f].normal,
                            &b = facets.facets[static_cast<std::size_t>(link.other)].normal;
      link.angle = std::atan2(a.cross(b).norm(), a.dot(b));
    }
  }
}

Facets plane_facets(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                    double tolerance) {
  return FacetMaker(mesh, neighbours, tolerance).make();
}

}  // namespace isopatch::segmentation
