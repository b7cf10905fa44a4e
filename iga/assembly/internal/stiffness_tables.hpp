#pragma once

#include <array>
#include <vector>

#include "iga/assembly/internal/direction_overlap.hpp"
#include "iga/internal/small_products.hpp"
#include "iga/spaces/element_tables.hpp"
#include "iga/spaces/patch_space.hpp"
#include "iga/spaces/quadrature_geometry.hpp"

namespace isopatch::iga {

/// One-dimensional products of values and derivatives, in the order in which the contractions want them.
///
/// Direction w goes first and leaves nine kinds of sums 3 s + t: s says whether function a is still to be
/// differentiated along u (1) or along v (2) or not at all (0), t the same of function b. Direction u leaves
/// four kinds: neither still to be differentiated along v, only b, only a, both.
struct StiffnessTables {
  std::array<int, 3> sizes;  ///< functions
  std::array<int, 3> degrees;
  std::array<int, 3> points;              ///< per element
  std::array<std::vector<int>, 3> first;  ///< function of each element
  std::array<std::vector<Overlap>, 3> overlaps;
  int first_layer = 0;  ///< elements of w that are integrated
  int last_layer = 0;
  int most_elements = 0;  ///< in the support of a function of u

  /// Factors of u for element e: [function a][term][function b]; terms of one kind of result together.
  std::vector<std::vector<double>> factors_u;
  /// Which sums a term takes: point of the element and kind.
  struct Term {
    int point;
    int kind;
  };
  std::vector<Term> terms_u;
  std::array<int, 5> kind_begin_u;  ///< terms of each kind of result
  /// Factors of v for element e: [kind and point][function a and function b].
  std::vector<std::vector<double>> factors_v;
  /// Values and derivatives of each function of w at the points of its support, in turns.
  std::vector<std::vector<double>> factors_w;

  StiffnessTables(const PatchSpace& space, const PatchLayers& part, const QuadratureGeometry& geometry);
  int elements(int d) const { return static_cast<int>(first[static_cast<std::size_t>(d)].size()); }
  const Overlap& overlap(int d, int function) const {
    return overlaps[static_cast<std::size_t>(d)][static_cast<std::size_t>(function)];
  }
};

}  // namespace isopatch::iga
