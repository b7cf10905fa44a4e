#include "geometry/part_box.hpp"

#include <algorithm>
#include <vector>

#include "geometry/splines/grid.hpp"

namespace isopatch::geometry {
namespace {

struct SampledFace {
  NurbsSurface surface;
  GridParameters<2> grid;
  Eigen::Matrix3Xd points;
};

SampledFace sampled(NurbsSurface surface) {
  SampledFace result{std::move(surface), {}, {}};
  for (int d = 0; d < 2; ++d) {
    const std::vector<double> breaks = result.surface.knots(d).breaks();
    const int pieces = 2 * result.surface.degree(d);
    auto& along = result.grid[static_cast<std::size_t>(d)];
    for (std::size_t e = 0; e + 1 < breaks.size(); ++e)
      for (int i = 0; i < pieces; ++i) along.push_back(breaks[e] + (breaks[e + 1] - breaks[e]) * i / pieces);
    along.push_back(breaks.back());
  }
  result.points = points_on_grid(result.surface, result.grid);
  return result;
}

// Climbs from a point of the grid as far as the surface goes in direction `sign` of an axis.
double furthest(const SampledFace& face, Eigen::Index start, int axis, double sign) {
  const auto count = static_cast<Eigen::Index>(face.grid[0].size());
  Parameter<2> here(face.grid[0][static_cast<std::size_t>(start % count)],
                    face.grid[1][static_cast<std::size_t>(start / count)]);
  const Parameter<2> low = face.surface.low(), high = face.surface.high();
  const Parameter<2> range = high - low;
  Parameter<2> step(range[0] / static_cast<double>(face.grid[0].size()),
                    range[1] / static_cast<double>(face.grid[1].size()));
  double best = sign * face.points(axis, start);
  // The value is flat where it is largest: a parameter good to 1e-7 is enough for round-off.
  while ((step.array() > 1e-7 * range.array()).any()) {
    bool moved = false;
    const Parameter<2> centre = here;
    for (const double u : {-1.0, 0.0, 1.0})
      for (const double v : {-1.0, 0.0, 1.0}) {
        const Parameter<2> there =
            (centre + step.cwiseProduct(Parameter<2>(u, v))).cwiseMax(low).cwiseMin(high);
        const double value = sign * face.surface.point(there)[axis];
        if (!(value > best)) continue;
        best = value;
        here = there;
        moved = true;
      }
    if (!moved) step *= 0.5;
  }
  return best;
}

double extreme(const std::vector<SampledFace>& faces, int axis, double sign) {
  constexpr double between = 0.05;  // of a face's extent: how far it may bulge beyond its grid
  double best = sign * faces.front().points(axis, 0);
  for (const SampledFace& face : faces) best = std::max(best, (sign * face.points.row(axis)).maxCoeff());
  for (const SampledFace& face : faces) {
    const Eigen::RowVectorXd values = sign * face.points.row(axis);
    Eigen::Index start = 0;
    const double own = values.maxCoeff(&start);
    const double hull = (sign * face.surface.control_points().row(axis)).maxCoeff();
    if (hull <= best || own + between * (own - values.minCoeff()) < best) continue;
    best = std::max(best, furthest(face, start, axis, sign));
  }
  return sign * best;
}

}  // namespace

Eigen::AlignedBox3d part_box(const MultiPatch& model) {
  std::vector<SampledFace> faces;
  for (const PatchFace& face : model.boundary_faces())
    faces.push_back(sampled(face_surface(model.patch(face.patch), face.side)));
  Eigen::AlignedBox3d result;
  if (faces.empty()) return result;
  for (int axis = 0; axis < 3; ++axis) {
    result.min()[axis] = extreme(faces, axis, -1);
    result.max()[axis] = extreme(faces, axis, 1);
  }
  return result;
}

}  // namespace isopatch::geometry
