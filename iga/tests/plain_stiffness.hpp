#pragma once

#include <Eigen/Core>
#include <Eigen/LU>
#include <array>
#include <cmath>
#include <vector>

#include "geometry/quadrature.hpp"
#include "geometry/splines/basis.hpp"
#include "iga/assembly/stiffness_pattern.hpp"
#include "iga/material/material.hpp"
#include "iga/spaces/patch_space.hpp"
#include "solvers/block_matrix.hpp"

namespace isopatch::iga {

inline Eigen::MatrixXd dense(const solvers::SymmetricBlockMatrix& matrix) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(matrix.rows(), matrix.rows());
  for (int row = 0; row < matrix.block_rows(); ++row)
    for (auto at = matrix.row_start[static_cast<std::size_t>(row)];
         at < matrix.row_start[static_cast<std::size_t>(row) + 1]; ++at) {
      const int column = matrix.columns[static_cast<std::size_t>(at)];
      const Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>> block(
          &matrix.values[static_cast<std::size_t>(9 * at)]);
      result.block<3, 3>(3 * row, 3 * column) = block;
      result.block<3, 3>(3 * column, 3 * row) = block.transpose();
    }
  return result;
}

/// The functions of a space that live at a parameter: local indices and physical gradients, one column each.
struct PlainFunctions {
  std::vector<int> nodes;
  Eigen::Matrix3Xd gradients;
  double determinant = 0;
};

inline PlainFunctions functions_at(const PatchSpace& space, const geometry::Parameter<3>& at) {
  std::array<geometry::BasisValues, 3> one;
  for (int d = 0; d < 3; ++d)
    one[static_cast<std::size_t>(d)] = geometry::basis(space.knots[static_cast<std::size_t>(d)], at[d], 1);
  const auto& [u, v, w] = one;
  PlainFunctions result;
  const auto count = u.values.cols() * v.values.cols() * w.values.cols();
  Eigen::Matrix4Xd homogeneous(4, count);  // value and parametric gradient
  for (int k = 0, a = 0; k < w.values.cols(); ++k)
    for (int j = 0; j < v.values.cols(); ++j)
      for (int i = 0; i < u.values.cols(); ++i, ++a) {
        const int node = u.first + i + space.sizes()[0] * (v.first + j + space.sizes()[1] * (w.first + k));
        result.nodes.push_back(node);
        homogeneous.col(a) << u.values(0, i) * v.values(0, j) * w.values(0, k),
            u.values(1, i) * v.values(0, j) * w.values(0, k),
            u.values(0, i) * v.values(1, j) * w.values(0, k),
            u.values(0, i) * v.values(0, j) * w.values(1, k);
        if (space.is_rational()) homogeneous.col(a) *= space.weights[node];
      }
  Eigen::Matrix3Xd parametric = homogeneous.bottomRows<3>();
  if (space.is_rational()) {
    const Eigen::Vector4d total = homogeneous.rowwise().sum();
    parametric = (parametric - total.tail<3>() / total[0] * homogeneous.row(0)) / total[0];
  }
  const Eigen::Matrix3d jacobian = space.geometry->jacobian(at);
  result.determinant = jacobian.determinant();
  result.gradients = jacobian.inverse().transpose() * parametric;
  return result;
}

/// The slow and plain assembler: element by element, point by point, every ordered pair of functions adds its
/// block to the block of their rows. Dense.
inline Eigen::MatrixXd plain_stiffness(const std::vector<PatchSpace>& spaces,
                                       const std::vector<PatchLayers>& parts,
                                       const std::vector<Material>& materials, const RowNumbering& numbering,
                                       int points = 0) {
  Eigen::MatrixXd result = Eigen::MatrixXd::Zero(3 * numbering.rows, 3 * numbering.rows);
  for (const PatchLayers& part : parts) {
    const PatchSpace& space = spaces[static_cast<std::size_t>(part.patch)];
    const Material& material = materials[static_cast<std::size_t>(part.patch)];
    int first_node = 0;
    for (int p = 0; p < part.patch; ++p) first_node += spaces[static_cast<std::size_t>(p)].size();
    std::array<std::vector<double>, 3> breaks;
    std::array<geometry::QuadratureRule, 3> rules;
    for (std::size_t d = 0; d < 3; ++d) {
      breaks[d] = space.knots[d].breaks();
      rules[d] = geometry::gauss_legendre(space.points_along(static_cast<int>(d), points));
    }
    const auto [nu, nv, nw] = std::array{rules[0].nodes.size(), rules[1].nodes.size(), rules[2].nodes.size()};
    for (auto e3 = static_cast<std::size_t>(part.first_layer); e3 < static_cast<std::size_t>(part.last_layer);
         ++e3)
      for (std::size_t e2 = 0; e2 + 1 < breaks[1].size(); ++e2)
        for (std::size_t e1 = 0; e1 + 1 < breaks[0].size(); ++e1) {
          const std::array<std::size_t, 3> element = {e1, e2, e3};
          Eigen::MatrixXd gradients;  // (3 functions, points), times the root of the measure
          std::vector<int> nodes;
          for (Eigen::Index q = 0; q < nu * nv * nw; ++q) {
            const std::array<Eigen::Index, 3> index = {q % nu, q / nu % nv, q / nu / nv};
            geometry::Parameter<3> at;
            double weight = 1;
            for (std::size_t d = 0; d < 3; ++d) {
              const double length = breaks[d][element[d] + 1] - breaks[d][element[d]];
              at[static_cast<int>(d)] = breaks[d][element[d]] + length * rules[d].nodes[index[d]];
              weight *= length * rules[d].weights[index[d]];
            }
            const PlainFunctions here = functions_at(space, at);
            nodes = here.nodes;
            gradients.conservativeResize(here.gradients.size(), nu * nv * nw);
            gradients.col(q) = std::sqrt(weight * here.determinant) * here.gradients.reshaped();
          }
          const Eigen::MatrixXd products = gradients * gradients.transpose();
          for (std::size_t a = 0; a < nodes.size(); ++a)
            for (std::size_t b = 0; b < nodes.size(); ++b) {
              const Eigen::Matrix3d t =
                  products.block<3, 3>(3 * static_cast<int>(a), 3 * static_cast<int>(b));
              const int row = numbering.row_of_node[static_cast<std::size_t>(first_node + nodes[a])];
              const int column = numbering.row_of_node[static_cast<std::size_t>(first_node + nodes[b])];
              result.block<3, 3>(3 * row, 3 * column) +=
                  material.lambda * t +
                  material.mu * (t.transpose() + t.trace() * Eigen::Matrix3d::Identity());
            }
        }
  }
  return result;
}

}  // namespace isopatch::iga
