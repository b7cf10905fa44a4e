#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <memory>
#include <vector>

#include "iga/material/material.hpp"
#include "iga/spaces/patch_space.hpp"

namespace isopatch::iga {

/// Stiffness of isotropic elasticity as an operator, without a matrix.
///
/// Sum factorization over whole boxes of elements, stage by stage; the Jacobians are computed again at every
/// product, so that nothing is stored per quadrature point. Equals the assembled matrix with the same
/// quadrature to round-off. The result does not depend on the number of threads, to the last bit.
///
/// @source  Sangalli, Tani, arXiv 1712.08565, section 4 (patch-wise products); Kronbichler, Kormann 2012
/// (vectors across quadrature points)
class StiffnessOperator {
 public:
  /// @param spaces     must outlive the operator; nodes are numbered over all of them, patch after patch
  /// @param parts      the elements that are integrated; must not overlap
  /// @param materials  one per patch
  /// @param points     Gauss points per element of the functions' knots and direction; 0: degree + 1
  /// @throws Error invalid_argument  counts that do not fit, a part outside its patch, points outside 0 .. 64
  StiffnessOperator(const std::vector<PatchSpace>& spaces, std::vector<PatchLayers> parts,
                    std::vector<Material> materials, int points = 0);

  /// K u per node, before any coupling of patches; 0 for nodes outside the parts.
  /// @param displacement  (3, nodes), m
  /// @return              (3, nodes), N
  /// @throws Error fold_over         a Gauss point with det J <= 0, naming patch, parameter and place
  /// @throws Error invalid_argument  another number of nodes
  /// @cost   at degree p about 54 (p + 1)^4 + 172 (p + 1)^3 flops per control point, 1.4 times that if
  ///         rational (9 and 13 kflop per unknown for p = 3); memory is read and written a few times; the
  ///         boxes' shares of the result are about two of it, three or more on small patches
  Eigen::Matrix3Xd apply(const Eigen::Matrix3Xd& displacement) const;

  /// The same for several displacements, for which the map of the geometry is computed once for some at a
  /// time.
  /// @cost  for each about 0.75 of what it takes alone if the functions are those of the geometry
  std::vector<Eigen::Matrix3Xd> apply(const std::vector<Eigen::Matrix3Xd>& displacements) const;

  /// The 3 x 3 diagonal block of every node, with the same quadrature; 0 for nodes outside the parts.
  /// @throws Error fold_over
  /// @cost   about two products
  std::vector<Eigen::Matrix3d> diagonal_blocks() const;

  int node_count() const;
  /// Memory that the operator keeps.
  std::int64_t bytes() const;

 private:
  struct State;
  std::shared_ptr<const State> state_;
};

}  // namespace isopatch::iga
