#pragma once

#include <array>
#include <vector>

#include "segmentation/profiles/quadrangulation.hpp"

namespace isopatch::segmentation {

/// Lines of a merged profile that continue each other.
enum class CollinearLines {
  apart,
  one,  ///< no corner where nothing else meets; what divides the profile has chords for them
};

/// A profile with fewer regions, and how what divides it is drawn in the whole one.
class MergedProfile {
 public:
  /// @param groups  by region of the profile: regions of one number are one where they share edges; -1: left
  /// out
  /// @throws Error unsupported  regions of one group that touch in a point
  MergedProfile(const Profile& whole, const std::vector<int>& groups,
                CollinearLines lines = CollinearLines::apart);

  /// By merged region: the whole profile's regions in it.
  const std::vector<std::vector<int>>& members() const { return members_; }

  /// The merged profile where the whole one, with the same edges in other places, is.
  Profile reduced(const Profile& whole) const;
  /// A division of the merged profile with the numbers of the whole one: its vertices first, also those that
  /// nothing uses; each quadrilateral has the first of the regions that it divides.
  Quadrangulation expanded(Quadrangulation quads, const Profile& whole) const;

 private:
  void merge(const Profile& whole, const std::vector<int>& members);
  void straighten(const Profile& whole, std::vector<geometry::EdgeUse>& loop);
  std::array<int, 2> ends(const Profile& whole, geometry::EdgeUse use) const;
  void number(const Profile& whole);

  std::vector<ProfileRegion> regions_;  // with the whole profile's edges at first, then with those left
  std::vector<std::vector<int>> members_;
  std::vector<std::array<int, 2>> lines_;  // made of several, by their vertices; numbered after all edges
  std::vector<int> edges_, vertices_;      // of the whole profile, by number here
};

}  // namespace isopatch::segmentation
