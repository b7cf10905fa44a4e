#pragma once

#include <array>
#include <vector>

#include "geometry/splines/nurbs.hpp"

namespace isopatch::iga {

/// Refuses a patch that is folded at a quadrature point.
/// @param reversed   whether the input has the first direction the other way round
/// @param parameter  of the volume
/// @throws Error fold_over  always, naming patch, parameter (the input's names) and place
[[noreturn]] void refuse_folded(int patch, const geometry::NurbsVolume& volume, bool reversed,
                                const geometry::Parameter<3>& parameter);

/// The same, at that point of a grid where det J is the smallest.
/// @param nodes  parameters of the grid in each direction
[[noreturn]] void refuse_folded(int patch, const geometry::NurbsVolume& volume, bool reversed,
                                const std::array<std::vector<double>, 3>& nodes);

}  // namespace isopatch::iga
