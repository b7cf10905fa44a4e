#pragma once

#include <memory>

#include "segmentation/profiles/quadrangulation.hpp"
#include "segmentation/profiles/quadrangulation_options.hpp"

namespace isopatch::segmentation {

/// Divides the wanted regions of a profile into few quadrilaterals with corners near right angles, which meet
/// side to side, across shared edges of regions as well. Same input, same result.
/// @throws Error bad_format for an invalid profile, unsupported naming the region where loops cross or no
/// division is found
/// @cost about 1 s for 100 vertices; several times that where no division within the bounds is found
Quadrangulation quadrangulate(const Profile& profile, const QuadrangulationOptions& options = {});

/// A division that could still get better: of several, those that look best may be finished.
class DraftedQuadrangulation {
 public:
  /// @throws Error bad_format for an invalid profile, unsupported where loops cross
  /// @cost  a half to three quarters of `quadrangulate` where that is thorough, all of it elsewhere
  explicit DraftedQuadrangulation(const Profile& profile, const QuadrangulationOptions& options = {});
  DraftedQuadrangulation(DraftedQuadrangulation&&) noexcept;
  DraftedQuadrangulation& operator=(DraftedQuadrangulation&&) noexcept;
  ~DraftedQuadrangulation();

  /// As the options weigh it; infinite where no division within their bounds is known.
  double cost() const;
  /// What `quadrangulate` gives.
  /// @throws Error unsupported naming the region for which no division is found
  Quadrangulation finished() const;

 private:
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace isopatch::segmentation
