#pragma once

#include <vector>

#include "geometry/splines/knot_vector.hpp"

namespace isopatch::iga {

/// With which functions of one direction a function shares an element, among some of the elements.
struct Overlap {
  int low = 0;            ///< first function
  int high = -1;          ///< last function; -1 if none of the elements carries the function itself
  int first_element = 0;  ///< of its support
  int last_element = -1;

  int count() const { return high - low + 1; }
  bool empty() const { return high < low; }
};

/// First function of every element.
std::vector<int> first_functions(const geometry::KnotVector& knots);

/// The overlaps of all functions, over the elements begin .. end - 1.
std::vector<Overlap> overlaps(const geometry::KnotVector& knots, int begin, int end);
/// The same over all elements.
std::vector<Overlap> overlaps(const geometry::KnotVector& knots);

}  // namespace isopatch::iga
