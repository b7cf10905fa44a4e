#include "segmentation/profiles/internal/candidates.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isopatch::segmentation::planar {

using Eigen::Vector2d;
using std::numbers::pi;

namespace {

/// Points that curves may be cut across from: vertices, centres of closed curves.
std::vector<Vector2d> features_of(const Profile& profile, const std::vector<Curve>& curves) {
  std::vector<Vector2d> result = profile.vertices;
  for (const Curve& curve : curves)
    if (curve.closed()) {
      Vector2d sum = Vector2d::Zero();
      for (int i = 0; i < 64; ++i) sum += curve.at(i / 64.0);
      result.emplace_back(sum / 64);
    }
  return result;
}

/// Whether a place is not too close to the ends of a curve with ends: by its share, or for a feature at a
/// distance, so that what lies between it and the end is no sliver.
bool leaves_room(const Curve& curve, double at, double distance) {
  const double room = std::min(0.03, 0.1 * distance / curve.length());
  return curve.closed() || (at > room && at < 1 - room);
}

void enter_feet(const Curve& curve, const std::vector<Vector2d>& features, std::vector<double>& places) {
  constexpr std::size_t most = 12;
  std::vector<std::pair<double, double>> feet;
  for (const Vector2d& feature : features) {
    const double at = curve.nearest(feature, 0, 1);
    const double distance = (curve.at(at) - feature).norm();
    if (distance > 1e-6 * curve.length() && leaves_room(curve, at, distance)) feet.emplace_back(distance, at);
  }
  std::sort(feet.begin(), feet.end());
  if (feet.size() > most) feet.resize(most);
  for (const auto& [distance, at] : feet) places.push_back(at);
}

}  // namespace

std::vector<double> places_of_directions(const Curve& curve, double direction, double step) {
  std::vector<double> result;
  constexpr int samples = 256;
  const auto turn = [&](double t) {
    const Vector2d d = curve.derivative(t);
    return (std::atan2(d.y(), d.x()) - direction) / step;
  };
  double before = turn(0);
  for (int i = 1; i <= samples; ++i) {
    double after = turn(static_cast<double>(i) / samples);
    after += 2 * pi / step * std::round((before - after) * step / (2 * pi));
    const double low = std::min(before, after), high = std::max(before, after);
    for (double k = std::ceil(low - 1e-9); k < high - 1e-9; ++k)
      if (high > low) result.push_back((i - 1 + (k - before) / (after - before)) / samples);
    before = after;
  }
  return result;
}

CutPlaces candidates_of(const Profile& profile, const std::vector<Curve>& curves) {
  const std::vector<Vector2d> features = features_of(profile, curves);
  CutPlaces result(curves.size());
  for (std::size_t e = 0; e < curves.size(); ++e) {
    std::vector<double>& places = result[e];
    const Curve& curve = curves[e];
    if (!curve.straight()) places = places_of_directions(curve, 0, pi / 12);
    if (!curve.closed()) places.insert(places.end(), {0.25, 1.0 / 3, 0.5, 2.0 / 3, 0.75});
    places.erase(std::remove_if(places.begin(), places.end(),
                                [&](double at) { return !curve.closed() && (at <= 0.03 || at >= 0.97); }),
                 places.end());
    enter_feet(curve, features, places);
    for (double& at : places) at = curve.closed() ? at - std::floor(at) : at;
    std::sort(places.begin(), places.end());
    std::vector<double> kept;
    for (const double at : places)
      if (kept.empty() || at - kept.back() > 0.004) kept.push_back(at);
    places = kept;
  }
  return result;
}

}  // namespace isopatch::segmentation::planar
