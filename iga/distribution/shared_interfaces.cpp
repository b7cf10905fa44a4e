#include "iga/distribution/shared_interfaces.hpp"

#include <algorithm>
#include <map>

#include "geometry/base/union_find.hpp"
#include "geometry/patch_face.hpp"

namespace isopatch::iga {
namespace {

// The patches of each group of interfaces, increasing.
std::vector<std::vector<int>> groups_of_patches(const geometry::MultiPatch& model,
                                                const std::vector<PatchSpace>& spaces,
                                                const GlobalNodes& global) {
  const std::vector<int> first_node = first_nodes(spaces);
  UnionFind sets(static_cast<int>(spaces.size()));
  std::vector<int> patch_of_node(static_cast<std::size_t>(global.count()), -1);
  std::vector<bool> is_tied(spaces.size(), false);
  const auto add = [&](const geometry::PatchFace& face) {
    const auto p = static_cast<std::size_t>(face.patch.value);
    is_tied[p] = true;
    for (const int node : geometry::face_control_points(spaces[p].sizes(), face.side)) {
      const int c = global.global_of[static_cast<std::size_t>(first_node[p] + node)];
      int& patch = patch_of_node[static_cast<std::size_t>(c)];
      if (patch >= 0) sets.unite(patch, face.patch.value);
      patch = face.patch.value;
    }
  };
  for (const geometry::NonMatchingInterface& interface : model.non_matching()) {
    sets.unite(interface.first.patch.value, interface.second.patch.value);
    add(interface.first);
    add(interface.second);
  }
  std::map<int, std::vector<int>> groups;
  for (std::size_t p = 0; p < spaces.size(); ++p)
    if (is_tied[p]) groups[sets.find(static_cast<int>(p))].push_back(static_cast<int>(p));
  std::vector<std::vector<int>> result;
  for (auto& [first, patches] : groups) result.push_back(std::move(patches));
  return result;
}

// The process with most nodes of some patches; of several the lowest.
std::size_t nearest_process(const std::vector<int>& patches, const std::vector<PatchSpace>& spaces,
                            const Distribution& distribution) {
  std::vector<double> nodes(distribution.size(), 0);
  for (std::size_t process = 0; process < distribution.size(); ++process)
    for (const PatchShare& share : distribution[process])
      if (std::binary_search(patches.begin(), patches.end(), share.patch))
        nodes[process] += (share.end - share.begin) * spaces[static_cast<std::size_t>(share.patch)].size();
  return static_cast<std::size_t>(std::max_element(nodes.begin(), nodes.end()) - nodes.begin());
}

PatchShare& share_of(std::vector<PatchShare>& shares, int patch) {
  auto at = std::lower_bound(shares.begin(), shares.end(), patch,
                             [](const PatchShare& share, int p) { return share.patch < p; });
  if (at == shares.end() || at->patch != patch) at = shares.insert(at, {patch, 0, 0, false});
  return *at;
}

}  // namespace

void share_interfaces(const geometry::MultiPatch& model, const std::vector<PatchSpace>& spaces,
                      const GlobalNodes& global, Distribution& distribution) {
  if (distribution.size() == 1) return;
  for (std::vector<PatchShare>& shares : distribution)
    for (PatchShare& share : shares) share.couples = false;
  for (const std::vector<int>& patches : groups_of_patches(model, spaces, global)) {
    std::vector<PatchShare>& shares = distribution[nearest_process(patches, spaces, distribution)];
    for (const int patch : patches) share_of(shares, patch).couples = true;
  }
}

Distribution distribute(const geometry::MultiPatch& model, const std::vector<PatchSpace>& spaces,
                        const GlobalNodes& global, int processes) {
  Distribution result = distribute(spaces, processes);
  share_interfaces(model, spaces, global, result);
  return result;
}

}  // namespace isopatch::iga
