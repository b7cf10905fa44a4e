#pragma once

#include <vector>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/cell_complex.hpp"
#include "segmentation/branches/internal/branch_place.hpp"
#include "segmentation/branches/internal/main_body.hpp"
#include "segmentation/pieces/joined_complex.hpp"

namespace isopatch::segmentation {

/// What stands on the branches of a body: flanges of pipes, chamfers of bosses, tapped holes in them.
class BranchTops {
 public:
  /// @param solid  must outlive it
  explicit BranchTops(const geometry::Brep& solid)
      : solid_(solid), cut_face_(static_cast<int>(solid.faces().size())) {}

  /// Enters in a branch's place up to where it is made, and how that is divided which stands there.
  /// @throws Error unsupported  that is no stack: names a face
  void find(const Branch& branch, BranchPlace& place);
  /// Of the sides that they stand on.
  FaceId cut_face() const { return cut_face_; }
  /// A body with branches, and all that was found.
  /// @throws Error unsupported  they do not meet side to side
  geometry::CellComplex with(geometry::CellComplex body);

 private:
  const geometry::Brep& solid_;
  FaceId cut_face_;
  std::vector<ComplexOfPiece> tops_;
};

}  // namespace isopatch::segmentation
