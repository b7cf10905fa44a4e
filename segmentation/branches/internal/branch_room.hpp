#pragma once

#include <vector>

#include "segmentation/branches/internal/inserted_branch.hpp"
#include "segmentation/branches/internal/main_body.hpp"
#include "segmentation/turned/turned_request.hpp"

namespace isopatch::segmentation {

/// How a body is to be divided, so that every branch begins within one side.
struct BranchLayout {
  TurnedRequest request;
  std::vector<BranchPlace> places;  ///< by branch, without tops
};

/// @throws Error unsupported  a branch has no room beside it on its cylinder, or none in a sector: names a
/// face and says how much there is
BranchLayout layout_of(const geometry::Brep& solid, const MainBody& body);

}  // namespace isopatch::segmentation
