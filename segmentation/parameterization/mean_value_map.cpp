#include "segmentation/parameterization/mean_value_map.hpp"

#include <Eigen/Geometry>
#include <Eigen/SparseLU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "segmentation/parameterization/outline.hpp"
#include "segmentation/parameterization/triangulation.hpp"

namespace isopatch::segmentation {
namespace {

constexpr int points_a_side = 40;
constexpr int inner_points = 1200;

/// The outline of the square, counterclockwise from its corner (0, 0).
std::vector<Eigen::Vector2d> square_outline() {
  std::vector<Eigen::Vector2d> result;
  for (int k = 0; k < 4; ++k)
    for (int i = 0; i < points_a_side; ++i) {
      const double x = double(i) / points_a_side;
      result.push_back(k == 0   ? Eigen::Vector2d(x, 0)
                       : k == 1 ? Eigen::Vector2d(1, x)
                       : k == 2 ? Eigen::Vector2d(1 - x, 1)
                                : Eigen::Vector2d(0, 1 - x));
    }
  return result;
}

Eigen::Vector2d on_outline(const std::array<DomainCurve, 4>& sides, const Eigen::Vector2d& p) {
  if (p[1] == 0) return sides[0](p[0]);
  if (p[0] == 1) return sides[3](p[1]);
  return p[1] == 1 ? sides[1](p[0]) : sides[2](p[1]);
}

bool share_a_side(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  for (int d = 0; d < 2; ++d)
    if (a[d] == b[d] && (a[d] == 0 || a[d] == 1)) return true;
  return false;
}

/// Factors that make a domain's two directions about as long as they are on the surface.
Eigen::Vector2d stretches(const std::vector<Eigen::Vector2d>& outline, const DomainSurface& surface) {
  Eigen::AlignedBox2d box;
  for (const auto& p : outline) box.extend(p);
  Eigen::Vector2d sum(0, 0);
  for (const auto& p : outline)
    for (int d = 0; d < 2; ++d) {
      const double step = 1e-3 * box.sizes()[d] * (p[d] > box.center()[d] ? -1 : 1);
      sum[d] += (surface(p + step * Eigen::Vector2d::Unit(d)) - surface(p)).norm() / std::abs(step);
    }
  return sum[0] > 0 && sum[1] > 0 ? Eigen::Vector2d(sum / sum.maxCoeff()) : Eigen::Vector2d(1, 1);
}

/// The sum over both triangles at edge ij of tan(angle at i / 2), divided by the edge's length.
Eigen::SparseMatrix<double> weights(const std::vector<Eigen::Vector3d>& points,
                                    const std::vector<std::array<int, 3>>& triangles) {
  std::vector<Eigen::Triplet<double>> entries;
  for (const auto& t : triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const int i = t[k], j = t[(k + 1) % 3], l = t[(k + 2) % 3];
      const Eigen::Vector3d a = points[static_cast<std::size_t>(j)] - points[static_cast<std::size_t>(i)];
      const Eigen::Vector3d b = points[static_cast<std::size_t>(l)] - points[static_cast<std::size_t>(i)];
      const double lengths = a.norm() * b.norm();
      // tan(x / 2) = sin x / (1 + cos x)
      const double half = a.cross(b).norm() / std::max(lengths + a.dot(b), 1e-12 * lengths);
      entries.emplace_back(i, j, half / a.norm());
      entries.emplace_back(i, l, half / b.norm());
    }
  const auto n = static_cast<Eigen::Index>(points.size());
  Eigen::SparseMatrix<double> result(n, n);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

/// Images of all points: the outline's are given, each inner one is the weighted mean of its neighbours.
std::vector<Eigen::Vector2d> solve(const Eigen::SparseMatrix<double>& weight,
                                   std::vector<Eigen::Vector2d> square) {
  const auto fixed = static_cast<Eigen::Index>(square.size());
  const Eigen::Index unknown = weight.rows() - fixed;
  const Eigen::SparseMatrix<double, Eigen::RowMajor> rows = weight;
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::MatrixX2d right = Eigen::MatrixX2d::Zero(unknown, 2);
  for (Eigen::Index i = 0; i < unknown; ++i) {
    double sum = 0;
    for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator entry(rows, i + fixed); entry; ++entry)
      sum += entry.value();
    for (Eigen::SparseMatrix<double, Eigen::RowMajor>::InnerIterator entry(rows, i + fixed); entry; ++entry)
      if (entry.col() < fixed)
        right.row(i) += entry.value() / sum * square[static_cast<std::size_t>(entry.col())].transpose();
      else
        entries.emplace_back(i, entry.col() - fixed, -entry.value() / sum);
    entries.emplace_back(i, i, 1.0);
  }
  Eigen::SparseMatrix<double> matrix(unknown, unknown);
  matrix.setFromTriplets(entries.begin(), entries.end());
  const Eigen::MatrixX2d inner = Eigen::SparseLU<Eigen::SparseMatrix<double>>(matrix).solve(right);
  for (Eigen::Index i = 0; i < unknown; ++i) square.emplace_back(inner.row(i));
  return square;
}

}  // namespace

MeanValueMap::MeanValueMap(const std::array<DomainCurve, 4>& sides, const DomainSurface& surface) {
  std::vector<Eigen::Vector2d> square = square_outline();
  std::vector<Eigen::Vector2d> outline;
  for (const auto& p : square) outline.push_back(on_outline(sides, p));
  Eigen::Vector2d stretch = stretches(outline, surface);
  double doubled = 0;
  for (std::size_t i = 0; i < outline.size(); ++i)
    doubled += doubled_area({0, 0}, outline[i], outline[(i + 1) % outline.size()]);
  if (doubled < 0) stretch[1] = -stretch[1];
  for (auto& p : outline) p = p.cwiseProduct(stretch);
  Triangulation mesh = triangulate(outline, inner_points);
  divide_edges(mesh, [&](int a, int b) {
    return std::max(a, b) < mesh.outline &&
           share_a_side(square[static_cast<std::size_t>(a)], square[static_cast<std::size_t>(b)]);
  });
  std::vector<Eigen::Vector3d> points;
  for (const auto& p : mesh.points) {
    domain_.emplace_back(p.cwiseQuotient(stretch));
    points.push_back(surface(domain_.back()));
  }
  triangles_ = mesh.triangles;
  square_ = solve(weights(points, triangles_), square);
  smallest_area_ = std::numeric_limits<double>::infinity();
  for (const auto& t : triangles_)
    smallest_area_ = std::min(smallest_area_, doubled_area(square_[static_cast<std::size_t>(t[0])],
                                                           square_[static_cast<std::size_t>(t[1])],
                                                           square_[static_cast<std::size_t>(t[2])]));
  smallest_area_ *= static_cast<double>(triangles_.size()) / 2;
}

Eigen::Vector2d MeanValueMap::domain_point(const Eigen::Vector2d& square) const {
  double best = -std::numeric_limits<double>::infinity();
  Eigen::Vector2d result(0, 0);
  for (const auto& t : triangles_) {
    const auto a = static_cast<std::size_t>(t[0]), b = static_cast<std::size_t>(t[1]),
               c = static_cast<std::size_t>(t[2]);
    const double area = doubled_area(square_[a], square_[b], square_[c]);
    if (!(area > 0)) continue;
    const Eigen::Vector3d shares(doubled_area(square, square_[b], square_[c]) / area,
                                 doubled_area(square_[a], square, square_[c]) / area,
                                 doubled_area(square_[a], square_[b], square) / area);
    if (shares.minCoeff() <= best) continue;
    best = shares.minCoeff();
    result = shares[0] * domain_[a] + shares[1] * domain_[b] + shares[2] * domain_[c];
    if (best >= 0) break;
  }
  return result;
}

}  // namespace isopatch::segmentation
