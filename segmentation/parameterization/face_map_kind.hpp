#pragma once

namespace isopatch::segmentation {

/// How the inside of a face came to its parameters.
enum class FaceMapKind {
  coons,       ///< transfinite blend of the sides in the face's domain
  mean_value,  ///< mean-value map of the triangulated domain to the square, pulled back and smoothed
};

/// "coons" or "mean_value".
const char* name(FaceMapKind kind);

}  // namespace isopatch::segmentation
