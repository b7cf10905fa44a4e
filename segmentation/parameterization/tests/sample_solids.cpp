#include "segmentation/parameterization/tests/sample_solids.hpp"

#include <cmath>
#include <memory>
#include <numbers>
#include <random>

#include "segmentation/parameterization/coons.hpp"

namespace isopatch::segmentation::test {
namespace {

constexpr double pi = std::numbers::pi;

DomainCurve line(const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return [=](double t) -> Eigen::Vector2d { return (1 - t) * from + t * to; };
}

Eigen::Vector3d corner_point(int corner) {
  return {double(corner & 1), double(corner >> 1 & 1), double(corner >> 2 & 1)};
}

/// A face with the frame of a side and the unit square as its domain.
SolidFace square_face(Side side, DomainSurface surface) {
  return {
      "side " + std::string(geometry::name(side)),
      {side_corner(side, 0, 0), side_corner(side, 1, 0), side_corner(side, 1, 1), side_corner(side, 0, 1)},
      {line({0, 0}, {1, 0}), line({1, 0}, {1, 1}), line({1, 1}, {0, 1}), line({0, 1}, {0, 0})},
      std::move(surface)};
}

Eigen::Vector3d on_side(Side side, const Eigen::Vector2d& uv) {
  Eigen::Vector3d p;
  const auto along = geometry::tangents(side);
  p[geometry::direction(side)] = geometry::is_high(side) ? 1 : 0;
  p[along[0]] = uv[0];
  p[along[1]] = uv[1];
  return p;
}

}  // namespace

HexSolid mapped_cube(const std::string& name,
                     const std::function<Eigen::Vector3d(const Eigen::Vector3d&)>& map) {
  HexSolid solid;
  solid.name = name;
  for (int c = 0; c < 8; ++c) solid.vertices.push_back(map(corner_point(c)));
  for (const Side side : geometry::all_sides)
    solid.faces.push_back(square_face(
        side, [=](const Eigen::Vector2d& uv) -> Eigen::Vector3d { return map(on_side(side, uv)); }));
  return solid;
}

HexSolid quarter_tube() {
  return mapped_cube("quarter tube", [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    const double r = 1 + p[0], a = pi / 2 * p[1];
    return {r * std::cos(a), r * std::sin(a), 1.5 * p[2]};
  });
}

HexSolid twisted_bar() {
  return mapped_cube("twisted bar", [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    const double a = 2 * pi / 3 * p[2], x = p[0] - 0.5, y = p[1] - 0.5;
    return {x * std::cos(a) - y * std::sin(a), x * std::sin(a) + y * std::cos(a), 4 * p[2]};
  });
}

HexSolid hilly_cube() {
  return mapped_cube("hilly cube", [](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    const double hill = 0.3 * std::sin(pi * p[0]) * std::sin(pi * p[1]) + 0.1 * std::sin(2 * pi * p[0]);
    return {p[0], p[1], p[2] * (1 + hill)};
  });
}

HexSolid trimmed_slab() {
  constexpr double height = 0.4, hump = 0.38;
  const auto bump = [](double t) { return hump * std::pow(std::sin(pi * t), 2); };
  const std::array<DomainCurve, 4> sides{[=](double s) -> Eigen::Vector2d {
                                           return {s, bump(s)};
                                         },
                                         line({0, 1}, {1, 1}),
                                         [=](double t) -> Eigen::Vector2d {
                                           return {bump(t), t};
                                         },
                                         line({1, 0}, {1, 1})};
  HexSolid solid;
  solid.name = "trimmed slab";
  for (int c = 0; c < 8; ++c)
    solid.vertices.push_back(corner_point(c).cwiseProduct(Eigen::Vector3d(1, 1, height)));
  const auto reversed = [](DomainCurve curve) { return [=](double t) { return curve(1 - t); }; };
  for (const Side side : geometry::all_sides) {
    SolidFace face = square_face(side, {});
    if (geometry::direction(side) == 2) {
      const double z = side == Side::back ? height : 0;
      face.surface = [=](const Eigen::Vector2d& uv) -> Eigen::Vector3d { return {uv[0], uv[1], z}; };
      face.curves = {sides[0], sides[3], reversed(sides[1]), reversed(sides[2])};
    } else {
      const DomainCurve wall = sides[side == Side::south   ? 0
                                     : side == Side::north ? 1
                                     : side == Side::west  ? 2
                                                           : 3];
      face.surface = [=](const Eigen::Vector2d& uv) -> Eigen::Vector3d {
        const Eigen::Vector2d p = wall(uv[0]);
        return {p[0], p[1], height * uv[1]};
      };
    }
    solid.faces.push_back(face);
  }
  return solid;
}

HexSolid straight(const std::string& name, const std::array<Eigen::Vector3d, 8>& corners) {
  return mapped_cube(name, [=](const Eigen::Vector3d& p) -> Eigen::Vector3d {
    Eigen::Vector3d sum(0, 0, 0);
    for (int c = 0; c < 8; ++c) {
      const Eigen::Vector3d q = corner_point(c);
      double weight = 1;
      for (int d = 0; d < 3; ++d) weight *= q[d] > 0 ? p[d] : 1 - p[d];
      sum += weight * corners[static_cast<std::size_t>(c)];
    }
    return sum;
  });
}

HexSolid random_hexahedron(std::uint32_t seed, double amount) {
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
  const auto volume = std::make_shared<const geometry::NurbsVolume>(all, net);
  return mapped_cube("random " + std::to_string(seed),
                     [=](const Eigen::Vector3d& p) -> Eigen::Vector3d { return volume->point(p); });
}

}  // namespace isopatch::segmentation::test
