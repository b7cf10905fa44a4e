#include "iga/spaces/element_sheets.hpp"

#include "geometry/base/union_find.hpp"
#include "iga/spaces/matching_spaces.hpp"

namespace isopatch::iga {

std::vector<ElementSheet> element_sheets(const Discretization& d, bool spread) {
  std::vector<ElementLayer> layers;
  std::vector<int> first;  // layer of each direction
  for (int patch = 0; patch < d.patch_count(); ++patch)
    for (int direction = 0; direction < 3; ++direction) {
      first.push_back(static_cast<int>(layers.size()));
      const int spans = d.patches[static_cast<std::size_t>(patch)].knots(direction).element_count();
      for (int span = 0; span < spans; ++span) layers.push_back({patch, direction, span});
    }
  first.push_back(static_cast<int>(layers.size()));
  UnionFind sheets(static_cast<int>(layers.size()));
  const std::vector<geometry::Interface> none;
  for (const geometry::Interface& interface : spread ? d.model.interfaces() : none)
    for (const TiedPair& pair : tied_pairs(interface)) {
      const int spans = first[pair.first + 1] - first[pair.first];
      for (int i = 0; i < spans; ++i)
        sheets.unite(first[pair.first] + i, first[pair.second] + (pair.flipped ? spans - 1 - i : i));
    }
  std::vector<ElementSheet> result;
  std::vector<std::size_t> sheet_of(layers.size());
  for (int i = 0; i < static_cast<int>(layers.size()); ++i) {
    const int smallest = sheets.find(i);
    auto& sheet = sheet_of[static_cast<std::size_t>(smallest)];
    if (smallest == i) {
      sheet = result.size();
      result.emplace_back();
    }
    result[sheet].push_back(layers[static_cast<std::size_t>(i)]);
  }
  return result;
}

}  // namespace isopatch::iga
