#pragma once

#include <array>
#include <vector>

namespace isopatch::iga {

/// What some patches have beyond the others.
struct PatchRefinement {
  std::vector<int> patches;
  /// As those of `DiscretizationOptions`; more than these alone counts.
  std::array<int, 3> degree = {0, 0, 0};
  std::array<int, 3> elements_per_direction = {0, 0, 0};
  double max_size = 0;
  int refine = 0;  ///< halvings after those of all patches, 0 .. 10
  bool operator==(const PatchRefinement&) const = default;
};

/// A place where the elements of a patch end along one direction, beside those that all patches have.
struct KnotPlace {
  int patch = 0;
  int direction = 0;  ///< 0 .. 2
  double parameter = 0;
  bool operator==(const KnotPlace&) const = default;
};

/// How the solution space refines the geometry's.
struct DiscretizationOptions {
  /// Degree per direction, raised where the geometry's is lower and never lowered; 0 keeps the geometry's.
  /// Raising keeps the continuity of the geometry at its knots. Range 0 .. 10.
  std::array<int, 3> degree = {0, 0, 0};
  /// Halvings of every element that the other options make. Range 0 .. 10.
  int refine = 0;
  /// Least number of elements per direction of each patch, before `refine`; 0: as many as the geometry has.
  /// Range 0 .. 10000.
  std::array<int, 3> elements_per_direction = {0, 0, 0};
  /// Largest length of an element's edge before `refine`, model units; 0: no limit.
  double max_size = 0;
  /// Highest continuity C^k across knots inside a patch; -1: as smooth as degree and geometry allow. Range -1
  /// .. 9.
  int continuity = -1;
  std::vector<PatchRefinement> patches = {};
  /// Further ends of elements, after all else.
  std::vector<KnotPlace> knots = {};
  /// Whether what `patches` and `knots` ask for continues through neighbours, so that faces still match.
  /// Otherwise interfaces whose sides differ become non-matching ones.
  bool spread = true;
  bool operator==(const DiscretizationOptions&) const = default;
};
/// @throws Error invalid_argument naming field, value and range
void validate(const DiscretizationOptions& options);

}  // namespace isopatch::iga
