#include "solvers/load_sequence.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/base/stopwatch.hpp"

namespace isopatch::solvers {
namespace {

using Eigen::VectorXd;

// Below this share of a load, what is across the earlier ones is not worth a direction of its own.
constexpr double least_share = 1e-3;
// Each round brings the error down to the tolerance but for what combining solutions has added.
constexpr int most_rounds = 4;
constexpr double largest_tolerance = 1e-2;  // that iterations may be asked for

double root(double square) {
  return square <= 0 ? 0 : std::sqrt(square);  // what is no number stays none
}

}  // namespace

LinearSolution LoadSequence::solve_alone(const VectorXd& load, const SolverOptions& options,
                                         const Progress& progress) const {
  OperatorSystem alone = *system_;
  alone.load = load;
  return method_ == KrylovMethod::cg ? solve_with_cg(alone, options, progress)
                                     : solve_with_minres(alone, options, progress);
}

// What is left of a load beside the directions known, and the combination of their solutions.
LoadSequence::Split LoadSequence::split(const VectorXd& load) const {
  const SharedRows& rows = system_->rows;
  Split result{load, system_->preconditioner(load), VectorXd::Zero(load.size()), 0, 0};
  result.size = root(rows.dot(result.rest, result.preconditioned));
  for (const Direction& one : known_) {
    const double part = rows.dot(result.rest, one.preconditioned);
    result.rest -= part * one.load;
    result.preconditioned -= part * one.preconditioned;
    result.solution += part * one.solution;
  }
  result.across = root(rows.dot(result.rest, result.preconditioned));
  return result;
}

LinearSolution LoadSequence::solve(const VectorXd& load, const SolverOptions& options,
                                   const Progress& progress) {
  const Stopwatch watch;
  const SharedRows& rows = system_->rows;
  if (!first_.x.size()) {
    LinearSolution alone = solve_alone(load, options, progress);
    if (rows.dot(load, load) > 0) {
      first_ = alone;
      first_load_ = load;
    }
    return alone;
  }
  // Of one load alone nothing more is asked.
  if (known_.empty()) {
    VectorXd preconditioned = system_->preconditioner(first_load_);
    const double size = root(rows.dot(first_load_, preconditioned));
    known_.push_back({first_load_ / size, preconditioned / size, first_.x / size});
  }
  Split split = this->split(load);
  if (split.size == 0) return solve_alone(load, options, progress);
  LinearSolution result{std::move(split.solution), {}, first_.report};
  result.report.iterations = 0;
  result.report.residual_history = {1};
  bool is_new = split.across > least_share * split.size;
  VectorXd rest = is_new ? split.rest : VectorXd(load - system_->product(result.x));
  for (int round = 0; round < most_rounds; ++round) {
    const double left =
        round == 0 && is_new ? split.across : root(rows.dot(rest, system_->preconditioner(rest)));
    result.report.energy_error = left / split.size;
    result.report.relative_residual = std::sqrt(rows.dot(rest, rest) / rows.dot(load, load));
    result.report.residual_history.push_back(result.report.energy_error);
    result.report.solve_seconds = watch.seconds();
    if (left <= options.tolerance * split.size) return result;
    SolverOptions own = options;
    own.tolerance = std::min(0.5 * options.tolerance * split.size / left, largest_tolerance);
    const LinearSolution part = solve_alone(rest, own, progress);
    if (is_new) known_.push_back({rest / left, split.preconditioned / left, part.x / left});
    is_new = false;
    result.x += part.x;
    result.report.iterations += part.report.iterations;
    for (const double error : part.report.residual_history)
      result.report.residual_history.push_back(error * left / split.size);
    rest = load - system_->product(result.x);
  }
  // Combinations do not get there where round-off is as large as the tolerance.
  return solve_alone(load, options, progress);
}

}  // namespace isopatch::solvers
