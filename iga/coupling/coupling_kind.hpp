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

inline constexpr std::array all_couplings = {Coupling::elimination, Coupling::lagrange};

}  // namespace isopatch::iga
