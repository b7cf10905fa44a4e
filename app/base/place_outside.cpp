#include "app/base/place_outside.hpp"

#include <fmt/format.h>

#include "app/base/engineering_units.hpp"
#include "geometry/measures.hpp"

namespace isopatch::app {

std::string outside_text(const geometry::MultiPatch& model, const Eigen::Vector3d& point,
                         const iga::Location& location) {
  std::string text =
      fmt::format("the point {} lies {} outside the part; the nearest patch is {}",
                  place_with_unit(point, model.size()), with_unit(location.distance, "m"), location.patch);
  // Farther away than the part is large: the number is right, its unit is not.
  if (location.distance < model.size()) return text;
  const Eigen::AlignedBox3d box = geometry::box(model);
  return text + fmt::format(
                    ". The part lies between {} and {}; numbers without a unit are metres, write '20 mm' for "
                    "millimetres",
                    place_with_unit(box.min(), model.size()), place_with_unit(box.max(), model.size()));
}

}  // namespace isopatch::app
