#include "iga/output/internal/grid_fields.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cstdint>

#include "geometry/scaled_jacobian.hpp"
#include "geometry/splines/basis.hpp"
#include "iga/internal/dense_along.hpp"
#include "iga/internal/parallel_for.hpp"
#include "iga/material/internal/point_fields.hpp"
#include "iga/post/stress_measures.hpp"

namespace isopatch::iga {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// Functions of one direction at its parameters, (parameters, functions).
struct Line {
  MatrixXd values;
  MatrixXd derivatives;
};

Line line(const geometry::KnotVector& knots, const std::vector<double>& parameters) {
  const auto rows = static_cast<Index>(parameters.size());
  Line result{MatrixXd::Zero(rows, knots.size()), MatrixXd::Zero(rows, knots.size())};
  for (Index i = 0; i < rows; ++i) {
    const geometry::BasisValues b = geometry::basis(knots, parameters[static_cast<std::size_t>(i)], 1);
    result.values.row(i).segment(b.first, b.values.cols()) = b.values.row(0);
    result.derivatives.row(i).segment(b.first, b.values.cols()) = b.values.row(1);
  }
  return result;
}

// A scalar spline on the grid: its values, and its derivatives along the three directions, as columns.
Eigen::MatrixX4d on_grid(const VectorXd& coefficients, const std::array<int, 3>& functions,
                         const std::array<Line, 3>& lines) {
  const auto along = [&](const std::array<bool, 3>& differentiated) {
    VectorXd values = coefficients;
    std::array<int, 3> sizes = functions;
    for (int d = 0; d < 3; ++d) {
      const auto& [value, derivative] = lines[static_cast<std::size_t>(d)];
      values = apply_dense_along(values, sizes, d,
                                 differentiated[static_cast<std::size_t>(d)] ? derivative : value);
    }
    return values;
  };
  const VectorXd values = along({false, false, false});
  Eigen::MatrixX4d result(values.size(), 4);
  result.col(0) = values;
  result.col(1) = along({true, false, false});
  result.col(2) = along({false, true, false});
  result.col(3) = along({false, false, true});
  return result;
}

// Three homogeneous components over their weight function: the value, then a column per derivative.
struct Rational {
  std::array<Eigen::MatrixX4d, 3> components;

  Vector3d value(Index point, const Eigen::MatrixX4d& weight) const {
    return Vector3d(components[0](point, 0), components[1](point, 0), components[2](point, 0)) /
           weight(point, 0);
  }
  Matrix3d derivatives(Index point, const Eigen::MatrixX4d& weight) const {
    const Vector3d here = value(point, weight);
    Matrix3d result;
    for (int c = 0; c < 3; ++c)
      result.row(c) = (components[static_cast<std::size_t>(c)].row(point).tail<3>() -
                       here[c] * weight.row(point).tail<3>()) /
                      weight(point, 0);
    return result;
  }
};

Rational rational_on_grid(const Eigen::Matrix3Xd& coefficients, const geometry::NurbsVolume& patch,
                          const std::array<Line, 3>& lines) {
  Rational result;
  for (int c = 0; c < 3; ++c)
    result.components[static_cast<std::size_t>(c)] =
        on_grid(coefficients.row(c).transpose().cwiseProduct(patch.weights()), patch.sizes(), lines);
  return result;
}

// Below this scaled Jacobian the map counts as singular: a gradient through it has no digits left.
constexpr double singular = 1e-9;

}  // namespace

PatchSamples fields_on_grid(const SampledPatch& sampled,
                            const std::array<std::vector<double>, 3>& parameters) {
  const geometry::NurbsVolume& patch = *sampled.patch;
  std::array<Line, 3> lines;
  for (int d = 0; d < 3; ++d)
    lines[static_cast<std::size_t>(d)] = line(patch.knots(d), parameters[static_cast<std::size_t>(d)]);
  const Eigen::MatrixX4d weight = on_grid(patch.weights(), patch.sizes(), lines);
  const Rational place = rational_on_grid(patch.control_points(), patch, lines);
  const Index count = weight.rows();
  const bool solved = sampled.field != nullptr;
  const auto p = static_cast<std::size_t>(sampled.index);
  Rational displacement;
  if (solved) displacement = rational_on_grid(sampled.field->displacement[p], patch, lines);
  PatchSamples result;
  result.parameters = parameters;
  result.points.resize(3, count);
  result.scaled_jacobian.resize(count);
  result.displacements.resize(3, solved ? count : 0);
  result.von_mises.resize(solved ? count : 0);
  result.stress.resize(6, solved ? count : 0);
  result.principal.resize(3, solved ? count : 0);
  const ThermalStrain thermal = solved ? sampled.field->thermal_strain(p) : ThermalStrain{};
  const std::array<int, 3> sizes = result.sizes();
  const auto at = [&](Index point) {
    return geometry::Parameter<3>(parameters[0][static_cast<std::size_t>(point % sizes[0])],
                                  parameters[1][static_cast<std::size_t>(point / sizes[0] % sizes[1])],
                                  parameters[2][static_cast<std::size_t>(point / sizes[0] / sizes[1])]);
  };
  constexpr Index piece = 1024;
  parallel_for((count + piece - 1) / piece, [&](std::int64_t task, int) {
    for (Index i = task * piece; i < std::min(count, (task + 1) * piece); ++i) {
      const Matrix3d jacobian = place.derivatives(i, weight);
      result.points.col(i) = place.value(i, weight);
      result.scaled_jacobian[i] = geometry::scaled_jacobian(jacobian);
      if (!solved) continue;
      result.displacements.col(i) = displacement.value(i, weight);
      const Matrix3d stress =
          std::abs(result.scaled_jacobian[i]) < singular
              ? evaluate(*sampled.field, sampled.index, at(i)).stress
              : stress_of_gradient(displacement.derivatives(i, weight) * jacobian.inverse(),
                                   sampled.field->materials[p], thermal.at(result.points.col(i)));
      result.stress.col(i) << stress(0, 0), stress(1, 1), stress(2, 2), stress(0, 1), stress(1, 2),
          stress(2, 0);
      result.von_mises[i] = von_mises(stress);
      result.principal.col(i) = principal_values(stress);
    }
  });
  return result;
}

}  // namespace isopatch::iga
