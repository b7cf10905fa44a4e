#pragma once

#include <string>
#include <vector>

#include "geometry/patch_face.hpp"
#include "iga/material/material.hpp"
#include "iga/spaces/discretization.hpp"

namespace isopatch::iga {

/// A non-matching interface with its roles in Nitsche's method: the traction there is that of one side, the
/// one that needs the smaller penalty. A penalty that is larger than it need be ties functions that differ as
/// if they had to be equal: a patch of degree 4 beside one of degree 2 is then no better than degree 2.
struct CoupledFaces {
  geometry::PatchFace traction;  ///< the side whose stresses are taken: softer, or of larger elements
  geometry::PatchFace other;
};

/// The roles of the sides of all non-matching interfaces.
/// @param materials  one per patch
std::vector<CoupledFaces> coupled_faces(const Discretization& discretization,
                                        const std::vector<Material>& materials);

/// A face whose displacements follow those of the faces that cover it, in the mortar method: multipliers live
/// on it, made of its own functions.
struct MortarFace {
  geometry::PatchFace slave;
  std::vector<geometry::PatchFace> masters;  ///< that cover it together
  std::string reason;                        ///< why this side and not the other, in words
};

/// Which of two sides has the multipliers, where either can.
enum class MortarSide {
  automatic,  ///< the softer, of equal ones the finer
  other,      ///< the opposite of that: results differ by no more than the error of the discretization
};

/// The faces with multipliers. Faces that meet, directly or through others, are the two sides of one surface;
/// all faces of one side of it are slaves. A slave must be covered all over, since multipliers where nothing
/// is tied have no meaning.
/// @param materials  one per patch
/// @return  ordered by slave; empty where all interfaces match
/// @throws Error unsupported  where each side has a face that others cover in part only, naming both
/// @source  Bernardi, Maday, Patera 1994; the choice of the softer side: Wohlmuth, Discretization Methods and
///          Iterative Solvers Based on Domain Decomposition, 2001, section 1.2
std::vector<MortarFace> mortar_faces(const Discretization& discretization,
                                     const std::vector<Material>& materials,
                                     MortarSide side = MortarSide::automatic);

}  // namespace isopatch::iga
