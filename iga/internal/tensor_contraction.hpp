#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace isopatch::iga {

/// C fields at one function or one point, side by side so that they fill a vector register.
template <int C>
using FieldLanes = Eigen::Array<double, C, 1>;

/// Combines the fields of functions or points along one direction of a tensor, first direction fastest:
/// out[o][r][i] (+)= sum over c of matrix(r, c) in[o][c][i].
///
/// @param matrix  (rows, columns); with Transposed its transpose is applied
/// @param inner   number of functions or points of the directions before, `outer` of those behind
/// @cost          2 C flops per entry of the matrix, inner and outer index
template <bool Transposed, bool Add, int C>
void contract(const Eigen::MatrixXd& matrix, Eigen::Index inner, Eigen::Index outer, const FieldLanes<C>* in,
              FieldLanes<C>* out) {
  const Eigen::Index rows = Transposed ? matrix.cols() : matrix.rows();
  const Eigen::Index columns = Transposed ? matrix.rows() : matrix.cols();
  const Eigen::Index row_step = Transposed ? matrix.rows() : 1;
  const Eigen::Index column_step = Transposed ? 1 : matrix.rows();
  for (Eigen::Index o = 0; o < outer; ++o, in += columns * inner, out += rows * inner) {
    for (Eigen::Index i = 0; i < inner; ++i) {
      const double* factor = matrix.data();
      for (Eigen::Index r = 0; r < rows; ++r, factor += row_step) {
        FieldLanes<C> sum = factor[0] * in[i];
        for (Eigen::Index c = 1; c < columns; ++c) sum += factor[c * column_step] * in[c * inner + i];
        if constexpr (Add)
          out[r * inner + i] += sum;
        else
          out[r * inner + i] = sum;
      }
    }
  }
}

/// Storage of one thread for the tensors of one element.
template <int C>
struct TensorBuffers {
  std::vector<FieldLanes<C>> coefficients;       ///< per function
  std::array<std::vector<FieldLanes<C>>, 4> at;  ///< per point: values, then derivatives along each direction
  std::array<std::vector<FieldLanes<C>>, 5> part;  ///< between the directions
};

}  // namespace isopatch::iga
