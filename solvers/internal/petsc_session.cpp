#include "solvers/internal/petsc_session.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "geometry/base/error.hpp"
#include "solvers/internal/mpi_session.hpp"
#include "solvers/internal/petsc_objects.hpp"

namespace isopatch::solvers {
namespace {

// What PETSc said when it last failed; its error codes alone say little.
thread_local std::string last_message;

PetscErrorCode remember_message(MPI_Comm, int, const char* function, const char*, PetscErrorCode code,
                                PetscErrorType type, const char* message, void*) {
  if (type == PETSC_ERROR_INITIAL) last_message = fmt::format("{} (in {})", message ? message : "", function);
  return code;
}

// Lives from the first use of PETSc to the end of the process.
class PetscSession {
 public:
  PetscSession() {
    PetscBool running = PETSC_FALSE;
    PetscInitialized(&running);
    if (running) return;
    PetscOptionsSetValue(nullptr, "-no_signal_handler", "true");
    petsc::check(PetscInitializeNoArguments(), "start PETSc");
    PetscPushErrorHandler(remember_message, nullptr);
    started_ = true;
  }
  ~PetscSession() {
    int mpi_finished = 0;
    MPI_Finalized(&mpi_finished);
    if (!started_ || mpi_finished) return;
    PetscPopErrorHandler();
    PetscFinalize();
  }
  PetscSession(const PetscSession&) = delete;
  PetscSession& operator=(const PetscSession&) = delete;

 private:
  bool started_ = false;
};

}  // namespace

void start_petsc() {
  start_mpi();
  static const PetscSession session;
}

namespace petsc {

void check(PetscErrorCode code, std::string_view action) {
  if (code == 0) return;
  const char* general = nullptr;
  PetscErrorMessage(code, &general, nullptr);
  const std::string detail = std::exchange(last_message, {});
  throw Error(code == PETSC_ERR_MEM ? ErrorCode::out_of_memory : ErrorCode::internal,
              fmt::format("PETSc could not {}: {}{}{}", action, general ? general : "unknown error",
                          detail.empty() ? "" : ": ", detail));
}

Vector view(MPI_Comm communicator, const Eigen::VectorXd& values, int block_size) {
  Vector vector;
  const auto size = static_cast<PetscInt>(values.size());
  check(
      VecCreateMPIWithArray(communicator, block_size, size, PETSC_DETERMINE, values.data(), vector.receive()),
      "make a vector");
  return vector;
}

}  // namespace petsc
}  // namespace isopatch::solvers
