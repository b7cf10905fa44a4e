#include "segmentation/decomposition/without_tips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "geometry/base/error.hpp"
#include "geometry/brep/flat_tips.hpp"

namespace isopatch::segmentation {
namespace {

/// Webs of twist drills are 0.15 to 0.2 of their diameter, and the chisel edge across is a little longer.
constexpr double share_of_flat = 0.25;

}  // namespace

WithoutTips without_tips(const geometry::Brep& solid) {
  WithoutTips result{solid};
  const std::vector<geometry::DrillTip> tips = geometry::drill_tips(solid);
  if (tips.empty()) return result;
  try {
    result.brep = geometry::with_flat_tips(solid, tips, share_of_flat);
  } catch (const Error& error) {
    if (error.code() == ErrorCode::internal) throw;
    result.why_kept = fmt::format("its {} drill tip{} cannot be made flat and stay{}: {}", tips.size(),
                                  tips.size() == 1 ? "" : "s", tips.size() == 1 ? "s" : "", error.what());
    return result;
  }
  result.flattened = static_cast<int>(tips.size());
  for (const geometry::DrillTip& tip : tips)
    result.largest_radius = std::max(result.largest_radius, share_of_flat * tip.radius);
  result.volume_change = result.brep.volume() - solid.volume();
  return result;
}

std::string text_of(const WithoutTips& flattening) {
  if (flattening.flattened == 0) return flattening.why_kept;
  const bool one = flattening.flattened == 1;
  return fmt::format("{} drill tip{} in {}flat{} of {:.3g} m radius{}, volume {:+.2g} %",
                     flattening.flattened, one ? " ends" : "s end", one ? "a " : "", one ? "" : "s",
                     flattening.largest_radius, one ? "" : " at most",
                     100 * flattening.volume_change / (flattening.brep.volume() - flattening.volume_change));
}

}  // namespace isopatch::segmentation
