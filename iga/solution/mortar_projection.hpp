#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <vector>

#include "geometry/base/sparse_lu.hpp"
#include "iga/assembly/mortar_constraints.hpp"

namespace isopatch::iga {

/// Displacements that satisfy mortar constraints B u = g: components of nodes of the slave faces on none of
/// their shared edges, of which there are as many as constraints, follow from all others.
class MortarProjection {
 public:
  /// @param constraints   those of this process
  /// @param b             their `mortar_matrix`; must outlive this
  /// @param rows          of b's columns
  /// @param sizes         functions per direction of every patch
  /// @param first_node    of every patch
  /// @param row_of_node   block rows of b's columns
  /// @param frame_of_row  one per row
  /// @throws Error unsupported  where none follow, or supports hold them
  /// @cost   a sparse factorization of the nodes of the slave faces
  MortarProjection(const MortarConstraints& constraints, const solvers::ConstraintMatrix& b,
                   const solvers::SharedRows& rows, const std::vector<std::array<int, 3>>& sizes,
                   const std::vector<int>& first_node, const std::vector<int>& row_of_node,
                   const std::vector<const SupportFrame*>& frame_of_row);

  // Below: consistent vectors of the local rows; all processes must call together.

  /// x with its followers changed so that B x = 0. (3 rows)
  Eigen::VectorXd project(Eigen::VectorXd x) const;
  /// The transpose: forces on followers moved to all others. (3 rows)
  Eigen::VectorXd moved_to_masters(Eigen::VectorXd force) const;
  /// The displacement of followers alone with B x = g. (3 rows)
  Eigen::VectorXd particular(const Eigen::VectorXd& g) const;
  /// The multipliers that balance a force where it acts on followers: B^T y = force there. Of this process.
  Eigen::VectorXd multipliers(const Eigen::VectorXd& force) const;

 private:
  Eigen::VectorXd followers_for(const Eigen::VectorXd& g) const;

  const solvers::ConstraintMatrix* b_;
  solvers::SharedRows rows_;
  std::vector<Eigen::Index> followers_;  // scalar unknowns
  std::optional<SparseLu> factors_;      // of their columns; none without followers
};

}  // namespace isopatch::iga
