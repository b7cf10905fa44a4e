#pragma once

#include <vector>

#include "geometry/io/vtk_bezier.hpp"
#include "iga/elastic_field.hpp"

namespace isopatch::iga {

/// One patch as rational Bezier cells with its fields.
///
/// Displacement (m) is exact. Stress (Pa, xx yy zz xy yz zx), von Mises (Pa) and the Jacobian determinant are
/// interpolated at the (p + 1)^3 Gauss points of each element: exact there, a polynomial between them.
/// The cell field `patch` holds the patch's index, from 0.
geometry::BezierCells bezier_cells(const ElasticField& field, int patch);

}  // namespace isopatch::iga
