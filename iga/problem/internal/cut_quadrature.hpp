#pragma once

#include <vector>

#include "geometry/splines/nurbs.hpp"
#include "iga/problem/region.hpp"

namespace isopatch::iga {

/// A quadrature point of a part of a surface.
struct CutPoint {
  geometry::Parameter<2> parameter;
  double weight = 0;  ///< in the parameters
};

/// How a region cuts one element of a surface.
struct CutRule {
  enum class Kind { inside, outside, cut };
  Kind kind = Kind::outside;
  std::vector<CutPoint> points = {};  ///< of what is inside, where it is cut
};

/// The part of an element that lies in a region, integrated up to its rim.
///
/// Every quadric on the element is a polynomial in Bernstein form, whose coefficients bound it. Cells are
/// quartered until at most one quadric cuts each and is steep in one direction there; there the rim is a
/// graph that is found point by point, and Gauss points lie between it and the cell's sides. Cells of 2^-14
/// of the element in which two quadrics still meet are counted by their middle.
///
/// @param element  a Bezier piece
/// @param points   Gauss points per direction of a cell
/// @param slack    an element that is nowhere farther outside than this is inside, m
/// @throws Error unsupported  a part so narrow that it takes more than 100,000 cells
/// @cost   some points^2 (degree + 1)^3 operations for each of the cells, which are a few per element
/// @source the rim as a graph as in Saye, SIAM J. Sci. Comput. 37 (2015), section 3
CutRule cut_rule(const geometry::NurbsSurface& element, const Region& region, int points, double slack);

}  // namespace isopatch::iga
