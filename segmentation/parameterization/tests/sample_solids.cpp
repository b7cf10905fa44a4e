#include "segmentation/parameterization/tests/sample_solids.hpp"

#include <Eigen/LU>
#include <cmath>
#include <numbers>
#include <random>
#include <vector>

#include "geometry/brep/make_brep.hpp"
#include "geometry/models/cylinder.hpp"
#include "geometry/patch_face.hpp"
#include "geometry/splines/grid.hpp"
#include "geometry/splines/tensor.hpp"
#include "segmentation/parameterization/tests/spline_blocks.hpp"

namespace isopatch::segmentation::test {
namespace {

constexpr double pi = std::numbers::pi;

Eigen::Vector3d corner_point(int corner) {
  return {double(corner & 1), double(corner >> 1 & 1), double(corner >> 2 & 1)};
}

}  // namespace

geometry::BrepFile solid_of(const std::string& name, const geometry::NurbsVolume& volume) {
  return {solid_of(volume), name};
}

geometry::NurbsVolume interpolated(const std::array<geometry::KnotVector, 3>& knots, const Map& map) {
  geometry::NurbsVolume samples = bent(knots, map);
  Eigen::Matrix3Xd points = samples.control_points();
  for (int d = 0; d < 3; ++d) {
    const geometry::KnotVector& along = knots[static_cast<std::size_t>(d)];
    const Eigen::MatrixXd basis(geometry::collocation(along, along.greville()));
    points = geometry::apply_along<3>(points, samples.sizes(), d, Eigen::MatrixXd(basis.inverse()));
  }
  return {knots, points};
}

geometry::BrepFile mapped_cube(const std::string& name, const Map& map) {
  // Of a degree above the patches', so that these have to be fitted.
  const auto knots = geometry::KnotVector::uniform(5, 8);
  return solid_of(name, interpolated({knots, knots, knots}, map));
}

geometry::BrepFile quarter_tube() {
  const geometry::CylinderOptions options{.inner_radius = 1, .outer_radius = 2, .height = 1.5};
  return solid_of("quarter tube", geometry::cylinder_model(options).patches[0]);
}

geometry::BrepFile twisted_bar() {
  return mapped_cube("twisted bar", [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    const double a = 2 * pi / 3 * p[2], x = p[0] - 0.5, y = p[1] - 0.5;
    return {x * std::cos(a) - y * std::sin(a), x * std::sin(a) + y * std::cos(a), 4 * p[2]};
  });
}

geometry::BrepFile hilly_cube() {
  return mapped_cube("hilly cube", [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    const double hill = 0.3 * std::sin(pi * p[0]) * std::sin(pi * p[1]) + 0.1 * std::sin(2 * pi * p[0]);
    return {p[0], p[1], p[2] * (1 + hill)};
  });
}

geometry::BrepFile trimmed_slab() {
  const auto hump = [](double t) { return 0.38 * std::pow(std::sin(pi * t), 2); };
  const auto knots = geometry::KnotVector::uniform(3, 16);
  return {slab_between(outline_curve(knots, [&](double s) { return Eigen::Vector2d(s, hump(s)); }),
                       outline_curve(knots, [](double s) { return Eigen::Vector2d(s, 1); }),
                       outline_curve(knots, [&](double t) { return Eigen::Vector2d(hump(t), t); }),
                       outline_curve(knots, [](double t) { return Eigen::Vector2d(1, t); }), 0.4),
          "trimmed slab"};
}

geometry::BrepFile straight(const std::string& name, const std::array<Eigen::Vector3d, 8>& corners) {
  Eigen::Matrix3Xd net(3, 8);
  for (int c = 0; c < 8; ++c) net.col(c) = corners[static_cast<std::size_t>(c)];
  const geometry::KnotVector line;
  return solid_of(name, {{line, line, line}, net});
}

geometry::BrepFile brick(const std::string& name, const Eigen::Vector3d& low, const Eigen::Vector3d& size) {
  std::array<Eigen::Vector3d, 8> corners;
  for (int c = 0; c < 8; ++c) corners[static_cast<std::size_t>(c)] = low + size.cwiseProduct(corner_point(c));
  return straight(name, corners);
}

geometry::BrepFile random_hexahedron(std::uint32_t seed, double amount) {
  std::mt19937 random(seed);
  const auto number = [&] { return 2.0 * random() / 4294967295.0 - 1; };
  const auto knots = geometry::KnotVector::bezier(3);
  const std::array<geometry::KnotVector, 3> all{knots, knots, knots};
  Eigen::Matrix3Xd net(3, 64);
  for (Eigen::Index i = 0; i < 64; ++i)
    net.col(i) = Eigen::Vector3d(double(i % 4), double(i / 4 % 4), double(i / 16)) / 3;
  std::array<Eigen::Vector3d, 8> shift;
  for (auto& vector : shift) vector = amount * Eigen::Vector3d(number(), number(), number());
  for (Eigen::Index i = 0; i < 64; ++i) {
    const Eigen::Vector3d at = net.col(i);
    int ends = 0;
    for (int d = 0; d < 3; ++d) ends += at[d] == 0 || at[d] == 1;
    Eigen::Vector3d move(0, 0, 0);
    for (int c = 0; c < 8; ++c) {
      double weight = 1;
      for (int d = 0; d < 3; ++d) weight *= corner_point(c)[d] > 0 ? at[d] : 1 - at[d];
      move += weight * shift[static_cast<std::size_t>(c)];
    }
    // Edges and faces are displaced half as far, which bends them.
    if (ends < 3) move += 0.5 * amount * Eigen::Vector3d(number(), number(), number());
    net.col(i) += move;
  }
  return solid_of("random " + std::to_string(seed), {all, net});
}

}  // namespace isopatch::segmentation::test
