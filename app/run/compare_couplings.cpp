#include "app/run/compare_couplings.hpp"

#include <fmt/format.h>

#include <map>

#include "app/problem/plausibility.hpp"
#include "app/study/load_cases.hpp"
#include "geometry/base/larger.hpp"
#include "iga/post/face_stresses.hpp"
#include "iga/post/internal_forces.hpp"
#include "iga/post/results.hpp"
#include "iga/solution/condition.hpp"

namespace isopatch::app {
namespace {

CouplingRun summarized(const iga::ElasticitySolution& solution, iga::Coupling coupling) {
  return {coupling, solution.size, solution.solver, solution.results, solution.timings};
}

double ratio(double difference, double scale) {
  return scale > 0 ? difference / scale : difference;
}

double displacement_difference(const iga::ElasticField& a, const iga::ElasticField& b) {
  double difference = 0;
  double scale = 0;
  for (std::size_t i = 0; i < a.displacement.size(); ++i) {
    difference = larger(difference,
                        (a.displacement[i] - b.displacement[i]).cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
    scale = larger(scale, a.displacement[i].cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
  }
  return ratio(difference, scale);
}

double energy_difference(const iga::ElasticityResults& first, const iga::ElasticityResults& second) {
  const double a = first.internal_energy;
  const double b = second.internal_energy;
  return ratio(std::abs(a - b), larger(std::abs(a), std::abs(b)));
}

// What a node bears on average: twice the energy over the way is a force, which all nodes share.
double typical_force(const iga::ElasticitySolution& solution) {
  const iga::ElasticityResults& results = solution.results;
  const double way = results.max_displacement.value;
  return way > 0 ? 2 * results.internal_energy / (way * static_cast<double>(solution.size.control_points))
                 : 0;
}

// Multipliers that are nothing but round-off are compared with what nodes of the part bear.
double multiplier_difference(const std::vector<iga::Multiplier>& a, const std::vector<iga::Multiplier>& b,
                             double least_scale) {
  std::map<std::pair<int, int>, Eigen::Vector3d> forces;
  for (const auto& multiplier : a) forces[{multiplier.first_node, multiplier.second_node}] = multiplier.force;
  double difference = 0;
  double scale = least_scale;
  for (const auto& multiplier : b) {
    const auto found = forces.find({multiplier.first_node, multiplier.second_node});
    const Eigen::Vector3d other = found == forces.end() ? Eigen::Vector3d::Zero() : found->second;
    difference = larger(difference, (multiplier.force - other).cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
    scale = larger(scale, multiplier.force.cwiseAbs().maxCoeff<Eigen::PropagateNaN>());
  }
  return ratio(difference, scale);
}

// The problem is linear: what differs between two solutions is a displacement with stresses of its own.
void find_largest_differences(const iga::ElasticityProblem& problem, const iga::ElasticField& a,
                              const iga::ElasticField& b, CouplingComparison& comparison) {
  iga::ElasticField difference{a.patches, a.displacement, a.materials};
  Eigen::Matrix3Xd nodal(3, problem.discretization.node_count());
  for (std::size_t i = 0; i < a.displacement.size(); ++i) {
    difference.displacement[i] -= b.displacement[i];
    nodal.middleCols(problem.discretization.first_node[i], difference.displacement[i].cols()) =
        difference.displacement[i];
  }
  comparison.largest_displacement_difference = iga::max_displacement(difference);
  comparison.largest_stress_difference =
      iga::larger(iga::internal_forces(problem.discretization, problem.materials, nodal).max_von_mises,
                  iga::stresses_on_faces(difference).max_von_mises);
  for (iga::Extremum* extremum :
       {&comparison.largest_displacement_difference, &comparison.largest_stress_difference})
    if (extremum->patch >= 0)
      extremum->parameter =
          problem.discretization.model.to_input(PatchId(extremum->patch), extremum->parameter);
}

std::vector<InterfaceForce> interface_forces(const geometry::MultiPatch& model,
                                             const std::vector<iga::InterfaceTraction>& tractions) {
  std::vector<InterfaceForce> result;
  for (const iga::InterfaceTraction& traction : tractions) {
    const geometry::Interface& interface = model.interfaces()[static_cast<std::size_t>(traction.interface)];
    result.push_back({model.label(interface.first), model.label(interface.second), traction.area, {}});
    if (traction.field) result.back().force = traction.force;
  }
  return result;
}

std::array<int, 3> highest_degree(const iga::Discretization& discretization) {
  std::array<int, 3> degree{};
  for (const auto& patch : discretization.patches)
    for (int d = 0; d < 3; ++d) {
      auto& highest = degree[static_cast<std::size_t>(d)];
      highest = larger(highest, patch.degree(d));
    }
  return degree;
}

void estimate(CouplingRun& run, const Study& study, const iga::ElasticityProblem& problem,
              const Progress& progress) {
  if (run.solver.factor_nonzeros > 0)
    run.condition =
        iga::estimate_condition(problem, run.coupling, study.options.quadrature_points, progress).number();
}

// The study's method, or what takes its place with a coupling that it does not suit.
iga::ElasticityOptions options_of(const Study& study, iga::Coupling coupling) {
  using solvers::Method;
  iga::ElasticityOptions options = study.options;
  options.coupling = coupling;
  Method& method = options.solver.method;
  const bool can_iterate =
      options.solver.preconditioner == solvers::Preconditioner::multigrid && options.processes.count() == 1;
  const bool has_mortar = options.non_matching == iga::NonMatchingCoupling::mortar;
  if (coupling == iga::Coupling::elimination && method == Method::minres && !has_mortar)
    method = Method::cg;
  else if (coupling == iga::Coupling::lagrange && method == Method::cg)
    method = can_iterate ? Method::minres : Method::automatic;
  else if (coupling == iga::Coupling::lagrange && method == Method::cholmod)
    method = Method::mumps;
  // Minimal residuals are made without a matrix only.
  if (method == Method::minres) options.solver.form = solvers::Operator::automatic;
  return options;
}

}  // namespace

double CouplingRun::seconds() const {
  double total = 0;
  for (const iga::PhaseTime& time : timings) total += time.seconds;
  return total;
}

bool CouplingComparison::agree() const {
  return displacement_difference <= allowed_difference && energy_difference <= allowed_difference &&
         multiplier_difference <= allowed_multiplier_difference;
}

ComparedStudy compare_couplings(const Study& study, bool condition, const Progress& progress) {
  if (condition && study.options.processes.count() > 1)
    throw Error(ErrorCode::invalid_argument, "--condition works on one process only");
  Study forecast = study;
  forecast.options = options_of(study, study.options.coupling);
  ComparedStudy result{{}, {build_problem(forecast, progress), {}, {}, {}, 0}, {}};
  warn_of_no_load(study, result.run.built);
  if (const iga::LoadCases cases = load_cases(study); !cases.cases.empty()) {
    const iga::LoadCase& first = cases.cases.front();
    BuiltProblem& built = result.run.built;
    built.problem = iga::of_case(built.problem, first);
    built.warnings.push_back(
        {fmt::format("the couplings are compared in the first load case, {}, alone", first.name)});
  }
  const iga::ElasticityProblem& problem = result.run.built.problem;
  const iga::ElasticitySolution eliminated =
      iga::solve_elasticity(problem, options_of(study, iga::Coupling::elimination), progress);
  iga::ElasticitySolution& tied = result.run.solution;
  tied = iga::solve_elasticity(problem, options_of(study, iga::Coupling::lagrange), progress);
  result.run.timings = tied.timings;
  CouplingComparison& comparison = result.comparison;
  comparison.refine = study.discretization.refine;
  comparison.degree = highest_degree(problem.discretization);
  comparison.elimination = summarized(eliminated, iga::Coupling::elimination);
  comparison.lagrange = summarized(tied, iga::Coupling::lagrange);
  if (condition)
    for (CouplingRun* run : {&comparison.elimination, &comparison.lagrange})
      estimate(*run, study, problem, progress);
  comparison.displacement_difference = displacement_difference(eliminated.field, tied.field);
  comparison.energy_difference = energy_difference(eliminated.results, tied.results);
  comparison.multiplier_difference =
      multiplier_difference(eliminated.multipliers, tied.multipliers, 1e-3 * typical_force(eliminated));
  if (!problem.discretization.model.non_matching().empty())
    comparison.non_matching =
        compare_non_matching(problem, options_of(study, iga::Coupling::elimination), eliminated, progress);
  for (Warning& warning : result_warnings(result.run.built, tied))
    result.run.built.warnings.push_back(std::move(warning));
  comparison.warnings = result.run.built.warnings;
  find_largest_differences(problem, eliminated.field, tied.field, comparison);
  result.tractions = iga::interface_tractions(problem, tied.multipliers);
  comparison.interfaces = interface_forces(problem.discretization.model, result.tractions);
  return result;
}

}  // namespace isopatch::app
