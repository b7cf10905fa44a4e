#pragma once

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

#include "iga/assembly/mortar_constraints.hpp"

namespace isopatch::iga {

/// Displacements that satisfy mortar constraints B u = g: the inner nodes of the slave faces, which are those
/// on none of their shared edges and as many as constraints, follow from all other nodes.
class MortarProjection {
 public:
  /// @param b             `mortar_matrix`; must outlive this
  /// @param sizes         functions per direction of every patch
  /// @param first_node    of every patch
  /// @param row_of_node   block rows of b's columns
  /// @param frame_of_row  one per row
  /// @throws Error unsupported  a slave face without inner nodes, or with supports on them
  /// @cost   a sparse factorization of the inner nodes of each slave face
  MortarProjection(const MortarConstraints& constraints, const solvers::ConstraintMatrix& b,
                   const std::vector<std::array<int, 3>>& sizes, const std::vector<int>& first_node,
                   const std::vector<int>& row_of_node, const std::vector<const SupportFrame*>& frame_of_row);
  ~MortarProjection();

  /// x with its inner nodes of slave faces changed so that B x = 0. (3 rows)
  Eigen::VectorXd project(Eigen::VectorXd x) const;
  /// The transpose: forces on the slaves' inner nodes moved to all others. (3 rows)
  Eigen::VectorXd moved_to_masters(Eigen::VectorXd force) const;
  /// The displacement of slaves' inner nodes alone with B x = g. (3 rows)
  Eigen::VectorXd particular(const Eigen::VectorXd& g) const;
  /// The multipliers that balance a force where it acts on the slaves' inner nodes: B^T y = force there.
  Eigen::VectorXd multipliers(const Eigen::VectorXd& force) const;

 private:
  struct Factors;
  Eigen::VectorXd on_inner(const Eigen::VectorXd& x) const;
  void add_to_inner(const Eigen::VectorXd& values, Eigen::VectorXd& x) const;

  const solvers::ConstraintMatrix* b_;
  std::vector<int> inner_;  // rows
  std::unique_ptr<Factors> factors_;
};

}  // namespace isopatch::iga
