#include "segmentation/decomposition/without_blends.hpp"

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "geometry/brep/without_faces.hpp"
#include "segmentation/sweeps/rounds.hpp"

namespace isopatch::segmentation {

WithoutBlends without_blends(const geometry::Brep& solid, const DecompositionOptions& options) {
  WithoutBlends result{solid};
  if (options.blends == Blends::keep || options.method == Method::cuts) return result;
  const Rounds rounds = rounds_in_the_way(solid, options.largest_blend * solid.size());
  if (rounds.faces.empty()) return result;
  try {
    result.brep = geometry::without_faces(solid, rounds.faces);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::internal) throw;
    result.why_kept = fmt::format("its {} round{} cannot be removed and stay: {}", rounds.faces.size(),
                                  rounds.faces.size() == 1 ? "" : "s", error.what());
    return result;
  }
  result.removed = static_cast<int>(rounds.faces.size());
  result.largest_radius = rounds.largest_radius;
  result.volume_change = result.brep.volume() - solid.volume();
  return result;
}

std::string text_of(const WithoutBlends& removal) {
  if (removal.removed == 0) return removal.why_kept;
  const double before = removal.brep.volume() - removal.volume_change;
  return fmt::format("{} round{} of {:.3g} m radius at most removed, volume {:+.2g} %", removal.removed,
                     removal.removed == 1 ? "" : "s", removal.largest_radius,
                     100 * removal.volume_change / before);
}

}  // namespace isopatch::segmentation
