#include "iga/spaces/elastic_field.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/measures.hpp"
#include "geometry/splines/basis.hpp"
#include "geometry/splines/grid.hpp"

namespace isopatch::iga {
namespace {

using geometry::NurbsVolume;
using geometry::Parameter;

// Values and first derivatives along the parameters at one point.
struct FirstDerivatives {
  Eigen::Vector3d value = Eigen::Vector3d::Zero();
  Eigen::Matrix3d jacobian = Eigen::Matrix3d::Zero();
};

// First derivatives of place and displacement, from one evaluation of the basis.
std::array<FirstDerivatives, 2> first_derivatives(const NurbsVolume& patch,
                                                  const Eigen::Matrix3Xd& displacement,
                                                  const Parameter<3>& parameter) {
  std::array<geometry::BasisValues, 3> b;
  for (int d = 0; d < 3; ++d)
    b[static_cast<std::size_t>(d)] = geometry::basis(patch.knots(d), parameter[d], 1);
  // Row 0: weighted sums of place, displacement and 1; rows 1 to 3: their derivatives.
  Eigen::Matrix<double, 4, 7> sums = Eigen::Matrix<double, 4, 7>::Zero();
  for (Eigen::Index k = 0; k < b[2].values.cols(); ++k)
    for (Eigen::Index j = 0; j < b[1].values.cols(); ++j)
      for (Eigen::Index i = 0; i < b[0].values.cols(); ++i) {
        const Eigen::Index index =
            b[0].first + i + patch.size(0) * (b[1].first + j + patch.size(1) * (b[2].first + k));
        const double u = b[0].values(0, i), v = b[1].values(0, j), w = b[2].values(0, k);
        const Eigen::Vector4d factors(u * v * w, b[0].values(1, i) * v * w, u * b[1].values(1, j) * w,
                                      u * v * b[2].values(1, k));
        Eigen::Matrix<double, 1, 7> row;
        row << patch.control_points().col(index).transpose(), displacement.col(index).transpose(), 1.0;
        sums += factors * (patch.weights()[index] * row);
      }
  std::array<FirstDerivatives, 2> result;
  for (Eigen::Index which = 0; which < 2; ++which) {
    FirstDerivatives& out = result[static_cast<std::size_t>(which)];
    out.value = sums.block<1, 3>(0, 3 * which).transpose() / sums(0, 6);
    for (int d = 0; d < 3; ++d)
      out.jacobian.col(d) =
          (sums.block<1, 3>(1 + d, 3 * which).transpose() - sums(1 + d, 6) * out.value) / sums(0, 6);
  }
  return result;
}

bool is_singular(const Eigen::Matrix3d& jacobian) {
  return std::abs(jacobian.determinant()) <= 1e-10 * std::pow(jacobian.colwise().norm().maxCoeff(), 3);
}

Parameter<3> clamped(const NurbsVolume& patch, const Parameter<3>& parameter) {
  return parameter.cwiseMax(patch.low()).cwiseMin(patch.high());
}

// Gauss-Newton for the closest point, with the parameter kept in the domain and steps halved while they do
// not help.
Location closest(const NurbsVolume& patch, int index, const Eigen::Vector3d& place,
                 const Parameter<3>& start) {
  Location best{index, start, (patch.point(start) - place).norm()};
  for (int iteration = 0; iteration < 50; ++iteration) {
    const Eigen::Matrix3d jacobian = patch.jacobian(best.parameter);
    Parameter<3> step = jacobian.fullPivLu().solve(place - patch.point(best.parameter));
    // Directions that point out of the domain are dropped and the others solved for again.
    std::vector<int> kept;
    for (int d = 0; d < 3; ++d) {
      const double target = best.parameter[d] + step[d];
      const bool stuck = (best.parameter[d] <= patch.knots(d).first() && target < best.parameter[d]) ||
                         (best.parameter[d] >= patch.knots(d).last() && target > best.parameter[d]);
      if (!stuck) kept.push_back(d);
    }
    if (kept.empty()) break;
    if (kept.size() < 3) {
      Eigen::Matrix3d reduced = Eigen::Matrix3d::Zero();
      for (const int d : kept) reduced.col(d) = jacobian.col(d);
      step = Eigen::Matrix3d(reduced.transpose() * reduced)
                 .fullPivLu()
                 .solve(reduced.transpose() * (place - patch.point(best.parameter)));
    }
    bool moved = false;
    for (int halving = 0; halving < 12 && !moved; ++halving, step *= 0.5) {
      const Parameter<3> next = clamped(patch, best.parameter + step);
      const double distance = (patch.point(next) - place).norm();
      if (distance < best.distance) {
        best = {index, next, distance};
        moved = true;
      }
    }
    if (!moved) break;
  }
  return best;
}

// The nearest of a grid of points with two per element starts the iteration.
Location closest(const NurbsVolume& patch, int index, const Eigen::Vector3d& place) {
  Parameter<3> start = patch.low();
  std::array<std::vector<double>, 3> grid;
  for (int d = 0; d < 3; ++d) {
    const std::vector<double> breaks = patch.knots(d).breaks();
    for (std::size_t e = 0; e + 1 < breaks.size(); ++e)
      for (const double share : {0.25, 0.75})
        grid[static_cast<std::size_t>(d)].push_back(breaks[e] + share * (breaks[e + 1] - breaks[e]));
  }
  const Eigen::Matrix3Xd points = geometry::points_on_grid(patch, grid);
  Eigen::Index nearest = 0;
  (points.colwise() - place).colwise().squaredNorm().minCoeff(&nearest);
  for (std::size_t d = 0; d < 3; ++d) {
    const auto count = static_cast<Eigen::Index>(grid[d].size());
    start[static_cast<int>(d)] = grid[d][static_cast<std::size_t>(nearest % count)];
    nearest /= count;
  }
  return closest(patch, index, place, start);
}

}  // namespace

double von_mises(const Eigen::Matrix3d& stress) {
  const double a = stress(0, 0) - stress(1, 1), b = stress(1, 1) - stress(2, 2),
               c = stress(2, 2) - stress(0, 0);
  const double shear = stress(0, 1) * stress(0, 1) + stress(1, 0) * stress(1, 0) +
                       stress(1, 2) * stress(1, 2) + stress(2, 1) * stress(2, 1) +
                       stress(2, 0) * stress(2, 0) + stress(0, 2) * stress(0, 2);
  return std::sqrt(0.5 * (a * a + b * b + c * c) + 1.5 * shear);
}

FieldValues evaluate(const ElasticField& field, int patch, const Parameter<3>& parameter) {
  const auto p = static_cast<std::size_t>(patch);
  const NurbsVolume& volume = field.patches[p];
  const auto [place, displacement] = first_derivatives(volume, field.displacement[p], parameter);
  FieldValues values;
  values.place = place.value;
  values.displacement = displacement.value;
  values.jacobian = place.jacobian.determinant();
  Eigen::Matrix3d gradient;
  if (is_singular(place.jacobian)) {
    const Parameter<3> inside = parameter + 1e-3 * (0.5 * (volume.low() + volume.high()) - parameter);
    const auto [place_there, displacement_there] = first_derivatives(volume, field.displacement[p], inside);
    gradient = displacement_there.jacobian * place_there.jacobian.inverse();
  } else {
    gradient = displacement.jacobian * place.jacobian.inverse();
  }
  values.strain = 0.5 * (gradient + gradient.transpose());
  const double thermal = field.thermal_strain(p).at(values.place);
  values.stress = stress(values.strain - thermal * Eigen::Matrix3d::Identity(), field.materials[p]);
  values.von_mises = von_mises(values.stress);
  return values;
}

Location locate(const ElasticField& field, const Eigen::Vector3d& place) {
  Location best;
  best.distance = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < field.patches.size(); ++p) {
    const NurbsVolume& patch = field.patches[p];
    if (geometry::box(patch).exteriorDistance(place) > best.distance) continue;
    const Location found = closest(patch, static_cast<int>(p), place);
    if (found.distance < best.distance) best = found;
  }
  return best;
}

std::vector<Location> locate_sides(const ElasticField& field, const Eigen::Vector3d& place, double within) {
  std::vector<Location> result = {locate(field, place)};
  const auto is_new = [&](const Material& material) {
    return std::none_of(result.begin(), result.end(), [&](const Location& other) {
      return field.materials[static_cast<std::size_t>(other.patch)] == material;
    });
  };
  for (std::size_t p = 0; p < field.patches.size(); ++p) {
    if (!is_new(field.materials[p]) || geometry::box(field.patches[p]).exteriorDistance(place) > within)
      continue;
    const Location found = closest(field.patches[p], static_cast<int>(p), place);
    if (found.distance <= within) result.push_back(found);
  }
  return result;
}

}  // namespace isopatch::iga
