#include "iga/internal/dense_along.hpp"

#include <algorithm>
#include <cstdint>

#include "iga/internal/parallel_for.hpp"

namespace isopatch::iga {

template <class Matrix>
Eigen::VectorXd apply_dense_along(const Eigen::VectorXd& values, std::array<int, 3>& sizes, int direction,
                                  const Matrix& matrix) {
  const Eigen::Index n0 = sizes[0];
  const Eigen::Index n1 = sizes[1];
  const Eigen::Index n2 = sizes[2];
  sizes[static_cast<std::size_t>(direction)] = static_cast<int>(matrix.rows());
  Eigen::VectorXd result(static_cast<Eigen::Index>(sizes[0]) * sizes[1] * sizes[2]);
  const Eigen::Index m = matrix.rows();
  constexpr Eigen::Index piece = 256;
  constexpr double least_parallel_flops = 1e6;
  const bool large = 2.0 * static_cast<double>(matrix.cols() * result.size()) >= least_parallel_flops;
  const auto for_all = [large](Eigen::Index count, const auto& body) {
    if (large) return parallel_for(count, body);
    for (Eigen::Index i = 0; i < count; ++i) body(i, 0);
  };
  if (direction == 0) {
    const Eigen::Map<const Eigen::MatrixXd> in(values.data(), n0, n1 * n2);
    Eigen::Map<Eigen::MatrixXd> out(result.data(), m, n1 * n2);
    for_all((in.cols() + piece - 1) / piece, [&](std::int64_t task, int) {
      const Eigen::Index count = std::min(piece, in.cols() - task * piece);
      out.middleCols(task * piece, count).noalias() = matrix * in.middleCols(task * piece, count);
    });
  } else if (direction == 1) {
    for_all(n2, [&](std::int64_t k, int) {
      const Eigen::Map<const Eigen::MatrixXd> in(values.data() + k * n0 * n1, n0, n1);
      Eigen::Map<Eigen::MatrixXd>(result.data() + k * n0 * m, n0, m).noalias() = in * matrix.transpose();
    });
  } else {
    const Eigen::Map<const Eigen::MatrixXd> in(values.data(), n0 * n1, n2);
    Eigen::Map<Eigen::MatrixXd> out(result.data(), n0 * n1, m);
    for_all((in.rows() + piece - 1) / piece, [&](std::int64_t task, int) {
      const Eigen::Index count = std::min(piece, in.rows() - task * piece);
      out.middleRows(task * piece, count).noalias() = in.middleRows(task * piece, count) * matrix.transpose();
    });
  }
  return result;
}

template Eigen::VectorXd apply_dense_along(const Eigen::VectorXd&, std::array<int, 3>&, int,
                                           const Eigen::MatrixXd&);
template Eigen::VectorXd apply_dense_along(const Eigen::VectorXd&, std::array<int, 3>&, int,
                                           const Eigen::Transpose<const Eigen::MatrixXd>&);

}  // namespace isopatch::iga
