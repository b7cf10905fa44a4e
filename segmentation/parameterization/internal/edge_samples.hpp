#pragma once

#include <Eigen/Core>
#include <vector>

#include "segmentation/parameterization/internal/hex_complex.hpp"

namespace isopatch::segmentation {

/// Shares of a way as its other end has them: 1 - x.
std::vector<double> turned(std::vector<double> shares);

/// A surface near a point, with a parameter to start from.
struct NearSurface {
  const FaceMap* map = nullptr;
  Eigen::Vector2d start;
};

/// The parameter of the surface's point nearest to a point, by Gauss and Newton from a start near it; not
/// held within the face's outline.
Eigen::Vector2d project(const FaceMap& map, const Eigen::Vector3d& point, const Eigen::Vector2d& start);

/// A point on all of several surfaces, near one that is on all of them up to a gap: projected on one after
/// the other, so that outlines that disagree along their surfaces do no harm.
struct CommonPoint {
  Eigen::Vector3d point;  ///< between the surfaces where they do not meet
  double miss = 0;        ///< largest distance of a surface from it, model units
};
CommonPoint common_point(const Eigen::Vector3d& near, std::vector<NearSurface> surfaces, double size);

/// Where an edge of a complex is at shares of its length: where the surfaces around it meet, or else in the
/// mean of the outlines of its faces.
struct EdgeSamples {
  Eigen::Matrix3Xd points;  ///< (3, shares); vertices at 0 and 1
  double gap =
      0;  ///< how far a face's own curve is from them at the same share of arc length, at most; model units
};
EdgeSamples sample_edge(const HexComplex& complex, std::size_t edge, const std::vector<double>& shares);

/// Puts the vertices of a complex on all surfaces around them and finds out along which edges surfaces meet.
void locate_vertices(HexComplex& complex);

}  // namespace isopatch::segmentation
