#include "solvers/internal/mpi_session.hpp"

#include <cstdlib>

#include "geometry/base/error.hpp"
#include "solvers/internal/launcher.hpp"
#include "solvers/launch.hpp"

namespace isopatch::solvers {
namespace {

// Alone, Open MPI would start a helper process that only spawning more processes would need; leaving it
// out saves 0.15 s. Whoever sets the variable himself has his way.
void prepare_to_be_alone() {
  leave_launcher();
  ::setenv("OMPI_MCA_ess_singleton_isolated", "1", 0);
  // Programs that begin and end at the same time take away each other's folders below /tmp, and fail.
  ::setenv("OMPI_MCA_orte_create_session_dirs", "0", 0);
}

// Lives from the first use of MPI to the end of the process.
class MpiSession {
 public:
  MpiSession() {
    int running = 0;
    MPI_Initialized(&running);
    if (running) return;
    if (launch().count == 1) prepare_to_be_alone();
    int provided = 0;
    if (MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &provided) != MPI_SUCCESS)
      throw Error(ErrorCode::internal, "MPI could not be started");
    started_ = true;
  }
  ~MpiSession() {
    int finished = 0;
    MPI_Finalized(&finished);
    if (started_ && !finished) MPI_Finalize();
  }
  MpiSession(const MpiSession&) = delete;
  MpiSession& operator=(const MpiSession&) = delete;

 private:
  bool started_ = false;
};

}  // namespace

void start_mpi() {
  static const MpiSession session;
}

}  // namespace isopatch::solvers
