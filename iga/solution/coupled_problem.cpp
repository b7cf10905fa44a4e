#include "iga/solution/coupled_problem.hpp"

#include "geometry/base/error.hpp"
#include "iga/post/internal_forces.hpp"

namespace isopatch::iga {
namespace {

// All but the right sides and the supports that they need.
CoupledProblem without_loads(const ElasticityProblem& problem, const CouplingOptions& options) {
  const solvers::Processes& processes = options.processes;
  if (processes.count() > 1 && !problem.discretization.model.non_matching().empty())
    throw Error(
        ErrorCode::unsupported,
        "models with non-matching interfaces are solved by one process; start isopatch without mpiexec");
  if (!problem.temperatures.empty() && !problem.discretization.model.non_matching().empty())
    throw Error(ErrorCode::unsupported,
                "temperatures are not for models with non-matching interfaces yet: their stresses would be "
                "missing in what couples the patches; divide the patches so that they match");
  CoupledProblem result;
  result.problem = &problem;
  result.coupling = options.coupling;
  result.points = options.points;
  result.processes = processes;
  result.global = global_nodes(problem.discretization);
  result.spaces = isoparametric_spaces(problem.discretization);
  result.distribution = distribute(result.spaces, processes.count());
  result.parts = layers_of(result.distribution, result.spaces, processes.rank());
  return result;
}

// The constraints of faces that do not match, once the supports are known.
MortarConstraints constraints_of(const CoupledProblem& coupled, const CouplingOptions& options) {
  const Discretization& d = coupled.discretization();
  if (options.non_matching != NonMatchingCoupling::mortar || d.model.non_matching().empty()) return {};
  const std::vector<MortarFace> faces = mortar_faces(d, coupled.problem->materials, options.mortar_side);
  std::vector<geometry::PatchFace> slaves;
  for (const MortarFace& face : faces) slaves.push_back(face.slave);
  std::vector<std::array<std::optional<SharedEdges>, 3>> edges;
  for (const MortarFace& face : faces)
    edges.push_back(shared_edges(face.slave, slaves, d, coupled.global, coupled.frames));
  return mortar_constraints(faces, edges, coupled.spaces, coupled.problem->materials,
                            d.model.tolerance().same_point * d.model.size());
}

// What acts on a problem, temperatures included.
RightSide whole_right_side(const ElasticityProblem& problem, const CoupledProblem& coupled) {
  RightSide result = right_side(problem, coupled.global, coupled.frames, coupled.points);
  result.thermal = thermal_strains(problem.temperatures, problem.materials);
  if (result.thermal.empty()) return result;
  result.thermal_load = thermal_forces(problem.discretization, problem.materials, result.thermal,
                                       coupled.parts, coupled.points);
  if (coupled.processes.count() > 1)
    coupled.processes.sum(
        Eigen::Map<Eigen::VectorXd>(result.thermal_load.data(), result.thermal_load.size()));
  result.load += result.thermal_load;
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
  result.right_sides = {whole_right_side(problem, result)};
  return result;
}

CoupledProblem coupled_cases(const ElasticityProblem& problem, const std::vector<LoadCase>& cases,
                             const CouplingOptions& options) {
  CoupledProblem result = without_loads(problem, options);
  for (const LoadCase& load_case : cases) {
    const ElasticityProblem own = of_case(problem, load_case);
    // Which directions are held does not depend on by how much.
    result.frames = support_frames(own, result.global);
    result.right_sides.push_back(whole_right_side(own, result));
  }
  result.multipliers = multiplier_rows(result.global, result.frames);
  result.mortar = constraints_of(result, options);
  return result;
}

}  // namespace isopatch::iga
