#pragma once

#include "iga/internal/lanes.hpp"
#include "iga/material/material.hpp"

namespace isopatch::iga {

/// Addresses of some fields and their derivatives at the Gauss points of a line in direction 2: component c
/// of a derivative is `derivatives[d][c]`, at the next point `step` further on.
struct LineFields {
  const Lanes* values = nullptr;  ///< only if rational
  const Lanes* derivatives[3] = {nullptr, nullptr, nullptr};
  int step = 0;
};

/// Which of functions and geometry are rational, so that their denominators enter.
enum class Denominators {
  none,       ///< functions and geometry are polynomial
  geometry,   ///< of the geometry only
  functions,  ///< of the functions only
  both,       ///< two different ones
  shared,     ///< functions and geometry have the same
};

/// Everything at the points of one line in direction 2. A, X are numerators, W denominators: u = A / Wf,
/// x = X / Wg.
struct PointLine {
  LineFields displacement;     ///< A
  LineFields places;           ///< X
  LineFields function_weight;  ///< Wf
  LineFields geometry_weight;  ///< Wg
  const Lanes* weights1;       ///< quadrature weights of the eight lanes, 0 for a lane that repeats a point
  const double* weights2;      ///< of the points of the line
  double weight3;
  int points;
};

/// What the map of the geometry does to forces at a point, whatever is displaced there.
struct PointMap {
  Lanes cofactors[3][3];  ///< [direction][coordinate], of dX - x dWg
  Lanes scale;            ///< quadrature weight over D Wg Wf^2
  Lanes ratio[3];         ///< dWf / Wf of each direction; only if the functions are rational
};

/// The weak form at the points: K u tested with a function N is the sum over the points of sigma(u) grad N
/// det J times the quadrature weight, and this computes what multiplies dB/dxi_1, dB/dxi_3, dB/dxi_2 in it
/// (three vectors each), B being the numerator of N; before them what multiplies B itself if the functions
/// are rational.
///
/// With C the cofactors and D the determinant of dX - x dWg, the gradient of the displacement is
/// (dA - u dWf) C Wg / (Wf D), and det J = D / Wg^3.
/// @return  smallest D of each lane
template <Denominators denominators>
Lanes forces_at_points(const PointLine& line, const Material& material, Lanes* out);

/// The same in two steps, of which the first serves any number of displacements.
/// @param maps  one for each point
/// @return  smallest D of each lane
template <Denominators denominators>
Lanes maps_at_points(const PointLine& line, PointMap* maps);
/// @param rational      whether the functions are
/// @param displacement  of the first of `count`; those of the next are three vectors further on
/// @param out           the vectors of all are side by side: three of each for each derivative
template <bool rational>
void forces_with_maps(const LineFields& displacement, int count, const PointMap* maps, int points,
                      const Material& material, Lanes* out);

/// The same for the diagonal blocks, products of the derivatives of one function: for each of the
/// square_kinds (0 is B itself) the entries 00, 11, 22, 01, 02, 12 of the integral of grad N grad N^T.
template <Denominators denominators>
Lanes squares_at_points(const PointLine& line, Lanes* out);

}  // namespace isopatch::iga
