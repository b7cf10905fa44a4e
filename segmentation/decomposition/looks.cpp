#include "segmentation/decomposition/looks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/base/error.hpp"
#include "segmentation/branches/branched_cells.hpp"
#include "segmentation/branches/cross_bored_cells.hpp"
#include "segmentation/sweeps/in_the_way.hpp"
#include "segmentation/sweeps/rounds.hpp"
#include "segmentation/sweeps/stack.hpp"
#include "segmentation/turned/turned_cells.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::Brep;

/// What a look finds; nothing where it ends with an error.
template <class Look>
auto tried(const Look& look) -> decltype(look()) {
  try {
    return look();
  } catch (const Error& error) {
    if (error.code() == ErrorCode::internal) throw;
    return {};
  }
}

std::string as_stack(const Brep& solid) {
  for (const SweepFrame& frame : sweep_frames(solid))
    if (is_stack(solid, frame)) return "swept along " + direction_text(frame.along);
  return "";
}

std::string as_rounded_stack(const Brep& solid) {
  const std::optional<InTheWay> least = least_in_the_way(solid);
  if (!least || least->faces.empty()) return "";
  const std::size_t rounds = rounds_in_the_way(solid, solid.size()).faces.size();
  if (rounds == 0) return "";
  return fmt::format("swept along {} but for {} round{}", direction_text(least->along), rounds,
                     rounds == 1 ? "" : "s");
}

std::string as_turned(const Brep& solid) {
  const std::optional<Eigen::Vector3d> axis = turned_about(solid);
  return axis ? "turned about " + direction_text(*axis) : "";
}

std::string as_branched(const Brep& solid) {
  const std::optional<Eigen::Vector3d> axis = branched_about(solid);
  return axis ? fmt::format("turned about {} with branches", direction_text(*axis)) : "";
}

std::string as_bored(const Brep& solid) {
  const std::optional<Eigen::Vector3d> along = bored_across(solid);
  if (!along) return "";
  // Bores that meet are looked at before pieces are, others after them.
  return fmt::format("swept along {} with bores, slots or bosses across{}", direction_text(*along),
                     bores_meet(solid) ? "" : ", or in pieces");
}

}  // namespace

std::string direction_text(const Eigen::Vector3d& direction) {
  for (int i = 0; i < 3; ++i)
    if (std::abs(direction[i]) > 1 - 1e-12) return std::string(1, "xyz"[i]);
  const auto clean = [](double x) { return std::abs(x) < 5e-7 ? 0.0 : x; };  // no "-0"
  return fmt::format("({:.3g}, {:.3g}, {:.3g})", clean(direction.x()), clean(direction.y()),
                     clean(direction.z()));
}

std::string looks(const Brep& solid) {
  for (const auto look : {as_stack, as_turned, as_branched, as_rounded_stack, as_bored})
    if (std::string found = tried([&] { return look(solid); }); !found.empty()) return found;
  return "";
}

}  // namespace isopatch::segmentation
