#pragma once

namespace isopatch::segmentation {

/// What could be made regular of the surfaces that were found, each counted once.
struct Regularity {
  int parallel = 0;  ///< directions that became another's, or at right angles to others
  int coaxial = 0;   ///< axes and centres that moved onto another's axis
  int equal = 0;     ///< radii that became another's
};

}  // namespace isopatch::segmentation
