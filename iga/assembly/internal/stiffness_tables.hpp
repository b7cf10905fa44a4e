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
/// Direction 3 goes first and leaves nine kinds of sums 3 s + t: s says whether the first function's factor
/// is still to be left alone (0), differentiated along direction 1 (1) or along direction 2 (2), t the same
/// of the second function. Direction 1 leaves four kinds: both left alone, only the second to be
/// differentiated along direction 2, only the first, both.
struct StiffnessTables {
  std::array<int, 3> sizes;  ///< functions
  std::array<int, 3> degrees;
  std::array<int, 3> points;              ///< per element
  std::array<std::vector<int>, 3> first;  ///< function of each element
  std::array<std::vector<Overlap>, 3> overlaps;
  int first_layer = 0;  ///< elements of direction 3 that are integrated
  int last_layer = 0;
  int most_elements = 0;  ///< in the support of a function of direction 1

  /// Factors of direction 1 for element e: [function a][term][function b]; terms of one kind of result
  /// together.
  std::vector<std::vector<double>> first_factors;
  /// Which sums a term takes: point of the element and kind.
  struct Term {
    int point;
    int kind;
  };
  std::vector<Term> first_terms;
  std::array<int, 5> first_kind_begin;  ///< terms of each kind of result
  /// Factors of direction 2 for element e: [kind and point][function a and function b].
  std::vector<std::vector<double>> second_factors;
  /// Values and derivatives of each function of direction 3 at the points of its support, in turns.
  std::vector<std::vector<double>> third_factors;

  StiffnessTables(const PatchSpace& space, const PatchPart& part, const QuadratureGeometry& geometry);
  int elements(int d) const { return static_cast<int>(first[static_cast<std::size_t>(d)].size()); }
  const Overlap& overlap(int d, int function) const {
    return overlaps[static_cast<std::size_t>(d)][static_cast<std::size_t>(function)];
  }
};

}  // namespace isopatch::iga
