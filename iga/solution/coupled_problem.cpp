#include "iga/solution/coupled_problem.hpp"

#include "geometry/base/error.hpp"
#include "iga/assembly/interface_thermal_load.hpp"
#include "iga/distribution/shared_interfaces.hpp"
#include "iga/post/internal_forces.hpp"

namespace isopatch::iga {
namespace {

// All but the right sides and the supports that they need.
CoupledProblem without_loads(const ElasticityProblem& problem, const CouplingOptions& options) {
  const solvers::Processes& processes = options.processes;
  CoupledProblem result;
  result.problem = &problem;
  result.coupling = options.coupling;
  result.points = options.points;
  result.processes = processes;
  result.global = global_nodes(problem.discretization);
  result.spaces = isoparametric_spaces(problem.discretization);
  result.distribution =
      distribute(problem.discretization.model, result.spaces, result.global, processes.count());
  result.parts = layers_of(result.distribution, result.spaces, processes.rank());
  return result;
}

// The constraints of faces that do not match, once the supports are known.
MortarConstraints constraints_of(const CoupledProblem& coupled, const CouplingOptions& options) {
  const Discretization& d = coupled.discretization();
  if (options.non_matching != NonMatchingCoupling::mortar || d.model.non_matching().empty()) return {};
  MortarTies ties{mortar_faces(d, coupled.problem->materials, options.mortar_side), {}};
  std::vector<geometry::PatchFace> slaves;
  for (const MortarFace& face : ties.faces) slaves.push_back(face.slave);
  for (const MortarFace& face : ties.faces)
    ties.edges.push_back(shared_edges(face.slave, slaves, d, coupled.global, coupled.frames));
  return mortar_constraints(ties, coupled.spaces, d.model.tolerance().same_point * d.model.size());
}

void sum_over(const solvers::Processes& processes, Eigen::Matrix3Xd& of_nodes) {
  if (processes.count() > 1) processes.sum(Eigen::Map<Eigen::VectorXd>(of_nodes.data(), of_nodes.size()));
}

// What acts on a problem, temperatures included.
RightSide whole_right_side(const ElasticityProblem& problem, const CoupledProblem& coupled,
                           NonMatchingCoupling non_matching) {
  RightSide result = right_side(problem, coupled.global, coupled.frames, coupled.points);
  result.thermal = thermal_strains(problem.temperatures, problem.materials);
  if (result.thermal.empty()) return result;
  result.thermal_load = thermal_forces(problem.discretization, problem.materials, result.thermal,
                                       coupled.parts, coupled.points);
  SurfaceTerms terms = surface_terms(problem);
  if (non_matching == NonMatchingCoupling::mortar) terms.interfaces.clear();
  result.thermal_ties = interface_thermal_load(coupled.spaces, coupled.parts, terms, result.thermal);
  sum_over(coupled.processes, result.thermal_load);
  sum_over(coupled.processes, result.thermal_ties);
  result.load += result.thermal_load + result.thermal_ties;
  return result;
}

}  // namespace

SurfaceTerms CoupledProblem::surfaces() const {
  SurfaceTerms result = surface_terms(*problem);
  if (!mortar.empty()) result.interfaces.clear();
  return result;
}

CoupledProblem coupled_problem(const ElasticityProblem& problem, const CouplingOptions& options) {
  CoupledProblem result = without_loads(problem, options);
  result.frames = support_frames(problem, result.global);
  result.multipliers = multiplier_rows(result.global, result.frames);
  result.mortar = constraints_of(result, options);
  result.right_sides = {whole_right_side(problem, result, options.non_matching)};
  return result;
}

CoupledProblem coupled_cases(const ElasticityProblem& problem, const std::vector<LoadCase>& cases,
                             const CouplingOptions& options) {
  CoupledProblem result = without_loads(problem, options);
  for (const LoadCase& load_case : cases) {
    const ElasticityProblem own = of_case(problem, load_case);
    // Which directions are held does not depend on by how much.
    result.frames = support_frames(own, result.global);
    result.right_sides.push_back(whole_right_side(own, result, options.non_matching));
  }
  result.multipliers = multiplier_rows(result.global, result.frames);
  result.mortar = constraints_of(result, options);
  return result;
}

}  // namespace isopatch::iga
