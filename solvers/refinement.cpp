#include "solvers/refinement.hpp"

#include <cmath>
#include <utility>

#include "geometry/base/error.hpp"

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

  void start(Eigen::VectorXd z) {
    check_finite(z);
    best_.z = std::move(z);
    residual_ = system_->residual(best_.z);
    best_.history.push_back(system_->norm(residual_) / load_norm_);
  }

  bool goes_on(int step) const { return !is_done_ && (step == 1 || best_.history.back() > tolerance_); }

  void correct(const Eigen::VectorXd& correction) {
    const double before = best_.history.back();
    Eigen::VectorXd z = best_.z + correction;
    check_finite(z);
    residual_ = system_->residual(z);
    const double after = system_->norm(residual_) / load_norm_;
    // At the round-off level residuals waver, while the error of z may still shrink.
    is_done_ = after > 0.5 * before;
    if (after > before && after > tolerance_) return;
    best_.z = std::move(z);
    best_.history.push_back(after);
  }

  const Eigen::VectorXd& residual() const { return residual_; }
  RefinedSolution take() { return std::move(best_); }

 private:
  const ScaledSystem* system_;
  double tolerance_;
  double load_norm_;
  RefinedSolution best_;
  Eigen::VectorXd residual_;
  bool is_done_ = false;
};

}  // namespace

std::vector<RefinedSolution> solve_and_refine(const ScaledSystems& systems, const ApplyInverse& inverse,
                                              double tolerance) {
  constexpr int most_steps = 10;
  const Eigen::Index rows = systems.front().rows();
  std::vector<Refinement> all;
  Eigen::MatrixXd columns(rows, static_cast<Eigen::Index>(systems.size()));
  for (const ScaledSystem& system : systems) {
    columns.col(static_cast<Eigen::Index>(all.size())) = system.right_side();
    all.emplace_back(system, tolerance);
  }
  columns = inverse(columns);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].start(columns.col(static_cast<Eigen::Index>(i)));
  for (int step = 1; step <= most_steps; ++step) {
    std::vector<Refinement*> active;
    for (Refinement& one : all)
      if (one.goes_on(step)) active.push_back(&one);
    if (active.empty()) break;
    columns.resize(rows, static_cast<Eigen::Index>(active.size()));
    for (std::size_t i = 0; i < active.size(); ++i)
      columns.col(static_cast<Eigen::Index>(i)) = active[i]->residual();
    columns = inverse(columns);
    for (std::size_t i = 0; i < active.size(); ++i)
      active[i]->correct(columns.col(static_cast<Eigen::Index>(i)));
  }
  std::vector<RefinedSolution> result;
  for (Refinement& one : all) result.push_back(one.take());
  return result;
}

std::vector<LinearSolution> with_reports(const ScaledSystems& systems, std::vector<RefinedSolution> refined,
                                         const SolveReport& report, double solve_seconds) {
  std::vector<LinearSolution> result;
  for (std::size_t i = 0; i < refined.size(); ++i) {
    LinearSolution one{systems[i].unknowns(refined[i].z), systems[i].multipliers(refined[i].z), report};
    one.report.residual_history = std::move(refined[i].history);
    one.report.iterations = static_cast<int>(one.report.residual_history.size()) - 1;
    one.report.solve_seconds = solve_seconds / static_cast<double>(refined.size());
    result.push_back(std::move(one));
  }
  return result;
}

}  // namespace isopatch::solvers
