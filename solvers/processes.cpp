#include "solvers/processes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <limits>

#include "geometry/base/error.hpp"
#include "solvers/internal/launcher.hpp"
#include "solvers/internal/mpi_session.hpp"
#include "solvers/launch.hpp"

namespace isopatch::solvers {
namespace {

// Largest number of values that one call of MPI takes.
constexpr Eigen::Index chunk = std::numeric_limits<int>::max() / 2;

}  // namespace

Processes Processes::launched() {
  Processes result;
  const int expected = launch().count;
  if (expected == 1) return result;
  if (const std::string objection = launcher_objection(expected); !objection.empty())
    throw Error(ErrorCode::unsupported, objection);
  start_mpi();
  MPI_Comm_rank(MPI_COMM_WORLD, &result.rank_);
  MPI_Comm_size(MPI_COMM_WORLD, &result.count_);
  if (result.count_ != expected)
    throw Error(ErrorCode::unsupported,
                fmt::format("{} processes were started, but MPI connects {}: the launcher belongs to another "
                            "MPI than isopatch; use the mpiexec of the MPI that isopatch was built with, or "
                            "with Slurm srun --mpi=pmix",
                            expected, result.count_));
  return result;
}

double Processes::sum(double value) const {
  if (count_ > 1) MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_SUM, MPI_COMM_WORLD);
  return value;
}

std::int64_t Processes::sum(std::int64_t value) const {
  if (count_ > 1) MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_INT64_T, MPI_SUM, MPI_COMM_WORLD);
  return value;
}

double Processes::largest(double value) const {
  if (count_ > 1) MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_DOUBLE, MPI_MAX, MPI_COMM_WORLD);
  return value;
}

void Processes::sum(Eigen::Ref<Eigen::VectorXd> values) const {
  if (count_ == 1) return;
  for (Eigen::Index begin = 0; begin < values.size(); begin += chunk)
    MPI_Allreduce(MPI_IN_PLACE, values.data() + begin,
                  static_cast<int>(std::min(chunk, values.size() - begin)), MPI_DOUBLE, MPI_SUM,
                  MPI_COMM_WORLD);
}

void Processes::broadcast(Eigen::Ref<Eigen::VectorXd> values, int rank) const {
  if (count_ == 1) return;
  for (Eigen::Index begin = 0; begin < values.size(); begin += chunk)
    MPI_Bcast(values.data() + begin, static_cast<int>(std::min(chunk, values.size() - begin)), MPI_DOUBLE,
              rank, MPI_COMM_WORLD);
}

void Processes::broadcast(void* bytes, std::size_t count, int rank) const {
  if (count_ > 1) MPI_Bcast(bytes, static_cast<int>(count), MPI_BYTE, rank, MPI_COMM_WORLD);
}

void Processes::barrier() const {
  if (count_ > 1) MPI_Barrier(MPI_COMM_WORLD);
}

int Processes::fortran_communicator() const {
  return MPI_Comm_c2f(count_ == 1 ? MPI_COMM_SELF : MPI_COMM_WORLD);
}

}  // namespace isopatch::solvers
