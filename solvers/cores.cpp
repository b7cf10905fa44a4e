#include "solvers/cores.hpp"

#include <mpi.h>
#include <omp.h>
#include <sched.h>

#include <algorithm>
#include <bit>
#include <numeric>
#include <vector>

namespace isopatch::solvers {
namespace {

// One bit for each core of the computer: more than Linux knows of.
constexpr std::size_t most_cores = 8192;
constexpr std::size_t bits = 64;
using CoreSet = std::vector<std::uint64_t>;

// Places are read where OpenMP has them, because it then ties the thread that asks to the first one.
CoreSet allowed_cores() {
  CoreSet set(most_cores / bits, 0);
  for (int place = 0; place < omp_get_num_places(); ++place) {
    std::vector<int> cores(static_cast<std::size_t>(omp_get_place_num_procs(place)));
    omp_get_place_proc_ids(place, cores.data());
    for (const int core : cores)
      if (const auto c = static_cast<std::size_t>(core); c < most_cores)
        set[c / bits] |= std::uint64_t{1} << (c % bits);
  }
  if (omp_get_num_places() == 0)
    ::sched_getaffinity(0, most_cores / 8, reinterpret_cast<cpu_set_t*>(set.data()));
  return set;
}

int count(const CoreSet& set) {
  const int found = std::accumulate(set.begin(), set.end(), 0,
                                    [](int sum, std::uint64_t part) { return sum + std::popcount(part); });
  return std::max(1, found);
}

// The processes on one computer, as long as this lives.
class Computer {
 public:
  explicit Computer(const Processes& processes) {
    MPI_Comm_split_type(MPI_COMM_WORLD, MPI_COMM_TYPE_SHARED, processes.rank(), MPI_INFO_NULL, &processes_);
  }
  ~Computer() { MPI_Comm_free(&processes_); }
  Computer(const Computer&) = delete;
  Computer& operator=(const Computer&) = delete;

  int process_count() const {
    int result = 1;
    MPI_Comm_size(processes_, &result);
    return result;
  }
  int sum(int value) const {
    MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_INT, MPI_SUM, processes_);
    return value;
  }
  int cores() const {
    CoreSet set = allowed_cores();
    MPI_Allreduce(MPI_IN_PLACE, set.data(), static_cast<int>(set.size()), MPI_UINT64_T, MPI_BOR, processes_);
    return count(set);
  }

 private:
  MPI_Comm processes_ = MPI_COMM_NULL;
};

}  // namespace

int usable_cores() {
  return count(allowed_cores());
}

Crowd largest_crowd(const Processes& processes, int threads) {
  if (processes.count() == 1) return {1, threads, usable_cores()};
  const Computer computer(processes);
  const Crowd mine{computer.process_count(), computer.sum(threads), computer.cores()};
  struct {
    double for_a_core;
    int rank;
  } most{static_cast<double>(mine.threads) / mine.cores, processes.rank()};
  MPI_Allreduce(MPI_IN_PLACE, &most, 1, MPI_DOUBLE_INT, MPI_MAXLOC, MPI_COMM_WORLD);
  return processes.from(most.rank, mine);
}

int Processes::on_this_computer() const {
  return count_ == 1 ? 1 : Computer(*this).process_count();
}

int Processes::fair_threads(int allowed) const {
  if (count_ == 1) return allowed;
  const Computer computer(*this);
  return std::clamp(computer.cores() / computer.process_count(), 1, std::max(1, allowed));
}

}  // namespace isopatch::solvers
