#pragma once

#include <vector>

#include "geometry/brep/module.hpp"
#include "geometry/brep/opencascade/internal/shape_kernel.hpp"

namespace isopatch::geometry {

/// A shell's faces as a solid with outward normals; a shell if it is open.
///
/// Turns faces around so that neighbours agree, and all if the volume is negative.
/// @param faces  in the order of their ids; edges shared
ShapeInput oriented_solid(std::vector<TopoDS_Face> faces, double metres);

/// A power of two that brings a size in metres to about 100, where OpenCASCADE's tolerances are at home.
/// Multiplying by it is exact.
double kernel_scale(double size);

KernelSolid sewn_solid(const std::vector<TrimmedSurface>& faces, const SewOptions& options);
std::vector<TrimmedSurface> surfaces_of(const ShapeKernel& kernel);
KernelSolid polyhedral_solid(const Polyhedron& polyhedron, const SewOptions& options);
/// As of BrepModule.
KernelSolid solid_with_carriers(const ShapeKernel& kernel, double tolerance);
KernelSolid solid_on_carriers(const CarrierSolid& solid, double tolerance);
std::vector<KernelSolid> solids_of_cells(const ShapeKernel& source, const CellComplex& complex,
                                         const std::vector<CellId>& cells);
/// As `overlay`.
KernelOverlay overlay_of(const ShapeKernel& source, const std::vector<FaceId>& faces,
                         const Eigen::Vector3d& origin, const Eigen::Vector3d& direction,
                         const Redrawn& redrawn, const std::vector<std::array<Eigen::Vector3d, 2>>& lines);
/// As `cut_by_plane`.
std::vector<KernelPart> parts_cut_by_plane(const ShapeKernel& source, const Eigen::Vector3d& point,
                                           const Eigen::Vector3d& normal);
/// As `without_faces`; what comes of it is to be checked.
KernelSolid solid_without_faces(const ShapeKernel& source, const std::vector<FaceId>& faces);
/// As `with_flat_tips`; what comes of it is to be checked.
KernelSolid solid_with_flat_tips(const ShapeKernel& source, const std::vector<DrillTip>& tips, double share);

}  // namespace isopatch::geometry
