#include "iga/solution/solve_elasticity.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/base/larger.hpp"
#include "geometry/base/stopwatch.hpp"
#include "iga/assembly/surface_stiffness.hpp"
#include "iga/coupling/rigid_motions.hpp"
#include "iga/post/elastic_reactions.hpp"
#include "iga/post/face_stresses.hpp"
#include "iga/post/internal_forces.hpp"
#include "iga/post/results.hpp"
#include "iga/solution/coupled_problem.hpp"
#include "iga/solution/planned_solution.hpp"

namespace isopatch::iga {
namespace {

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

ProblemSize problem_size(const CoupledProblem& coupled) {
  ProblemSize size;
  size.elements = coupled.discretization().element_count();
  size.control_points = coupled.discretization().node_count();
  size.dofs_uncoupled = 3 * size.control_points;
  size.dofs_eliminated = 3 * std::int64_t{coupled.global.count()};
  size.multipliers = size.dofs_uncoupled - size.dofs_eliminated;
  size.multipliers_free = static_cast<std::int64_t>(coupled.multipliers.size());
  std::int64_t free = 0;
  const bool merged = coupled.coupling == Coupling::elimination;
  for (int g = 0; g < coupled.global.count(); ++g)
    free += coupled.frames[static_cast<std::size_t>(g)].free *
            (merged ? 1 : static_cast<std::int64_t>(coupled.global.nodes_of(g).size()));
  size.dofs = merged ? size.dofs_eliminated : size.dofs_uncoupled + size.multipliers;
  size.dofs_free = merged ? free : free + size.multipliers_free;
  size.mortar_multipliers = coupled.mortar.rows();
  size.dofs += size.mortar_multipliers;
  size.dofs_free += size.mortar_multipliers;
  return size;
}

std::vector<Multiplier> multipliers_in_space(const CoupledProblem& coupled, const Eigen::VectorXd& values) {
  std::vector<Multiplier> result;
  for (std::size_t r = 0; r < coupled.multipliers.size(); ++r) {
    const MultiplierRow& row = coupled.multipliers[r];
    if (result.empty() || result.back().second_node != row.second)
      result.push_back({row.first, row.second, Eigen::Vector3d::Zero()});
    result.back().force += values[static_cast<Eigen::Index>(r)] *
                           coupled.frames[static_cast<std::size_t>(row.global_node)].axes.col(row.axis);
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

CouplingOptions coupling_of(const ElasticityOptions& options) {
  return {options.coupling, options.quadrature_points, options.processes, options.non_matching,
          options.mortar_side};
}

PlannedSolution solved(const CoupledProblem& coupled, const solvers::SolverOptions& options,
                       const Progress& progress) {
  SizeForecast size = forecast_size(
      coupled.discretization(), coupled.problem->materials, coupled.coupling, coupled.processes.count(),
      coupled.mortar.empty() ? NonMatchingCoupling::nitsche : NonMatchingCoupling::mortar);
  size.right_sides = static_cast<int>(coupled.right_sides.size());
  const std::vector<SolverPlan> plans =
      solver_plans(size, options, available_bytes(options, coupled.processes));
  return solve_as_planned(coupled, plans, options, progress);
}

// Prescribed displacements do work through the reactions, free ones through the loads. J
double external_work(const GlobalNodes& global, const RightSide& side, const Eigen::Matrix3Xd& load,
                     const Eigen::Matrix3Xd& displacement, const Eigen::Matrix3Xd& unbalanced) {
  double work = load.cwiseProduct(displacement).sum();
  for (Eigen::Index node = 0; node < displacement.cols(); ++node)
    work += unbalanced.col(node).dot(side.prescribed.col(global.global_of[static_cast<std::size_t>(node)]));
  return 0.5 * work;
}

std::vector<MortarTie> mortar_ties(const CoupledProblem& coupled, const Eigen::VectorXd& multipliers) {
  const MortarConstraints& mortar = coupled.mortar;
  const std::vector<Eigen::Vector3d> forces = forces_on_slaves(mortar, coupled.spaces, multipliers);
  std::vector<MortarTie> result;
  for (std::size_t f = 0; f < mortar.ties.faces.size(); ++f)
    result.push_back({mortar.ties.faces[f], mortar.first_row[f + 1] - mortar.first_row[f], forces[f]});
  return result;
}

// Multipliers, and what follows from the stresses of `solution.field`, whose own process' shares are given.
void add_results(const CoupledProblem& coupled, const RightSide& side, const DiscreteSolution& discrete,
                 InternalForces share, const FaceStresses& faces, const NodeBlocks& between_patches,
                 ElasticitySolution& solution) {
  const ElasticityProblem& problem = *coupled.problem;
  ElasticReactions springs = elastic_reactions(problem, discrete.displacement, coupled.spaces, coupled.parts);
  share.forces += springs.forces;
  Eigen::Matrix3Xd between = Eigen::Matrix3Xd::Zero(3, discrete.displacement.cols());
  between_patches.add_forces(discrete.displacement, between);
  if (!coupled.mortar.empty()) {
    // All processes have all multipliers.
    if (coupled.processes.is_first()) between += mortar_forces(coupled.mortar, discrete.mortar);
    solution.mortar = mortar_ties(coupled, discrete.mortar);
  }
  if (!side.thermal.empty() && coupled.processes.is_first()) between -= side.thermal_ties;
  share.forces += between;
  const InternalForces internal = summed(std::move(share), coupled.processes);
  springs = summed(std::move(springs), coupled.processes);
  // The internal forces are those of stresses, of which thermal strains cause none.
  const Eigen::Matrix3Xd load =
      side.thermal.empty() ? side.load : Eigen::Matrix3Xd(side.load - side.thermal_load - side.thermal_ties);
  const Eigen::Matrix3Xd unbalanced = internal.forces - load;
  solution.multipliers = multipliers_in_space(
      coupled, discrete.multipliers.size() == static_cast<Eigen::Index>(coupled.multipliers.size())
                   ? discrete.multipliers
                   : recovered_multipliers(coupled.multipliers, coupled.global, coupled.frames, -unbalanced));
  ElasticityResults& results = solution.results;
  results.max_displacement = largest(max_displacement(solution.field, coupled.parts), coupled.processes);
  const FaceStresses on_faces = summed(faces, coupled.processes);
  results.max_von_mises = larger(internal.max_von_mises, on_faces.max_von_mises);
  results.peaks = together(internal.peaks, on_faces.peaks);
  results.max_strain = internal.max_strain;
  results.left_out = together(internal.left_out, on_faces.left_out);
  results.unresolved = internal.unresolved;
  results.idle_loads = side.idle_loads;
  results.internal_energy = internal.energy;
  results.reactions = support_reactions(problem, coupled.global, coupled.frames, unbalanced);
  for (std::size_t s = 0; s < results.reactions.size(); ++s) {
    results.reactions[s].force += springs.reactions[s].force;
    results.reactions[s].moment += springs.reactions[s].moment;
  }
  results.support_energy = springs.energy;
  results.interface_energy = coupled.processes.sum(0.5 * between.cwiseProduct(discrete.displacement).sum());
  results.load_size = side.load.colwise().norm().sum();
  results.total_load = load.rowwise().sum();
  results.thermal_work = internal.thermal_work;
  results.external_work = external_work(coupled.global, side, load, discrete.displacement, unbalanced);
}

// What a method that stands in for another one gives must hold by itself: the energy of the stresses is the
// work.
void require_balance(const ElasticityResults& results, const solvers::SolveReport& report) {
  constexpr double most = 1e-6;
  const double stored = results.internal_energy + results.support_energy + results.interface_energy;
  const double work = results.external_work + results.thermal_work;
  const double scale =
      std::max({std::abs(stored), std::abs(results.external_work), std::abs(results.thermal_work)});
  if (std::abs(stored - work) <= most * scale) return;
  throw Error(ErrorCode::not_converged,
              fmt::format("{}; but the energy of its stresses is {:.6g} J and the work of the loads {:.6g} J",
                          report.reason, stored, work));
}

// The sum of solutions with factors; its report is that of the first with the worst residual that one may
// have.
DiscreteSolution combined(const std::vector<DiscreteSolution>& solutions, const LoadCombination& sum) {
  DiscreteSolution result = solutions.front();
  result.displacement *= sum.factors[0];
  result.multipliers *= sum.factors[0];
  result.mortar *= sum.factors[0];
  solvers::SolveReport& report = result.report;
  for (std::size_t i = 1; i < sum.factors.size(); ++i) {
    result.displacement += sum.factors[i] * solutions[i].displacement;
    result.multipliers += sum.factors[i] * solutions[i].multipliers;
    result.mortar += sum.factors[i] * solutions[i].mortar;
    report.relative_residual =
        isopatch::larger(report.relative_residual, solutions[i].report.relative_residual);
    report.energy_error = isopatch::larger(report.energy_error, solutions[i].report.energy_error);
  }
  report.reason = "a sum of cases: nothing was solved for it; residuals are the largest of the cases'";
  report.residual_history.clear();
  report.iterations = 0;
  report.solve_seconds = 0;
  return result;
}

// Fields and results of every solution of a problem, with the phases' times at the first.
std::vector<ElasticitySolution> with_results(const CoupledProblem& coupled,
                                             const std::vector<RightSide>& sides,
                                             const std::vector<DiscreteSolution>& discrete,
                                             const PlannedSolution& planned, const Progress& progress) {
  std::vector<ElasticitySolution> result;
  std::vector<StrainedPart> displacements;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (!discrete[i].displacement.allFinite())
      throw Error(ErrorCode::singular_system,
                  "the displacements are not finite numbers: the equations have no solution; look at the "
                  "supports and at the materials' constants");
    ElasticitySolution& solution = result.emplace_back();
    solution.size = problem_size(coupled);
    solution.predicted_bytes = static_cast<std::int64_t>(planned.predicted_bytes);
    solution.solver = discrete[i].report;
    solution.field = field_of(*coupled.problem, discrete[i].displacement);
    solution.field.thermal = sides[i].thermal;
    displacements.push_back({discrete[i].displacement, sides[i].thermal});
  }
  std::vector<const ElasticField*> fields;
  for (const ElasticitySolution& solution : result) fields.push_back(&solution.field);
  std::vector<InternalForces> internal =
      internal_forces(coupled.discretization(), coupled.problem->materials, displacements, coupled.parts,
                      coupled.points, progress);
  const std::vector<FaceStresses> faces = stresses_on_faces(fields, coupled.parts);
  const NodeBlocks between_patches = interface_stiffness(coupled.spaces, coupled.parts, coupled.surfaces());
  for (std::size_t i = 0; i < sides.size(); ++i) {
    add_results(coupled, sides[i], discrete[i], std::move(internal[i]), faces[i], between_patches, result[i]);
    if (!planned.is_first) require_balance(result[i].results, discrete[i].report);
  }
  return result;
}

std::vector<ElasticitySolution> solutions_of(CoupledProblem coupled,
                                             const std::vector<LoadCombination>& combinations,
                                             const ElasticityOptions& options, Stopwatch watch,
                                             const Progress& progress) {
  require_supported(*coupled.problem, coupled.global, coupled.frames);
  std::vector<PhaseTime> timings = {{"coupling and loads", watch.lap()}};
  PlannedSolution planned = solved(coupled, options.solver, progress);
  const double assembly_seconds = planned.solutions.front().report.assembly_seconds;
  timings.push_back({"assembly", assembly_seconds});
  timings.push_back({"solve", watch.lap() - assembly_seconds});
  std::vector<RightSide> sides = std::move(coupled.right_sides);
  std::vector<DiscreteSolution> discrete = std::move(planned.solutions);
  for (const LoadCombination& sum : combinations) {
    RightSide side = combined(sides, sum.factors);
    DiscreteSolution solution = combined(discrete, sum);
    sides.push_back(std::move(side));
    discrete.push_back(std::move(solution));
  }
  std::vector<ElasticitySolution> result = with_results(coupled, sides, discrete, planned, progress);
  timings.push_back({"results", watch.lap()});
  result.front().timings = std::move(timings);
  return result;
}

}  // namespace

ElasticitySolution solve_elasticity(const ElasticityProblem& problem, const ElasticityOptions& options,
                                    const Progress& progress) {
  check(problem, options);
  const Stopwatch watch;
  return std::move(
      solutions_of(coupled_problem(problem, coupling_of(options)), {}, options, watch, progress).front());
}

std::vector<ElasticitySolution> solve_cases(const ElasticityProblem& problem, const LoadCases& cases,
                                            const ElasticityOptions& options, const Progress& progress) {
  check(problem, options);
  validate(cases);
  const Stopwatch watch;
  return solutions_of(coupled_cases(problem, cases.cases, coupling_of(options)), cases.combinations, options,
                      watch, progress);
}

}  // namespace isopatch::iga
