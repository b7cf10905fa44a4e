#pragma once

#include <array>
#include <optional>

#include "geometry/jacobian_certificate.hpp"
#include "geometry/measures.hpp"
#include "segmentation/parameterization/internal/complex_fit.hpp"
#include "segmentation/parameterization/internal/shape_optimization.hpp"
#include "segmentation/parameterization/parameterization_report.hpp"

namespace isopatch::segmentation {

/// How healthy a patch is.
struct Health {
  geometry::JacobianCertificate certificate;
  geometry::Quality quality;
  std::optional<HopelessPlace> hopeless;

  /// Certified before not certified, then by the smallest scaled Jacobian.
  bool better_than(const Health& other) const;
};
Health health(const std::array<KnotVector, 3>& knots, const Eigen::Matrix3Xd& net);

/// Control points with their health, and what they cost.
struct ImprovedNet {
  Eigen::Matrix3Xd net;
  Health health;
  int evaluations = 0;
};

/// Moves a patch's inner control points until it is certified and as good as `wanted_quality`, if that can
/// be.
///
/// Where the certificate still finds a fold between the points looked at, it is done again with a look there.
/// @return the better of the given and the found net; its six faces as given, to the last bit
ImprovedNet improve_interior(const std::array<KnotVector, 3>& knots, const Eigen::Matrix3Xd& net,
                             double wanted_quality, const OptimizationOptions& options);

/// A complex with the nets of its blocks.
struct BlockNets {
  std::vector<Eigen::Matrix3Xd> nets;
  std::vector<Health> healths;
  int evaluations = 0;
};

/// Lets the inner parameters of the faces of unhealthy blocks slide on their surfaces, together with the
/// interiors of the blocks at them. Maps of faces, the fit and the nets change; surfaces and edges stay.
///
/// @param unhealthy  blocks whose faces slide
/// @return whether any block became better; everything is as before otherwise
bool slide_faces(HexComplex& complex, ComplexFit& fit, BlockNets& blocks,
                 const std::vector<BlockId>& unhealthy, double wanted_quality,
                 const OptimizationOptions& options);

}  // namespace isopatch::segmentation
