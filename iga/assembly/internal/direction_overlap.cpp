#include "iga/assembly/internal/direction_overlap.hpp"

namespace isopatch::iga {

std::vector<int> first_functions(const geometry::KnotVector& knots) {
  const std::vector<double> breaks = knots.breaks();
  std::vector<int> first;
  for (std::size_t e = 0; e + 1 < breaks.size(); ++e) first.push_back(knots.span(breaks[e]) - knots.degree());
  return first;
}

std::vector<Overlap> overlaps(const geometry::KnotVector& knots, int begin, int end) {
  const std::vector<int> first = first_functions(knots);
  std::vector<Overlap> result(static_cast<std::size_t>(knots.size()));
  for (int e = begin; e < end; ++e) {
    const int low = first[static_cast<std::size_t>(e)];
    const int high = low + knots.degree();
    for (int i = low; i <= high; ++i) {
      Overlap& overlap = result[static_cast<std::size_t>(i)];
      if (overlap.empty()) {
        overlap.low = low;
        overlap.first_element = e;
      }
      overlap.high = high;
      overlap.last_element = e;
    }
  }
  return result;
}

std::vector<Overlap> overlaps(const geometry::KnotVector& knots) {
  return overlaps(knots, 0, knots.element_count());
}

}  // namespace isopatch::iga
