#pragma once

#include <array>
#include <string_view>

namespace isopatch::iga {

/// How patches are held together.
enum class Coupling {
  elimination,  ///< coincident control points share their unknowns: a positive definite system
  lagrange,     ///< every patch keeps its unknowns, multipliers tie them: a saddle point
};
std::string_view name(Coupling coupling);

/// How faces are held together that are one surface but do not match.
enum class NonMatchingCoupling {
  nitsche,  ///< tractions and a penalty between the displacements: a positive definite system
  mortar,   ///< multipliers make the displacements equal in the mean: a saddle point
};
std::string_view name(NonMatchingCoupling coupling);

inline constexpr std::array all_couplings = {Coupling::elimination, Coupling::lagrange};

}  // namespace isopatch::iga
