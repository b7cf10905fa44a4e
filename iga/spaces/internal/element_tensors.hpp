#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <vector>

#include "iga/internal/tensor_contraction.hpp"
#include "iga/spaces/element_tables.hpp"

namespace isopatch::iga {

/// The B-splines of one patch on its elements, summed direction by direction: splines and their first
/// derivatives at a grid of points per element, and the transposed sums.
///
/// @cost  O((degree + 1)^4) per element and component, where a table of all functions at all points has
/// (degree + 1)^6
/// @source Antolin, Buffa, Calabro, Martinelli, Sangalli 2015, section 3, for products of vectors in place of
/// matrices
class ElementTensors {
 public:
  /// @param rules  points and weights on [0, 1], of each direction
  ElementTensors(const geometry::NurbsVolume& patch, const std::array<geometry::QuadratureRule, 3>& rules)
      : ElementTensors(ElementTables(patch, rules), patch) {}
  /// Gauss points; 0: degree + 1 of them in each direction.
  ElementTensors(const geometry::NurbsVolume& patch, int points)
      : ElementTensors(ElementTables(patch, points), patch) {}

  std::int64_t element_count() const { return tables_.element_count(); }
  Eigen::Index function_count() const { return functions_[0] * functions_[1] * functions_[2]; }
  Eigen::Index point_count() const { return points_[0] * points_[1] * points_[2]; }
  geometry::Parameter<3> parameter(std::int64_t element, Eigen::Index point) const {
    return tables_.parameter(element, point);
  }

  /// Calls visit(a, index): the a-th function of the element is the patch's function `index`.
  template <class Visit>
  void for_each_function(std::int64_t element, Visit visit) const {
    const auto [u, v, w] = tables_.of(element);
    Eigen::Index a = 0;
    for (Eigen::Index k = 0; k < functions_[2]; ++k)
      for (Eigen::Index j = 0; j < functions_[1]; ++j) {
        const Eigen::Index row = u->first + size_[0] * (v->first + j + size_[1] * (w->first + k));
        for (Eigen::Index i = 0; i < functions_[0]; ++i) visit(a++, row + i);
      }
  }
  /// Calls visit(q, weight): the q-th point of the element and its quadrature weight, without det J.
  template <class Visit>
  void for_each_point(std::int64_t element, Visit visit) const {
    const auto [u, v, w] = tables_.of(element);
    Eigen::Index q = 0;
    for (Eigen::Index k = 0; k < points_[2]; ++k)
      for (Eigen::Index j = 0; j < points_[1]; ++j) {
        const double weight = v->weights[j] * w->weights[k];
        for (Eigen::Index i = 0; i < points_[0]; ++i) visit(q++, u->weights[i] * weight);
      }
  }

  /// From coefficients to at[0], values at the points.
  template <int C>
  void values(std::int64_t element, TensorBuffers<C>& buffers) const;
  /// From coefficients to at[0] .. at[3]: values and derivatives along the three directions.
  template <int C>
  void gradients(std::int64_t element, TensorBuffers<C>& buffers) const;
  /// The transpose of `values`: coefficients = sums over the points of at[0] times each function.
  template <int C>
  void test_with_values(std::int64_t element, TensorBuffers<C>& buffers) const;
  /// The transpose of `gradients`: sums of at[0] times each function and of at[1 + d] times its derivatives.
  template <int C>
  void test_with_gradients(std::int64_t element, TensorBuffers<C>& buffers) const;

 private:
  ElementTensors(ElementTables tables, const geometry::NurbsVolume& patch);
  template <int C>
  void resize(TensorBuffers<C>& buffers) const;

  ElementTables tables_;
  std::array<int, 3> size_;
  std::array<Eigen::Index, 3> functions_;  // per element and direction
  std::array<Eigen::Index, 3> points_;
};

/// Numbers of points and weights of a patch as fields (x w, y w, z w, w), and of two sets of columns as
/// (x w, y w, z w, w, u w, v w, w w, 0).
void gather(const ElementTensors& tensors, std::int64_t element, const Eigen::Matrix3Xd& columns,
            const Eigen::VectorXd& weights, std::vector<FieldLanes<4>>& out);
/// @param displacement  of the patch's functions: 3 numbers each
void gather(const ElementTensors& tensors, std::int64_t element, const geometry::NurbsVolume& patch,
            const double* displacement, std::vector<FieldLanes<8>>& out);

}  // namespace isopatch::iga
