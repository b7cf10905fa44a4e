#include "solvers/load_sequence.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/base/stopwatch.hpp"
#include "solvers/block_cg.hpp"

namespace isopatch::solvers {
namespace {

using Eigen::VectorXd;

// Below this share of a load, what is across the earlier ones is not worth a direction of its own.
constexpr double least_share = 1e-3;
// Each round brings the error down to the tolerance but for what combining solutions has added.
constexpr int most_rounds = 4;
constexpr double largest_tolerance = 1e-2;  // that iterations may be asked for
// Loads that iterate together: six vectors each.
constexpr std::size_t most_together = 10;

double root(double square) {
  return square <= 0 ? 0 : std::sqrt(square);  // what is no number stays none
}

Eigen::MatrixXd columns(std::span<const VectorXd> vectors) {
  Eigen::MatrixXd result(vectors.front().size(), static_cast<Eigen::Index>(vectors.size()));
  for (std::size_t i = 0; i < vectors.size(); ++i) result.col(static_cast<Eigen::Index>(i)) = vectors[i];
  return result;
}

}  // namespace

LinearSolution LoadSequence::solve_alone(const VectorXd& load, const SolverOptions& options,
                                         const Progress& progress) const {
  OperatorSystem alone = *system_;
  alone.load = load;
  return method_ == KrylovMethod::cg ? solve_with_cg(alone, options, progress)
                                     : solve_with_minres(alone, options, progress);
}

// What is left of a load beside the directions known, and its parts along them.
LoadSequence::Split LoadSequence::split(const VectorXd& load, VectorXd preconditioned) const {
  const SharedRows& rows = system_->rows;
  Split result{load, std::move(preconditioned), {}, 0, 0};
  result.size = root(rows.dot(result.rest, result.preconditioned));
  for (const Direction& one : known_) {
    const double part = rows.dot(result.rest, one.preconditioned);
    result.rest -= part * one.load;
    result.preconditioned -= part * one.preconditioned;
    result.parts.push_back(part);
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
  Split split = this->split(load, system_->preconditioner(load));
  if (split.size == 0) return solve_alone(load, options, progress);
  LinearSolution result{VectorXd::Zero(load.size()), {}, first_.report};
  for (std::size_t k = 0; k < split.parts.size(); ++k) result.x += split.parts[k] * known_[k].solution;
  result.report.iterations = 0;
  result.report.residual_history = {1};
  if (split.across > least_share * split.size) {
    SolverOptions own = options;
    own.tolerance = std::min(0.5 * options.tolerance * split.size / split.across, largest_tolerance);
    const LinearSolution part = solve_alone(split.rest, own, progress);
    known_.push_back({split.rest / split.across, split.preconditioned / split.across, part.x / split.across});
    add(part, split.across / split.size, result);
  }
  Rest rest = rest_of(load, result.x);
  return finished(std::move(result), load, split.size, std::move(rest), watch, options, progress);
}

LoadSequence::Rest LoadSequence::rest_of(const VectorXd& load, const VectorXd& x) const {
  VectorXd rest = load - system_->product(x);
  const double size = root(system_->rows.dot(rest, system_->preconditioner(rest)));
  return {std::move(rest), size};
}

// Adds the solution of a rest, whose error was such a share of the load's.
void LoadSequence::add(const LinearSolution& part, double share, LinearSolution& to) {
  to.x += part.x;
  to.report.iterations += part.report.iterations;
  for (const double error : part.report.residual_history) to.report.residual_history.push_back(error * share);
}

// Goes on from the true residual of a start until the error is small enough.
LinearSolution LoadSequence::finished(LinearSolution result, const VectorXd& load, double size, Rest rest,
                                      const Stopwatch& watch, const SolverOptions& options,
                                      const Progress& progress) const {
  const SharedRows& rows = system_->rows;
  for (int round = 0; round < most_rounds; ++round) {
    if (round > 0) rest = rest_of(load, result.x);
    result.report.energy_error = rest.size / size;
    result.report.relative_residual = std::sqrt(rows.dot(rest.load, rest.load) / rows.dot(load, load));
    result.report.residual_history.push_back(result.report.energy_error);
    result.report.solve_seconds = watch.seconds();
    if (rest.size <= options.tolerance * size) return result;
    SolverOptions own = options;
    own.tolerance = std::min(0.5 * options.tolerance * size / rest.size, largest_tolerance);
    add(solve_alone(rest.load, own, progress), rest.size / size, result);
  }
  // Combinations do not get there where round-off is as large as the tolerance.
  return solve_alone(load, options, progress);
}

// Those that are new become directions; all of them are combinations of directions then.
std::vector<LinearSolution> LoadSequence::solve_together(std::span<const VectorXd> loads,
                                                         const SolverOptions& options,
                                                         const Progress& progress) {
  const Stopwatch watch;
  const SharedRows& rows = system_->rows;
  const std::size_t before = known_.size();
  std::vector<Split> splits;
  std::vector<std::size_t> direction_of;  // or none: the number of all
  const Eigen::MatrixXd all = columns(loads);
  const Eigen::MatrixXd all_preconditioned = system_->preconditioner.of_each(all);
  for (Eigen::Index i = 0; i < all.cols(); ++i) {
    const Split& split = splits.emplace_back(this->split(all.col(i), all_preconditioned.col(i)));
    const bool is_new = split.across > least_share * split.size;
    direction_of.push_back(is_new ? known_.size() : static_cast<std::size_t>(-1));
    if (is_new) known_.push_back({split.rest / split.across, split.preconditioned / split.across, {}});
  }
  const auto count = static_cast<Eigen::Index>(known_.size() - before);
  BlockSolution found;
  if (count > 0) {
    Eigen::MatrixXd block(loads.front().size(), count), preconditioned(loads.front().size(), count);
    for (Eigen::Index k = 0; k < count; ++k) {
      block.col(k) = known_[before + static_cast<std::size_t>(k)].load;
      preconditioned.col(k) = known_[before + static_cast<std::size_t>(k)].preconditioned;
    }
    SolverOptions own = options;
    own.tolerance = 0.5 * options.tolerance;
    found = solve_with_block_cg(*system_, block, preconditioned, own, progress);
    for (Eigen::Index k = 0; k < count; ++k)
      known_[before + static_cast<std::size_t>(k)].solution = found.x.col(k);
  }
  std::vector<LinearSolution> result;
  Eigen::MatrixXd rests = all;
  for (std::size_t i = 0; i < loads.size(); ++i) {
    LinearSolution& start = result.emplace_back(
        LinearSolution{VectorXd::Zero(loads[i].size()), {}, first_report(*system_, Method::cg)});
    for (std::size_t k = 0; k < splits[i].parts.size(); ++k)
      start.x += splits[i].parts[k] * known_[k].solution;
    start.report.residual_history = {1};
    if (direction_of[i] < known_.size()) {
      start.x += splits[i].across * known_[direction_of[i]].solution;
      const std::vector<double>& errors = found.errors[direction_of[i] - before];
      for (std::size_t k = 1; k < errors.size(); ++k)
        start.report.residual_history.push_back(errors[k] * splits[i].across / splits[i].size);
      start.report.iterations = static_cast<int>(errors.size()) - 1;
    }
    rests.col(static_cast<Eigen::Index>(i)) = start.x;
  }
  rests = all - system_->product.of_each(rests);
  const Eigen::MatrixXd rests_preconditioned = system_->preconditioner.of_each(rests);
  for (std::size_t i = 0; i < loads.size(); ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    const VectorXd rest = rests.col(k);
    result[i] = splits[i].size == 0 ? solve_alone(loads[i], options, progress)
                                    : finished(std::move(result[i]), loads[i], splits[i].size,
                                               {rest, root(rows.dot(rest, rests_preconditioned.col(k)))},
                                               watch, options, progress);
  }
  return result;
}

std::vector<LinearSolution> LoadSequence::solve_all(const std::vector<VectorXd>& loads,
                                                    const SolverOptions& options, const Progress& progress) {
  std::vector<LinearSolution> result;
  if (method_ != KrylovMethod::cg || system_->rows.is_distributed() || loads.size() < 2) {
    for (const VectorXd& load : loads) result.push_back(solve(load, options, progress));
    return result;
  }
  for (std::size_t first = 0; first < loads.size(); first += most_together) {
    const std::size_t count = std::min(most_together, loads.size() - first);
    for (LinearSolution& one : solve_together(std::span(loads).subspan(first, count), options, progress))
      result.push_back(std::move(one));
  }
  return result;
}

}  // namespace isopatch::solvers
