#pragma once

#include <Eigen/Core>
#include <functional>
#include <vector>

#include "iga/problem/problem.hpp"
#include "iga/problem/sprung_point.hpp"

namespace isopatch::iga {

/// A face on springs: their force per area is minus the stiffness times the displacement.
struct SprungFace {
  geometry::PatchFace face;
  /// Symmetric, not negative, N/m^3; of a place and the outward normal there.
  std::function<Eigen::Matrix3d(const Eigen::Vector3d& place, const Eigen::Vector3d& normal)> stiffness;
  /// Whether the springs stand for a rigid hold: they act at one point for each function of the face (its
  /// Greville point) and not everywhere, or more conditions than functions would lock the face.
  bool is_hold = false;
};

/// The springs of a problem, on faces and at points.
struct Springs {
  std::vector<SprungFace> faces = {};
  std::vector<SprungPoint> points = {};

  bool empty() const { return faces.empty() && points.empty(); }
};

/// The springs of one support: those of an elastic one, and of a cylindrical one that holds the radial
/// or the tangential direction alone. For its springs stand for a hold, because its direction turns along the
/// face: coefficients held along directions of their own leave an error like the square of the elements' size
/// that is four percent of the energy where sixteen elements go around. They are ten thousand times as stiff
/// as the part, so that what they give way is some 2e-4 of its energy; faces held so are factorized blocks of
/// the multigrid's smoother, without which it needs ten times as many iterations.
///
/// In a region (`Support::region`) springs act where the part of the faces is; what holds rigidly there does
/// so at Greville points, without springs unless it has them anyway.
///
/// Points of a support (`Support::points`) are held by springs ten thousand times as stiff as the part.
///
/// @throws Error invalid_argument  a stiffness that is negative or not finite; points that are to be
///     moved by springs; a region without area on the faces
Springs springs_of(const ElasticityProblem& problem, const Support& support);
/// Those of all supports.
Springs springs_of(const ElasticityProblem& problem);

/// The faces among them that stand for holds; the other springs; all of them with holds everywhere on their
/// faces instead of at points.
Springs holds_among(const Springs& springs);
Springs without_holds(Springs springs);
Springs held_everywhere(Springs springs);

/// Whether a cylindrical support needs springs.
bool is_sprung(const CylindricalSupport& support);

}  // namespace isopatch::iga
