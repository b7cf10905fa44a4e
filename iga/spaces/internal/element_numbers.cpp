#include "iga/spaces/internal/element_numbers.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/base/error.hpp"

namespace isopatch::iga {

void share_along_interfaces(const geometry::MultiPatch& model, std::vector<ElementNumbers>& all) {
  bool changed = true;
  while (changed) {
    changed = false;
    for (const geometry::Interface& interface : model.interfaces())
      for (std::size_t a = 0; a < 2; ++a) {
        const std::size_t b = interface.orientation.swapped ? 1 - a : a;
        const bool flip = b == 0 ? interface.orientation.flip_first : interface.orientation.flip_second;
        const auto side = [&](const geometry::PatchFace& face, std::size_t tangent) -> std::vector<double>& {
          return all[static_cast<std::size_t>(face.patch.value)]
                    [static_cast<std::size_t>(tangents(face.side)[tangent])];
        };
        std::vector<double>& first = side(interface.first, a);
        std::vector<double>& second = side(interface.second, b);
        if (first.size() != second.size())
          throw Error(
              ErrorCode::not_conforming,
              fmt::format(
                  "{} and {} have {} and {} elements along their interface; discretize the model first",
                  model.label(interface.first), model.label(interface.second), first.size(), second.size()));
        for (std::size_t e = 0; e < first.size(); ++e) {
          double& other = second[flip ? second.size() - 1 - e : e];
          if (first[e] == other) continue;
          first[e] = other = std::max(first[e], other);
          changed = true;
        }
      }
  }
}

}  // namespace isopatch::iga
