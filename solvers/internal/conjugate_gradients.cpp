#include "solvers/internal/conjugate_gradients.hpp"

#include <algorithm>
#include <cmath>
#include <exception>

namespace isopatch::solvers {
namespace {

// What PETSc hands back to us after each iteration.
struct Monitor {
  const Progress& progress;
  double goal;
  std::vector<double> norms = {};
  std::exception_ptr thrown = nullptr;
};

double finished_share(double first, double now, double goal) {
  if (!(now < first) || !(goal < first)) return 0;
  return std::clamp(std::log(first / now) / std::log(first / goal), 0.0, 1.0);
}

// An exception of the listener must not fly through PETSc's C code.
PetscErrorCode after_iteration(KSP, PetscInt, PetscReal norm, void* context) {
  auto& monitor = *static_cast<Monitor*>(context);
  monitor.norms.push_back(norm);
  try {
    monitor.progress("iterations", finished_share(monitor.norms.front(), norm, monitor.goal));
  } catch (...) {
    monitor.thrown = std::current_exception();
    return PETSC_ERR_USER;
  }
  return 0;
}

}  // namespace

KrylovSolution conjugate_gradients(const petsc::Matrix& matrix, const ConfigurePreconditioner& configure,
                                   const Eigen::VectorXd& right_side, const KrylovOptions& options,
                                   const Progress& progress) {
  using petsc::check;
  const MPI_Comm communicator = PetscObjectComm(reinterpret_cast<PetscObject>(matrix.get()));
  petsc::Krylov krylov;
  check(KSPCreate(communicator, krylov.receive()), "make a Krylov solver");
  KSP ksp = krylov.get();
  check(KSPSetType(ksp, KSPCG), "choose conjugate gradients");
  check(KSPSetOperators(ksp, matrix.get(), matrix.get()), "set the matrix");
  check(KSPSetNormType(ksp, KSP_NORM_UNPRECONDITIONED), "choose the norm");
  check(KSPSetTolerances(ksp, 0, options.residual, PETSC_DEFAULT, options.max_iterations), "set tolerances");
  PC preconditioner = nullptr;
  check(KSPGetPC(ksp, &preconditioner), "reach the preconditioner");
  configure(preconditioner);
  Monitor monitor{progress, options.residual};
  check(KSPMonitorSet(ksp, after_iteration, &monitor, nullptr), "listen to the iterations");
  KrylovSolution solution;
  solution.x = Eigen::VectorXd::Zero(right_side.size());
  const petsc::Vector b = petsc::view(communicator, right_side, 3),
                      x = petsc::view(communicator, solution.x, 3);
  const PetscErrorCode code = KSPSolve(ksp, b.get(), x.get());
  if (monitor.thrown) std::rethrow_exception(monitor.thrown);
  check(code, "iterate");
  check(KSPGetConvergedReason(ksp, &solution.reason), "ask how the iteration ended");
  solution.residual_norms = std::move(monitor.norms);
  return solution;
}

}  // namespace isopatch::solvers
