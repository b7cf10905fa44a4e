#pragma once

#include <Eigen/Core>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace isopatch::solvers {

/// The processes that work on one problem together, of which this is one. Cheap to copy.
///
/// But for `rank` and `count`, all processes must call the same
/// functions in the same order. Results of sums are the same to the last bit on all processes.
class Processes {
 public:
  /// This process alone. MPI is not needed.
  Processes() = default;

  /// All that a launcher (mpiexec, srun) started with this one; this process alone if there was none, or if
  /// it started one. MPI starts only for several.
  /// @throws Error unsupported  if MPI connects another number than the launcher started
  static Processes launched();

  bool operator==(const Processes&) const = default;

  int rank() const { return rank_; }
  int count() const { return count_; }
  /// Whether this is rank 0, which writes files and reports.
  bool is_first() const { return rank_ == 0; }

  double sum(double value) const;
  std::int64_t sum(std::int64_t value) const;
  double largest(double value) const;
  /// Sums every entry.
  void sum(Eigen::Ref<Eigen::VectorXd> values) const;
  /// The value of one process, on all.
  template <class T>
  T from(int rank, T value) const {
    static_assert(std::is_trivially_copyable_v<T>);
    broadcast(&value, sizeof(T), rank);
    return value;
  }
  /// Overwrites the values by those of one process.
  void broadcast(Eigen::Ref<Eigen::VectorXd> values, int rank) const;
  void barrier() const;

  /// How many of them run on the computer that this one runs on.
  int on_this_computer() const;
  /// Threads for this process if all that run on this computer are to share its cores evenly.
  int fair_threads(int allowed) const;

  /// Fortran handle of the communicator, for libraries. MPI must have started.
  int fortran_communicator() const;

 private:
  void broadcast(void* bytes, std::size_t count, int rank) const;
  int rank_ = 0;
  int count_ = 1;
};

}  // namespace isopatch::solvers
