#pragma once

#include "geometry/base/angle.hpp"

namespace isopatch::segmentation {

/// How triangles are put together to faces.
enum class RegionMethod {
  carriers,  ///< by the planes, cylinders, cones, spheres and tori that vertices lie on
  angles,    ///< by the angles between triangles alone, as published
};

struct ReconstructionOptions {
  RegionMethod method = RegionMethod::carriers;
  /// Largest distance between vertices and the surface they belong to, as a share of the model's size; the
  /// file's rounding is allowed for. Range (0, 0.01].
  double tolerance = 1e-6;
  /// Largest angle between neighbouring facets of one curved surface. Range (0, 90 degrees).
  Angle smooth = Angle::degrees(41);
  /// Places where surfaces are looked for in vain before the search ends. At least 1.
  int most_failures = 4000;
  /// Seconds of the processor after which it is given up. Above 0.
  double time_limit = 300;
  /// Whether rounds along freeform walls between parallel planes are left out, and the walls extended.
  bool remove_blends = false;

  // Of the method by angles.
  Angle cutoff = Angle::degrees(40);        ///< edges of at least this part regions
  Angle inner_cutoff = Angle::degrees(15);  ///< the same inside of large regions, in the second pass
  double large =
      0.2;  ///< regions of more than this share of the mean area are divided once more; 0: no second pass
  double small = 0;  ///< regions of less than this share of the mean area are given to a neighbour; 0: none
  bool operator==(const ReconstructionOptions&) const = default;
};

/// @throws Error invalid_argument  names field, value and range
void validate(const ReconstructionOptions& options);

}  // namespace isopatch::segmentation
