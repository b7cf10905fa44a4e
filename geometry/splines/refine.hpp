#pragma once

#include <array>
#include <vector>

#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry {

/// The same map in a finer space, exactly; `fine` must contain the space of `spline` in every direction.
/// @throws Error invalid_argument if it does not
template <int D>
Nurbs<D> refined(const Nurbs<D>& spline, const typename Nurbs<D>::KnotVectors& fine);

/// Knots inserted along one direction.
template <int D>
Nurbs<D> insert_knots(const Nurbs<D>& spline, int direction, const std::vector<double>& knots);

/// Degree raised along one direction; the continuity stays.
template <int D>
Nurbs<D> elevate_degree(const Nurbs<D>& spline, int direction, int times);

/// One direction turned around: the point at t is where first + last - t was.
template <int D>
Nurbs<D> reversed(const Nurbs<D>& spline, int direction);

/// The single Bezier pieces of a spline, elements of the first direction running fastest.
/// Each has the knots of its element, so parameters keep their meaning.
template <int D>
std::vector<Nurbs<D>> bezier_pieces(const Nurbs<D>& spline);

}  // namespace isopatch::geometry
