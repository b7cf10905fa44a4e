#include "segmentation/decomposition/without_blends.hpp"

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "geometry/brep/without_faces.hpp"
#include "segmentation/sweeps/rounds.hpp"

namespace isopatch::segmentation {

WithoutBlends without_blends(const geometry::Brep& solid, const std::string& name,
                             const DecompositionOptions& options) {
  WithoutBlends result{solid, 0, 0, 0};
  if (options.blends == Blends::keep || options.method == Method::cuts) return result;
  const Rounds rounds = rounds_in_the_way(solid, options.largest_blend * solid.size());
  if (rounds.faces.empty()) return result;
  try {
    result.brep = geometry::without_faces(solid, rounds.faces);
  } catch (const Error& error) {
    throw Error(error.code(),
                fmt::format("solid '{}': its {} rounds cannot be removed: {}; blends = \"keep\", "
                            "or remove them in the CAD program",
                            name, rounds.faces.size(), error.what()));
  }
  result.removed = static_cast<int>(rounds.faces.size());
  result.largest_radius = rounds.largest_radius;
  result.volume_change = result.brep.volume() - solid.volume();
  return result;
}

std::string text_of(const WithoutBlends& removal) {
  const double before = removal.brep.volume() - removal.volume_change;
  return fmt::format("{} round{} of {:.3g} m radius at most removed, volume {:+.2g} %", removal.removed,
                     removal.removed == 1 ? "" : "s", removal.largest_radius,
                     100 * removal.volume_change / before);
}

}  // namespace isopatch::segmentation
