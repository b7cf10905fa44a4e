#pragma once

#include "geometry/brep/brep.hpp"
#include "segmentation/profiles/division_error.hpp"
#include "segmentation/sweeps/sweep_frame.hpp"

namespace isopatch::segmentation {

/// What to say of a stack whose drawing cannot be divided: where that is in space, and beside which wall.
Error placed_refusal(const geometry::Brep& solid, const SweepFrame& frame, const DivisionError& error);

/// What `make` returns; a refusal to divide the drawing is placed.
template <class Make>
auto or_placed_refusal(const geometry::Brep& solid, const SweepFrame& frame, const Make& make) {
  try {
    return make();
  } catch (const DivisionError& error) {
    throw placed_refusal(solid, frame, error);
  }
}

}  // namespace isopatch::segmentation
