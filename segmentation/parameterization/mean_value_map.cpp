#include "segmentation/parameterization/internal/mean_value_map.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/base/sparse_lu.hpp"
#include "segmentation/parameterization/internal/face_map.hpp"
#include "segmentation/parameterization/internal/mesh_refinement.hpp"
#include "segmentation/parameterization/internal/outline.hpp"

namespace isopatch::segmentation {
namespace {

constexpr int outline_pieces = 32;
constexpr int wanted_triangles = 2400;

/// The square is looked up in a grid of this many cells along each direction.
constexpr int cells_a_side = 40;

int cell_of(double x) {
  return std::clamp(static_cast<int>(cells_a_side * x), 0, cells_a_side - 1);
}

/// Where a point of the outline goes.
Eigen::Vector2d on_square(const FaceMap& map, const OutlinePoint& point) {
  const double share = map.side_share(point.side, point.t);
  switch (point.side) {
    case 0:
      return {share, 0};
    case 1:
      return {share, 1};
    case 2:
      return {0, share};
    default:
      return {1, share};
  }
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
  if (unknown == 0) return square;
  const std::optional<Eigen::MatrixXd> inner = solve_by_lu(matrix, right);
  if (!inner)
    throw Error(ErrorCode::singular_system,
                "the weights of a face's mean value map are singular; the face may have slivers, so try more "
                "points on "
                "its outline");
  for (Eigen::Index i = 0; i < unknown; ++i) square.emplace_back(inner->row(i).transpose());
  return square;
}

}  // namespace

MeanValueMap::MeanValueMap(const FaceMap& blend, const DomainMesh& given) {
  const QuadFace& face = blend.face();
  DomainMesh mesh = refined(given, face.sides, face.surface, outline_pieces, wanted_triangles);
  std::vector<Eigen::Vector2d> square;
  for (const OutlinePoint& point : mesh.outline) square.push_back(on_square(blend, point));
  std::vector<Eigen::Vector3d> points;
  for (const auto& p : mesh.points) points.push_back(face.surface(p));
  domain_ = std::move(mesh.points);
  triangles_ = std::move(mesh.triangles);
  square_ = solve(weights(points, triangles_), square);
  smallest_area_ = std::numeric_limits<double>::infinity();
  for (const auto& t : triangles_)
    smallest_area_ = std::min(smallest_area_, doubled_area(square_[static_cast<std::size_t>(t[0])],
                                                           square_[static_cast<std::size_t>(t[1])],
                                                           square_[static_cast<std::size_t>(t[2])]));
  smallest_area_ *= static_cast<double>(triangles_.size()) / 2;
  sort_into_cells();
}

void MeanValueMap::sort_into_cells() {
  cells_.resize(static_cast<std::size_t>(cells_a_side * cells_a_side));
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    Eigen::AlignedBox2d box;
    for (const int corner : triangles_[t]) box.extend(square_[static_cast<std::size_t>(corner)]);
    for (int j = cell_of(box.min()[1]); j <= cell_of(box.max()[1]); ++j)
      for (int i = cell_of(box.min()[0]); i <= cell_of(box.max()[0]); ++i)
        cells_[static_cast<std::size_t>(i + cells_a_side * j)].push_back(static_cast<int>(t));
  }
}

Eigen::Vector2d MeanValueMap::domain_point(const Eigen::Vector2d& square) const {
  double best = -std::numeric_limits<double>::infinity();
  Eigen::Vector2d result(0, 0);
  for (const int at :
       cells_[static_cast<std::size_t>(cell_of(square[0]) + cells_a_side * cell_of(square[1]))]) {
    const auto& t = triangles_[static_cast<std::size_t>(at)];
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
