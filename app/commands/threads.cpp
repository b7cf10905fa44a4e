#include "app/commands/threads.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "app/base/engineering_units.hpp"
#include "solvers/blas_threads.hpp"
#include "solvers/cores.hpp"

namespace isopatch::app {
namespace {

/// What to say of threads that outnumber the cores; empty if they do not.
std::string crowd_warning(const solvers::Crowd& crowd) {
  if (!crowd.is_too_large()) return "";
  const int fair = std::max(1, crowd.cores / crowd.processes);
  const std::string cores = counted(crowd.cores, "core");
  if (crowd.processes == 1)
    return fmt::format("{} threads on {}: they take turns, which is slower than --threads {}", crowd.threads,
                       cores, fair);
  return fmt::format(
      "{} processes with {} threads in all on {} of one computer: they take turns, which is slower than "
      "fewer; give "
      "them more cores (mpiexec --bind-to none, srun -c THREADS) or use --threads {}",
      crowd.processes, crowd.threads, cores, fair);
}

}  // namespace

void set_threads(int asked, const solvers::Processes& processes, const Console& console) {
  if (asked > 0)
    omp_set_num_threads(asked);
  else if (processes.count() > 1 && !std::getenv("OMP_NUM_THREADS"))
    omp_set_num_threads(processes.fair_threads(omp_get_max_threads()));
  // Threads of OpenMP regions would otherwise multiply with those of the BLAS; factorizations raise it again.
  solvers::set_blas_threads(1);
  const std::string warning = crowd_warning(solvers::largest_crowd(processes, omp_get_max_threads()));
  if (!warning.empty() && processes.is_first()) console.warn(warning);
}

}  // namespace isopatch::app
