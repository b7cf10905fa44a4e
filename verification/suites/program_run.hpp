#pragma once

#include <string>
#include <vector>

#include "iga/spaces/elastic_field.hpp"
#include "verification/claims/expect.hpp"

namespace isopatch::verification {

/// How the program is started.
struct Launch {
  int processes = 1;
  int threads = 1;  ///< of each process
};
/// "4 processes of 1 thread".
std::string words(const Launch& launch);

/// What a run of the program leaves in its files.
struct ProgramRun {
  iga::ElasticField field;
  double energy = 0;            ///< J
  double max_displacement = 0;  ///< m
  int processes = 0;            ///< that solved together, as the summary says
  int threads = 0;
  double error_energy = 0;  ///< estimated energy of the discretization's error, J
};

/// Why no processes can be started on this machine; empty if they can.
/// @cost  that of starting two
std::string launcher_fault();

/// Starts `isopatch run` in processes of its own, through mpiexec where they are several, and reads its
/// results.
///
/// @param study  with the file named from the root of the tree
/// @throws std::runtime_error with what the program said, if it fails
ProgramRun run_program(const ClaimStudy& study, const Launch& launch);

}  // namespace isopatch::verification
