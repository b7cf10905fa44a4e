#pragma once

#include <compare>
#include <functional>

namespace isopatch {

/// An index that cannot be mistaken for another kind of index. Counts from 0.
template <class Tag>
struct Id {
  int value = -1;
  constexpr Id() = default;
  constexpr explicit Id(int index) : value(index) {}
  constexpr auto operator<=>(const Id&) const = default;
};

using PatchId = Id<struct PatchTag>;
/// Of a solid's boundary: `geometry::Brep` and `geometry::EdgeGraph`.
using FaceId = Id<struct FaceTag>;
using EdgeId = Id<struct EdgeTag>;
using VertexId = Id<struct VertexTag>;

}  // namespace isopatch

template <class Tag>
struct std::hash<isopatch::Id<Tag>> {
  std::size_t operator()(const isopatch::Id<Tag>& id) const noexcept { return std::hash<int>()(id.value); }
};
