#pragma once

#include <map>
#include <string>
#include <vector>

#include "geometry/base/progress.hpp"
#include "geometry/brep/brep.hpp"
#include "geometry/mesh/triangle_mesh.hpp"
#include "segmentation/reconstruction/reconstruction_options.hpp"
#include "segmentation/reconstruction/regions.hpp"
#include "segmentation/reconstruction/regularity.hpp"

namespace isopatch::segmentation {

/// How near the solid is to the triangles.
struct ReconstructionReport {
  double tolerance = 0;              ///< m, that vertices had to be on their surfaces by
  double largest_deviation = 0;      ///< m, of a vertex from its surface
  double mean_deviation = 0;         ///< m, root of the mean square
  double mesh_volume = 0;            ///< m^3
  double expected_volume = 0;        ///< m^3, the mesh's and what lies between its triangles and the surfaces
  double volume = 0;                 ///< m^3, of the solid
  std::vector<std::string> remarks;  ///< sentences: what was mended, what is doubtful
  Regularity regularity;             ///< what was made parallel, coaxial, equal
  double seconds = 0;                ///< of the processor
};

struct Reconstruction {
  geometry::Brep brep;          ///< face i is region i; "plane_1", "cylinder_2", ..., in the order of area
  geometry::TriangleMesh mesh;  ///< mended
  Regions regions;              ///< of it
  ReconstructionReport report;
};

/// The solid that triangles were made of: vertices lie on its surfaces, edges are where these meet.
/// @param mesh  in m; vertices may be repeated
/// @throws Error not_manifold, bad_format  as of `geometry::mended`
/// @throws Error unsupported  a part of the surface is no plane, cylinder, cone, sphere or torus: named with
/// its place; surfaces that do not meet along the mesh's edges
/// @throws Error unsupported  it would take longer than `time_limit`
/// @throws Error invalid_argument  options out of range
/// @cost  O(T log T)
Reconstruction reconstruct(const geometry::TriangleMesh& mesh, const ReconstructionOptions& options = {},
                           const Progress& progress = {});

/// The regions alone, in the order of area; of a mesh as `geometry::mended` returns it.
Regions find_regions(const geometry::TriangleMesh& mesh, const ReconstructionOptions& options = {},
                     const Progress& progress = {});

/// "9 planes, 2 cylinders, 1 freeform surface".
std::string kinds_text(const Regions& regions);

}  // namespace isopatch::segmentation
