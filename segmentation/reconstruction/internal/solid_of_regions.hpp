#pragma once

#include "geometry/base/progress.hpp"
#include "geometry/brep/carrier_solid.hpp"
#include "geometry/mesh/mesh_neighbours.hpp"
#include "geometry/mesh/triangle_mesh.hpp"
#include "segmentation/reconstruction/regions.hpp"

namespace isopatch::segmentation {

/// Faces from regions, edges where their surfaces meet, vertices where more of them do. Axes of spheres may
/// be turned; regions without carriers get splines.
/// @param tolerance  of freeform edges from the mesh's vertices, m
/// @throws Error unsupported  as `add_seams` and `add_freeform_faces`
geometry::CarrierSolid solid_of_regions(const geometry::TriangleMesh& mesh,
                                        const geometry::MeshNeighbours& neighbours, Regions& regions,
                                        double tolerance, const Progress& progress = {});

/// "plane_1", "cylinder_2", ...: the kind and the number of the face among those of its kind.
std::vector<std::string> face_names(const Regions& regions);

}  // namespace isopatch::segmentation
