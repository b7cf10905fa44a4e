#include "geometry/models/sphere.hpp"

#include <array>
#include <cmath>

#include "geometry/models/check_option.hpp"
#include "geometry/models/model_builder.hpp"
#include "geometry/splines/arc.hpp"
#include "geometry/splines/sweep.hpp"

namespace isopatch::geometry {
namespace {

constexpr const char* sphere_model_name = "sphere";

// Bernstein coefficients of a polynomial in two variables, (degree + 1, degree + 1).
using Biquadratic = Eigen::Matrix3d;
using Biquartic = Eigen::Matrix<double, 5, 5>;

Biquartic product(const Biquadratic& a, const Biquadratic& b) {
  constexpr std::array<double, 3> two = {1, 2, 1};         // binomials of 2
  constexpr std::array<double, 5> four = {1, 4, 6, 4, 1};  // and of 4
  Biquartic result = Biquartic::Zero();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      for (int k = 0; k < 3; ++k)
        for (int l = 0; l < 3; ++l)
          result(i + k, j + l) +=
              two[i] * two[j] * two[k] * two[l] / (four[i + k] * four[j + l]) * a(i, j) * b(k, l);
  return result;
}

// A planar rational map in homogeneous form: point = (y, z) / w.
struct PlanarMap {
  Biquadratic y;
  Biquadratic z;
  Biquadratic w;
};

// The patch about the x axis projected from (-1, 0, 0) onto the plane x = 0. The coordinate planes become the
// axes; the planes x = y and x = z become the circles of radius sqrt(2) about (-1, 0) and (0, -1), of which
// the patch takes 15 degrees each, from (tan 22.5, 0) and (0, tan 22.5) to the image of the direction (1, 1,
// 1).
PlanarMap projected_patch() {
  const NurbsCurve along_xy = arc({-1, 0, 0}, std::sqrt(2.0), Angle(), Angle::degrees(15));
  const Eigen::Matrix3Xd& p = along_xy.control_points();
  const double middle = along_xy.weights()[1];
  const double pole = p(0, 0);
  Eigen::Matrix3d y;
  Eigen::Matrix3d z;
  Eigen::Matrix3d w;
  y << 0, 0, 0, 0.5 * pole, 0, middle * p(1, 1), pole, middle * p(0, 1), p(0, 2);
  w << 1, 1, 1, 1, 0, middle, 1, middle, 1;
  // The inner point is that of Coons: opposite sides' means added, the corners' mean taken away.
  const auto fill = [](Eigen::Matrix3d& m) {
    m(1, 1) = 0.5 * (m(0, 1) + m(2, 1) + m(1, 0) + m(1, 2)) - 0.25 * (m(0, 0) + m(2, 0) + m(0, 2) + m(2, 2));
  };
  fill(y);
  fill(w);
  z = y.transpose();
  return {y, z, w};
}

// The patch of the unit sphere about the x axis, u along y and v along z, in homogeneous coordinates.
NurbsSurface unit_patch() {
  const auto [y, z, w] = projected_patch();
  const Biquartic square = product(w, w);
  const Biquartic distance = product(y, y) + product(z, z);
  const std::array<Biquartic, 4> sphere = {square - distance, 2 * product(y, w), 2 * product(z, w),
                                           square + distance};
  Eigen::Matrix4Xd homogeneous(4, 25);
  for (Eigen::Index row = 0; row < 4; ++row)
    homogeneous.row(row) = sphere[static_cast<std::size_t>(row)].reshaped().transpose();
  const KnotVector knots = KnotVector::bezier(4);
  return NurbsSurface::from_homogeneous({knots, knots}, homogeneous);
}

// The patch about axis 0, 1 or 2, scaled to a radius: coordinates exchanged in a cycle.
NurbsSurface patch_about(const NurbsSurface& unit, int axis, double radius) {
  Eigen::Matrix3Xd points(3, unit.size());
  for (int d = 0; d < 3; ++d) points.row((d + axis) % 3) = radius * unit.control_points().row(d);
  return NurbsSurface(unit.knots(), points, unit.weights());
}

}  // namespace

void validate(const SphereOptions& options) {
  check_length(sphere_model_name, "inner_radius", options.inner_radius);
  check_length(sphere_model_name, "outer_radius", options.outer_radius);
  check_below(sphere_model_name, "inner_radius", options.inner_radius, "outer_radius", options.outer_radius);
  check_count(sphere_model_name, "radial_patches", options.radial_patches);
}

PatchSet sphere_model(const SphereOptions& options) {
  validate(options);
  constexpr std::array<std::string_view, 3> planes = {"x0", "y0", "z0"};
  const NurbsSurface unit = unit_patch();
  const auto radius = [&](int layer) {
    const double share = static_cast<double>(layer) / options.radial_patches;
    return (1 - share) * options.inner_radius + share * options.outer_radius;
  };
  ModelBuilder builder;
  for (int layer = 0; layer < options.radial_patches; ++layer)
    for (int axis = 0; axis < 3; ++axis) {
      const NurbsVolume patch =
          ruled(patch_about(unit, axis, radius(layer)), patch_about(unit, axis, radius(layer + 1)));
      // u = 0 lies in the plane normal to the axis that u runs along.
      std::vector<std::pair<Side, std::string_view>> names = {
          {Side::west, planes[static_cast<std::size_t>((axis + 1) % 3)]},
          {Side::south, planes[static_cast<std::size_t>((axis + 2) % 3)]}};
      if (layer == 0) names.emplace_back(Side::front, "inner");
      if (layer + 1 == options.radial_patches) names.emplace_back(Side::back, "outer");
      builder.add(patch, names);
    }
  for (int layer = 0; layer < options.radial_patches; ++layer)
    for (int axis = 0; axis < 3; ++axis)
      builder.join({PatchId(3 * layer + axis), Side::east},
                   {PatchId(3 * layer + (axis + 1) % 3), Side::north});
  for (int axis = 0; axis < 3; ++axis) builder.join_row(axis, 3, options.radial_patches, 2);
  return builder.patches();
}

}  // namespace isopatch::geometry
