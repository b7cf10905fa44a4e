#include "segmentation/sweeps/internal/merged_profile.hpp"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/base/union_find.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::EdgeUse;
using Loop = std::vector<EdgeUse>;

int number_of(const std::vector<int>& sorted, int value) {
  return static_cast<int>(std::lower_bound(sorted.begin(), sorted.end(), value) - sorted.begin());
}

const ProfileEdge& edge_of(const Profile& profile, const EdgeUse& use) {
  return profile.edges[static_cast<std::size_t>(use.edge.value)];
}
int from(const Profile& profile, const EdgeUse& use) {
  return use.reversed ? edge_of(profile, use).end : edge_of(profile, use).start;
}
int to(const Profile& profile, const EdgeUse& use) {
  return use.reversed ? edge_of(profile, use).start : edge_of(profile, use).end;
}

/// Uses one after the other, as closed chains.
std::vector<Loop> chained(const Profile& profile, const Loop& uses) {
  std::vector<Loop> result;
  std::map<int, EdgeUse> next;
  for (const EdgeUse& use : uses) {
    if (edge_of(profile, use).start < 0)
      result.push_back({use});
    else if (!next.try_emplace(from(profile, use), use).second)
      throw Error(ErrorCode::unsupported, "outlines of its layers touch in a point");
  }
  while (!next.empty()) {
    Loop& loop = result.emplace_back();
    loop.push_back(next.begin()->second);
    next.erase(next.begin());
    for (auto on = next.find(to(profile, loop.back())); on != next.end();
         on = next.find(to(profile, loop.back()))) {
      loop.push_back(on->second);
      next.erase(on);
    }
  }
  return result;
}

}  // namespace

MergedProfile::MergedProfile(const Profile& whole, const std::vector<int>& groups) {
  UnionFind together(static_cast<int>(whole.regions.size()));
  std::map<EdgeId, int> beside;
  for (int r = 0; r < static_cast<int>(whole.regions.size()); ++r)
    for (const Loop& loop : whole.regions[static_cast<std::size_t>(r)].loops)
      for (const EdgeUse& use : loop) {
        const auto [other, fresh] = beside.try_emplace(use.edge, r);
        if (!fresh && groups[static_cast<std::size_t>(r)] == groups[static_cast<std::size_t>(other->second)])
          together.unite(r, other->second);
      }
  std::map<int, std::vector<int>> members;
  for (int r = 0; r < static_cast<int>(whole.regions.size()); ++r)
    if (groups[static_cast<std::size_t>(r)] >= 0) members[together.find(r)].push_back(r);
  for (const auto& [root, regions] : members) merge(whole, regions);
  number(whole);
}

/// What two of them have is no outline any more.
void MergedProfile::merge(const Profile& whole, const std::vector<int>& members) {
  std::map<EdgeId, Loop> uses;
  for (const int region : members)
    for (const Loop& loop : whole.regions[static_cast<std::size_t>(region)].loops)
      for (const EdgeUse& use : loop) uses[use.edge].push_back(use);
  Loop outline;
  for (const auto& [edge, found] : uses)
    if (found.size() == 1) outline.push_back(found.front());
  ProfileRegion region{chained(whole, outline), true};
  std::stable_sort(region.loops.begin(), region.loops.end(),
                   [&](const Loop& a, const Loop& b) { return twice_area(whole, a) > twice_area(whole, b); });
  regions_.push_back(std::move(region));
  members_.push_back(members);
}

void MergedProfile::number(const Profile& whole) {
  std::set<int> edges, vertices;
  for (const ProfileRegion& region : regions_)
    for (const Loop& loop : region.loops)
      for (const EdgeUse& use : loop) {
        edges.insert(use.edge.value);
        if (edge_of(whole, use).start >= 0) vertices.insert({from(whole, use), to(whole, use)});
      }
  edges_.assign(edges.begin(), edges.end());
  vertices_.assign(vertices.begin(), vertices.end());
  for (ProfileRegion& region : regions_)
    for (Loop& loop : region.loops)
      for (EdgeUse& use : loop) use.edge = EdgeId(number_of(edges_, use.edge.value));
}

Profile MergedProfile::reduced(const Profile& whole) const {
  Profile result;
  for (const int vertex : vertices_)
    result.vertices.push_back(whole.vertices[static_cast<std::size_t>(vertex)]);
  for (const int number : edges_) {
    ProfileEdge edge = whole.edges[static_cast<std::size_t>(number)];
    if (edge.start >= 0) {
      edge.start = number_of(vertices_, edge.start);
      edge.end = number_of(vertices_, edge.end);
    }
    result.edges.push_back(std::move(edge));
  }
  result.regions = regions_;
  return result;
}

Quadrangulation MergedProfile::expanded(Quadrangulation quads, const Profile& whole) const {
  const int known = static_cast<int>(vertices_.size()), all = static_cast<int>(whole.vertices.size());
  const auto vertex = [&](int v) {
    return v < known ? vertices_[static_cast<std::size_t>(v)] : v - known + all;
  };
  std::vector<Eigen::Vector2d> places = whole.vertices;
  for (std::size_t v = 0; v < quads.vertices.size(); ++v) {
    const int here = vertex(static_cast<int>(v));
    if (here < all)
      places[static_cast<std::size_t>(here)] = quads.vertices[v];
    else
      places.push_back(quads.vertices[v]);
  }
  quads.vertices = std::move(places);
  for (QuadEdge& edge : quads.edges) {
    edge.start = vertex(edge.start);
    edge.end = vertex(edge.end);
    if (edge.profile_edge >= 0) edge.profile_edge = edges_[static_cast<std::size_t>(edge.profile_edge)];
  }
  for (Quad& quad : quads.quads) quad.region = members_[static_cast<std::size_t>(quad.region)].front();
  return quads;
}

}  // namespace isopatch::segmentation
