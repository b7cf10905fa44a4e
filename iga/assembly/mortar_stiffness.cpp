#include "iga/assembly/mortar_stiffness.hpp"

#include "iga/assembly/internal/side_grid.hpp"

namespace isopatch::iga {
namespace {

using SparseJumps = Eigen::SparseMatrix<double, Eigen::RowMajor>;

// Times Young's modulus (degree + 1)^2 / thickness. Iterations for degrees 1 to 4 on a link, a plate and a
// pipe joint are the same to a tenth between 5 and 80.
constexpr double stiffness_of_springs = 20;

// t of a face, Pa/m.
double stiffness_of(const geometry::PatchFace& slave, const std::vector<PatchSpace>& spaces,
                    const std::vector<Material>& materials) {
  const auto p = static_cast<std::size_t>(slave.patch.value);
  return stiffness_of_springs * young(materials[p]) *
         trace_constants(SideFunctions(spaces[p], slave.side, 0)).mean();
}

}  // namespace

NodeBlocks mortar_stiffness(const MortarTies& ties, const std::vector<PatchSpace>& spaces,
                            const std::vector<Material>& materials, double same_point) {
  if (ties.faces.empty()) return {};
  const MortarConstraints constraints = mortar_constraints(ties, spaces, same_point);
  Eigen::VectorXd stiffness(constraints.rows());
  for (std::size_t f = 0; f < ties.faces.size(); ++f) {
    const double of_face = stiffness_of(ties.faces[f].slave, spaces, materials);
    for (int row = constraints.first_row[f]; row < constraints.first_row[f + 1]; ++row)
      stiffness[row] = of_face * constraints.size[static_cast<std::size_t>(row)];
  }
  BlockSums sums;
  for (int component = 0; component < 3; ++component) {
    Eigen::VectorXd of_component = stiffness;
    for (Eigen::Index row = 0; row < stiffness.size(); ++row)
      if (constraints.component[static_cast<std::size_t>(row)] != component) of_component[row] = 0;
    const SparseJumps jumps = of_component.cwiseSqrt().asDiagonal() * constraints.jumps;
    const SparseJumps products = SparseJumps(jumps.transpose()) * jumps;
    for (Eigen::Index node = 0; node < products.rows(); ++node)
      for (SparseJumps::InnerIterator it(products, node); it; ++it) {
        if (it.col() < node || it.value() == 0) continue;
        Eigen::Matrix3d block = Eigen::Matrix3d::Zero();
        block(component, component) = it.value();
        sums.add(static_cast<int>(node), static_cast<int>(it.col()), block);
      }
  }
  return sums.blocks();
}

}  // namespace isopatch::iga
