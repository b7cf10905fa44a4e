#include "geometry/smooth_surface.hpp"

#include <Eigen/SparseCore>
#include <vector>

#include "geometry/base/error.hpp"
#include "geometry/base/sparse_lu.hpp"
#include "geometry/quadrature.hpp"
#include "geometry/splines/basis.hpp"
#include "geometry/splines/grid.hpp"

namespace isopatch::geometry {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

/// By how much points may give way to bending. Its multipliers are of the size of 1e6 and more where lines
/// that are not parallel to the knots are followed; less than this would be lost in round-off.
constexpr double give = 1e-15;

/// Integrals over a range of products of derivatives of the same order, as a share of the range: its length
/// counts as 1.
Eigen::SparseMatrix<double> products(const KnotVector& knots, int order) {
  const KnotVector unit = rescaled(knots, 0, 1);
  const QuadratureRule rule = gauss_legendre(unit.degree() + 1);
  const std::vector<double> breaks = unit.breaks();
  std::vector<double> at, weights;
  for (std::size_t e = 0; e + 1 < breaks.size(); ++e)
    for (Eigen::Index q = 0; q < rule.nodes.size(); ++q) {
      at.push_back(breaks[e] + rule.nodes[q] * (breaks[e + 1] - breaks[e]));
      weights.push_back(rule.weights[q] * (breaks[e + 1] - breaks[e]));
    }
  const Eigen::SparseMatrix<double> values = collocation(unit, at, order);
  const Eigen::VectorXd w = Eigen::VectorXd::Map(weights.data(), static_cast<Eigen::Index>(weights.size()));
  return values.transpose() * w.asDiagonal() * values;
}

void add_product(Triplets& triplets, const Eigen::SparseMatrix<double>& first,
                 const Eigen::SparseMatrix<double>& second, double factor) {
  using Entry = Eigen::SparseMatrix<double>::InnerIterator;
  const Eigen::Index n = first.rows();
  for (Eigen::Index a = 0; a < first.outerSize(); ++a)
    for (Entry i(first, a); i; ++i)
      for (Eigen::Index b = 0; b < second.outerSize(); ++b)
        for (Entry j(second, b); j; ++j)
          triplets.emplace_back(static_cast<int>(i.row() + n * j.row()),
                                static_cast<int>(i.col() + n * j.col()), factor * i.value() * j.value());
}

/// Second derivatives squared, over the domain as a unit square.
Triplets bending(const std::array<KnotVector, 2>& knots) {
  const auto of = [&](std::size_t k, int order) { return products(knots[k], order); };
  Triplets result;
  add_product(result, of(0, 2), of(1, 0), 1);
  add_product(result, of(0, 1), of(1, 1), 2);
  add_product(result, of(0, 0), of(1, 2), 1);
  return result;
}

/// Of how far points are from each other: nearer to one line than this they leave the surface free to turn
/// about it, and round-off would decide.
constexpr double on_line = 1e-9;

/// @param uv  over the domain as a unit square
bool lie_on_one_line(const Eigen::Matrix2Xd& uv) {
  const Eigen::Matrix2Xd ways = uv.colwise() - Eigen::Vector2d(uv.col(0));
  Eigen::Index farthest = 0;
  const double length = ways.colwise().squaredNorm().maxCoeff<Eigen::PropagateNaN>(&farthest);
  const Eigen::Vector2d along = ways.col(farthest);
  const Eigen::RowVectorXd across = along.x() * ways.row(1) - along.y() * ways.row(0);
  return !(across.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() > on_line * length);
}

}  // namespace

NurbsSurface smooth_surface(const SurfacePoints& through, const std::array<KnotVector, 2>& knots) {
  const int u = knots[0].size(), size = u * knots[1].size();
  const int count = static_cast<int>(through.points.cols());
  if (count < 3 || through.uv.cols() != count || !through.uv.allFinite() || !through.points.allFinite())
    throw Error(ErrorCode::invalid_argument, "a surface is put through three finite points or more");
  const Eigen::Array2d range(knots[0].last() - knots[0].first(), knots[1].last() - knots[1].first());
  if (lie_on_one_line(through.uv.array().colwise() / range))
    throw Error(ErrorCode::invalid_argument, "the points of a surface lie on one line of its domain");
  Triplets triplets = bending(knots);
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(size + count, 3);
  for (int p = 0; p < count; ++p) {
    const BasisValues a = basis(knots[0], through.uv(0, p)), b = basis(knots[1], through.uv(1, p));
    for (int j = 0; j < b.values.cols(); ++j)
      for (int i = 0; i < a.values.cols(); ++i) {
        const double value = a.values(0, i) * b.values(0, j);
        if (value == 0) continue;
        const int function = a.first + i + u * (b.first + j);
        triplets.emplace_back(size + p, function, value);
        triplets.emplace_back(function, size + p, value);
      }
    triplets.emplace_back(size + p, size + p, -give);
    right.row(size + p) = through.points.col(p).transpose();
  }
  Eigen::SparseMatrix<double> matrix(size + count, size + count);
  matrix.setFromTriplets(triplets.begin(), triplets.end());
  const auto solution = solve_by_lu(matrix, right);
  if (!solution || !solution->allFinite())
    throw Error(ErrorCode::invalid_argument, "no surface that bends least goes through its points");
  return NurbsSurface(knots, Eigen::Matrix3Xd(solution->topRows(size).transpose()));
}

}  // namespace isopatch::geometry
