#pragma once

#include <Eigen/Core>
#include <array>
#include <functional>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "geometry/collapse.hpp"
#include "geometry/patch_face.hpp"
#include "iga/material/material.hpp"
#include "iga/problem/corners.hpp"
#include "iga/problem/patch_point.hpp"
#include "iga/problem/region.hpp"
#include "iga/problem/thermal_load.hpp"
#include "iga/spaces/discretization.hpp"

namespace isopatch::iga {

/// Components of the displacement prescribed on a face: u = value + gradient * x, absent components are free.
struct PrescribedDisplacement {
  std::array<std::optional<double>, 3> value = {0.0, 0.0, 0.0};  ///< m
  Eigen::Matrix3d gradient = Eigen::Matrix3d::Zero();            ///< dimensionless; exact for any patch
  bool operator==(const PrescribedDisplacement&) const = default;
};

/// u.n = normal_displacement on a plane face of any orientation: a symmetry plane, or a frictionless roller.
struct PlaneSupport {
  double normal_displacement = 0;  ///< m, along the outward normal
};

/// Faces about an axis that are held along the directions of cylinder coordinates: no displacement along
/// those that are true. Radial or tangential alone is held by springs ten thousand times as stiff as the
/// part, at as many points as the faces have functions (`springs_of`); all else exactly.
struct CylindricalSupport {
  Eigen::Vector3d point = Eigen::Vector3d::Zero();  ///< on the axis, m
  Eigen::Vector3d axis = Eigen::Vector3d::UnitZ();  ///< of any length
  bool radial = true;
  bool tangential = false;
  bool axial = false;
};

/// Springs between faces and what does not move, N/m^3: force per area and displacement.
struct ElasticSupport {
  double normal = 0;      ///< against displacement across the faces, both ways
  double tangential = 0;  ///< against displacement along them
  /// The stiffness where faces have a normal of length 1.
  Eigen::Matrix3d at(const Eigen::Vector3d& n) const {
    return tangential * Eigen::Matrix3d::Identity() + (normal - tangential) * n * n.transpose();
  }
  bool operator==(const ElasticSupport&) const = default;
};

/// Holds the rigid motions that all other supports leave to each body, by as many single conditions at
/// corners of patches: loads that balance find no resistance in them, and what does not balance is its
/// reaction.
struct FreeBodySupport {};

/// One edge of one patch, where a support holds a line.
struct SupportedEdge {
  PatchId patch;
  geometry::PatchEdge edge;
  auto operator<=>(const SupportedEdge&) const = default;
};

/// A support: prescribed displacements, or springs, on faces, edges or corners. Where supports meet, all of
/// them apply.
struct Support {
  std::string name;  ///< for messages and reports: "support 1 (clamped bore)"
  std::vector<geometry::PatchFace> faces;
  std::variant<PrescribedDisplacement, PlaneSupport, CylindricalSupport, ElasticSupport, FreeBodySupport>
      condition;
  /// Lines that are held, of any edges of patches, besides the faces; by a PrescribedDisplacement alone. In
  /// three dimensions a line gives way without limit as elements become small, so displacements and energy
  /// have no limit, while stresses away from the line have.
  std::vector<SupportedEdge> edges = {};
  std::vector<PatchCorner> corners = {};  ///< points that are held, with the same reservation as edges
  /// Where on the faces it holds, if not everywhere. Springs act exactly there; what is held rigidly are the
  /// functions whose Greville points lie there, so up to half an element at the rim.
  Region region = {};
  /// Points anywhere in the part that springs hold, as stiff as ten thousand times the part for each unit of
  /// weight; by a PrescribedDisplacement of 0 alone.
  std::vector<PatchPoint> points = {};
};

/// Traction on boundary faces as a function of place and outward unit normal, Pa.
struct SurfaceLoad {
  std::string name;
  std::vector<geometry::PatchFace> faces;
  std::function<Eigen::Vector3d(const Eigen::Vector3d& place, const Eigen::Vector3d& normal)> traction;
  Region region = {};  ///< where on the faces it acts
};
SurfaceLoad constant_traction(std::string name, std::vector<geometry::PatchFace> faces,
                              const Eigen::Vector3d& traction, const Region& region = {});
/// @param pressure  Pa, positive pushes against the face
SurfaceLoad pressure_load(std::string name, std::vector<geometry::PatchFace> faces, double pressure,
                          const Region& region = {});
/// A total force (N) spread evenly over the area of the faces, or of the part of them in a region.
/// @throws Error invalid_argument  no area there
SurfaceLoad total_force(std::string name, std::vector<geometry::PatchFace> faces,
                        const Eigen::Vector3d& force, const Discretization& discretization,
                        const Region& region = {});

/// Forces at points of the part, N: `weight` of each point is the share of the force. Displacements and
/// stresses there have no limit as elements become small.
struct PointLoad {
  std::string name;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
  std::vector<PatchPoint> points;  ///< whose weights add up to 1
};

/// Force per volume in patches, N/m^3.
struct VolumeLoad {
  std::string name;
  std::vector<PatchId> patches;
  /// May be called by several threads at once.
  std::function<Eigen::Vector3d(const Eigen::Vector3d& place)> force;
};
/// Weight of patches with the given acceleration (m/s^2); one load per patch, because densities differ.
/// @throws Error invalid_argument if a patch's material has no density
std::vector<VolumeLoad> gravity(const std::string& name, const std::vector<PatchId>& patches,
                                const Eigen::Vector3d& acceleration, const std::vector<Material>& materials);

/// Linear elasticity on a multi-patch model, SI units throughout.
struct ElasticityProblem {
  Discretization discretization;
  std::vector<Material> materials;  ///< one per patch
  std::vector<Support> supports;
  std::vector<SurfaceLoad> surface_loads;
  std::vector<VolumeLoad> volume_loads;
  std::vector<TemperatureLoad> temperatures = {};
  std::vector<PointLoad> point_loads = {};
};

}  // namespace isopatch::iga
