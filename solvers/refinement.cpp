#include "solvers/refinement.hpp"

#include <cmath>
#include <utility>

#include "geometry/base/error.hpp"
#include "solvers/residuals.hpp"

namespace isopatch::solvers {
namespace {

void check_finite(const Eigen::VectorXd& z) {
  if (!z.allFinite())
    throw Error(ErrorCode::singular_system,
                "the factors gave values that are not finite: the matrix is singular to working precision");
}

// The steps of one right side.
class Refinement {
 public:
  Refinement(const ScaledSystem& system, double tolerance)
      : system_(&system), tolerance_(tolerance), load_norm_(system.load_norm()) {}

  const ScaledSystem& system() const { return *system_; }
  bool goes_on(int step) const { return !is_done_ && (step <= 1 || best_.history.back() > tolerance_); }
  // The solution that a correction leads to, from nothing at first.
  Eigen::VectorXd corrected(const Eigen::VectorXd& correction) const {
    Eigen::VectorXd z = best_.history.empty() ? correction : best_.z + correction;
    check_finite(z);
    return z;
  }
  void take(Eigen::VectorXd z, Eigen::VectorXd residual) {
    residual_ = std::move(residual);
    const double after = system_->norm(residual_) / load_norm_;
    if (!best_.history.empty()) {
      const double before = best_.history.back();
      // At the round-off level residuals waver, while the error of z may still shrink.
      is_done_ = after > 0.5 * before;
      if (after > before && after > tolerance_) return;
    }
    best_.z = std::move(z);
    best_.history.push_back(after);
  }

  const Eigen::VectorXd& residual() const { return residual_; }
  RefinedSolution result() { return std::move(best_); }

 private:
  const ScaledSystem* system_;
  double tolerance_;
  double load_norm_;
  RefinedSolution best_;
  Eigen::VectorXd residual_;
  bool is_done_ = false;
};

// One step of some right sides: from their residuals in `columns` to better solutions and what these leave.
void step(const std::vector<Refinement*>& active, Eigen::MatrixXd columns, const ApplyInverse& inverse) {
  columns = inverse(columns);
  std::vector<const ScaledSystem*> systems;
  for (std::size_t i = 0; i < active.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    systems.push_back(&active[i]->system());
    columns.col(k) = active[i]->corrected(columns.col(k));
  }
  const Eigen::MatrixXd left = residuals(systems, columns);
  for (std::size_t i = 0; i < active.size(); ++i)
    active[i]->take(columns.col(static_cast<Eigen::Index>(i)), left.col(static_cast<Eigen::Index>(i)));
}

}  // namespace

std::vector<RefinedSolution> solve_and_refine(const ScaledSystems& systems, const ApplyInverse& inverse,
                                              double tolerance) {
  constexpr int most_steps = 10;
  const Eigen::Index rows = systems.front().rows();
  std::vector<Refinement> all;
  for (const ScaledSystem& system : systems) all.emplace_back(system, tolerance);
  for (int k = 0; k <= most_steps; ++k) {
    std::vector<Refinement*> active;
    for (Refinement& one : all)
      if (one.goes_on(k)) active.push_back(&one);
    if (active.empty()) break;
    Eigen::MatrixXd columns(rows, static_cast<Eigen::Index>(active.size()));
    for (std::size_t i = 0; i < active.size(); ++i)
      columns.col(static_cast<Eigen::Index>(i)) =
          k == 0 ? active[i]->system().right_side() : active[i]->residual();
    step(active, std::move(columns), inverse);
  }
  std::vector<RefinedSolution> result;
  for (Refinement& one : all) result.push_back(one.result());
  return result;
}

std::vector<LinearSolution> with_reports(const ScaledSystems& systems, std::vector<RefinedSolution> refined,
                                         const SolveReport& report, double solve_seconds) {
  std::vector<LinearSolution> result;
  for (std::size_t i = 0; i < refined.size(); ++i) {
    LinearSolution one{systems[i].unknowns(refined[i].z), systems[i].multipliers(refined[i].z), report};
    one.report.residual_history = std::move(refined[i].history);
    one.report.relative_residual = one.report.residual_history.back();
    one.report.iterations = static_cast<int>(one.report.residual_history.size()) - 1;
    one.report.solve_seconds = solve_seconds / static_cast<double>(refined.size());
    result.push_back(std::move(one));
  }
  return result;
}

}  // namespace isopatch::solvers
