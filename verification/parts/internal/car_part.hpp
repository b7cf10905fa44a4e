#pragma once

#include "verification/parts/internal/part.hpp"

namespace isopatch::parts {

/// A wishbone: a hub and two arms with eyes, symmetric about y = 0, of plane and cylindrical faces that meet
/// in sharp edges. Of the kind in Fig. 1 of the paper on the segmentation pipeline, drawn freely.
Part car_part();

}  // namespace isopatch::parts
