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

/// One edge of one patch, where a support holds a line.
struct SupportedEdge {
  PatchId patch;
  geometry::PatchEdge edge;
  auto operator<=>(const SupportedEdge&) const = default;
};

/// A support: prescribed displacements on faces or edges. Where supports meet, all of them apply.
struct Support {
  std::string name;  ///< for messages and reports: "support 1 (clamped bore)"
  std::vector<geometry::PatchFace> faces;
  std::variant<PrescribedDisplacement, PlaneSupport> condition;
  /// Lines that are held, of any edges of patches, besides the faces; not by a PlaneSupport. In three
  /// dimensions a line gives way without limit as elements become small, so displacements and energy have no
  /// limit, while stresses away from the line have.
  std::vector<SupportedEdge> edges = {};
};

/// Traction on boundary faces as a function of place and outward unit normal, Pa.
struct SurfaceLoad {
  std::string name;
  std::vector<geometry::PatchFace> faces;
  std::function<Eigen::Vector3d(const Eigen::Vector3d& place, const Eigen::Vector3d& normal)> traction;
};
SurfaceLoad constant_traction(std::string name, std::vector<geometry::PatchFace> faces,
                              const Eigen::Vector3d& traction);
/// @param pressure  Pa, positive pushes against the face
SurfaceLoad pressure_load(std::string name, std::vector<geometry::PatchFace> faces, double pressure);
/// A total force (N) spread evenly over the faces' area.
SurfaceLoad total_force(std::string name, std::vector<geometry::PatchFace> faces,
                        const Eigen::Vector3d& force, const Discretization& discretization);

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
};

}  // namespace isopatch::iga
