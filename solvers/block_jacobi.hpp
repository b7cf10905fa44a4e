#pragma once

#include <Eigen/Core>
#include <vector>

#include "solvers/block_matrix.hpp"

namespace isopatch::solvers {

/// The inverses of a matrix's diagonal blocks, the simplest preconditioner that knows the coupling of
/// components.
class BlockJacobi {
 public:
  /// @throws Error singular_system  naming the first block that is not positive definite
  explicit BlockJacobi(const SymmetricBlockMatrix& matrix);
  Eigen::VectorXd apply(const Eigen::VectorXd& x) const;

 private:
  std::vector<Eigen::Matrix3d> inverses_;
};

}  // namespace isopatch::solvers
