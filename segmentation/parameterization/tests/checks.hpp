#pragma once

#include <gmock/gmock.h>

#include <string>
#include <vector>

#include "geometry/base/error.hpp"
#include "segmentation/parameterization/parameterize.hpp"

namespace isopatch::segmentation::test {

ParameterizationOptions options(ParameterizationMethod method);

/// How many control points of different patches are closer than 1e-6 of the model's size without being equal
/// to the last bit.
int coincident_but_different_points(const geometry::PatchSet& set);

/// det J of a B-spline volume by the recursion of Cox and de Boor, written down plainly: shares no code with
/// the library.
double plain_determinant(const geometry::NurbsVolume& volume, const Eigen::Vector3d& parameter);

/// The smallest of `plain_determinant` on a grid of n^3 points, ends included.
double smallest_determinant(const geometry::NurbsVolume& volume, int n);

/// Matches a function that throws an Error with a code and a message that has all parts.
MATCHER_P2(ThrowsErrorLike, code, parts, "") {
  try {
    arg();
  } catch (const Error& error) {
    *result_listener << "throws " << isopatch::name(error.code()) << ": " << error.what();
    for (const std::string& part : parts)
      if (std::string(error.what()).find(part) == std::string::npos) return false;
    return error.code() == code;
  }
  *result_listener << "throws nothing";
  return false;
}
inline auto ThrowsError(ErrorCode code, std::vector<std::string> parts) {
  return ThrowsErrorLike(code, std::move(parts));
}

}  // namespace isopatch::segmentation::test
