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

}  // namespace isopatch::geometry
