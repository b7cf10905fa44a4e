#pragma once

#include <Eigen/Core>
#include <Eigen/SparseCore>
#include <vector>

#include "iga/coupling/interface_roles.hpp"
#include "iga/coupling/row_numbering.hpp"
#include "iga/coupling/shared_edges.hpp"
#include "iga/coupling/support_frame.hpp"
#include "iga/spaces/patch_space.hpp"
#include "solvers/linear_system.hpp"

namespace isopatch::iga {

/// What the mortar method asks of displacements: for every multiplier function m_i of a slave face
///
///     integral m_i (u_slave - u_masters) = 0,   divided by s_i.
///
/// The multiplier functions are splines of the slave's own knots with one degree less on elements at edges
/// that are not the face's alone (`multiplier_coefficients`), polynomial where its displacements are
/// rational. So there are as many as nodes of the face on none of these edges.
struct MortarConstraints {
  std::vector<MortarFace> faces;
  std::vector<SharedEdges> edges;   ///< of each slave
  std::vector<int> first_function;  ///< of each face, and their number at the end
  Eigen::VectorXd scale;            ///< s_i, m^2: the sum of the slave's entries' sizes
  /// (functions, nodes of all patches): the same for each component of u.
  Eigen::SparseMatrix<double, Eigen::RowMajor> jumps;
  /// (3 functions)^2, m^3/N: integral of m_i m_j / (s_i s_j) by the inverse of Nitsche's penalty, 3 x 3. What
  /// multipliers cost in a block diagonal preconditioner.
  Eigen::SparseMatrix<double> compliance;

  int functions() const { return first_function.empty() ? 0 : first_function.back(); }
  bool empty() const { return functions() == 0; }
};

/// @param edges       one per face
/// @param spaces      of all patches
/// @param materials   one per patch
/// @param same_point  how far faces may be apart, m
/// @cost    (degree + 1)^4 per quadrature point, of (degree + 3)^2 per cell of the common refinement
/// @source  Bernardi, Maday, Patera 1994; for splines Brivadis, Buffa, Wohlmuth, Wunderlich, Isogeometric
///          mortar methods, 2015
MortarConstraints mortar_constraints(const std::vector<MortarFace>& faces,
                                     const std::vector<SharedEdges>& edges,
                                     const std::vector<PatchSpace>& spaces,
                                     const std::vector<Material>& materials, double same_point);

/// B of the constraints for the unknowns x of block rows, u = prescribed + axes * x: three rows for each
/// function, along the coordinate axes. (3 functions, 3 rows)
/// @param frame_of_row  one per row of the numbering
solvers::ConstraintMatrix mortar_matrix(const MortarConstraints& constraints, const RowNumbering& numbering,
                                        const std::vector<const SupportFrame*>& frame_of_row);

/// What B x must be where supports prescribe displacements: minus the jump of these. (3 functions), m
/// @param prescribed  of the block rows, (3 rows), m
Eigen::VectorXd mortar_right_side(const MortarConstraints& constraints, const RowNumbering& numbering,
                                  const Eigen::VectorXd& prescribed);

/// The forces that the multipliers put on the nodes of all patches, as the stiffness counts them: K u + these
/// are the loads. (3, nodes), N
/// @param multipliers  (3 functions), N
Eigen::Matrix3Xd mortar_forces(const MortarConstraints& constraints, const Eigen::VectorXd& multipliers);

/// The force of the masters on each slave face, N.
std::vector<Eigen::Vector3d> forces_on_slaves(const MortarConstraints& constraints,
                                              const std::vector<PatchSpace>& spaces,
                                              const Eigen::VectorXd& multipliers);

}  // namespace isopatch::iga
