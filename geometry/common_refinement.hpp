#pragma once

#include <array>
#include <vector>

#include "geometry/divided_surface.hpp"
#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry {

/// A quadrature point of the surface that two faces share.
struct SharedPoint {
  Parameter<2> first;
  Parameter<2> second;
  double weight = 0;  ///< with the area, model units^2
};

/// Where one element of a face lies on one element of another.
struct SharedCell {
  std::array<int, 2> first = {0, 0};  ///< element of the first face, per direction
  std::array<int, 2> second = {0, 0};
  std::vector<SharedPoint> points;
};

/// The common refinement of two faces that are one surface where they overlap, as quadrature.
///
/// Elements of the face that lies within the other, or else of that with the smaller elements, are taken into
/// the other's parameters, where they are polygons (`element_outlines`), and clipped by its elements. Where
/// all lie within one element of the other each they have Gauss's points of their own parameters. Where their
/// edges are not straight there they get 16 to 64 segments a side: the cells still cover the overlap once,
/// but near cut lines up to a hundredth of an element's square is counted to the neighbouring element, whose
/// functions differ there by little.
/// @param points      Gauss points per direction of a cell that is a rectangle, or of each triangle of others
/// @param same_point  how far the faces may be apart, model units
/// @return  cells without area are left out
/// @cost    a few nearest points per element edge and one per quadrature point
std::vector<SharedCell> common_refinement(const DividedSurface& first, const DividedSurface& second,
                                          int points, double same_point);

/// What two faces share, and how well it is known.
struct SharedSurface {
  double area = 0;        ///< model units^2
  double area_error = 0;  ///< estimated: by how much a rule of one point less differs, model units^2
  /// The largest distance between the two, model units, but for a thousandth of the area: where curved
  /// outlines are taken for chords, points beside them are on one of the two alone.
  double gap = 0;
};

/// Integrates over what two faces share, each in its own elements, as integrals between patches do: with
/// three points more than the degree.
/// @param same_point  how far the faces may be apart, model units
/// @cost  twice that of the common refinement
SharedSurface shared_surface(const NurbsSurface& first, const NurbsSurface& second, double same_point);

}  // namespace isopatch::geometry
