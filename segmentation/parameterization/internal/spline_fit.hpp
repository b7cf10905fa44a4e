#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "geometry/splines/knot_vector.hpp"
#include "segmentation/parameterization/internal/rational_net.hpp"

namespace isopatch::segmentation {

using geometry::KnotVector;

/// `per_span` parameters in the middle of equal parts of every knot span, with both ends of the range.
std::vector<double> fitting_parameters(const KnotVector& knots, int per_span);

/// Least squares on given parameters by splines that vanish at both ends.
/// @return  (size - 2, parameters): from values to the inner coefficients
/// @cost    O(parameters * size^2)
Eigen::MatrixXd inner_fit(const KnotVector& knots, const std::vector<double>& parameters);

/// Control points of the curve with given ends that fits points at parameters; (3, size).
/// @param points  (3, parameters), the first and the last at the ends
Eigen::Matrix3Xd fit_curve(const KnotVector& knots, const std::vector<double>& parameters,
                           const Eigen::Matrix3Xd& points, const Eigen::Vector3d& first,
                           const Eigen::Vector3d& last);

/// Control points of the surface with a given boundary that fits a grid of points; (3, sizes).
///
/// The boundary is not touched: its control points come out as they went in, to the last bit.
/// @param boundary  (3, sizes): a net whose outer points are given; the inner ones are the start
/// @param points    (3, grid), first direction fastest
Eigen::Matrix3Xd fit_surface(const std::array<KnotVector, 2>& knots,
                             const std::array<std::vector<double>, 2>& parameters,
                             const Eigen::Matrix3Xd& points, Eigen::Matrix3Xd boundary);

/// The same of a rational surface, whose weights are given: of the boundary and inside.
RationalNet fit_surface(const std::array<KnotVector, 2>& knots,
                        const std::array<std::vector<double>, 2>& parameters, const Eigen::Matrix3Xd& points,
                        RationalNet boundary);

/// How far points are from every spline of a space, as far as each line of the grid along one direction
/// tells: per span the largest distance of a point from its line's least squares fit, model units.
std::vector<double> line_errors(const std::array<KnotVector, 2>& knots,
                                const std::array<std::vector<double>, 2>& parameters,
                                const Eigen::Matrix3Xd& points, int direction);

}  // namespace isopatch::segmentation
