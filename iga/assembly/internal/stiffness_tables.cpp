#include "iga/assembly/internal/stiffness_tables.hpp"

#include <algorithm>

namespace isopatch::iga {
namespace {

double factor(const DirectionTable::Element& element, int point, int function, bool derivative) {
  return derivative ? element.derivatives(point, function) : element.values(point, function);
}

// Kinds of sums after w, by the kind of result of u; see StiffnessTables.
constexpr std::array<std::array<int, 4>, 4> sums_of_kind = {
    {{0, 1, 3, 4}, {2, 5, -1, -1}, {6, 7, -1, -1}, {8, -1, -1, -1}}};

}  // namespace

StiffnessTables::StiffnessTables(const PatchSpace& space, const PatchLayers& part,
                                 const QuadratureGeometry& geometry)
    : sizes(space.sizes()), first_layer(part.first_layer), last_layer(part.last_layer) {
  for (int d = 0; d < 3; ++d) {
    const auto k = static_cast<std::size_t>(d);
    degrees[k] = space.knots[k].degree();
    points[k] = geometry.points_per_element(d);
    first[k] = first_functions(space.knots[k]);
    overlaps[k] =
        d == 2 ? iga::overlaps(space.knots[k], first_layer, last_layer) : iga::overlaps(space.knots[k]);
  }
  for (const Overlap& overlap : overlaps[0])
    most_elements = std::max(most_elements, overlap.last_element - overlap.first_element + 1);

  for (std::size_t kind = 0; kind < 4; ++kind) {
    kind_begin_u[kind] = static_cast<int>(terms_u.size());
    for (int point = 0; point < points[0]; ++point)
      for (const int sum : sums_of_kind[kind])
        if (sum >= 0) terms_u.push_back({point, sum});
  }
  kind_begin_u[4] = static_cast<int>(terms_u.size());
  for (const DirectionTable::Element& element : geometry.table(0).elements) {
    std::vector<double>& factors = factors_u.emplace_back();
    for (int a = 0; a <= degrees[0]; ++a)
      for (const auto& [point, kind] : terms_u)
        for (int b = 0; b <= degrees[0]; ++b)
          factors.push_back(factor(element, point, a, kind / 3 == 1) *
                            factor(element, point, b, kind % 3 == 1));
  }
  for (const DirectionTable::Element& element : geometry.table(1).elements) {
    std::vector<double>& factors = factors_v.emplace_back();
    for (int kind = 0; kind < 4; ++kind)
      for (int point = 0; point < points[1]; ++point)
        for (int a = 0; a <= degrees[1]; ++a)
          for (int b = 0; b <= degrees[1]; ++b)
            factors.push_back(factor(element, point, a, kind >= 2) *
                              factor(element, point, b, kind % 2 == 1));
  }
  for (int function = 0; function < sizes[2]; ++function) {
    std::vector<double>& factors = factors_w.emplace_back();
    const Overlap& overlap = overlaps[2][static_cast<std::size_t>(function)];
    for (int e = overlap.first_element; e <= overlap.last_element; ++e) {
      const DirectionTable::Element& element = geometry.table(2).elements[static_cast<std::size_t>(e)];
      for (int point = 0; point < points[2]; ++point)
        for (const bool derivative : {false, true})
          factors.push_back(factor(element, point, function - element.first, derivative));
    }
  }
}

}  // namespace isopatch::iga
