#pragma once

#include <array>
#include <optional>

#include "geometry/jacobian_certificate.hpp"
#include "geometry/measures.hpp"
#include "segmentation/parameterization/internal/complex_fit.hpp"
#include "segmentation/parameterization/internal/shape_optimization.hpp"
#include "segmentation/parameterization/parameterization_report.hpp"

namespace isopatch::segmentation {

/// Whether the map of a patch is regular, and how well shaped it is.
struct PatchValidity {
  geometry::JacobianCertificate certificate;
  geometry::Quality quality;
  std::optional<FoldedEdge> folded_edge;

  /// Certified before not certified, then by the smallest scaled Jacobian.
  bool better_than(const PatchValidity& other) const;
};
PatchValidity validity(const geometry::NurbsVolume& patch);

/// A patch with its validity, and what it cost.
struct ImprovedPatch {
  geometry::NurbsVolume patch;
  PatchValidity validity;
  int evaluations = 0;
};

/// Moves a patch's inner control points until it is certified and as good as `wanted_quality`, if that can
/// be.
///
/// Where the certificate still finds a fold between the sampled points, the optimization is repeated with a
/// sample there.
/// @return the better of the given and the found patch; all its weights and its six faces as given, to the
/// last bit
ImprovedPatch improve_interior(const geometry::NurbsVolume& patch, double wanted_quality,
                               const OptimizationOptions& options);

/// The patches of a complex.
struct BlockPatches {
  std::vector<geometry::NurbsVolume> patches;
  std::vector<PatchValidity> validities;
  int evaluations = 0;
};

/// Lets the inner parameters of the faces of poor blocks slide on their surfaces, together with the
/// interiors of the blocks at them. Maps of faces, the fit and the patches change; surfaces and edges stay,
/// and so do curved faces that are made of their edges.
///
/// @param poor_blocks  blocks whose faces slide
/// @return whether any block became better; everything is as before otherwise
bool slide_faces(HexComplex& complex, ComplexFit& fit, BlockPatches& blocks,
                 const std::vector<BlockId>& poor_blocks, double wanted_quality,
                 const OptimizationOptions& options);

}  // namespace isopatch::segmentation
