#include "iga/assembly/surface_stiffness.hpp"

#include <algorithm>
#include <iterator>

#include "iga/assembly/mortar_stiffness.hpp"
#include "iga/assembly/support_stiffness.hpp"

namespace isopatch::iga {

SurfaceTerms surface_terms(const ElasticityProblem& problem) {
  const Discretization& d = problem.discretization;
  return {springs_of(problem),
          coupled_faces(d, problem.materials),
          problem.materials,
          d.model.tolerance().same_point * d.model.size(),
          {}};
}

NodeBlocks surface_stiffness(const std::vector<PatchSpace>& spaces, const std::vector<PatchLayers>& parts,
                             const SurfaceTerms& terms) {
  NodeBlocks result = support_stiffness(spaces, parts, terms.springs);
  result.add(interface_stiffness(spaces, parts, terms));
  result.add(mortar_stiffness(ties_of(terms.mortar, parts), spaces, terms.materials, terms.same_point));
  return result;
}

std::vector<CoupledFaces> interfaces_of(const SurfaceTerms& terms, const std::vector<PatchLayers>& parts) {
  const auto is_here = [&](const CoupledFaces& faces) {
    return std::any_of(parts.begin(), parts.end(), [&](const PatchLayers& part) {
      return part.couples && part.patch == faces.traction.patch.value;
    });
  };
  std::vector<CoupledFaces> result;
  std::copy_if(terms.interfaces.begin(), terms.interfaces.end(), std::back_inserter(result), is_here);
  return result;
}

NodeBlocks interface_stiffness(const std::vector<PatchSpace>& spaces, const std::vector<PatchLayers>& parts,
                               const SurfaceTerms& terms) {
  return interface_stiffness(interfaces_of(terms, parts), spaces, terms.materials, terms.same_point);
}

}  // namespace isopatch::iga
