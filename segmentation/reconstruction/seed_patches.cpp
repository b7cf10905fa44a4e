#include "segmentation/reconstruction/internal/seed_patches.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace isopatch::segmentation {
namespace {

// Facets of a band that are looked at to either side.
constexpr std::size_t strip_length = 6;
// A facet so many times as large as what is beside it is a plane.
constexpr double plane_ratio = 10;
// Facets of the largest patch.
constexpr std::size_t most_facets = 32;

}  // namespace

SeedPatches::SeedPatches(const std::vector<Facet>& facets, Angle smooth) : facets_(facets), smooth_(smooth) {
  for (const Facet& facet : facets) large_.push_back(is_much_larger(facet));
}

bool SeedPatches::is_much_larger(const Facet& facet) const {
  double sum = 0;
  int count = 0;
  for (const FacetLink& link : facet.links)
    if (is_smooth(link)) {
      sum += facets_[static_cast<std::size_t>(link.other)].area;
      ++count;
    }
  return count == 0 || facet.area * count > plane_ratio * sum;
}

std::vector<int> SeedPatches::in_order() const {
  std::vector<int> order;
  for (std::size_t f = 0; f < facets_.size(); ++f)
    if (!large_[f]) order.push_back(static_cast<int>(f));
  std::uint64_t state = 1;
  for (std::size_t i = order.size(); i > 1; --i) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    std::swap(order[i - 1], order[(state >> 33) % i]);
  }
  return order;
}

std::vector<int> SeedPatches::smooth_neighbours(int facet) const {
  std::vector<int> result;
  for (const FacetLink& link : facets_[static_cast<std::size_t>(facet)].links)
    if (is_smooth(link) && !is_large(link.other)) result.push_back(link.other);
  return result;
}

std::vector<std::vector<int>> SeedPatches::patches(int seed) const {
  const std::vector<int> near = smooth_neighbours(seed);
  std::vector<std::vector<int>> result;
  std::vector<int> one{seed};
  one.insert(one.end(), near.begin(), near.end());
  std::vector<int> two = one;
  for (const int f : near)
    for (const int g : smooth_neighbours(f))
      if (std::find(two.begin(), two.end(), g) == two.end() && two.size() < most_facets) two.push_back(g);
  if (two.size() > one.size()) result.push_back(two);
  if (one.size() > 2) result.push_back(one);
  if (near.size() > 2 && near.size() <= 5)
    for (std::size_t i = 0; i < near.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) result.push_back({seed, near[j], near[i]});
  for (const FacetLink& link : facets_[static_cast<std::size_t>(seed)].links)
    if (is_smooth(link)) result.push_back(strip(seed, link));
  return result;
}

/// Facets of a narrow band: each next one is across the edge that runs most like the one before.
std::vector<int> SeedPatches::strip(int seed, const FacetLink& first) const {
  std::vector<int> result{seed};
  const auto walk = [&](const FacetLink& start) {
    FacetLink last = start;
    for (std::size_t k = 0; k < strip_length; ++k) {
      if (std::find(result.begin(), result.end(), last.other) != result.end()) return;
      result.push_back(last.other);
      const FacetLink next = most_alike(last.other, last);
      if (next.other < 0) return;
      last = next;
    }
  };
  walk(first);
  const FacetLink back = most_alike(seed, first);
  if (back.other >= 0) walk(back);
  return result;
}

/// The smooth link of a facet whose edge runs most like another's, but for that one.
FacetLink SeedPatches::most_alike(int facet, const FacetLink& like) const {
  FacetLink best{-1};
  double most = 0.5;
  for (const FacetLink& link : facets_[static_cast<std::size_t>(facet)].links) {
    if (!is_smooth(link) || (link.edge + like.edge).norm() < 1e-9 * like.edge.norm() ||
        link.edge == like.edge)
      continue;
    const double along = std::abs(link.edge.dot(like.edge)) / (link.edge.norm() * like.edge.norm());
    if (!(along > most)) continue;
    most = along;
    best = link;
  }
  return best;
}

}  // namespace isopatch::segmentation
