#include "segmentation/sweeps/internal/column_volume.hpp"

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "geometry/base/adaptive_integral.hpp"
#include "geometry/base/error.hpp"
#include "geometry/brep/require_solid.hpp"

namespace isopatch::segmentation {
namespace {

/// Areas of quadrilaterals at heights, by Green's theorem along their sides.
class Areas {
 public:
  Areas(const SweepFrame& frame, const Quadrangulation& quads, const MovingDrawing& moving)
      : frame_(frame), quads_(quads), moving_(moving) {}

  double operator()(std::size_t quad, double height) {
    double area = 0;
    for (const geometry::EdgeUse& side : quads_.quads[quad].sides) {
      const auto [known, fresh] = along_.try_emplace({side.edge.value, height}, 0);
      if (fresh) known->second = integral(moving_.curve(side.edge.value, height));
      area += side.reversed ? -known->second : known->second;
    }
    return area;
  }

 private:
  /// Of x dy.
  double integral(const geometry::NurbsCurve& curve) const {
    const auto integrand = [&](int, double t) -> Eigen::Array<double, 1, 1> {
      const geometry::Parameter<1> at(t);
      const Eigen::Vector3d way = curve.jacobian(at);
      return Eigen::Array<double, 1, 1>(frame_.flat(curve.point(at)).x() * way.dot(frame_.y));
    };
    std::vector<Stretch> stretches;
    const std::vector<double> breaks = curve.knots(0).breaks();
    for (std::size_t i = 1; i < breaks.size(); ++i) stretches.push_back({0, breaks[i - 1], breaks[i]});
    const double enough =
        1e-9 * (curve.control_points().rowwise().maxCoeff() - curve.control_points().rowwise().minCoeff())
                   .squaredNorm();
    const auto allowed = [&](const auto&) { return Eigen::Array<double, 1, 1>(enough); };
    constexpr int most_evaluations = 2000;
    AdaptiveIntegral<1> integrate;
    return integrate(integrand, stretches, allowed, most_evaluations).value(0);
  }

  const SweepFrame& frame_;
  const Quadrangulation& quads_;
  const MovingDrawing& moving_;
  std::map<std::pair<int, double>, double> along_;  // by edge and height
};

}  // namespace

namespace {

/// What may be the reason, and what can be done; "" where all walls are upright.
std::string leaning(const geometry::Brep& solid, const SweepFrame& frame) {
  if (frame.inclined.empty()) return {};
  std::string faces;
  for (const FaceId face : frame.inclined) faces += (faces.empty() ? "" : ", ") + describe(solid, face);
  return fmt::format(
      ", since inclined walls lean over others or end on them: {}; a [[segmentation.cut]] where they do may "
      "help",
      faces);
}

}  // namespace

double column_volume(const SweepFrame& frame, const Quadrangulation& quads, const MovingDrawing& moving,
                     const Layers& layers) {
  Areas area(frame, quads, moving);
  double volume = 0;
  for (std::size_t q = 0; q < quads.quads.size(); ++q)
    for (const Layer& layer : layers.columns[q]) {
      const double low = layers.levels[static_cast<std::size_t>(layer.low)],
                   high = layers.levels[static_cast<std::size_t>(layer.high)];
      // Sides move in proportion to the height, so areas are quadratic in it.
      volume += (high - low) / 6 * (area(q, low) + 4 * area(q, (low + high) / 2) + area(q, high));
    }
  return volume;
}

void require_whole(const geometry::Brep& solid, const SweepFrame& frame, const Quadrangulation& quads,
                   const MovingDrawing& moving, const Layers& layers) {
  const double volume = column_volume(frame, quads, moving, layers);
  if (!(std::abs(volume - solid.volume()) <= 1e-5 * solid.volume()))
    throw Error(ErrorCode::unsupported, fmt::format("columns along it would have {:.4g} of its {:.4g} m^3{}",
                                                    volume, solid.volume(), leaning(solid, frame)));
}

}  // namespace isopatch::segmentation
