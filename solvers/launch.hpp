#pragma once

namespace isopatch::solvers {

/// What a launcher says in the environment about the processes that it started.
struct Launch {
  int count = 1;
  int rank = 0;
};
/// From Open MPI's variables, PMI's, or Slurm's of a job step (those of a batch script count its tasks, not
/// this program's); one process without a launcher. Does not start MPI.
Launch launch();

}  // namespace isopatch::solvers
