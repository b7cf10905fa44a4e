#pragma once

#include "iga/spaces/discretization.hpp"

namespace isopatch::iga {

/// Refuses a quadrature point with det J <= 0.
/// @param parameter  in the naming of `discretization.model`
/// @throws Error fold_over  always, naming patch, parameter (the input's names) and place
[[noreturn]] void refuse_folded(const Discretization& discretization, int patch, double jacobian,
                                const geometry::Parameter<3>& parameter, const Eigen::Vector3d& place);

}  // namespace isopatch::iga
