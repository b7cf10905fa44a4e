#include "iga/assembly/surface_stiffness.hpp"

#include "iga/assembly/support_stiffness.hpp"

namespace isopatch::iga {

SurfaceTerms surface_terms(const ElasticityProblem& problem) {
  const Discretization& d = problem.discretization;
  return {springs_of(problem), coupled_faces(d, problem.materials), problem.materials,
          d.model.tolerance().same_point * d.model.size()};
}

NodeBlocks surface_stiffness(const std::vector<PatchSpace>& spaces, const std::vector<PatchLayers>& parts,
                             const SurfaceTerms& terms) {
  NodeBlocks result = support_stiffness(spaces, parts, terms.springs);
  result.add(interface_stiffness(terms.interfaces, spaces, terms.materials, terms.same_point));
  return result;
}

}  // namespace isopatch::iga
