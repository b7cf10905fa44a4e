#include "segmentation/sweeps/internal/straight_wall.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "geometry/splines/sweep.hpp"

namespace isopatch::segmentation {

bool is_segment(const geometry::NurbsCurve& curve) {
  return curve.degree(0) == 1 && curve.size() == 2;
}

geometry::NurbsSurface straight_wall(const geometry::NurbsCurve& below, const geometry::NurbsCurve& above) {
  const std::vector<double>& known = below.knots(0).knots();
  std::vector<double> knots = above.knots(0).knots();
  for (double& knot : knots) {
    const auto nearest = std::min_element(known.begin(), known.end(), [&](double a, double b) {
      return std::abs(a - knot) < std::abs(b - knot);
    });
    if (std::abs(*nearest - knot) < 1e-9) knot = *nearest;
  }
  return geometry::ruled(below,
                         geometry::NurbsCurve({geometry::KnotVector(above.degree(0), std::move(knots))},
                                              above.control_points(), above.weights()));
}

}  // namespace isopatch::segmentation
