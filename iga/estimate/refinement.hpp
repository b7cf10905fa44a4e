#pragma once

#include <vector>

#include "iga/spaces/discretization.hpp"
#include "iga/spaces/elastic_field.hpp"

namespace isopatch::iga {

/// Where elements are to be halved so that the error becomes small: sheets of elements, one for one in the
/// order of what they promise per unknown that they add, until what is left promises to be small enough.
///
/// No more than to a tenth of the error, and to twice what halving all would leave: the last sheets promise
/// little for what they add.
///
/// Halving a sheet along its direction takes its share of the error there (`ElementErrors::along`) to 4^-p, p
/// being the degree: so it is where the solution is smooth. Where it is not, errors shrink more slowly, and
/// the next estimate asks for more.
/// @param errors  of each patch; energies, or any multiple of them
/// @param wanted  sum of energies that is small enough, in the same unit
/// @param growth  most control points afterwards, as a multiple of those now; above 1
/// @param spread  as the discretization was made: otherwise layers are halved one by one
/// @return        what to add to `DiscretizationOptions::knots`: one knot for each sheet, at least one if
/// there
///                is any error
/// @cost          O(elements)
std::vector<KnotPlace> knots_to_add(const Discretization& discretization,
                                    const std::vector<ElementErrors>& errors, double wanted, double growth,
                                    bool spread = true);

}  // namespace isopatch::iga
