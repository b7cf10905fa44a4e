#pragma once

#include <Eigen/Core>
#include <optional>
#include <vector>

#include "geometry/multi_patch.hpp"
#include "geometry/splines/nurbs.hpp"
#include "iga/problem/problem.hpp"
#include "iga/solution/solve_elasticity.hpp"

namespace isopatch::iga {

/// The force per area that holds two patches together, as a field over their interface.
struct InterfaceTraction {
  int interface = 0;  ///< index into the model's interfaces
  /// On the first patch, Pa, over the parameters of its face: a surface whose points are tractions. Nothing
  /// where no multiplier belongs to this interface alone, because it has too few functions.
  std::optional<geometry::NurbsSurface> field;
  double area = 0;                                  ///< m^2
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  ///< integral of the field, N
};

/// Tractions from multipliers, one for each interface of the model.
///
/// The multipliers of an interface are the integrals of its traction against trace functions. Those of points
/// where more than two patches meet, or that a support holds, cannot be attributed to one interface: these
/// functions are left out of the test, and near such an edge the traction continues linearly from inside, in
/// terms of its coefficients. A traction that is constant or, with B-splines, linear in the face's parameters
/// is exact.
///
/// @param multipliers  of a solution of the problem, solved for or recovered
/// @throws Error as support_frames
/// @cost   a sparse factorization of the functions on each interface
/// @source the change of the space near edges is that of mortar methods: Bernardi, Maday, Patera 1994; for
///         splines Brivadis, Buffa, Wohlmuth, Wunderlich 2015, section 4.3
std::vector<InterfaceTraction> interface_tractions(const ElasticityProblem& problem,
                                                   const std::vector<Multiplier>& multipliers);

/// The traction on the interface's first patch at a place that is given on either side.
/// @param face       the first or the second of the interface
/// @param parameter  of this face
Eigen::Vector3d traction_at(const Discretization& discretization, const InterfaceTraction& traction,
                            const geometry::PatchFace& face, const geometry::Parameter<2>& parameter);

}  // namespace isopatch::iga
