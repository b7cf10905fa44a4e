#include "segmentation/reconstruction/internal/region_map.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/SparseCore>
#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <unordered_map>
#include <utility>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/base/sparse_lu.hpp"

namespace isopatch::segmentation {
namespace {

// Turns of the border by more than 46 degrees are corners of a quadrangle, where there are four.
constexpr double corner_of_four = 0.8;
// Sides of the polygon keep this share of their length at least.
constexpr double shortest_side = 0.1;
// A region faces a plane if all its normals are within 66 degrees of it.
constexpr double facing = 0.4;

class RegionMapper {
 public:
  RegionMapper(const geometry::TriangleMesh& mesh, const geometry::MeshNeighbours& neighbours,
               const Regions& regions, int region)
      : mesh_(mesh), triangles_(regions.regions[static_cast<std::size_t>(region)].triangles) {
    for (const int t : triangles_)
      for (int i = 0; i < 3; ++i) {
        const auto [known, added] = number_.emplace(mesh.triangles(i, t), static_cast<int>(vertices_.size()));
        if (added) vertices_.push_back(known->first);
      }
    for (const int t : triangles_)
      for (int i = 0; i < 3; ++i) {
        const int other =
            neighbours.across[static_cast<std::size_t>(t)][static_cast<std::size_t>(i)].triangle;
        if (regions.of_triangle[static_cast<std::size_t>(other)] == region) continue;
        is_simple_ = next_.emplace(local(t, i), local(t, i + 1)).second && is_simple_;
      }
  }

  std::optional<RegionMap> make(const std::vector<int>& corners) {
    if (!is_simple_ || next_.empty()) return std::nullopt;
    find_loops();
    auto places = to_plane();
    if (!places) places = to_polygon(corners);
    if (!places) places = to_disc();
    if (!places) return std::nullopt;
    return RegionMap{vertices_, *places};
  }

 private:
  int local(int t, int i) const { return number_.at(mesh_.triangles(i % 3, t)); }
  Eigen::Vector3d point(int local) const {
    return mesh_.vertices.col(vertices_[static_cast<std::size_t>(local)]);
  }

  /// The longest one first.
  void find_loops() {
    std::map<int, int> left(next_.begin(), next_.end());
    std::vector<double> lengths;
    while (!left.empty()) {
      std::vector<int> loop;
      double length = 0;
      for (auto at = left.begin(); at != left.end(); at = left.find(loop.back())) {
        loop.push_back(at->second);
        length += (point(at->second) - point(at->first)).norm();
        left.erase(at);
      }
      const auto place = std::upper_bound(lengths.begin(), lengths.end(), length, std::greater<>());
      loops_.insert(loops_.begin() + (place - lengths.begin()), std::move(loop));
      lengths.insert(place, length);
    }
  }

  /// Of the region at its border vertices, rad.
  std::vector<double> inner_angles() const {
    std::vector<double> result(vertices_.size(), 0);
    for (const int t : triangles_)
      for (int i = 0; i < 3; ++i) result[static_cast<std::size_t>(local(t, i))] += angle(t, i);
    return result;
  }
  double angle(int t, int i) const {
    const Eigen::Vector3d a = point(local(t, i + 1)) - point(local(t, i)),
                          b = point(local(t, i + 2)) - point(local(t, i));
    return std::atan2(a.cross(b).norm(), a.dot(b));
  }

  /// The exterior angles of a convex polygon for the outer loop, one for each of its vertices, 2 pi in all.
  /// Corners keep their angle, or get 0 where they turn to the right. Sides between four corners or more are
  /// straight; between fewer they turn evenly.
  std::vector<double> convex_turns(const std::vector<int>& corners) const {
    const std::vector<double> angles = inner_angles();
    const std::vector<int>& loop = loops_[0];
    const std::size_t n = loop.size();
    std::vector<double> turns(n);
    std::vector<std::size_t> at;
    for (std::size_t i = 0; i < n; ++i) {
      const auto v = static_cast<std::size_t>(loop[i]);
      turns[i] = std::numbers::pi - angles[v];
      if (std::find(corners.begin(), corners.end(), vertices_[v]) != corners.end()) at.push_back(i);
    }
    if (at.empty()) at.push_back(0);
    // Sides between four corners are straight, however a long one turns in its surface, as along a spring.
    const bool four =
        std::count_if(at.begin(), at.end(), [&](std::size_t i) { return turns[i] > corner_of_four; }) >= 4;
    std::vector<double> result(n, 0);
    for (std::size_t k = 0; k < at.size(); ++k) {
      result[at[k]] = std::max(0.0, turns[at[k]]);
      const std::size_t inside = (at[(k + 1) % at.size()] + n - at[k] - 1) % n;
      double sum = 0;
      for (std::size_t i = 1; i <= inside; ++i) sum += turns[(at[k] + i) % n];
      for (std::size_t i = 1; i <= inside && !four; ++i)
        result[(at[k] + i) % n] = std::max(0.0, sum / static_cast<double>(inside));
    }
    const double whole = std::accumulate(result.begin(), result.end(), 0.0);
    for (double& turn : result) turn *= 2 * std::numbers::pi / whole;
    return result;
  }

  /// Places the outer loop's vertices on a closed convex polygon with the loop's exterior angles, and with
  /// sides as near to the loop's in length as closes it.
  std::optional<Eigen::Matrix2Xd> to_polygon(const std::vector<int>& corners) const {
    const std::vector<int>& loop = loops_[0];
    const std::size_t n = loop.size();
    const std::vector<double> turns = convex_turns(corners);
    Eigen::Matrix2Xd ways(2, static_cast<Eigen::Index>(n));
    double direction = 0;
    for (std::size_t i = 0; i < n; ++i) {
      direction += turns[i];
      const double length = (point(loop[(i + 1) % n]) - point(loop[i])).norm();
      ways.col(static_cast<Eigen::Index>(i)) =
          length * Eigen::Vector2d(std::cos(direction), std::sin(direction));
    }
    // Least squares: the sides are scaled by factors as near to 1 as closes the polygon; the change of each
    // factor is then linear in the side's vector.
    const Eigen::Vector2d share = (ways * ways.transpose()).eval().inverse() * ways.rowwise().sum();
    const Eigen::RowVectorXd kept = (1 - (share.transpose() * ways).array()).matrix();
    if (!(kept.minCoeff() > shortest_side)) return std::nullopt;
    Eigen::Matrix2Xd places = unknown_places();
    Eigen::Vector2d at(0, 0);
    for (std::size_t i = 0; i < n; ++i) {
      places.col(loop[i]) = at;
      at += kept[static_cast<Eigen::Index>(i)] * ways.col(static_cast<Eigen::Index>(i));
    }
    return by_mean_values(std::move(places));
  }

  /// On the plane at right angles to the mean normal, the longer way along the first axis.
  std::optional<Eigen::Matrix2Xd> to_plane() const {
    Eigen::Vector3d normal = Eigen::Vector3d::Zero();
    for (const int t : triangles_) normal += geometry::area_vector(mesh_, t);
    normal.stableNormalize();
    for (const int t : triangles_) {
      const Eigen::Vector3d own = geometry::area_vector(mesh_, t);
      if (!(own.dot(normal) > facing * own.norm())) return std::nullopt;
    }
    const Eigen::Matrix3Xd points = mesh_.vertices(Eigen::all, vertices_);
    Eigen::Matrix3Xd arms = points.colwise() - points.rowwise().mean();
    arms -= normal * (normal.transpose() * arms);
    const Eigen::Vector3d x = principal_axes(arms * arms.transpose()).axes.col(2), y = normal.cross(x);
    Eigen::Matrix2Xd places(2, arms.cols());
    places << x.transpose() * arms, y.transpose() * arms;
    return checked(std::move(places));
  }

  std::optional<Eigen::Matrix2Xd> to_disc() const {
    const std::vector<int>& loop = loops_[0];
    std::vector<double> way{0};
    for (std::size_t i = 0; i < loop.size(); ++i)
      way.push_back(way.back() + (point(loop[(i + 1) % loop.size()]) - point(loop[i])).norm());
    double area = 0;
    for (const int t : triangles_) area += geometry::area_vector(mesh_, t).norm() / 2;
    const double radius = std::sqrt(area / std::numbers::pi);
    Eigen::Matrix2Xd places = unknown_places();
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const double turn = 2 * std::numbers::pi * way[i] / way.back();
      places.col(loop[i]) = radius * Eigen::Vector2d(std::cos(turn), std::sin(turn));
    }
    return by_mean_values(std::move(places));
  }

  Eigen::Matrix2Xd unknown_places() const {
    return Eigen::Matrix2Xd::Constant(2, static_cast<Eigen::Index>(vertices_.size()), std::nan(""));
  }

  /// Vertices without a place get the mean of their neighbours'.
  std::optional<Eigen::Matrix2Xd> by_mean_values(Eigen::Matrix2Xd places) const {
    const auto known = static_cast<int>(vertices_.size()), all = known + static_cast<int>(loops_.size()) - 1;
    std::vector<Eigen::Triplet<double>> weights;
    const auto add = [&](int at, int other, double tangent, double length) {
      if (at < known && !std::isnan(places(0, at))) return;
      weights.emplace_back(at, at, tangent / length);
      weights.emplace_back(at, other, -tangent / length);
    };
    const auto add_triangle = [&](const std::array<int, 3>& corners,
                                  const std::array<Eigen::Vector3d, 3>& p) {
      for (std::size_t i = 0; i < 3; ++i) {
        const Eigen::Vector3d a = p[(i + 1) % 3] - p[i], b = p[(i + 2) % 3] - p[i];
        const double tangent = std::tan(std::atan2(a.cross(b).norm(), a.dot(b)) / 2);
        add(corners[i], corners[(i + 1) % 3], tangent, a.norm());
        add(corners[i], corners[(i + 2) % 3], tangent, b.norm());
      }
    };
    for (const int t : triangles_) {
      const std::array<int, 3> v{local(t, 0), local(t, 1), local(t, 2)};
      add_triangle(v, {point(v[0]), point(v[1]), point(v[2])});
    }
    for (std::size_t hole = 1; hole < loops_.size(); ++hole) {
      const std::vector<int>& loop = loops_[hole];
      Eigen::Vector3d middle = Eigen::Vector3d::Zero();
      for (const int v : loop) middle += point(v) / double(loop.size());
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const int a = loop[i], b = loop[(i + 1) % loop.size()];
        add_triangle({b, a, known + static_cast<int>(hole) - 1}, {point(b), point(a), middle});
      }
    }
    Eigen::MatrixXd right = Eigen::MatrixXd::Zero(all, 2);
    for (int v = 0; v < known; ++v)
      if (!std::isnan(places(0, v))) {
        weights.emplace_back(v, v, 1);
        right.row(v) = places.col(v).transpose();
      }
    Eigen::SparseMatrix<double> matrix(all, all);
    matrix.setFromTriplets(weights.begin(), weights.end());
    const auto solved = solve_by_lu(matrix, right);
    if (!solved) return std::nullopt;
    return checked(solved->topRows(known).transpose());
  }

  /// The places if no triangle is turned over.
  std::optional<Eigen::Matrix2Xd> checked(Eigen::Matrix2Xd places) const {
    for (const int t : triangles_) {
      const Eigen::Vector2d a = places.col(local(t, 1)) - places.col(local(t, 0)),
                            b = places.col(local(t, 2)) - places.col(local(t, 0));
      if (!(a.x() * b.y() - a.y() * b.x() > 0)) return std::nullopt;
    }
    return places;
  }

  const geometry::TriangleMesh& mesh_;
  const std::vector<int>& triangles_;
  std::vector<int> vertices_;
  std::unordered_map<int, int> number_;  ///< of the mesh's vertices in the region
  std::map<int, int> next_;              ///< along the border
  bool is_simple_ = true;
  std::vector<std::vector<int>> loops_;
};

}  // namespace

std::optional<RegionMap> region_map(const geometry::TriangleMesh& mesh,
                                    const geometry::MeshNeighbours& neighbours, const Regions& regions,
                                    int region, const std::vector<int>& corners) {
  return RegionMapper(mesh, neighbours, regions, region).make(corners);
}

}  // namespace isopatch::segmentation
