#include "segmentation/profiles/internal/shared_cuts.hpp"

#include <algorithm>
#include <cmath>
#include <deque>
#include <numbers>

#include "segmentation/profiles/internal/candidates.hpp"

namespace isopatch::segmentation::planar {

using std::numbers::pi;

namespace {

/// The regions on both sides of each edge, -1 where there is none that is wanted.
std::vector<std::array<int, 2>> regions_beside(const Profile& profile) {
  std::vector<std::array<int, 2>> result(profile.edges.size(), {-1, -1});
  for (std::size_t r = 0; r < profile.regions.size(); ++r)
    for (const auto& loop : profile.regions[r].loops)
      for (const geometry::EdgeUse& use : loop)
        if (profile.regions[r].wanted) result[use.edge.value][use.reversed ? 1 : 0] = static_cast<int>(r);
  return result;
}

/// Edges that lead from an odd region to another one or to one that can be made even by itself.
std::vector<int> way_to_even(const std::vector<std::array<int, 2>>& beside,
                             const std::vector<double>& weights, int from, const std::vector<bool>& free,
                             const std::vector<int>& corners) {
  std::vector<int> reached_by(free.size(), -2);
  std::deque<int> open = {from};
  reached_by[from] = -1;
  while (!open.empty()) {
    const int region = open.front();
    open.pop_front();
    if (region != from && (free[region] || corners[region] % 2 != 0)) {
      std::vector<int> result;
      for (int r = region; r != from;) {
        const int edge = reached_by[r];
        result.push_back(edge);
        r = beside[edge][0] == r ? beside[edge][1] : beside[edge][0];
      }
      return result;
    }
    std::vector<int> edges;
    for (std::size_t e = 0; e < beside.size(); ++e)
      if (beside[e][0] >= 0 && beside[e][1] >= 0 && (beside[e][0] == region) != (beside[e][1] == region))
        edges.push_back(static_cast<int>(e));
    std::sort(edges.begin(), edges.end(), [&](int a, int b) { return weights[a] > weights[b]; });
    for (const int edge : edges) {
      const int other = beside[edge][0] == region ? beside[edge][1] : beside[edge][0];
      if (reached_by[other] != -2) continue;
      reached_by[other] = edge;
      open.push_back(other);
    }
  }
  return {};
}

/// How many further cuts each edge needs for the parity of regions.
std::vector<int> cuts_for_parity(const Profile& profile, const std::vector<Curve>& curves,
                                 const CutPlaces& places) {
  const auto beside = regions_beside(profile);
  std::vector<bool> free(profile.regions.size(), false);
  std::vector<int> corners(profile.regions.size(), 0);
  std::vector<double> weights;
  for (std::size_t e = 0; e < beside.size(); ++e) {
    weights.push_back(curves[e].length() * (curves[e].straight() ? 1 : 3));
    const bool shared = beside[e][0] >= 0 && beside[e][1] >= 0;
    for (const int region : beside[e])
      if (region >= 0) {
        corners[region] += static_cast<int>(places[e].size()) + (curves[e].closed() ? 0 : 1);
        if (!shared) free[region] = true;
      }
  }
  std::vector<int> result(profile.edges.size(), 0);
  for (std::size_t r = 0; r < corners.size(); ++r) {
    if (!profile.regions[r].wanted || free[r] || corners[r] % 2 == 0) continue;
    for (const int edge : way_to_even(beside, weights, static_cast<int>(r), free, corners)) {
      ++result[edge];
      for (const int region : beside[edge]) ++corners[region];
    }
  }
  return result;
}

/// Halves the longest stretches.
void cut_further(const Curve& curve, std::vector<double>& places, int number) {
  for (; number > 0; --number) {
    std::vector<double> ends = places;
    if (!curve.closed()) ends.insert(ends.begin(), 0.0);
    ends.push_back(curve.closed() ? ends.front() + 1 : 1.0);
    std::size_t longest = 0;
    for (std::size_t i = 0; i + 1 < ends.size(); ++i)
      if (ends[i + 1] - ends[i] > ends[longest + 1] - ends[longest] + 1e-9) longest = i;
    const double middle = (ends[longest] + ends[longest + 1]) / 2;
    places.push_back(middle - std::floor(middle));
    std::sort(places.begin(), places.end());
  }
}

}  // namespace

std::vector<bool> shared_edges(const Profile& profile) {
  std::vector<bool> result;
  for (const auto& regions : regions_beside(profile)) result.push_back(regions[0] >= 0 && regions[1] >= 0);
  return result;
}

CutPlaces shared_places(const Profile& profile, const std::vector<Curve>& curves, const SharedCuts& cuts) {
  constexpr double most = 110 * pi / 180;  // a little less than what a side may turn
  const std::vector<bool> shared = shared_edges(profile);
  CutPlaces result(curves.size());
  for (std::size_t e = 0; e < curves.size(); ++e) {
    if (!shared[e]) continue;
    if (curves[e].closed()) {
      result[e] = places_of_directions(curves[e], cuts.diagonal ? pi / 4 : 0, pi / 2);
      for (double& at : result[e]) at -= std::floor(at);
      std::sort(result[e].begin(), result[e].end());
    } else if (!curves[e].straight()) {
      cut_further(curves[e], result[e],
                  std::max(0, static_cast<int>(std::ceil(curves[e].turning() / most)) - 1));
    }
    if (result[e].empty() && curves[e].closed()) result[e] = {0, 0.25, 0.5, 0.75};
    cut_further(curves[e], result[e], cuts.more);
  }
  const std::vector<int> further = cuts_for_parity(profile, curves, result);
  for (std::size_t e = 0; e < curves.size(); ++e) cut_further(curves[e], result[e], further[e]);
  return result;
}

}  // namespace isopatch::segmentation::planar
