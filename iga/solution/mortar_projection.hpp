#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "geometry/base/sparse_lu.hpp"
#include "iga/multigrid/interface_block.hpp"
#include "solvers/linear_system.hpp"

namespace isopatch::iga {

/// Displacements that satisfy mortar constraints B u = g, from others by a change of least energy of the
/// nodes on both sides of the faces, while all others stay where they are.
class MortarProjection {
 public:
  /// @param b         `mortar_matrix` of this process; must outlive this
  /// @param rows      of b's columns
  /// @param of_faces  the stiffness between the faces' nodes, without what ties them
  /// @throws Error singular_system  where constraints depend on each other
  /// @cost   a sparse factorization of the faces' nodes and multipliers
  MortarProjection(const solvers::ConstraintMatrix& b, const solvers::SharedRows& rows,
                   const InterfaceMatrix& of_faces);

  // Below: consistent vectors of the local rows; all processes must call together.

  /// The nearest x with B x = 0. (3 rows)
  Eigen::VectorXd project(Eigen::VectorXd x) const;
  /// The transpose: forces less those of the multipliers that take up what projection takes away. (3 rows)
  Eigen::VectorXd reduce(Eigen::VectorXd force) const;
  /// The displacement of least energy with B x = g. (3 rows)
  Eigen::VectorXd particular(const Eigen::VectorXd& g) const;
  /// The multipliers y, of this process, that balance a force as far as B^T y can.
  Eigen::VectorXd multipliers(const Eigen::VectorXd& force) const;

 private:
  const solvers::ConstraintMatrix* b_;
  solvers::SharedRows rows_;
  std::vector<Eigen::Index> places_;  // unknowns of the faces' nodes
  double scale_ = 1;                  // s
  std::optional<SparseLu> factors_;   // of [[H, s B^T], [s B, 0]]; none without constraints
};

}  // namespace isopatch::iga
