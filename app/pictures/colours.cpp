#include "app/pictures/colours.hpp"

#include <cmath>

namespace isopatch::app {
namespace {

constexpr std::array<Colour, 10> viridis_stops = {{{68, 1, 84},
                                                   {72, 40, 120},
                                                   {62, 73, 137},
                                                   {49, 104, 142},
                                                   {38, 130, 142},
                                                   {31, 158, 137},
                                                   {53, 183, 121},
                                                   {110, 206, 88},
                                                   {181, 222, 43},
                                                   {253, 231, 37}}};

constexpr std::array<Colour, 12> distinct = {{{141, 179, 214},
                                              {240, 178, 122},
                                              {147, 199, 153},
                                              {224, 153, 157},
                                              {184, 168, 211},
                                              {226, 212, 129},
                                              {133, 200, 203},
                                              {201, 174, 155},
                                              {232, 176, 214},
                                              {183, 193, 203},
                                              {193, 214, 121},
                                              {130, 152, 201}}};

std::uint8_t between(std::uint8_t low, std::uint8_t high, double share) {
  return static_cast<std::uint8_t>(std::lround(low + share * (high - low)));
}

}  // namespace

std::vector<Colour> viridis() {
  constexpr int count = 256;
  std::vector<Colour> colours;
  for (int i = 0; i < count; ++i) {
    const double place = static_cast<double>(i) / (count - 1) * (viridis_stops.size() - 1);
    const auto stop = std::min(static_cast<std::size_t>(place), viridis_stops.size() - 2);
    const double share = place - static_cast<double>(stop);
    const Colour& low = viridis_stops[stop];
    const Colour& high = viridis_stops[stop + 1];
    colours.push_back({between(low.red, high.red, share), between(low.green, high.green, share),
                       between(low.blue, high.blue, share)});
  }
  return colours;
}

std::vector<Colour> patch_colours(int count) {
  std::vector<Colour> colours;
  for (int i = 0; i < count; ++i) colours.push_back(distinct[static_cast<std::size_t>(i) % distinct.size()]);
  return colours;
}

}  // namespace isopatch::app
