#pragma once

#include <Eigen/Core>
#include <vector>

#include "iga/assembly/node_blocks.hpp"
#include "iga/multigrid/elasticity_multigrid.hpp"
#include "iga/operator/stiffness_operator.hpp"
#include "iga/solution/coupled_problem.hpp"

namespace isopatch::iga {

/// The saddle point of patches that multipliers tie, without a matrix, spread over processes.
///
/// Block rows: the nodes, three components each along the frame of its global node; then one for every node
/// but the first of each global node, the forces that tie it to the first, along the same frame. The unknowns
/// of such a node are its jump, the displacement less that of the first: jumps fade, and as unknowns keep all
/// digits however much they cost. A process keeps all nodes and ties of every global node of which it has
/// one: whatever couples patches is local then, and only the forces of elements are summed over processes.
///
/// K + g Q stands for K, with Q the projection onto jumps and g a stiffness per global node: it is positive
/// definite where K is singular on floating patches, and the solution is the same.
class SaddlePoint {
 public:
  /// @param level      the finest one; must outlive this, as must all others
  /// @param multigrid  for what is continuous
  /// @param diagonal   of the level's rows, the 3 x 3 diagonal blocks of the stiffness
  SaddlePoint(const CoupledProblem& coupled, const Level& level, const ElasticityMultigrid& multigrid,
              const std::vector<Eigen::Matrix3d>& diagonal);

  const solvers::SharedRows& rows() const { return rows_; }

  /// The product of K + g Q, B and B^T. Here and below: consistent local vectors. (3 rows)
  Eigen::VectorXd product(const Eigen::VectorXd& z) const;

  /// Block diagonal: the multigrid on what is continuous, 1 / g on jumps, g (B B^T)^-1 on multipliers.
  Eigen::VectorXd preconditioned(const Eigen::VectorXd& r) const;

  /// The right side: loads, less what prescribed displacements cause.
  Eigen::VectorXd load(const RightSide& side) const;

  /// Displacements of all nodes with what the side prescribes, the same on every process. (3, nodes), m
  Eigen::Matrix3Xd displacement(const Eigen::VectorXd& z, const RightSide& side) const;

  /// One per MultiplierRow, the same on every process: those without g Q, which takes its share of the force
  /// as long as jumps are not quite closed. N
  Eigen::VectorXd multipliers(const Eigen::VectorXd& z) const;

 private:
  // Nodes that are one point of the body, with their places among the rows.
  struct TiedNodes {
    std::vector<Eigen::Index> nodes;  // local rows, first the one that the others are tied to
    Eigen::Index first_tie = 0;       // local row
    int free = 3;                     // components that supports leave
    double jump_stiffness = 0;        // N/m
  };
  struct Node {
    int node = 0;           // of all patches
    int row_of_global = 0;  // of the level
    bool is_first = true;   // of its global node, and not a jump
    const SupportFrame* frame = nullptr;
  };
  static Eigen::Vector3d sum_of_jumps(const TiedNodes& tied, const Eigen::VectorXd& z);
  void move_all_by_first(Eigen::VectorXd& forces) const;
  Eigen::VectorXd values_of(Eigen::VectorXd z) const;
  void add_tie_inverse(const TiedNodes& tied, const Eigen::VectorXd& in, Eigen::VectorXd& out) const;
  Eigen::VectorXd on_unknowns(const Eigen::Matrix3Xd& forces) const;
  Eigen::Matrix3Xd forces_of(const Eigen::Matrix3Xd& displacement) const;

  const CoupledProblem* coupled_;
  const Level* level_;
  const ElasticityMultigrid* multigrid_;
  StiffnessOperator stiffness_;
  NodeBlocks surfaces_;
  solvers::SharedRows rows_;
  std::vector<int> first_tie_;  // per global node, row of the whole system
  std::vector<Node> nodes_;     // of the first local rows
  std::vector<TiedNodes> tied_;
};

}  // namespace isopatch::iga
