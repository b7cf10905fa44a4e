#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <array>
#include <vector>

#include "iga/coupling/interface_roles.hpp"
#include "iga/coupling/row_numbering.hpp"
#include "iga/coupling/shared_edges.hpp"
#include "iga/coupling/support_frame.hpp"
#include "iga/spaces/patch_space.hpp"
#include "solvers/linear_system.hpp"

namespace isopatch::iga {

/// The faces with multipliers.
struct MortarTies {
  std::vector<MortarFace> faces;
  std::vector<std::array<std::optional<SharedEdges>, 3>>
      edges;  ///< of each slave, per component; nothing where supports hold all of it
};

/// Those whose slaves a process integrates.
MortarTies ties_of(const MortarTies& all, const std::vector<PatchLayers>& parts);

/// What the mortar method asks of displacements: for every multiplier function m of a slave face and the
/// component that it is for
///
///     integral m (u_slave - u_masters) = 0,   divided by s.
///
/// The multiplier functions are splines of the slave's own knots with one degree less on elements at edges
/// whose displacements are not the face's alone (`multiplier_coefficients`), polynomial where its
/// displacements are rational. So there are as many as components of nodes on none of these edges.
struct MortarConstraints {
  MortarTies ties;
  std::vector<int> first_row;  ///< of each face, and the number of rows at the end
  std::vector<int> component;  ///< of each row
  std::vector<double> size;    ///< s of each row, m^2: the sum of the sizes of the slave's entries
  /// (rows, nodes of all patches), of the row's component.
  Eigen::SparseMatrix<double, Eigen::RowMajor> jumps;

  int rows() const { return first_row.empty() ? 0 : first_row.back(); }
  bool empty() const { return rows() == 0; }
};

/// @param spaces      of all patches
/// @param same_point  how far faces may be apart, m
/// @cost    as that of `interface_stiffness`, less by half
/// @source  Bernardi, Maday, Patera 1994; for splines Brivadis, Buffa, Wohlmuth, Wunderlich, Isogeometric
///          mortar methods, 2015
MortarConstraints mortar_constraints(const MortarTies& ties, const std::vector<PatchSpace>& spaces,
                                     double same_point);

/// B of the constraints for the unknowns x of block rows, u = prescribed + axes * x. (rows, 3 block rows)
/// @param frame_of_row  one per block row of the numbering
solvers::ConstraintMatrix mortar_matrix(const MortarConstraints& constraints, const RowNumbering& numbering,
                                        const std::vector<const SupportFrame*>& frame_of_row);

/// What B x must be where supports prescribe displacements: minus the jump of these. (rows), m
/// @param prescribed  of the block rows, (3 block rows), m
Eigen::VectorXd mortar_right_side(const MortarConstraints& constraints, const RowNumbering& numbering,
                                  const Eigen::VectorXd& prescribed);

/// The forces that the multipliers put on the nodes of all patches, as the stiffness counts them: K u + these
/// are the loads. (3, nodes), N
/// @param multipliers  (rows), N
Eigen::Matrix3Xd mortar_forces(const MortarConstraints& constraints, const Eigen::VectorXd& multipliers);

/// The force of the masters on each slave face, N.
std::vector<Eigen::Vector3d> forces_on_slaves(const MortarConstraints& constraints,
                                              const std::vector<PatchSpace>& spaces,
                                              const Eigen::VectorXd& multipliers);

}  // namespace isopatch::iga
