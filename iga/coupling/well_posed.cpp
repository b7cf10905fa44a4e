#include "iga/coupling/well_posed.hpp"

#include "iga/coupling/global_nodes.hpp"
#include "iga/coupling/rigid_motions.hpp"
#include "iga/coupling/support_frames.hpp"
#include "iga/problem/loads.hpp"
#include "iga/spaces/quadrature_geometry.hpp"

namespace isopatch::iga {

void require_unfolded(const Discretization& discretization, int points) {
  const std::vector<PatchSpace> spaces = isoparametric_spaces(discretization);
  std::vector<double> plane;
  for (std::size_t p = 0; p < spaces.size(); ++p) {
    const QuadratureGeometry geometry(spaces[p], points);
    const int layers = geometry.points(2);
    plane.resize(static_cast<std::size_t>(geometry.blocks()) * static_cast<std::size_t>(layers) *
                 static_cast<std::size_t>(geometry.components() * QuadratureGeometry::block_size));
    for (int j = 0; j < geometry.points(1); ++j)
      geometry.evaluate(j, 0, layers, plane.data(), layers, static_cast<int>(p));
  }
}

void require_well_posed(const ElasticityProblem& problem, int points) {
  const Discretization& discretization = problem.discretization;
  for (const Material& material : problem.materials) validate(material);
  thermal_strains(problem.temperatures, problem.materials);
  const GlobalNodes global = global_nodes(discretization);
  require_supported(problem, global, support_frames(problem, global));
  load_vector(problem, points);
  require_unfolded(discretization, points);
}

}  // namespace isopatch::iga
