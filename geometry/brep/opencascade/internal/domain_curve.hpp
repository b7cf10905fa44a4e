#pragma once

#include <Eigen/Core>
#include <Geom2d_Curve.hxx>

namespace isopatch::geometry {

/// A curve of a domain through points at parameters: a line where they lie on one.
/// @param t       increasing
/// @param points  (2, t.size())
/// @param near    largest distance from a line
Handle(Geom2d_Curve) domain_curve(const Eigen::VectorXd& t, const Eigen::Matrix2Xd& points, double near);

}  // namespace isopatch::geometry
