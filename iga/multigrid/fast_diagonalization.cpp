#include "iga/multigrid/fast_diagonalization.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cstdint>
#include <map>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/quadrature.hpp"
#include "iga/internal/dense_along.hpp"
#include "iga/internal/parallel_for.hpp"
#include "iga/multigrid/separable_coefficients.hpp"
#include "iga/spaces/element_tables.hpp"

namespace isopatch::iga {
namespace {

using geometry::KnotVector;

// Mass and stiffness of one direction.
struct LineMatrices {
  Eigen::MatrixXd mass;
  Eigen::MatrixXd stiffness;
};

LineMatrices line(const KnotVector& knots, const LineWeight& stiffness, const LineWeight& mass) {
  const DirectionTable table = direction_table(knots, geometry::gauss_legendre(knots.degree() + 1));
  LineMatrices result{Eigen::MatrixXd::Zero(knots.size(), knots.size()),
                      Eigen::MatrixXd::Zero(knots.size(), knots.size())};
  const int n = knots.degree() + 1;
  for (const DirectionTable::Element& e : table.elements) {
    Eigen::VectorXd of_mass = e.weights;
    Eigen::VectorXd of_stiffness = e.weights;
    for (Eigen::Index q = 0; q < e.nodes.size(); ++q) {
      of_mass[q] *= mass.at(e.nodes[q]);
      of_stiffness[q] *= stiffness.at(e.nodes[q]);
    }
    result.mass.block(e.first, e.first, n, n) += e.values.transpose() * of_mass.asDiagonal() * e.values;
    result.stiffness.block(e.first, e.first, n, n) +=
        e.derivatives.transpose() * of_stiffness.asDiagonal() * e.derivatives;
  }
  return result;
}

// The lines of one patch and one component.
struct LinesOfAxis {
  std::array<double, 3> factor;
  std::array<LineMatrices, 3> along;
};

std::array<LinesOfAxis, 3> lines_of(const PatchSpace& space, const Material& material) {
  const std::array<SeparableCoefficients, 3> coefficients = separable_coefficients(*space.geometry, material);
  std::array<LinesOfAxis, 3> result;
  for (std::size_t c = 0; c < 3; ++c) {
    result[c].factor = coefficients[c].factor;
    for (std::size_t d = 0; d < 3; ++d)
      result[c].along[d] = line(space.knots[d], coefficients[c].stiffness[d], coefficients[c].mass[d]);
  }
  return result;
}

struct Modes {
  std::shared_ptr<const Eigen::MatrixXd> vectors;  // (functions, modes), 0 for fixed functions
  Eigen::VectorXd values;
};

Modes modes(const LineMatrices& l, int low, int high, bool fixed_low, bool fixed_high) {
  const int n = high - low;
  const int first = fixed_low ? 1 : 0;
  const int count = n - first - (fixed_high ? 1 : 0);
  Modes result;
  Eigen::MatrixXd vectors = Eigen::MatrixXd::Zero(n, std::max(0, count));
  if (count > 0) {
    const SymmetricEigen eigen = symmetric_eigen(l.stiffness.block(low + first, low + first, count, count),
                                                 l.mass.block(low + first, low + first, count, count));
    vectors.middleRows(first, count) = eigen.vectors;
    result.values = eigen.values.cwiseMax(0.0);
  }
  result.vectors = std::make_shared<const Eigen::MatrixXd>(std::move(vectors));
  return result;
}

// 1 / (sum of the directions' eigenvalues); modes without energy get the inverse of the softest other one.
Eigen::VectorXd inverse_eigenvalues(const std::array<Modes, 3>& along, const Eigen::Vector3d& coefficients) {
  const Eigen::Index n0 = along[0].values.size();
  const Eigen::Index n1 = along[1].values.size();
  const Eigen::Index n2 = along[2].values.size();
  Eigen::VectorXd sum(n0 * n1 * n2);
  for (Eigen::Index k = 0, at = 0; k < n2; ++k)
    for (Eigen::Index j = 0; j < n1; ++j)
      for (Eigen::Index i = 0; i < n0; ++i, ++at)
        sum[at] = coefficients[0] * along[0].values[i] + coefficients[1] * along[1].values[j] +
                  coefficients[2] * along[2].values[k];
  if (sum.size() == 0) return sum;
  const double largest = sum.maxCoeff();
  double softest = largest;
  for (const double value : sum)
    if (value > 1e-8 * largest) softest = std::min(softest, value);
  return sum.cwiseMax(softest).cwiseInverse();
}

// Whether supports hold all rows of a block's first or last layer along a component.
bool is_held(const Level& level, const std::vector<int>& rows, const std::array<int, 3>& sizes, int direction,
             bool high, int component) {
  const int layer = high ? sizes[static_cast<std::size_t>(direction)] - 1 : 0;
  std::size_t at = 0;
  for (int k = 0; k < sizes[2]; ++k)
    for (int j = 0; j < sizes[1]; ++j)
      for (int i = 0; i < sizes[0]; ++i, ++at) {
        const std::array<int, 3> index = {i, j, k};
        if (index[static_cast<std::size_t>(direction)] == layer && level.free.can_move(rows[at], component))
          return false;
      }
  return true;
}

}  // namespace

FastDiagonalization::FastDiagonalization(const geometry::MultiPatch& model, const Level& level,
                                         const std::vector<Material>& materials,
                                         const std::vector<Eigen::Matrix3d>& diagonal,
                                         const NodeBlocks& surfaces, const Springs& holds)
    : level_(&level), interface_(model, level, materials, surfaces, diagonal) {
  std::vector<char> in_block(static_cast<std::size_t>(level.rows.global_rows()), 0);
  const std::vector<bool> elsewhere = nodes_that_do_not_match(model, level);
  for (std::size_t node = 0; node < elsewhere.size(); ++node)
    if (elsewhere[node]) in_block[static_cast<std::size_t>(level.global_of[node])] = 1;
  held_ = HeldFaces(level, materials, holds, diagonal, in_block);
  std::vector<geometry::PatchFace> apart;
  for (const SprungFace& held : holds.faces) apart.push_back(held.face);
  std::map<std::array<int, 7>, Modes> known;  // patch, component, direction, range, fixed ends
  std::map<int, std::array<LinesOfAxis, 3>> lines;
  for (const TensorBlock& block : tensor_blocks(model, level, apart, in_block)) {
    const std::vector<int> nodes = nodes_of(level, block);
    const auto p = static_cast<std::size_t>(block.patch);
    if (!level.is_primary[p]) continue;
    const PatchSpace& space = level.spaces[p];
    if (!lines.contains(block.patch)) lines[block.patch] = lines_of(space, materials[p]);
    Block& made = blocks_.emplace_back();
    made.sizes = block.sizes();
    for (const int node : nodes) made.rows.push_back(level.row_of_node[static_cast<std::size_t>(node)]);
    for (int c = 0; c < 3; ++c) {
      Component& component = made.components[static_cast<std::size_t>(c)];
      const LinesOfAxis& of_patch = lines[block.patch][static_cast<std::size_t>(c)];
      const Eigen::Vector3d factor(of_patch.factor[0], of_patch.factor[1], of_patch.factor[2]);
      std::array<Modes, 3> along;
      for (int d = 0; d < 3; ++d) {
        const auto direction = static_cast<std::size_t>(d);
        const bool single = made.sizes[direction] == 1;
        const bool low = !single && is_held(level, made.rows, made.sizes, d, false, c);
        const bool high = !single && is_held(level, made.rows, made.sizes, d, true, c);
        Modes& found = known[{block.patch, c, d, block.low[direction], block.high[direction], low, high}];
        if (!found.vectors)
          found = modes(of_patch.along[direction], block.low[direction], block.high[direction], low, high);
        along[direction] = found;
        component.modes[direction] = found.vectors;
      }
      component.inverse = inverse_eigenvalues(along, factor);
      component.scale.resize(static_cast<Eigen::Index>(nodes.size()));
      Eigen::Index at = 0;
      for (int k = block.low[2]; k < block.high[2]; ++k)
        for (int j = block.low[1]; j < block.high[1]; ++j)
          for (int i = block.low[0]; i < block.high[0]; ++i, ++at) {
            const auto& [u, v, w] = of_patch.along;
            const double own = factor[0] * u.stiffness(i, i) * v.mass(j, j) * w.mass(k, k) +
                               factor[1] * u.mass(i, i) * v.stiffness(j, j) * w.mass(k, k) +
                               factor[2] * u.mass(i, i) * v.mass(j, j) * w.stiffness(k, k);
            const auto row = static_cast<std::size_t>(made.rows[static_cast<std::size_t>(at)]);
            component.scale[at] = std::sqrt(own / diagonal[row](c, c));
          }
    }
  }
  for (const int row : level.rows.owned()) {
    const int c = level.rows.global_of_local()[static_cast<std::size_t>(row)];
    if (!in_block[static_cast<std::size_t>(c)])
      points_.push_back({row, diagonal[static_cast<std::size_t>(row)].inverse()});
  }
}

void FastDiagonalization::solve_component(const Block& block, int c, const Eigen::VectorXd& residual,
                                          Eigen::VectorXd& result) const {
  const Component& component = block.components[static_cast<std::size_t>(c)];
  if (component.inverse.size() == 0) return;
  Eigen::VectorXd values(static_cast<Eigen::Index>(block.rows.size()));
  for (std::size_t a = 0; a < block.rows.size(); ++a)
    values[static_cast<Eigen::Index>(a)] = residual[3 * static_cast<Eigen::Index>(block.rows[a]) + c] *
                                           component.scale[static_cast<Eigen::Index>(a)];
  std::array<int, 3> sizes = block.sizes;
  for (int d = 0; d < 3; ++d)
    values = apply_dense_along(values, sizes, d, component.modes[static_cast<std::size_t>(d)]->transpose());
  values.array() *= component.inverse.array();
  for (int d = 0; d < 3; ++d)
    values = apply_dense_along(values, sizes, d, *component.modes[static_cast<std::size_t>(d)]);
  for (std::size_t a = 0; a < block.rows.size(); ++a)
    result[3 * static_cast<Eigen::Index>(block.rows[a]) + c] =
        values[static_cast<Eigen::Index>(a)] * component.scale[static_cast<Eigen::Index>(a)];
}

Eigen::VectorXd FastDiagonalization::apply(const Eigen::VectorXd& residual) const {
  constexpr std::size_t large = 20000;  // nodes; larger blocks keep all threads busy by themselves
  const Eigen::VectorXd force = level_->free.to_space(residual);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(residual.size());
  for (const Block& block : blocks_)
    if (block.rows.size() >= large)
      for (int c = 0; c < 3; ++c) solve_component(block, c, force, result);
  parallel_for(static_cast<std::int64_t>(3 * blocks_.size()), [&](std::int64_t task, int) {
    const Block& block = blocks_[static_cast<std::size_t>(task / 3)];
    if (block.rows.size() < large) solve_component(block, static_cast<int>(task % 3), force, result);
  });
  for (const Point& point : points_)
    result.segment<3>(Eigen::Index{3} * point.row) =
        point.inverse * force.segment<3>(Eigen::Index{3} * point.row);
  result = level_->free.to_free(std::move(result));
  interface_.add(residual, result);
  held_.add(residual, result);
  level_->rows.sum(result);
  return result;
}

std::int64_t FastDiagonalization::bytes() const {
  std::int64_t total = 0;
  for (const Block& block : blocks_) {
    total += static_cast<std::int64_t>(block.rows.size() * sizeof(int));
    for (const Component& component : block.components)
      total += 8 * (component.inverse.size() + component.scale.size());
  }
  return total;
}

}  // namespace isopatch::iga
