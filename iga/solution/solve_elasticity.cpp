#include "iga/solution/solve_elasticity.hpp"

#include <fmt/format.h>

#include <chrono>
#include <cmath>
#include <numeric>

#include "geometry/base/error.hpp"
#include "iga/coupling/idle_loads.hpp"
#include "iga/coupling/rigid_motions.hpp"
#include "iga/distribution/distribution.hpp"
#include "iga/post/face_stresses.hpp"
#include "iga/post/internal_forces.hpp"
#include "iga/post/results.hpp"
#include "iga/problem/loads.hpp"
#include "iga/solution/planned_solution.hpp"

namespace isopatch::iga {
namespace {

class Stopwatch {
 public:
  explicit Stopwatch(std::vector<PhaseTime>& times) : times_(times) {}
  // Ends a phase: the time since the last one goes to its name.
  void lap(const char* phase) { lap(phase, 0, ""); }
  // The same, `seconds` of it spent on another phase.
  void lap(const char* phase, double seconds, const char* other) {
    const auto now = std::chrono::steady_clock::now();
    if (*other) times_.push_back({other, seconds});
    times_.push_back({phase, std::chrono::duration<double>(now - last_).count() - seconds});
    last_ = now;
  }

 private:
  std::vector<PhaseTime>& times_;
  std::chrono::steady_clock::time_point last_ = std::chrono::steady_clock::now();
};

void check(const ElasticityProblem& problem, const ElasticityOptions& options) {
  if (options.quadrature_points < 0 || options.quadrature_points > 20)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("quadrature_points is {}; its range is 0 .. 20", options.quadrature_points));
  solvers::validate(options.solver);
  if (static_cast<int>(problem.materials.size()) != problem.discretization.patch_count())
    throw Error(ErrorCode::invalid_argument,
                fmt::format("{} materials for {} patches", problem.materials.size(),
                            problem.discretization.patch_count()));
  for (const Material& material : problem.materials) validate(material);
}

ProblemSize problem_size(const Discretization& d, const NodeClasses& classes,
                         const std::vector<SupportFrame>& frames, std::size_t multipliers_free,
                         Coupling coupling) {
  ProblemSize size;
  size.elements = d.element_count();
  size.control_points = d.node_count();
  size.dofs_uncoupled = 3 * size.control_points;
  size.dofs_eliminated = 3 * std::int64_t{classes.count()};
  size.multipliers = size.dofs_uncoupled - size.dofs_eliminated;
  size.multipliers_free = static_cast<std::int64_t>(multipliers_free);
  std::int64_t free = 0;
  const bool merged = coupling == Coupling::elimination;
  for (int c = 0; c < classes.count(); ++c)
    free += frames[static_cast<std::size_t>(c)].free *
            (merged ? 1 : static_cast<std::int64_t>(classes.of(c).size()));
  size.dofs = merged ? size.dofs_eliminated : size.dofs_uncoupled + size.multipliers;
  size.dofs_free = merged ? free : free + size.multipliers_free;
  return size;
}

std::vector<Multiplier> multipliers_in_space(const std::vector<MultiplierRow>& rows,
                                             const std::vector<SupportFrame>& frames,
                                             const Eigen::VectorXd& values) {
  std::vector<Multiplier> result;
  for (std::size_t r = 0; r < rows.size(); ++r) {
    const MultiplierRow& row = rows[r];
    if (result.empty() || result.back().second_node != row.second)
      result.push_back({row.first, row.second, Eigen::Vector3d::Zero()});
    result.back().force += values[static_cast<Eigen::Index>(r)] *
                           frames[static_cast<std::size_t>(row.node_class)].axes.col(row.axis);
  }
  return result;
}

ElasticField field_of(const ElasticityProblem& problem, const Eigen::Matrix3Xd& displacement) {
  const Discretization& d = problem.discretization;
  ElasticField field{d.patches, {}, problem.materials};
  for (std::size_t p = 0; p < d.patches.size(); ++p)
    field.displacement.push_back(displacement.middleCols(d.first_node[p], d.patches[p].size()));
  return field;
}

PlannedSolution solved(const SolutionTask& task, const solvers::SolverOptions& options,
                       const Progress& progress) {
  const SizeForecast size = forecast_size(task.problem.discretization, task.problem.materials, task.coupling,
                                          task.processes.count());
  const std::vector<SolverPlan> plans = solver_plans(size, options, available_bytes(options, task.processes));
  return solve_as_planned(task, plans, options, progress);
}

// What a method that stands in for another one gives must hold by itself: the energy of the stresses is the
// work.
void require_balance(const ElasticityResults& results, const solvers::SolveReport& report) {
  constexpr double most = 1e-6;
  const double scale = std::max(std::abs(results.internal_energy), std::abs(results.external_work));
  if (std::abs(results.internal_energy - results.external_work) <= most * scale) return;
  throw Error(ErrorCode::not_converged,
              fmt::format("{}; but the energy of its stresses is {:.6g} J and the work of the loads {:.6g} J",
                          report.reason, results.internal_energy, results.external_work));
}

}  // namespace

ElasticitySolution solve_elasticity(const ElasticityProblem& problem, const ElasticityOptions& options,
                                    const Progress& progress) {
  check(problem, options);
  ElasticitySolution solution;
  Stopwatch watch(solution.timings);
  const Discretization& d = problem.discretization;

  const NodeClasses classes = node_classes(d);
  const std::vector<SupportFrame> frames = support_frames(problem, classes);
  require_supported(d, classes, frames);
  const Eigen::Matrix3Xd load = load_vector(problem, options.quadrature_points);
  const std::vector<MultiplierRow> rows = multiplier_rows(classes, frames);
  solution.size = problem_size(d, classes, frames, rows.size(), options.coupling);
  watch.lap("coupling and loads");

  const std::vector<PatchSpace> spaces = isoparametric_spaces(d);
  const solvers::Processes& processes = options.processes;
  const Distribution distribution = distribute(spaces, processes.count());
  const std::vector<PatchPart> parts = parts_of(distribution, spaces, processes.rank());
  const SolutionTask task{problem,
                          classes,
                          frames,
                          rows,
                          load,
                          distribution,
                          processes,
                          options.coupling,
                          options.quadrature_points};
  const PlannedSolution planned = solved(task, options.solver, progress);
  const NodalSolution& nodal = planned.solution;
  solution.predicted_bytes = static_cast<std::int64_t>(planned.predicted_bytes);
  solution.solver = nodal.report;
  watch.lap("solve", nodal.report.assembly_seconds, "assembly");
  const Eigen::Matrix3Xd& displacement = nodal.displacement;
  if (!displacement.allFinite())
    throw Error(ErrorCode::singular_system,
                "the displacements are not finite numbers: the equations have no solution; look at the "
                "supports and at the materials' constants");
  solution.field = field_of(problem, displacement);

  const InternalForces internal =
      summed(internal_forces(d, problem.materials, displacement, parts, options.quadrature_points, progress),
             processes);
  const Eigen::Matrix3Xd unbalanced = internal.forces - load;
  const Eigen::VectorXd multipliers = options.coupling == Coupling::lagrange
                                          ? nodal.multipliers
                                          : recovered_multipliers(rows, classes, frames, -unbalanced);
  solution.multipliers = multipliers_in_space(rows, frames, multipliers);
  ElasticityResults& results = solution.results;
  results.max_displacement = largest(max_displacement(solution.field, parts), processes);
  const FaceStresses on_faces = summed(stresses_on_faces(solution.field, parts), processes);
  results.max_von_mises = larger(internal.max_von_mises, on_faces.max_von_mises);
  results.max_strain = internal.max_strain;
  results.left_out = together(internal.left_out, on_faces.left_out);
  results.unresolved = internal.unresolved;
  results.idle_loads = idle_loads(problem, classes, frames);
  results.internal_energy = internal.energy;
  results.reactions = support_reactions(problem, classes, frames, unbalanced);
  results.total_load = load.rowwise().sum();
  // Prescribed displacements do work through the reactions, free ones through the loads.
  double work = load.cwiseProduct(displacement).sum();
  for (Eigen::Index node = 0; node < displacement.cols(); ++node)
    work += unbalanced.col(node).dot(
        frames[static_cast<std::size_t>(classes.class_of[static_cast<std::size_t>(node)])].prescribed);
  results.external_work = 0.5 * work;
  if (!planned.is_first) require_balance(results, nodal.report);
  watch.lap("results");
  return solution;
}

}  // namespace isopatch::iga
