#include "solvers/block_jacobi.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>

#include "geometry/base/error.hpp"

namespace isopatch::solvers {

BlockJacobi::BlockJacobi(const SymmetricBlockMatrix& matrix) : inverses_(matrix.block_rows()) {
  for (int row = 0; row < matrix.block_rows(); ++row) {
    const Eigen::Map<const Eigen::Matrix3d> block(matrix.values.data() +
                                                  block_entries * matrix.row_start[row]);
    const Eigen::LLT<Eigen::Matrix3d> cholesky(block);
    if (cholesky.info() != Eigen::Success)
      throw Error(
          ErrorCode::singular_system,
          fmt::format(
              "the matrix is not positive definite: its diagonal block {} has no Cholesky factor; the "
              "block row belongs to no element, or the matrix was assembled wrongly",
              row));
    inverses_[row] = cholesky.solve(Eigen::Matrix3d::Identity());
  }
}

Eigen::VectorXd BlockJacobi::apply(const Eigen::VectorXd& x) const {
  Eigen::VectorXd y(x.size());
#pragma omp parallel for schedule(static) if (inverses_.size() > 10000)
  for (std::size_t row = 0; row < inverses_.size(); ++row)
    y.segment<block_size>(block_size * row).noalias() =
        inverses_[row] * x.segment<block_size>(block_size * row);
  return y;
}

}  // namespace isopatch::solvers
