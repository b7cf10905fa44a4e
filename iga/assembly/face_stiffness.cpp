#include "iga/assembly/face_stiffness.hpp"

#include <Eigen/LU>
#include <array>
#include <cmath>
#include <set>
#include <vector>

#include "geometry/quadrature.hpp"
#include "iga/assembly/internal/patch_side.hpp"

namespace isopatch::iga {
namespace {

using Eigen::Index;

// Gradients of the functions on sides, at all points of the volume's element behind an element of one of
// them.
struct GradientsBehind {
  std::vector<int> nodes;
  std::array<Eigen::MatrixXd, 3> gradients;  // (nodes, points) per direction
  Eigen::RowVectorXd weights;                // with the volume
};

GradientsBehind gradients_behind(const PatchSide& side, const PatchSpace& space, const ElementOfFace& element,
                                 const std::set<int>& on_sides) {
  std::array<geometry::QuadratureRule, 3> rules;
  Index points = 1;
  for (std::size_t d = 0; d < 3; ++d) {
    rules[d] = geometry::gauss_legendre(space.knots[d].degree() + 1);
    points *= static_cast<Index>(rules[d].nodes.size());
  }
  const auto [corner, extent] = side.box_behind(element);
  GradientsBehind result;
  result.weights.resize(points);
  Index q = 0;
  for (Index k = 0; k < rules[2].nodes.size(); ++k)
    for (Index j = 0; j < rules[1].nodes.size(); ++j)
      for (Index i = 0; i < rules[0].nodes.size(); ++i, ++q) {
        const geometry::Parameter<3> at =
            corner + extent.cwiseProduct(
                         geometry::Parameter<3>(rules[0].nodes[i], rules[1].nodes[j], rules[2].nodes[k]));
        result.weights[q] = rules[0].weights[i] * rules[1].weights[j] * rules[2].weights[k] * extent.prod() *
                            std::abs(space.geometry->jacobian(at).determinant());
        const PatchSide::Functions functions = side.functions_behind(element, at);
        if (q == 0) {
          for (std::size_t f = 0; f < functions.nodes.size(); ++f)
            if (on_sides.contains(functions.nodes[f])) result.nodes.push_back(functions.nodes[f]);
          for (Eigen::MatrixXd& g : result.gradients)
            g.resize(static_cast<Index>(result.nodes.size()), points);
        }
        Index row = 0;
        for (std::size_t f = 0; f < functions.nodes.size(); ++f) {
          if (!on_sides.contains(functions.nodes[f])) continue;
          for (Index d = 0; d < 3; ++d)
            result.gradients[static_cast<std::size_t>(d)](row, q) = functions.gradients[f][d];
          ++row;
        }
      }
  return result;
}

void add_element(const GradientsBehind& at, const Material& material, BlockSums& blocks) {
  std::array<Eigen::MatrixXd, 9> sums;  // of g_d g_e at d + 3 e
  for (std::size_t e = 0; e < 3; ++e)
    for (std::size_t d = 0; d < 3; ++d)
      sums[d + 3 * e] = at.gradients[d] * at.weights.asDiagonal() * at.gradients[e].transpose();
  for (Index b = 0; b < sums[0].cols(); ++b)
    for (Index a = 0; a <= b; ++a) {
      Eigen::Matrix3d of_pair;
      for (std::size_t k = 0; k < 9; ++k) of_pair(static_cast<Index>(k)) = sums[k](a, b);
      blocks.add(at.nodes[static_cast<std::size_t>(a)], at.nodes[static_cast<std::size_t>(b)],
                 material.lambda * of_pair + material.mu * of_pair.transpose() +
                     material.mu * of_pair.trace() * Eigen::Matrix3d::Identity());
    }
}

}  // namespace

NodeBlocks face_stiffness(const PatchSpace& space, const std::vector<geometry::Side>& sides, int first_node,
                          const Material& material) {
  std::set<int> on_sides;
  for (const geometry::Side side : sides)
    for (const int node : geometry::face_control_points(space.sizes(), side))
      on_sides.insert(first_node + node);
  std::set<std::array<int, 3>> done;  // elements at edges lie behind two sides
  BlockSums result;
  for (const geometry::Side side : sides) {
    const PatchSide of_patch(space, side, first_node);
    for (int j = 0; j < of_patch.elements(1); ++j)
      for (int i = 0; i < of_patch.elements(0); ++i)
        if (done.insert(of_patch.element({i, j})).second)
          add_element(gradients_behind(of_patch, space, {i, j}, on_sides), material, result);
  }
  return result.blocks();
}

}  // namespace isopatch::iga
