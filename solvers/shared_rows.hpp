#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

namespace isopatch::solvers {

/// The block rows of one system, spread over the processes.
///
/// Every process keeps a *local vector*: three values for each block row that its elements touch. Rows
/// touched by several processes are shared. A local vector is *consistent* if all processes have the same
/// values at shared rows, *additive* if the true value is their sum. Every row has one owner, the lowest
/// process that shares it.
class SharedRows {
 public:
  /// One process that has all rows.
  explicit SharedRows(int block_rows = 0);

  /// @param processes_of_row  of every block row of the whole system: the processes that touch it,
  /// increasing;
  ///                          the same on all processes
  /// The local rows are those that this process touches, in the order of the whole system.
  explicit SharedRows(const std::vector<std::vector<int>>& processes_of_row);

  /// Block rows of this process, and of the whole system.
  int local_rows() const;
  int global_rows() const;
  /// Place of each local block row in the whole system.
  const std::vector<int>& global_of_local() const;
  /// Local block rows that this process owns, increasing.
  const std::vector<int>& owned() const;
  /// Whether any row is shared, so that `sum` talks to others.
  bool is_distributed() const;

  /// Makes an additive vector consistent, the same to the last bit on all processes. (3 local rows)
  void sum(Eigen::VectorXd& x) const;
  /// Scalar product of two consistent vectors, every row counted once. The same on all processes.
  double dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

}  // namespace isopatch::solvers
