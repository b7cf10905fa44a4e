#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "solvers/block_size.hpp"
#include "solvers/processes.hpp"

namespace isopatch::solvers {

/// The block rows of one system, spread over the processes.
///
/// Every process keeps a *local vector*: three values (or `block_size`) for each block row that its elements
/// touch. Rows touched by several processes are shared. A local vector is *consistent* if all processes have
/// the same values at shared rows, *additive* if the true value is their sum. Every row has one owner, the
/// lowest process that shares it.
///
/// All processes must call `sum`, `dot`, `norm` and `whole` in the same order.
class SharedRows {
 public:
  using ExtendedVector = Eigen::Matrix<long double, Eigen::Dynamic, 1>;

  /// One process that has all rows. Vectors of other lengths do as well.
  explicit SharedRows(int block_rows = 0);

  /// @param processes_of_row  of every block row of the whole system: the processes that touch it,
  /// increasing;
  ///                          the same on all processes
  /// The local rows are those that this process touches, in the order of the whole system.
  explicit SharedRows(const std::vector<std::vector<int>>& processes_of_row,
                      const Processes& processes = Processes::launched(), int unknowns_per_row = block_size);

  /// Block rows of this process, and of the whole system.
  int local_rows() const;
  int global_rows() const;
  /// Place of each local block row in the whole system.
  const std::vector<int>& global_of_local() const;
  /// Local block rows that this process owns, increasing.
  const std::vector<int>& owned() const;
  /// Whether there are several processes, so that sums talk to others.
  bool is_distributed() const;
  const Processes& processes() const;

  /// Makes an additive vector consistent, the same to the last bit on all processes. (block size * local
  /// rows)
  /// @cost  one message each way per neighbour
  void sum(Eigen::VectorXd& x) const;
  /// The same in extended precision, for sums whose terms cancel.
  void sum(ExtendedVector& x) const;
  /// Scalar product of two consistent vectors, every row counted once. The same on all processes.
  double dot(const Eigen::VectorXd& a, const Eigen::VectorXd& b) const;
  /// Length of a consistent vector; squares neither overflow nor vanish.
  double norm(const Eigen::VectorXd& x) const;

  /// A consistent vector as a vector of the whole system, on all processes.
  Eigen::VectorXd whole(const Eigen::VectorXd& x) const;
  /// The local rows of a vector of the whole system.
  Eigen::VectorXd part(const Eigen::VectorXd& whole) const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

}  // namespace isopatch::solvers
