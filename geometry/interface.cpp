#include "geometry/interface.hpp"

#include <utility>

namespace isopatch::geometry {

Parameter<2> FaceOrientation::operator()(const Parameter<2>& parameter) const {
  Parameter<2> result = swapped ? Parameter<2>(parameter[1], parameter[0]) : parameter;
  if (flip_first) result[0] = 1 - result[0];
  if (flip_second) result[1] = 1 - result[1];
  return result;
}

FaceOrientation inverse(const FaceOrientation& orientation) {
  if (!orientation.swapped) return orientation;
  return {true, orientation.flip_second, orientation.flip_first};
}

FaceOrientation composed(const FaceOrientation& first, const FaceOrientation& second) {
  FaceOrientation result = first;
  if (second.swapped) {
    result.swapped = !first.swapped;
    std::swap(result.flip_first, result.flip_second);
  }
  result.flip_first = result.flip_first != second.flip_first;
  result.flip_second = result.flip_second != second.flip_second;
  return result;
}

StatedInterface exchanged(const StatedInterface& interface) {
  return {interface.second, interface.first, inverse(interface.orientation)};
}

StatedInterface turned_around(StatedInterface interface, bool first, bool second) {
  // Parameters of a face in which direction 1 runs begin with it; the other two sides exchange.
  const auto turn = [](PatchFace& face) {
    const bool across = direction(face.side) == 0;
    if (across) face.side = opposite(face.side);
    return FaceOrientation{.flip_first = !across};
  };
  if (first) interface.orientation = composed(turn(interface.first), interface.orientation);
  if (second) interface.orientation = composed(interface.orientation, turn(interface.second));
  return interface;
}

std::optional<FaceOrientation> orientation_between(const std::array<int, 4>& first,
                                                   const std::array<int, 4>& second) {
  for (int flags = 0; flags < 8; ++flags) {
    const FaceOrientation orientation{(flags & 4) != 0, (flags & 1) != 0, (flags & 2) != 0};
    bool same = true;
    for (int corner = 0; corner < 4 && same; ++corner) {
      const Parameter<2> there = orientation(Parameter<2>(corner & 1, corner >> 1));
      same = first[static_cast<std::size_t>(corner)] ==
             second[static_cast<std::size_t>(there[0]) + 2 * static_cast<std::size_t>(there[1])];
    }
    if (same) return orientation;
  }
  return std::nullopt;
}

}  // namespace isopatch::geometry
