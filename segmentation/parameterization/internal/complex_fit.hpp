#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

#include "geometry/splines/nurbs.hpp"
#include "segmentation/parameterization/deviation_grid.hpp"
#include "segmentation/parameterization/fit_options.hpp"
#include "segmentation/parameterization/internal/hex_complex.hpp"
#include "segmentation/parameterization/internal/rational_net.hpp"
#include "segmentation/parameterization/internal/spline_fit.hpp"

namespace isopatch::segmentation {

/// Edges and faces of a complex as splines, each once: neighbours share their control points.
struct ComplexFit {
  std::vector<KnotVector> sheets;   ///< knots on [0, 1], by sheet, in its direction
  std::vector<RationalNet> edges;   ///< in the direction of the complex' edge
  std::vector<RationalNet> faces;   ///< in the frame of the complex' face
  std::vector<bool> made_of_edges;  ///< faces whose nets come of their edges, without a fit (`exact_face`)
  bool has_fair_weights = true;     ///< of all faces; the fit is given up otherwise
  std::vector<double> edge_gap;     ///< how far a face's own curve along the edge is from the samples at the
                                    ///< same share of arc length, at most
  std::vector<double> face_deviation;  ///< largest distance from points of the surface and from the edges
  std::vector<double>
      off_edges;  ///< of what its sides aim at from the edges in space, where blocks know them
  std::vector<DeviationGrid> face_deviations;  ///< all of them, in the frame of the complex' face
  std::vector<int> most_spans;                 ///< by sheet, that knot insertion may make
  double tolerance = 0;                        ///< model units
  int rounds = 0;                              ///< of knot insertion
};

/// Fits edges, then faces that keep their edges, and halves knot spans until the deviation is below the
/// tolerance.
///
/// Edges that are arcs are taken as they are, with their weights; so are faces that come of their edges
/// alone. Other faces at such edges are fitted with the weights that the blend of their edges gives. Where
/// trimming curves of two faces disagree, the edge is put where their surfaces meet; where these do not meet
/// either, half way, and the difference is blended over the face.
/// @cost O(rounds * faces * samples), some hundred samples a span of a face
ComplexFit fit(const HexComplex& complex, const FitOptions& options);

/// Fits one face anew, with its edges and knots as they are, after its map has changed.
void refit_face(const HexComplex& complex, ComplexFit& fit, std::size_t face);

KnotVector edge_knots(const HexComplex& complex, const ComplexFit& fit, std::size_t edge);
/// In the frame of the face.
std::array<KnotVector, 2> face_knots(const HexComplex& complex, const ComplexFit& fit, std::size_t face);
std::array<KnotVector, 3> block_knots(const HexComplex& complex, const ComplexFit& fit, BlockId block);

/// Where the points of a face's net lie in the net of the block that uses it.
std::vector<int> points_in_block(const HexComplex& complex, const ComplexFit& fit, const HexFaceUse& use);

/// The net of a block: faces as they are, the inside blended.
RationalNet block_net(const HexComplex& complex, const ComplexFit& fit, BlockId block);

}  // namespace isopatch::segmentation
