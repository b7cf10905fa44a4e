#include "iga/multigrid/tensor_blocks.hpp"

#include <algorithm>
#include <set>

namespace isopatch::iga {
namespace {

using geometry::PatchFace;

// Sides that belong to several patches or meet others, or have collapsed.
std::set<PatchFace> inner_faces(const geometry::MultiPatch& model) {
  std::set<PatchFace> faces(model.degenerate_faces().begin(), model.degenerate_faces().end());
  for (const geometry::Interface& interface : model.interfaces()) {
    faces.insert(interface.first);
    faces.insert(interface.second);
  }
  for (const geometry::NonMatchingInterface& interface : model.non_matching()) {
    faces.insert(interface.first);
    faces.insert(interface.second);
  }
  return faces;
}

// Low end, middle and high end of one direction; the ends by themselves only where they are inner faces.
std::vector<std::array<int, 2>> ranges(const std::set<PatchFace>& inner, int patch, int direction,
                                       int count) {
  const auto is_inner = [&](bool high) {
    return inner.contains({PatchId(patch), geometry::side_of(direction, high)});
  };
  std::vector<std::array<int, 2>> result;
  const int begin = is_inner(false) ? 1 : 0;
  const int end = is_inner(true) ? count - 1 : count;
  if (begin < end) result.push_back({begin, end});
  if (begin > 0) result.push_back({0, 1});
  if (end < count) result.push_back({count - 1, count});
  return result;
}

}  // namespace

std::vector<int> nodes_of(const Level& level, const TensorBlock& block) {
  const auto p = static_cast<std::size_t>(block.patch);
  const auto sizes = level.spaces[p].sizes();
  std::vector<int> nodes;
  nodes.reserve(static_cast<std::size_t>(block.size()));
  for (int k = block.low[2]; k < block.high[2]; ++k)
    for (int j = block.low[1]; j < block.high[1]; ++j)
      for (int i = block.low[0]; i < block.high[0]; ++i)
        nodes.push_back(level.first_node[p] + i + sizes[0] * (j + sizes[1] * k));
  return nodes;
}

std::vector<TensorBlock> tensor_blocks(const geometry::MultiPatch& model, const Level& level,
                                       const std::vector<PatchFace>& apart, std::vector<char>& taken) {
  std::set<PatchFace> inner = inner_faces(model);
  inner.insert(apart.begin(), apart.end());
  std::vector<TensorBlock> blocks;
  for (int p = 0; p < model.patch_count(); ++p) {
    const auto sizes = level.spaces[static_cast<std::size_t>(p)].sizes();
    for (const auto& z : ranges(inner, p, 2, sizes[2]))
      for (const auto& y : ranges(inner, p, 1, sizes[1]))
        for (const auto& x : ranges(inner, p, 0, sizes[0])) {
          const TensorBlock block{p, {x[0], y[0], z[0]}, {x[1], y[1], z[1]}};
          if (block.size() < 2) continue;
          std::vector<std::size_t> global;
          for (const int node : nodes_of(level, block))
            global.push_back(static_cast<std::size_t>(level.global_of[static_cast<std::size_t>(node)]));
          std::vector<std::size_t> sorted = global;
          std::sort(sorted.begin(), sorted.end());
          const bool repeats = std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
          if (repeats || std::any_of(global.begin(), global.end(), [&](std::size_t c) { return taken[c]; }))
            continue;
          for (const std::size_t c : global) taken[c] = 1;
          blocks.push_back(block);
        }
  }
  return blocks;
}

}  // namespace isopatch::iga
