#pragma once

#include <vector>

#include "geometry/io/vtu_file.hpp"
#include "geometry/splines/grid.hpp"
#include "iga/spaces/elastic_field.hpp"

namespace isopatch::iga {

/// The estimated errors of elements as numbers of the cells into which grids cut them: `error_energy` (of the
/// whole element, J) and `stress_error` (Pa). None where errors are not estimated.
/// @param field    must outlive the result
/// @param patches  one for each grid
/// @param grids    ends of the cells along each direction
std::vector<geometry::VtuCellField> error_cells(const ElasticField& field, const std::vector<int>& patches,
                                                const std::vector<geometry::GridParameters<3>>& grids);

/// The ends of elements as a grid.
geometry::GridParameters<3> element_grid(const geometry::NurbsVolume& patch);

}  // namespace isopatch::iga
