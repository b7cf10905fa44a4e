#include "solvers/launch.hpp"

#include <algorithm>
#include <cstdlib>

namespace isopatch::solvers {

Launch launch() {
  struct Names {
    const char* count;
    const char* rank;
  };
  // In this order: mpiexec uses srun to start itself on other computers.
  constexpr Names known[] = {{"OMPI_COMM_WORLD_SIZE", "OMPI_COMM_WORLD_RANK"},
                             {"PMI_SIZE", "PMI_RANK"},
                             {"SLURM_STEP_NUM_TASKS", "SLURM_PROCID"}};
  for (const Names& names : known) {
    const char* const count = std::getenv(names.count);
    const char* const rank = std::getenv(names.rank);
    if (count && rank) return {std::max(1, std::atoi(count)), std::atoi(rank)};
  }
  return {};
}

}  // namespace isopatch::solvers
