#include "solvers/internal/krylov.hpp"

#include <algorithm>
#include <cmath>
#include <exception>

#include "solvers/block_size.hpp"
#include "solvers/internal/petsc_shell.hpp"

namespace isopatch::solvers {
namespace {

Eigen::VectorXd to_owned(const SharedRows& rows, const Eigen::VectorXd& local) {
  if (!rows.is_distributed()) return local;
  Eigen::VectorXd owned(block_size * static_cast<Eigen::Index>(rows.owned().size()));
  for (std::size_t k = 0; k < rows.owned().size(); ++k)
    owned.segment<block_size>(block_size * static_cast<Eigen::Index>(k)) =
        local.segment<block_size>(block_size * static_cast<Eigen::Index>(rows.owned()[k]));
  return owned;
}

Eigen::VectorXd to_local(const SharedRows& rows, const Eigen::VectorXd& owned) {
  if (!rows.is_distributed()) return owned;
  Eigen::VectorXd local = Eigen::VectorXd::Zero(block_size * static_cast<Eigen::Index>(rows.local_rows()));
  for (std::size_t k = 0; k < rows.owned().size(); ++k)
    local.segment<block_size>(block_size * static_cast<Eigen::Index>(rows.owned()[k])) =
        owned.segment<block_size>(block_size * static_cast<Eigen::Index>(k));
  rows.sum(local);
  return local;
}

LinearOperator on_owned(const SharedRows& rows, const LinearOperator& apply) {
  if (!rows.is_distributed()) return apply;
  return [rows, apply](const Eigen::VectorXd& x) { return to_owned(rows, apply(to_local(rows, x))); };
}

// What PETSc hands back to us after each iteration.
struct Monitor {
  const Progress& progress;
  double goal;
  double start = 1;
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
  // MINRES starts from another norm than CG, but both reduce the error's.
  if (monitor.norms.empty()) monitor.start = norm > 0 ? norm : 1;
  monitor.norms.push_back(norm / monitor.start);

  try {
    monitor.progress("iterations", finished_share(1, monitor.norms.back(), monitor.goal));
  } catch (...) {
    monitor.thrown = std::current_exception();
    return PETSC_ERR_USER;
  }
  return 0;
}

}  // namespace

KrylovSolution iterate(const SharedRows& rows, const LinearOperator& product,
                       const LinearOperator& preconditioner, const Eigen::VectorXd& right_side,
                       const KrylovOptions& options, const Progress& progress) {
  using petsc::check;
  const LinearOperator product_owned = on_owned(rows, product);
  const LinearOperator preconditioner_owned = on_owned(rows, preconditioner);
  const Eigen::VectorXd b_owned = to_owned(rows, right_side);
  const petsc::Matrix matrix =
      petsc::shell_matrix(PETSC_COMM_WORLD, static_cast<int>(b_owned.size()), product_owned);
  petsc::Krylov krylov;
  check(KSPCreate(PETSC_COMM_WORLD, krylov.receive()), "make a Krylov solver");
  KSP ksp = krylov.get();
  const bool cg = options.method == Krylov::conjugate_gradients;
  check(KSPSetType(ksp, cg ? KSPCG : KSPMINRES), "choose the Krylov method");
  check(KSPSetOperators(ksp, matrix.get(), matrix.get()), "set the matrix");
  const KSPNormType norm = options.norm == ErrorNorm::residual ? KSP_NORM_UNPRECONDITIONED
                           : cg                                ? KSP_NORM_NATURAL
                                                               : KSP_NORM_PRECONDITIONED;
  check(KSPSetNormType(ksp, norm), "choose the norm");
  check(KSPSetTolerances(ksp, options.reduction, 1e-300, PETSC_DEFAULT, options.max_iterations),
        "set tolerances");
  PC pc = nullptr;
  check(KSPGetPC(ksp, &pc), "reach the preconditioner");
  petsc::use_shell(pc, preconditioner_owned);
  Monitor monitor{progress, options.reduction};
  check(KSPMonitorSet(ksp, after_iteration, &monitor, nullptr), "listen to the iterations");
  KrylovSolution solution;
  Eigen::VectorXd x_owned = Eigen::VectorXd::Zero(b_owned.size());
  const petsc::Vector b = petsc::view(PETSC_COMM_WORLD, b_owned, block_size);
  const petsc::Vector x = petsc::view(PETSC_COMM_WORLD, x_owned, block_size);
  const PetscErrorCode code = KSPSolve(ksp, b.get(), x.get());
  if (monitor.thrown) std::rethrow_exception(monitor.thrown);
  check(code, "iterate");
  check(KSPGetConvergedReason(ksp, &solution.reason), "ask how the iteration ended");
  solution.x = to_local(rows, x_owned);
  solution.errors = std::move(monitor.norms);
  return solution;
}

}  // namespace isopatch::solvers
