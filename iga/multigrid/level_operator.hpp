#pragma once

#include <Eigen/Core>
#include <vector>

#include "iga/assembly/surface_stiffness.hpp"
#include "iga/multigrid/level.hpp"
#include "iga/operator/stiffness_operator.hpp"

namespace isopatch::iga {

/// Gathers a vector of nodes into rows: sums the nodes of every local row. (3 x nodes -> local rows),
/// additive over processes.
Eigen::VectorXd sum_of_nodes(const Level& level, const Eigen::Matrix3Xd& of_nodes);
/// Scatters a vector of rows to nodes: the transpose. (Consistent local rows -> 3 x nodes), 0 where the row
/// belongs to other processes only.
Eigen::Matrix3Xd at_nodes(const Level& level, const Eigen::VectorXd& of_rows);

/// The stiffness of one level between unknowns, that of springs and non-matching interfaces included, without
/// a matrix.
class LevelOperator {
 public:
  /// `level` must outlive it.
  LevelOperator(const Level& level, const std::vector<Material>& materials, int points,
                const SurfaceTerms& surfaces = {});
  /// @param spaces  those of the level, but for their Gauss points; must outlive it as well
  LevelOperator(const Level& level, const std::vector<PatchSpace>& spaces,
                const std::vector<Material>& materials, int points, const SurfaceTerms& surfaces = {});

  /// K x for consistent local vectors; the fixed components of the result are 0. (3 rows)
  Eigen::VectorXd apply(const Eigen::VectorXd& x) const;
  /// The same for several vectors, a column each. (3 rows, vectors)
  Eigen::MatrixXd apply_each(const Eigen::MatrixXd& x) const;
  /// Forces of a displacement in coordinate axes, without regard to supports: additive. (3 rows)
  Eigen::VectorXd forces(const Eigen::VectorXd& displacement) const;
  /// The same for several displacements, a column each. (3 rows, displacements)
  Eigen::MatrixXd forces_each(const Eigen::MatrixXd& displacements) const;
  /// The diagonal blocks of the local rows in coordinate axes, summed over processes.
  std::vector<Eigen::Matrix3d> diagonal() const;
  /// Stiffness of supports and of interfaces that do not match, which is added to that of the elements.
  const NodeBlocks& surfaces() const { return surfaces_; }

 private:
  const Level* level_;
  StiffnessOperator stiffness_;
  NodeBlocks surfaces_;
};

}  // namespace isopatch::iga
