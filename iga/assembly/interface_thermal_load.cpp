#include "iga/assembly/interface_thermal_load.hpp"

#include "geometry/common_refinement.hpp"
#include "iga/assembly/internal/patch_side.hpp"

namespace isopatch::iga {
namespace {

void add_at_point(const PatchSide::Functions& functions, const Eigen::Vector3d& force,
                  Eigen::Matrix3Xd& load) {
  for (std::size_t f = 0; f < functions.nodes.size(); ++f)
    if (functions.is_on_side[f]) load.col(functions.nodes[f]) += functions.values[f] * force;
}

}  // namespace

Eigen::Matrix3Xd interface_thermal_load(const std::vector<PatchSpace>& spaces,
                                        const std::vector<PatchLayers>& parts, const SurfaceTerms& terms,
                                        const std::vector<ThermalStrain>& strain) {
  const std::vector<int> first_node = first_nodes(spaces);
  Eigen::Matrix3Xd load = Eigen::Matrix3Xd::Zero(3, first_node.back());
  for (const CoupledFaces& faces : interfaces_of(terms, parts)) {
    const auto p = static_cast<std::size_t>(faces.traction.patch.value);
    const auto q = static_cast<std::size_t>(faces.other.patch.value);
    const Material& material = terms.materials[p];
    const PatchSide own(spaces[p], faces.traction.side, first_node[p]);
    const PatchSide other(spaces[q], faces.other.side, first_node[q]);
    const geometry::DividedSurface divided = own.divided();
    for (const geometry::SharedCell& cell :
         geometry::common_refinement(divided, other.divided(), points_of_cell(own, other), terms.same_point))
      for (const geometry::SharedPoint& point : cell.points) {
        const PatchSide::Functions of_own = own.functions(cell.first, point.first);
        const double stress =
            (3 * material.lambda + 2 * material.mu) * strain[p].at(divided.surface->point(point.first));
        const Eigen::Vector3d force = point.weight * stress * of_own.normal;
        add_at_point(of_own, -force, load);
        add_at_point(other.functions(cell.second, point.second), force, load);
      }
  }
  return load;
}

}  // namespace isopatch::iga
