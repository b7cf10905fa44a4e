#include "segmentation/decomposition/without_tips.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "geometry/base/error.hpp"
#include "geometry/brep/flat_tips.hpp"
#include "geometry/brep/require_solid.hpp"

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
  for (const geometry::DrillTip& tip : tips)
    result.flats.push_back({describe(solid, tip.cone), tip.apex, share_of_flat * tip.radius});
  result.volume_change = result.brep.volume() - solid.volume();
  return result;
}

std::string text_of(const WithoutTips& flattening) {
  constexpr std::size_t most = 4;
  const std::size_t count = flattening.flats.size();
  if (count == 0) return flattening.why_kept;
  std::string list;
  for (std::size_t i = 0; i < std::min(most, count); ++i) {
    const WithoutTips::Flat& flat = flattening.flats[i];
    const Eigen::Vector3d at =
        (1e3 * flat.place).unaryExpr([](double x) { return std::abs(x) < 1e-6 ? 0 : x; });  // no "-0"
    list += fmt::format("{}{} at ({:.4g}, {:.4g}, {:.4g}) mm in one of {:.3g} mm radius", i == 0 ? "" : ", ",
                        flat.face, at.x(), at.y(), at.z(), 1e3 * flat.radius);
  }
  if (count > most) list += fmt::format(" and {} more", count - most);
  const double before = flattening.brep.volume() - flattening.volume_change;
  return fmt::format("{} drill tip{}: {}; volume {:+.2g} %", count,
                     count == 1 ? " ends in a flat" : "s end in flats", list,
                     100 * flattening.volume_change / before);
}

}  // namespace isopatch::segmentation
