#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <stdexcept>
#include <string>

#include "geometry/base/error.hpp"
#include "geometry/multi_patch.hpp"

namespace isopatch::geometry {

/// A patch of random degrees, knots, points and (every other time) weights, whose numbers use all their bits.
inline NurbsVolume random_patch(std::mt19937& random) {
  const auto integer = [&](int low, int high) { return std::uniform_int_distribution(low, high)(random); };
  std::uniform_real_distribution<double> real(0.0, 1.0);
  NurbsVolume::KnotVectors knots;
  Eigen::Index count = 1;
  for (KnotVector& k : knots) {
    const int degree = integer(1, 4);
    std::vector<double> inner(static_cast<std::size_t>(integer(0, 3)));
    for (double& t : inner) t = real(random);
    std::sort(inner.begin(), inner.end());
    std::vector<double> all(static_cast<std::size_t>(degree) + 1, -1.0 / 3);
    all.insert(all.end(), inner.begin(), inner.end());
    all.insert(all.end(), static_cast<std::size_t>(degree) + 1, 1.1);
    k = KnotVector(degree, all);
    count *= k.size();
  }
  Eigen::Matrix3Xd points(3, count);
  for (double& x : points.reshaped()) x = std::ldexp(real(random) - 0.5, integer(-60, 20));
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(count);
  if (integer(0, 1) == 1)
    for (double& w : weights) w = 0.1 + real(random);
  return NurbsVolume(knots, points, weights);
}

inline bool same_bits(const NurbsVolume& a, const NurbsVolume& b) {
  return a.knots() == b.knots() && a.control_points() == b.control_points() && a.weights() == b.weights();
}

/// The unit cube, its patch shifted by (x, y, z).
inline NurbsVolume cube_at(double x, double y, double z) {
  return NurbsVolume({}, NurbsVolume().control_points().colwise() + Eigen::Vector3d(x, y, z));
}

/// What an Error says and its code, "bad_format: ..."; "no error" if nothing is thrown.
template <class Action>
std::string error_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return fmt::format("{}: {}", name(error.code()), error.what());
  }
  return "no error";
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  if (at == text.npos) throw std::logic_error("the test's text lacks '" + from + "'");
  return text.replace(at, from.size(), to);
}

}  // namespace isopatch::geometry
