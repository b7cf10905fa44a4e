#include "geometry/brep/opencascade/internal/curve_length.hpp"

#include <GeomAdaptor_Curve.hxx>
#include <Standard_Failure.hxx>
#include <limits>

#include "geometry/base/adaptive_integral.hpp"
#include "geometry/brep/opencascade/internal/smooth_ranges.hpp"

namespace isopatch::geometry {
namespace {

using Values = Eigen::Array<double, 1, 1>;

constexpr int most_evaluations = 20000;

std::vector<Stretch> stretches_of(const std::vector<double>& ranges) {
  std::vector<Stretch> result;
  for (std::size_t i = 0; i + 1 < ranges.size(); ++i) result.push_back({0, ranges[i], ranges[i + 1]});
  return result;
}

}  // namespace

Measure curve_length(const Handle(Geom_Curve) & curve, double first, double last, double relative) {
  try {
    const GeomAdaptor_Curve adaptor(curve);
    const auto speed = [&](int, double t) {
      gp_Pnt p;
      gp_Vec d;
      adaptor.D1(t, p, d);
      return Values(d.Magnitude());
    };
    const auto allowed = [&](const Values& total) { return Values(relative * total); };
    AdaptiveIntegral<1> integrate;
    const auto found =
        integrate(speed, stretches_of(smooth_ranges(curve, first, last)), allowed, most_evaluations);
    return {found.value(0), found.error(0)};
  } catch (const Standard_Failure&) {
    return {0, std::numeric_limits<double>::infinity()};
  }
}

}  // namespace isopatch::geometry
