#include "iga/solution/mortar_projection.hpp"

#include "geometry/base/error.hpp"

namespace isopatch::iga {
namespace {

using Eigen::Index;
using Eigen::VectorXd;
using Sparse = Eigen::SparseMatrix<double>;

// How much more jumps cost than the stiffness beside them: what is left of them at degree 4, where they
// differ most, no longer costs iterations (32 for 50 with 100), and eleven digits remain.
constexpr double weight_of_jumps = 1e5;

Sparse both_triangles(const solvers::SymmetricBlockMatrix& matrix) {
  std::vector<Eigen::Triplet<double>> entries;
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
  Sparse result(matrix.rows(), matrix.rows());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

// The columns of some rows of nodes alone.
solvers::ConstraintMatrix columns_of(const solvers::ConstraintMatrix& b, const std::vector<Index>& places) {
  std::vector<int> place_of(static_cast<std::size_t>(b.cols()), -1);
  for (std::size_t i = 0; i < places.size(); ++i)
    place_of[static_cast<std::size_t>(places[i])] = static_cast<int>(i);
  std::vector<Eigen::Triplet<double>> entries;
  for (Index i = 0; i < b.rows(); ++i)
    for (solvers::ConstraintMatrix::InnerIterator it(b, i); it; ++it)
      entries.emplace_back(static_cast<int>(i), place_of[static_cast<std::size_t>(it.col())], it.value());
  solvers::ConstraintMatrix result(b.rows(), static_cast<Index>(places.size()));
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace

MortarProjection::MortarProjection(const solvers::ConstraintMatrix& b, const solvers::SharedRows& rows,
                                   const InterfaceMatrix& of_faces)
    : rows_of_vectors_(b.cols()), rows_(rows) {
  if (b.rows() == 0) return;
  for (const int row : of_faces.rows)
    for (int i = 0; i < 3; ++i) places_.push_back(3 * Index{row} + i);
  b_ = columns_of(b, places_);
  const Sparse stiffness = both_triangles(of_faces.matrix);
  by_diagonal_ = b_ * VectorXd(stiffness.diagonal()).cwiseInverse().asDiagonal();
  const Sparse schur = by_diagonal_ * b_.transpose();
  weight_ = weight_of_jumps * static_cast<double>(schur.rows()) / VectorXd(schur.diagonal()).sum();
  of_jumps_.emplace(schur);
  of_nodes_.emplace(Sparse(stiffness + Sparse(weight_ * (Sparse(b_.transpose()) * Sparse(b_)))));
  if (!of_jumps_->is_positive_definite() || !of_nodes_->is_positive_definite())
    throw Error(ErrorCode::singular_system,
                "the multipliers between faces that do not match depend on each other; use "
                "coupling.non_matching = \"nitsche\", or halve the elements there");
}

// A displacement of the faces' nodes with B x = jump.
VectorXd MortarProjection::correction(const VectorXd& jump) const {
  const VectorXd first = of_nodes_->solve(weight_ * (b_.transpose() * jump));
  return first + by_diagonal_.transpose() * of_jumps_->solve(jump - b_ * first);
}

VectorXd MortarProjection::particular(const VectorXd& g) const {
  VectorXd result = VectorXd::Zero(rows_of_vectors_);
  if (of_nodes_) result(places_) = correction(g);
  rows_.sum(result);
  return result;
}

VectorXd MortarProjection::project(const VectorXd& x) const {
  return x - particular(of_nodes_ ? VectorXd(b_ * x(places_)) : VectorXd(0));
}

VectorXd MortarProjection::multipliers(const VectorXd& force) const {
  if (!of_nodes_) return VectorXd(0);
  const VectorXd here = force(places_);
  const VectorXd second = of_jumps_->solve(by_diagonal_ * here);
  return second + weight_ * (b_ * of_nodes_->solve(here - b_.transpose() * second));
}

VectorXd MortarProjection::reduce(const VectorXd& force) const {
  VectorXd taken = VectorXd::Zero(rows_of_vectors_);
  if (of_nodes_) taken(places_) = b_.transpose() * multipliers(force);
  rows_.sum(taken);
  return force - taken;
}

}  // namespace isopatch::iga
