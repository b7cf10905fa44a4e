#include "iga/solution/mortar_projection.hpp"

#include "geometry/base/error.hpp"

namespace isopatch::iga {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Triplets = std::vector<Eigen::Triplet<double>>;

void add_both_triangles(const solvers::SymmetricBlockMatrix& matrix, Triplets& entries) {
  for (int row = 0; row < matrix.block_rows(); ++row)
    for (std::int64_t k = matrix.row_start[static_cast<std::size_t>(row)];
         k < matrix.row_start[static_cast<std::size_t>(row) + 1]; ++k) {
      const int column = matrix.columns[static_cast<std::size_t>(k)];
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          const double value = matrix.values[static_cast<std::size_t>(9 * k + 3 * i + j)];
          if (value == 0) continue;
          entries.emplace_back(3 * row + i, 3 * column + j, value);
          if (column != row) entries.emplace_back(3 * column + j, 3 * row + i, value);
        }
    }
}

}  // namespace

MortarProjection::MortarProjection(const solvers::ConstraintMatrix& b, const solvers::SharedRows& rows,
                                   const InterfaceMatrix& of_faces)
    : b_(&b), rows_(rows) {
  if (b.rows() == 0) return;
  std::vector<int> place_of(static_cast<std::size_t>(b.cols()), -1);
  for (const int row : of_faces.rows)
    for (int i = 0; i < 3; ++i) {
      place_of[static_cast<std::size_t>(3 * row + i)] = static_cast<int>(places_.size());
      places_.push_back(3 * Index{row} + i);
    }
  const auto unknowns = static_cast<Index>(places_.size());
  Triplets entries;
  add_both_triangles(of_faces.matrix, entries);
  const double scale = solvers::mean_diagonal(of_faces.matrix);
  for (Index i = 0; i < b.rows(); ++i)
    for (solvers::ConstraintMatrix::InnerIterator it(b, i); it; ++it) {
      const int column = place_of[static_cast<std::size_t>(it.col())];
      const auto row = static_cast<int>(unknowns + i);
      entries.emplace_back(row, column, scale * it.value());
      entries.emplace_back(column, row, scale * it.value());
    }
  Eigen::SparseMatrix<double> both(unknowns + b.rows(), unknowns + b.rows());
  both.setFromTriplets(entries.begin(), entries.end());
  scale_ = scale;
  factors_.emplace(both);
  if (factors_->is_singular())
    throw Error(ErrorCode::singular_system,
                "the multipliers between faces that do not match depend on each other; use "
                "coupling.non_matching = \"nitsche\", or halve the elements there");
}

VectorXd MortarProjection::particular(const VectorXd& g) const {
  VectorXd result = VectorXd::Zero(b_->cols());
  if (factors_) {
    VectorXd right = VectorXd::Zero(static_cast<Index>(places_.size()) + g.size());
    right.tail(g.size()) = scale_ * g;
    const VectorXd both = factors_->solve(right);
    result(places_) = both.head(static_cast<Index>(places_.size()));
  }
  rows_.sum(result);
  return result;
}

VectorXd MortarProjection::project(VectorXd x) const {
  x -= particular(*b_ * x);
  return x;
}

VectorXd MortarProjection::multipliers(const VectorXd& force) const {
  if (!factors_) return VectorXd(0);
  VectorXd right = VectorXd::Zero(static_cast<Index>(places_.size()) + b_->rows());
  right.head(static_cast<Index>(places_.size())) = force(places_);
  return scale_ * VectorXd(factors_->solve(right)).tail(b_->rows());
}

VectorXd MortarProjection::reduce(VectorXd force) const {
  VectorXd taken = b_->transpose() * multipliers(force);
  rows_.sum(taken);
  return force - taken;
}

}  // namespace isopatch::iga
