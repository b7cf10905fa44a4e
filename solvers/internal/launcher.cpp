#include "solvers/internal/launcher.hpp"

#include <fmt/format.h>
#include <mpi.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string_view>
#include <vector>

namespace isopatch::solvers {
namespace {

// Those of Open MPI that a user would set (OMPI_MCA_btl, OMPI_ALLOW_RUN_AS_ROOT) are not among them.
constexpr std::array<std::string_view, 11> of_launchers = {
    "PMIX_",        "PMI_",           "SLURM_",       "OMPI_COMM_WORLD_", "OMPI_UNIVERSE_SIZE",
    "OMPI_APP_CTX", "OMPI_MCA_orte_", "OMPI_MCA_ess", "OMPI_MCA_pmix",    "OMPI_NUM_APP_CTX",
    "PRTE_"};

std::string environment_value(const char* name) {
  const char* const value = std::getenv(name);
  return value ? value : "";
}

// A shell in a step of PMIx hands its variables on to the steps that it starts itself.
bool is_of_this_step(const std::string& space) {
  constexpr std::string_view slurms = "slurm.pmix.";
  return !space.starts_with(slurms) ||
         space == fmt::format("{}{}.{}", slurms, environment_value("SLURM_JOB_ID"),
                              environment_value("SLURM_STEP_ID"));
}

}  // namespace

std::string launcher_objection(int started) {
#ifdef OPEN_MPI
  const std::string space = environment_value("PMIX_NAMESPACE");
  if (!environment_value("OMPI_COMM_WORLD_SIZE").empty() || (!space.empty() && is_of_this_step(space)))
    return "";
  return fmt::format(
      "{} processes were started that cannot find each other, because their launcher does not speak PMIx: "
      "with "
      "Slurm use srun --mpi=pmix (srun --mpi=list says whether it has it), else the mpiexec of Open MPI",
      started);
#else
  static_cast<void>(started);
  return "";
#endif
}

void leave_launcher() {
  std::vector<std::string> names;
  for (char** entry = environ; entry != nullptr && *entry != nullptr; ++entry) {
    const std::string_view name = std::string_view(*entry).substr(0, std::string_view(*entry).find('='));
    if (std::any_of(of_launchers.begin(), of_launchers.end(),
                    [&](std::string_view start) { return name.starts_with(start); }))
      names.emplace_back(name);
  }
  for (const std::string& name : names) ::unsetenv(name.c_str());
}

}  // namespace isopatch::solvers
