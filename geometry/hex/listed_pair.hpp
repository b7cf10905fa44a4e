#pragma once

namespace isopatch::geometry {

/// Two faces that are one, by the numbers that they have in their solids.
struct ListedPair {
  int first_block = 0, first_face = 0;
  int second_block = 0, second_face = 0;
  bool operator==(const ListedPair&) const = default;
};

}  // namespace isopatch::geometry
