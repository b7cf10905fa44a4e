#include "segmentation/sweeps/internal/merged_profile.hpp"

#include <algorithm>
#include <cmath>
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

MergedProfile::MergedProfile(const Profile& whole, const std::vector<int>& groups, CollinearLines lines) {
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
  if (lines == CollinearLines::one)
    for (ProfileRegion& region : regions_)
      for (Loop& loop : region.loops) straighten(whole, loop);
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

/// Lines one after the other in one direction become one. Regions that touch are one, so nothing else ends
/// between them.
void MergedProfile::straighten(const Profile& whole, Loop& loop) {
  const auto direction = [&](const EdgeUse& use) -> Eigen::Vector2d {
    const auto at = [&](int vertex) { return whole.vertices[static_cast<std::size_t>(vertex)]; };
    return (at(to(whole, use)) - at(from(whole, use))).normalized();
  };
  const auto goes_on = [&](const EdgeUse& a, const EdgeUse& b) {
    if (edge_of(whole, a).points.size() != 2 || edge_of(whole, b).points.size() != 2) return false;
    const Eigen::Vector2d one = direction(a), other = direction(b);
    return one.dot(other) > 0 && std::abs(one[0] * other[1] - one[1] * other[0]) < 1e-9;
  };
  std::size_t corner = 0;
  while (corner < loop.size() && goes_on(loop[(corner + loop.size() - 1) % loop.size()], loop[corner]))
    ++corner;
  if (corner == loop.size()) return;
  std::rotate(loop.begin(), loop.begin() + static_cast<std::ptrdiff_t>(corner), loop.end());
  Loop result;
  for (std::size_t i = 0; i < loop.size();) {
    std::size_t last = i;
    while (last + 1 < loop.size() && goes_on(loop[last], loop[last + 1])) ++last;
    if (last == i) {
      result.push_back(loop[i]);
    } else {
      result.push_back({EdgeId(static_cast<int>(whole.edges.size() + lines_.size())), false});
      lines_.push_back({from(whole, loop[i]), to(whole, loop[last])});
    }
    i = last + 1;
  }
  loop = std::move(result);
}

/// Vertices of the whole profile; -1 of a closed edge.
std::array<int, 2> MergedProfile::ends(const Profile& whole, EdgeUse use) const {
  const auto e = static_cast<std::size_t>(use.edge.value);
  if (e >= whole.edges.size()) return lines_[e - whole.edges.size()];
  return {whole.edges[e].start, whole.edges[e].end};
}

void MergedProfile::number(const Profile& whole) {
  std::set<int> edges, vertices;
  for (const ProfileRegion& region : regions_)
    for (const Loop& loop : region.loops)
      for (const EdgeUse& use : loop) {
        edges.insert(use.edge.value);
        for (const int vertex : ends(whole, use))
          if (vertex >= 0) vertices.insert(vertex);
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
    ProfileEdge edge;
    const auto e = static_cast<std::size_t>(number);
    const auto [start, end] = ends(whole, {EdgeId(number), false});
    if (e < whole.edges.size())
      edge.points = whole.edges[e].points;
    else
      edge.points = {whole.vertices[static_cast<std::size_t>(start)],
                     whole.vertices[static_cast<std::size_t>(end)]};
    if (start >= 0) {
      edge.start = number_of(vertices_, start);
      edge.end = number_of(vertices_, end);
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
    if (edge.profile_edge < 0) continue;
    edge.profile_edge = edges_[static_cast<std::size_t>(edge.profile_edge)];
    if (edge.profile_edge >= static_cast<int>(whole.edges.size())) edge.profile_edge = -1;
  }
  for (Quad& quad : quads.quads) quad.region = members_[static_cast<std::size_t>(quad.region)].front();
  return quads;
}

}  // namespace isopatch::segmentation
