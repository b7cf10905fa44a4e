#pragma once

namespace isopatch::app {

/// How far a place that a person wrote may lie from the model, as a share of the model's size: four digits,
/// what one reads off a drawing.
inline constexpr double place_tolerance = 1e-4;

}  // namespace isopatch::app
