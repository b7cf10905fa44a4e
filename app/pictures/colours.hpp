#pragma once

#include <array>
#include <cstdint>
#include <vector>

namespace isopatch::app {

/// Red, green, blue.
struct Colour {
  std::uint8_t red = 0;
  std::uint8_t green = 0;
  std::uint8_t blue = 0;
  bool operator==(const Colour&) const = default;
};

/// 256 colours from dark blue over green to yellow, of evenly rising lightness.
/// @source the map "viridis" of S. van der Walt and N. Smith (2015, CC0), through ten of its colours
std::vector<Colour> viridis();

/// Light colours that neighbours in the list tell apart; they repeat after twelve.
std::vector<Colour> patch_colours(int count);

}  // namespace isopatch::app
