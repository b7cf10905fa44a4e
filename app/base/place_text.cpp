#include "app/base/place_text.hpp"

#include <fmt/format.h>

namespace isopatch::app {

std::string triple_text(std::string_view x, std::string_view y, std::string_view z) {
  return fmt::format("({}, {}, {})", x, y, z);
}

std::string place_text(const Eigen::Vector3d& place, int digits) {
  const auto text = [&](double x) {
    return digits > 0 ? fmt::format("{:.{}g}", x, digits) : fmt::format("{}", x);
  };
  return triple_text(text(place[0]), text(place[1]), text(place[2]));
}

}  // namespace isopatch::app
