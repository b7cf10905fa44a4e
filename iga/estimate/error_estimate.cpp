#include "iga/estimate/error_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/base/error.hpp"
#include "iga/estimate/element_errors.hpp"
#include "iga/estimate/raised_problem.hpp"
#include "iga/multigrid/fast_diagonalization.hpp"
#include "iga/multigrid/level_operator.hpp"
#include "iga/post/internal_forces.hpp"
#include "iga/problem/loads.hpp"
#include "iga/problem/thermal_load.hpp"
#include "iga/solution/solver_bytes.hpp"
#include "iga/solution/solver_choice.hpp"

namespace isopatch::iga {
namespace {

// An iteration that adds less than this share of the energy found before is the last one.
constexpr double least_gain = 0.03;
constexpr int most_corrections = 12;
// Measured on patches of degree 2 to 4, with what the operator and the smoother keep.
constexpr double bytes_per_raised_node = 550;

void require_room(const Discretization& raised, const ElasticityOptions& options) {
  const double bytes = bytes_per_raised_node * raised.node_count();
  const double available = available_bytes(options.solver, options.processes);
  if (bytes <= available) return;
  throw Error(ErrorCode::out_of_memory,
              fmt::format("an estimate of the error takes about {}, and there are {}", gigabytes(bytes),
                          gigabytes(std::max(0.0, available))));
}

Level raised_level(const Discretization& d, const ElasticityProblem& raised,
                   const std::vector<PatchSpace>& spaces, const ElasticityOptions& options) {
  const GlobalNodes global = global_nodes(d);
  return finest_level(spaces, global, support_frames(raised, global),
                      distribute(spaces, options.processes.count()), options.processes);
}

// The values of nodes at the local rows: all nodes of a row have the same.
Eigen::VectorXd rows_of(const Level& level, const Eigen::Matrix3Xd& of_nodes) {
  Eigen::VectorXd result(3 * static_cast<Eigen::Index>(level.rows.local_rows()));
  for (Eigen::Index node = 0; node < of_nodes.cols(); ++node)
    if (const int row = level.row_of_node[static_cast<std::size_t>(node)]; row >= 0)
      result.segment<3>(3 * static_cast<Eigen::Index>(row)) = of_nodes.col(node);
  return result;
}

// What a solution leaves of the loads, and its energy.
struct Residual {
  Eigen::VectorXd force;  // on the free unknowns, N
  double energy = 0;      // J
};

// A fold is seen by the process whose elements have it, and must be known to all before they talk again.
Eigen::VectorXd forces_of(const Level& level, const LevelOperator& stiffness, const Eigen::VectorXd& u,
                          const solvers::Processes& processes) {
  Eigen::VectorXd forces = Eigen::VectorXd::Zero(u.size());
  std::string failure;
  try {
    forces = stiffness.forces(u);
  } catch (const Error& error) {
    if (processes.count() == 1 || error.code() != ErrorCode::fold_over) throw;
    failure = error.what();
  }
  if (processes.sum(failure.empty() ? 0.0 : 1.0) > 0)
    throw Error(ErrorCode::fold_over, failure.empty() ? "a patch of another process is folded" : failure);
  level.rows.sum(forces);
  return forces;
}

// Between the points at which holds act they would tell of no error: they hold everywhere.
SurfaceTerms held_everywhere(SurfaceTerms terms) {
  for (SprungFace& face : terms.springs.faces) face.is_hold = false;
  return terms;
}

// The displacement that a residual causes, on the free unknowns, and its energy.
struct Correction {
  Eigen::VectorXd displacement;
  double energy = 0;  // J
  int iterations = 0;
};

// Conjugate gradients, whose energy grows from iteration to iteration towards that of the solution.
Correction correction_of(Eigen::VectorXd residual, const Level& level, const LevelOperator& stiffness,
                         const FastDiagonalization& smoother, const Progress& progress) {
  Correction result{Eigen::VectorXd::Zero(residual.size()), 0, 0};
  Eigen::VectorXd smoothed = smoother.apply(residual);
  Eigen::VectorXd direction = smoothed;
  double square = level.rows.dot(residual, smoothed);
  while (square > 0 && result.iterations < most_corrections) {
    progress("estimating the error", static_cast<double>(result.iterations) / most_corrections);
    const Eigen::VectorXd forces = stiffness.apply(direction);
    const double curvature = level.rows.dot(direction, forces);
    if (!(curvature > 0)) break;  // a motion without energy
    const double length = square / curvature;
    result.displacement += length * direction;
    residual -= length * forces;
    const double gained = 0.5 * length * square;
    result.energy += gained;
    ++result.iterations;
    if (gained <= least_gain * result.energy) break;
    smoothed = smoother.apply(residual);
    const double next = level.rows.dot(residual, smoothed);
    direction = smoothed + next / square * direction;
    square = next;
  }
  return result;
}

// Stress of the error at some places; the process that acts for a patch knows it.
std::vector<Eigen::Matrix3d> stresses_at(const std::vector<PatchPlace>& places,
                                         const ElasticityProblem& raised, const Level& level,
                                         const Eigen::Matrix3Xd& error, const solvers::Processes& processes) {
  std::vector<Eigen::Matrix3d> result;
  for (const PatchPlace& place : places) {
    const auto p = static_cast<std::size_t>(place.patch);
    Eigen::VectorXd stress = Eigen::VectorXd::Zero(9);
    if (level.is_primary[p]) {
      const geometry::NurbsVolume& patch = raised.discretization.patches[p];
      const ElasticField field{
          {patch}, {error.middleCols(level.first_node[p], patch.size())}, {raised.materials[p]}};
      const Eigen::Matrix3d here = evaluate(field, 0, place.parameter).stress;
      stress = Eigen::Map<const Eigen::VectorXd>(here.data(), 9);
    }
    if (processes.count() > 1) processes.sum(stress);
    result.emplace_back(Eigen::Map<const Eigen::Matrix3d>(stress.data()));
  }
  return result;
}

}  // namespace

struct ErrorEstimator::State {
  State(const ElasticityProblem& given, ElasticityProblem with_raised_degree,
        const ElasticityOptions& with_options)
      : problem(given),
        raised(std::move(with_raised_degree)),
        options(with_options),
        spaces(isoparametric_spaces(raised.discretization)),
        level(raised_level(raised.discretization, raised, spaces, options)),
        stiffness(level, raised.materials, 0, held_everywhere(surface_terms(problem))),
        smoother(raised.discretization.model, level, raised.materials, stiffness.diagonal(),
                 stiffness.surfaces()) {}

  // What a solution leaves of the loads.
  Residual residual(const Eigen::Matrix3Xd& loads, const ElasticField& solution) const {
    const Eigen::VectorXd u = rows_of(level, in_raised_space(problem, raised, solution.displacement));
    const Eigen::VectorXd forces = forces_of(level, stiffness, u, options.processes);
    return {level.free.to_free(sum_of_nodes(level, loads) - forces), 0.5 * level.rows.dot(u, forces)};
  }

  const ElasticityProblem& problem;
  ElasticityProblem raised;  // its loads say nothing
  ElasticityOptions options;
  std::vector<PatchSpace> spaces;
  Level level;
  LevelOperator stiffness;
  FastDiagonalization smoother;
};

ErrorEstimator::ErrorEstimator(const ElasticityProblem& problem, const ElasticityOptions& options,
                               const Progress& progress) {
  ElasticityProblem raised = with_degree_raised(problem, options.quadrature_points);
  require_room(raised.discretization, options);
  progress("estimating the error", 0);
  state_ = std::make_unique<State>(problem, std::move(raised), options);
}

ErrorEstimator::~ErrorEstimator() = default;
ErrorEstimator::ErrorEstimator(ErrorEstimator&&) noexcept = default;

// Those of temperatures included; every process has all.
Eigen::Matrix3Xd ErrorEstimator::loads(const ElasticityProblem& problem) const {
  const ElasticityProblem& raised = state_->raised;
  const solvers::Processes& processes = state_->options.processes;
  Eigen::Matrix3Xd result = load_vector({raised.discretization,
                                         problem.materials,
                                         {},
                                         problem.surface_loads,
                                         problem.volume_loads,
                                         {},
                                         problem.point_loads});
  const std::vector<ThermalStrain> strains = thermal_strains(problem.temperatures, problem.materials);
  if (strains.empty()) return result;
  Eigen::Matrix3Xd thermal =
      thermal_forces(raised.discretization, problem.materials, strains, state_->level.parts);
  if (processes.count() > 1) processes.sum(Eigen::Map<Eigen::VectorXd>(thermal.data(), thermal.size()));
  return result + thermal;
}

ErrorEstimate ErrorEstimator::estimate(const Eigen::Matrix3Xd& loads, const ElasticField& solution,
                                       const std::vector<PatchPlace>& places,
                                       const Progress& progress) const {
  const State& s = *state_;
  Residual residual = s.residual(loads, solution);
  const Correction correction =
      correction_of(std::move(residual.force), s.level, s.stiffness, s.smoother, progress);
  const Eigen::Matrix3Xd error = at_nodes(s.level, s.level.free.to_space(correction.displacement));
  ErrorEstimate result;
  result.energy = correction.energy;
  result.iterations = correction.iterations;
  const double whole = residual.energy + result.energy;
  result.relative = whole > 0 ? std::sqrt(result.energy / whole) : 0;
  result.elements =
      element_errors(s.raised.discretization, s.raised.materials, error, s.level.parts, s.options.processes);
  result.stress_at = stresses_at(places, s.raised, s.level, error, s.options.processes);
  return result;
}

ErrorEstimate estimate_error(const ElasticityProblem& problem, const ElasticField& solution,
                             const std::vector<PatchPlace>& places, const ElasticityOptions& options,
                             const Progress& progress) {
  const ErrorEstimator estimator(problem, options, progress);
  return estimator.estimate(estimator.loads(problem), solution, places, progress);
}

}  // namespace isopatch::iga
