#pragma once

#include <vector>

#include "geometry/base/angle.hpp"
#include "segmentation/reconstruction/internal/facets.hpp"

namespace isopatch::segmentation {

/// Small sets of facets that a surface is first fitted to: around a seed, or along a narrow band.
class SeedPatches {
 public:
  /// @param facets  must outlive it
  /// @param smooth  largest angle between the normals of neighbours on one surface
  SeedPatches(const std::vector<Facet>& facets, Angle smooth);

  /// Whether a facet is much larger than its smooth neighbours, or has none: then it is a plane.
  bool is_large(int facet) const { return large_[static_cast<std::size_t>(facet)]; }
  /// All others, in an order without a pattern, so that surfaces of many facets are met first.
  std::vector<int> in_order() const;
  /// A facet with its neighbours and theirs; with its neighbours; with two of them; bands through it.
  std::vector<std::vector<int>> patches(int seed) const;

 private:
  bool is_smooth(const FacetLink& link) const { return link.angle < smooth_.radians(); }
  bool is_much_larger(const Facet& facet) const;
  std::vector<int> smooth_neighbours(int facet) const;
  std::vector<int> strip(int seed, const FacetLink& first) const;
  FacetLink most_alike(int facet, const FacetLink& like) const;

  const std::vector<Facet>& facets_;
  Angle smooth_;
  std::vector<bool> large_;
};

}  // namespace isopatch::segmentation
