#include "segmentation/parameterization/tests/spline_blocks.hpp"

#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/brep/make_brep.hpp"
#include "geometry/patch_face.hpp"
#include "geometry/splines/grid.hpp"

namespace isopatch::segmentation::test {
namespace {

using geometry::KnotVector;
using geometry::NurbsCurve;
using geometry::NurbsSurface;
using geometry::TrimmedSurface;

NurbsCurve spline_line(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Zero(3, 2);
  points.col(0).head<2>() = from;
  points.col(1).head<2>() = to;
  return {{KnotVector()}, points};
}

TrimmedSurface untrimmed(const NurbsSurface& surface) {
  const Eigen::Vector2d a = surface.low(), c = surface.high(), b(c[0], a[1]), d(a[0], c[1]);
  return {"", surface, {{spline_line(a, b), spline_line(b, c), spline_line(c, d), spline_line(d, a)}}};
}

/// The parallelogram with a corner and two sides.
NurbsSurface plane(const Eigen::Vector3d& corner, const Eigen::Vector3d& along,
                   const Eigen::Vector3d& across) {
  Eigen::Matrix3Xd points(3, 4);
  points << corner, corner + along, corner + across, corner + along + across;
  return {{KnotVector(), KnotVector()}, points};
}

}  // namespace

geometry::Brep solid_of(const geometry::NurbsVolume& volume) {
  std::vector<TrimmedSurface> faces;
  for (const geometry::Side side : geometry::all_sides)
    faces.push_back(untrimmed(geometry::face_surface(volume, side)));
  return geometry::sew(faces).brep;
}

geometry::NurbsVolume bent(const std::array<KnotVector, 3>& knots,
                           const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& map) {
  std::array<std::vector<double>, 3> at;
  for (std::size_t d = 0; d < 3; ++d) at[d] = rescaled(knots[d], 0, 1).greville();
  Eigen::Matrix3Xd points(3, Eigen::Index(knots[0].size()) * knots[1].size() * knots[2].size());
  Eigen::Index column = 0;
  for (const double w : at[2])
    for (const double v : at[1])
      for (const double u : at[0]) points.col(column++) = map({u, v, w});
  return {knots, points};
}

geometry::NurbsCurve outline_curve(const KnotVector& knots,
                                   const std::function<Eigen::Vector2d(double)>& map) {
  const std::vector<double> at = knots.greville();
  Eigen::MatrixXd points(static_cast<Eigen::Index>(at.size()), 2);
  for (std::size_t i = 0; i < at.size(); ++i)
    points.row(static_cast<Eigen::Index>(i)) = map(at[i]).transpose();
  const Eigen::MatrixXd basis(geometry::collocation(knots, at));
  Eigen::Matrix3Xd net = Eigen::Matrix3Xd::Zero(3, points.rows());
  net.topRows<2>() = solve_by_lu(basis, points).transpose();
  return {{knots}, net};
}

geometry::Brep slab_between(const NurbsCurve& south, const NurbsCurve& north, const NurbsCurve& west,
                            const NurbsCurve& east, double height) {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                        up = height * Eigen::Vector3d::UnitZ();
  const auto backwards = [](const NurbsCurve& curve) {
    return NurbsCurve({reversed(curve.knots(0))}, curve.control_points().rowwise().reverse());
  };
  const std::vector<NurbsCurve> loop = {south, east, backwards(north), backwards(west)};
  const auto wall = [&](const NurbsCurve& curve) {
    Eigen::Matrix3Xd points(3, 2 * curve.control_points().cols());
    points << curve.control_points(), curve.control_points().colwise() + up;
    return untrimmed(NurbsSurface({curve.knots(0), KnotVector()}, points));
  };
  return geometry::sew({TrimmedSurface{"", plane(Eigen::Vector3d::Zero(), x, y), {loop}},
                        TrimmedSurface{"", plane(up, x, y), {loop}}, wall(south), wall(north), wall(west),
                        wall(east)})
      .brep;
}

geometry::Brep wavy_top_over_planes(const KnotVector& knots) {
  constexpr double width = 2, depth = 1, height = 1;
  const std::vector<double> greville = rescaled(knots, 0, 1).greville();
  const int n = knots.size();
  Eigen::Matrix3Xd top(3, 2 * n), outline = Eigen::Matrix3Xd::Zero(3, n);
  for (int i = 0; i < n; ++i) {
    const double x = width * greville[static_cast<std::size_t>(i)];
    const double z = height + 0.2 * std::sin(3 * x) + 0.05 * x;
    top.col(i) << x, 0, z;
    top.col(n + i) << x, depth, z;
    outline.col(i) << x / width, z / 2, 0;  // in walls of height 2
  }
  const double left = outline(1, 0), right = outline(1, n - 1);
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                        z = Eigen::Vector3d::UnitZ();
  const NurbsCurve wave({knots}, outline);
  const auto wall = [&](double at) {
    return TrimmedSurface{"",
                          plane(at * y, width * x, 2 * z),
                          {{spline_line({1, right}, {1, 0}), spline_line({1, 0}, {0, 0}),
                            spline_line({0, 0}, {0, left}), wave}}};
  };
  return geometry::sew({untrimmed(NurbsSurface({knots, KnotVector()}, top)), wall(0), wall(depth),
                        untrimmed(plane(Eigen::Vector3d::Zero(), width * x, depth * y)),
                        untrimmed(plane(Eigen::Vector3d::Zero(), depth * y, 2 * left * z)),
                        untrimmed(plane(width * x, depth * y, 2 * right * z))})
      .brep;
}

Eigen::Vector3d helix(const Eigen::Vector3d& parameter, double turns) {
  const double angle = 2 * std::numbers::pi * turns * parameter[0], r = 1 + 0.2 * (parameter[1] - 0.5);
  return {r * std::cos(angle), r * std::sin(angle), 0.5 * turns * parameter[0] + 0.2 * parameter[2]};
}

}  // namespace isopatch::segmentation::test
