#include "segmentation/reconstruction/internal/angle_regions.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "geometry/base/union_find.hpp"
#include "segmentation/reconstruction/internal/carrier_distance.hpp"
#include "segmentation/reconstruction/internal/fit_carrier.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::SurfaceKind;
using geometry::TriangleSide;

class AngleRegions {
 public:
  AngleRegions(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
               const ReconstructionOptions& options)
      : mesh_(mesh), neighbours_(neighbours), options_(options) {
    for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
      const Eigen::Vector3d twice = geometry::area_vector(mesh, t);
      normals_.push_back(twice.stableNormalized());
      areas_.push_back(twice.norm() / 2);
    }
  }

  Regions make(double tolerance) {
    std::vector<int> region =
        flood([&](const TriangleSide& s) { return angle(s) < options_.cutoff.radians(); });
    if (options_.large > 0) region = second_pass(region);
    if (options_.small > 0) merge_small(region);
    return with_carriers(region, tolerance);
  }

 private:
  TriangleSide across(const TriangleSide& s) const {
    return neighbours_.across[static_cast<std::size_t>(s.triangle)][static_cast<std::size_t>(s.side)];
  }
  double angle(const TriangleSide& s) const {
    const Eigen::Vector3d &a = normals_[static_cast<std::size_t>(s.triangle)],
                          &b = normals_[static_cast<std::size_t>(across(s).triangle)];
    return std::atan2(a.cross(b).norm(), a.dot(b));
  }

  template <class Test>
  std::vector<int> flood(Test is_open) const {
    const int count = static_cast<int>(normals_.size());
    UnionFind together(count);
    for (int t = 0; t < count; ++t)
      for (int i = 0; i < 3; ++i)
        if (is_open({t, i})) together.unite(t, across({t, i}).triangle);
    std::vector<int> result(normals_.size());
    for (int t = 0; t < count; ++t) result[static_cast<std::size_t>(t)] = together.find(t);
    return result;
  }

  std::map<int, double> areas_of(const std::vector<int>& region) const {
    std::map<int, double> result;
    for (std::size_t t = 0; t < region.size(); ++t) result[region[t]] += areas_[t];
    return result;
  }
  static double mean_of(const std::map<int, double>& areas) {
    double sum = 0;
    for (const auto& [region, area] : areas) sum += area;
    return sum / double(areas.size());
  }

  std::vector<int> second_pass(const std::vector<int>& region) const {
    const std::map<int, double> areas = areas_of(region);
    const double large = options_.large * mean_of(areas);
    return flood([&](const TriangleSide& s) {
      const int own = region[static_cast<std::size_t>(s.triangle)];
      if (own != region[static_cast<std::size_t>(across(s).triangle)]) return false;
      return areas.at(own) <= large || angle(s) < options_.inner_cutoff.radians();
    });
  }

  /// Length and angle times length of the edges between two regions.
  struct Border {
    double length = 0, turn = 0;
  };

  void merge_small(std::vector<int>& region) const {
    for (;;) {
      const std::map<int, double> areas = areas_of(region);
      const double small = options_.small * mean_of(areas);
      const auto least = std::min_element(areas.begin(), areas.end(),
                                          [](const auto& a, const auto& b) { return a.second < b.second; });
      if (areas.size() < 2 || least->second >= small) return;
      std::map<int, Border> borders;
      for (int t = 0; t < static_cast<int>(region.size()); ++t)
        for (int i = 0; i < 3 && region[static_cast<std::size_t>(t)] == least->first; ++i) {
          const int other = region[static_cast<std::size_t>(across({t, i}).triangle)];
          const double length = (mesh_.vertices.col(mesh_.triangles(i, t)) -
                                 mesh_.vertices.col(mesh_.triangles((i + 1) % 3, t)))
                                    .norm();
          if (other == least->first) continue;
          borders[other].length += length;
          borders[other].turn += length * angle({t, i});
        }
      const auto best = std::min_element(borders.begin(), borders.end(), [](const auto& a, const auto& b) {
        return a.second.turn * b.second.length < b.second.turn * a.second.length;
      });
      if (best == borders.end()) return;
      const int from = least->first, to = best->first;
      std::replace(region.begin(), region.end(), from, to);
    }
  }

  Regions with_carriers(const std::vector<int>& region, double tolerance) const {
    Regions result;
    std::map<int, int> number;
    for (std::size_t t = 0; t < region.size(); ++t) {
      const int n = number.emplace(region[t], static_cast<int>(number.size())).first->second;
      if (n == static_cast<int>(result.regions.size())) result.regions.emplace_back();
      result.of_triangle.push_back(n);
      result.regions[static_cast<std::size_t>(n)].triangles.push_back(static_cast<int>(t));
      result.regions[static_cast<std::size_t>(n)].area += areas_[t];
    }
    for (Region& one : result.regions) set_carrier(one, tolerance);
    return result;
  }

  void set_carrier(Region& region, double tolerance) const {
    SurfaceSample sample;
    const auto count = static_cast<Eigen::Index>(region.triangles.size());
    sample.points.resize(3, 3 * count);
    sample.normals.resize(3, count);
    sample.middles.resize(3, count);
    for (Eigen::Index k = 0; k < count; ++k) {
      const int t = region.triangles[static_cast<std::size_t>(k)];
      for (int i = 0; i < 3; ++i) sample.points.col(3 * k + i) = mesh_.vertices.col(mesh_.triangles(i, t));
      sample.normals.col(k) = normals_[static_cast<std::size_t>(t)];
      sample.middles.col(k) = sample.points.middleCols<3>(3 * k).rowwise().mean();
    }
    for (const SurfaceKind kind : {SurfaceKind::plane, SurfaceKind::cylinder, SurfaceKind::cone,
                                   SurfaceKind::sphere, SurfaceKind::torus}) {
      const auto fit = fit_carrier(kind, sample);
      if (!fit || !(fit->largest <= tolerance)) continue;
      region.carrier = fit->carrier;
      region.deviation = fit->largest;
      double along = 0;
      for (Eigen::Index k = 0; k < count; ++k)
        along += carrier_distance(fit->carrier, sample.middles.col(k)).gradient.dot(sample.normals.col(k)) *
                 areas_[static_cast<std::size_t>(region.triangles[static_cast<std::size_t>(k)])];
      region.reversed = along < 0;
      return;
    }
  }

  const geometry::TriangleMesh& mesh_;
  const geometry::MeshNeighbours& neighbours_;
  const ReconstructionOptions& options_;
  std::vector<Eigen::Vector3d> normals_;
  std::vector<double> areas_;
};

}  // namespace

Regions angle_regions(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
                      double tolerance, const ReconstructionOptions& options) {
  return AngleRegions(mesh, neighbours, options).make(tolerance);
}

}  // namespace isopatch::segmentation
