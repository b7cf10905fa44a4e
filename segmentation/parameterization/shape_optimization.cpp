#include "segmentation/parameterization/internal/shape_optimization.hpp"

#include <nlopt.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>

namespace isopatch::segmentation {
namespace {

/// The sum of the blocks' energies as a function of the variables.
class Objective {
 public:
  explicit Objective(const std::vector<MovableBlock>& blocks) : blocks_(blocks) {
    for (const MovableBlock& block : blocks)
      energies_.emplace_back(block.knots, block.lengths, block.counted, block.extra, block.weights);
  }

  struct Value {
    double energy = 0;
    double smallest = std::numeric_limits<double>::infinity();
    Eigen::VectorXd gradient;
  };
  Value operator()(const Eigen::VectorXd& variables, double epsilon) const {
    Value result;
    result.gradient = Eigen::VectorXd::Zero(variables.size());
    for (std::size_t b = 0; b < blocks_.size(); ++b) {
      const Eigen::VectorXd moved = blocks_[b].moves * variables;
      const Eigen::Matrix3Xd points = blocks_[b].points + moved.reshaped(3, moved.size() / 3);
      const ShapeEnergy::Value value = energies_[b](points, epsilon);
      result.energy += value.energy;
      result.smallest = std::min(result.smallest, value.smallest);
      result.gradient += blocks_[b].moves.transpose() * value.gradient.reshaped();
    }
    return result;
  }

 private:
  const std::vector<MovableBlock>& blocks_;
  std::vector<ShapeEnergy> energies_;
};

/// What NLopt calls: remembers the variables with the least energy.
struct Descent {
  const Objective& objective;
  double epsilon = 0;
  Eigen::VectorXd best;
  double least = std::numeric_limits<double>::infinity();
  double smallest = 0;  ///< det M of the best
  int evaluations = 0;
};

double evaluate(unsigned count, const double* x, double* gradient, void* data) {
  Descent& descent = *static_cast<Descent*>(data);
  const Eigen::VectorXd variables = Eigen::Map<const Eigen::VectorXd>(x, static_cast<Eigen::Index>(count));
  const Objective::Value value = descent.objective(variables, descent.epsilon);
  ++descent.evaluations;
  if (value.energy < descent.least) {
    descent.least = value.energy;
    descent.best = variables;
    descent.smallest = value.smallest;
  }
  if (gradient) Eigen::Map<Eigen::VectorXd>(gradient, static_cast<Eigen::Index>(count)) = value.gradient;
  return std::isfinite(value.energy) ? value.energy : 1e300;
}

/// Limited-memory BFGS from a start; a line search that gives up is no failure, the best point counts.
Descent minimize(const Objective& objective, const Eigen::VectorXd& start, double epsilon, int evaluations) {
  Descent descent{objective, epsilon, start};
  const std::unique_ptr<nlopt_opt_s, void (*)(nlopt_opt)> optimizer(
      nlopt_create(NLOPT_LD_LBFGS, static_cast<unsigned>(start.size())), nlopt_destroy);
  nlopt_set_min_objective(optimizer.get(), evaluate, &descent);
  nlopt_set_maxeval(optimizer.get(), evaluations);
  nlopt_set_ftol_rel(optimizer.get(), 1e-5);
  Eigen::VectorXd x = start;
  double least = 0;
  nlopt_optimize(optimizer.get(), x.data(), &least);
  return descent;
}

// As in the paper's code: proportional to the worst fold, never zero.
double regularization(double smallest) {
  return std::sqrt(1e-12 + 0.04 * std::pow(std::min(smallest, 0.0), 2));
}

}  // namespace

OptimizedShapes optimize_shapes(const std::vector<MovableBlock>& blocks, const OptimizationOptions& options) {
  const Objective objective(blocks);
  OptimizedShapes result;
  result.variables = Eigen::VectorXd::Zero(blocks.front().moves.cols());
  result.smallest_before = result.smallest_after = objective(result.variables, 1).smallest;
  if (result.variables.size() == 0) return result;
  for (int round = 0; round < options.untangling_rounds && result.smallest_after <= 0; ++round) {
    const Descent descent = minimize(objective, result.variables, regularization(result.smallest_after),
                                     options.untangling_evaluations);
    result.evaluations += descent.evaluations;
    const bool stuck = std::abs(descent.smallest - result.smallest_after) < 1e-9;
    result.variables = descent.best;
    result.smallest_after = descent.smallest;
    if (stuck) break;
  }
  if (options.quality_evaluations > 0 && result.smallest_after > 0) {
    const Descent descent = minimize(objective, result.variables, 1e-9, options.quality_evaluations);
    result.evaluations += descent.evaluations;
    if (descent.smallest > 0) {
      result.variables = descent.best;
      result.smallest_after = descent.smallest;
    }
  }
  return result;
}

}  // namespace isopatch::segmentation
