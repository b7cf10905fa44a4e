#include "segmentation/profiles/division_error.hpp"

#include <fmt/format.h>

namespace isopatch::segmentation {

DivisionError::DivisionError(int region, const Eigen::Vector2d& place)
    : Error(ErrorCode::unsupported,
            fmt::format("region {} of the profile cannot be divided: all divisions found are folded near "
                        "({:.6g}, {:.6g}); try a larger effort or wider bounds of angles",
                        region, place.x(), place.y())),
      region_(region),
      place_(place) {}

}  // namespace isopatch::segmentation
