#pragma once

#include "geometry/base/progress.hpp"
#include "geometry/mesh/triangle_mesh.hpp"
#include "segmentation/reconstruction/internal/facets.hpp"
#include "segmentation/reconstruction/reconstruction_options.hpp"
#include "segmentation/reconstruction/regions.hpp"

namespace isopatch::segmentation {

/// Regions by the surfaces that their vertices lie on.
/// @param tolerance  m
Regions carrier_regions(const geometry::TriangleMesh& mesh, const Facets& facets, double tolerance,
                        const ReconstructionOptions& options, const Progress& progress = {});

}  // namespace isopatch::segmentation
