#pragma once

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "geometry/brep/brep.hpp"
#include "geometry/brep/solid_error.hpp"

namespace isopatch::segmentation {

/// What a solid had been cut into when it was given up.
struct UnfinishedPart {
  geometry::Brep solid;
  bool finished = false;  ///< a base solid already
  /// What stands in the way: edges that no cut was found through, or at which its neighbours divide a side;
  /// m.
  std::vector<Eigen::Matrix3Xd> lines = {};
};

/// A solid that could not be taken apart.
class CuttingError : public geometry::SolidError {
 public:
  /// @param parts  none where no cut was tried
  CuttingError(ErrorCode code, const std::string& message, geometry::SolidFault fault,
               std::vector<UnfinishedPart> parts)
      : SolidError(code, message, std::move(fault)), parts_(std::move(parts)) {}
  const std::vector<UnfinishedPart>& parts() const { return parts_; }

 private:
  std::vector<UnfinishedPart> parts_;
};

}  // namespace isopatch::segmentation
