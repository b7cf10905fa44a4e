#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "geometry/base/sparse_cholesky.hpp"
#include "iga/multigrid/interface_block.hpp"
#include "solvers/linear_system.hpp"

namespace isopatch::iga {

/// Displacements that satisfy mortar constraints B u = g, from others by a change of nearly the least energy
/// of the nodes on both sides of the faces, while all others stay where they are.
///
/// With H the stiffness between the faces' nodes a first change, by (H + w B^T B)^-1 w B^T, leaves next to
/// nothing of B u - g; a second one, the least in the metric of H's diagonal D, takes the rest:
///
///     P = (I - D^-1 B^T (B D^-1 B^T)^-1 B) (I - (H + w B^T B)^-1 w B^T B)
class MortarProjection {
 public:
  /// @param b         `mortar_matrix` of this process; must outlive this
  /// @param rows      of b's columns
  /// @param of_faces  the stiffness between the faces' nodes, without what ties them
  /// @throws Error singular_system  where constraints depend on each other
  /// @cost   sparse factorizations of the faces' nodes and of the multipliers
  MortarProjection(const solvers::ConstraintMatrix& b, const solvers::SharedRows& rows,
                   const InterfaceMatrix& of_faces);

  // Below: consistent vectors of the local rows; all processes must call together.

  /// P x, with B x = 0. (3 rows)
  Eigen::VectorXd project(const Eigen::VectorXd& x) const;
  /// P^T f: forces less those of the multipliers that take up what projection takes away. (3 rows)
  Eigen::VectorXd reduce(const Eigen::VectorXd& force) const;
  /// A small displacement with B x = g. (3 rows)
  Eigen::VectorXd particular(const Eigen::VectorXd& g) const;
  /// The multipliers y, of this process, that balance a force: f - B^T y = P^T f.
  Eigen::VectorXd multipliers(const Eigen::VectorXd& force) const;

 private:
  Eigen::VectorXd correction(const Eigen::VectorXd& jump) const;

  Eigen::Index rows_of_vectors_ = 0;
  solvers::SharedRows rows_;
  std::vector<Eigen::Index> places_;        // unknowns of the faces' nodes
  solvers::ConstraintMatrix b_;             // of these
  solvers::ConstraintMatrix by_diagonal_;   // B D^-1
  double weight_ = 0;                       // w
  std::optional<SparseCholesky> of_nodes_;  // H + w B^T B; none without constraints
  std::optional<SparseCholesky> of_jumps_;  // B D^-1 B^T
};

}  // namespace isopatch::iga
