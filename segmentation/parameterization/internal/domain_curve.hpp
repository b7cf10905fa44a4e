#pragma once

#include <Eigen/Core>
#include <functional>

namespace isopatch::segmentation {

/// A curve in the domain of a face, over [0, 1].
using DomainCurve = std::function<Eigen::Vector2d(double)>;
/// The surface above a domain; model units.
using DomainSurface = std::function<Eigen::Vector3d(const Eigen::Vector2d&)>;

/// A curve in space, over [0, 1]; model units.
using SpaceCurve = std::function<Eigen::Vector3d(double)>;

}  // namespace isopatch::segmentation
