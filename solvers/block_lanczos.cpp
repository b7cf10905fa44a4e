#include "solvers/block_lanczos.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/base/error.hpp"

namespace isopatch::solvers {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

// The basis, orthonormal in the mass, with the mass times it.
class Basis {
 public:
  Basis(Index rows, Index most) : vectors_(rows, most), massive_(rows, most) {}

  Index size() const { return size_; }
  auto vectors() const { return vectors_.leftCols(size_); }
  auto massive() const { return massive_.leftCols(size_); }
  auto last(Index count) const { return vectors_.middleCols(size_ - count, count); }
  auto massive_last(Index count) const { return massive_.middleCols(size_ - count, count); }

  // Takes what is new in a block: at most as many vectors as there is room for.
  // @return  how many, which span all of the block beside what was there
  Index add(MatrixXd block, const BlockOperator& mass) {
    const double square = (block.transpose() * mass(block)).trace();
    if (!(square > 0)) return 0;
    block /= std::sqrt(square);
    for (int pass = 0; pass < 2; ++pass) block -= vectors() * (massive().transpose() * block);
    Index added = 0;
    for (Index j = 0; j < block.cols() && size_ < vectors_.cols(); ++j) {
      VectorXd x = block.col(j);
      MatrixXd mx;
      double length = 0;
      for (int pass = 0; pass < 3; ++pass) {
        if (pass > 0) x -= vectors() * (massive().transpose() * x);
        mx = mass(x);
        const double of_x = x.dot(mx.col(0));
        if (!(of_x > 0)) break;
        length = std::sqrt(of_x);
        if (pass == 0 && length < least_new) break;  // nothing but round-off is new in it
        x /= length;
        mx /= length;
      }
      if (!(length > 0) || length < least_new) continue;
      vectors_.col(size_) = x;
      massive_.col(size_) = mx.col(0);
      ++size_;
      ++added;
    }
    return added;
  }

 private:
  static constexpr double least_new = 1e-10;
  MatrixXd vectors_, massive_;
  Index size_ = 0;
};

}  // namespace

EigenPairs largest_eigenpairs(const BlockOperator& apply, const BlockOperator& mass, const MatrixXd& start,
                              const LanczosOptions& options) {
  const auto wanted = static_cast<Index>(options.count);
  Basis basis(start.rows(), static_cast<Index>(options.most_vectors));
  MatrixXd projected(0, 0);  // V^T M O V
  EigenPairs result;
  Index block = basis.add(start, mass);
  while (block > 0) {
    const MatrixXd image = apply(basis.last(block));
    result.applications += static_cast<int>(block);
    const Index old = projected.cols(), size = basis.size();
    const MatrixXd column = basis.massive().transpose() * image;
    projected.conservativeResize(size, size);
    projected.rightCols(block) = column;
    projected.bottomRows(block) = column.transpose();
    const MatrixXd rest = image - basis.vectors() * column;
    const SymmetricEigen ritz = symmetric_eigen(0.5 * (projected + projected.transpose()));
    // The residual of a Ritz pair is what its share of the last block leaves of the image.
    const MatrixXd gram = rest.transpose() * mass(rest);
    Index converged = 0;
    for (; converged < size; ++converged) {
      const VectorXd share = ritz.vectors.col(size - 1 - converged).tail(size - old);
      const double square = share.dot(gram * share);
      const double residual = square <= 0 ? 0 : std::sqrt(square);
      if (!(residual <= options.tolerance * ritz.values[size - 1 - converged])) break;
    }
    const bool is_whole = basis.size() + block > basis.vectors().rows();
    const Index before = basis.size();
    const bool is_full = before >= static_cast<Index>(options.most_vectors);
    const Index next = converged > wanted || is_full ? 0 : basis.add(rest, mass);
    if (converged > wanted || ((next == 0 || is_whole) && converged >= std::min(wanted, size))) {
      const Index kept = std::min(converged, size);
      result.values = ritz.values.tail(kept).reverse();
      result.vectors = basis.vectors().leftCols(before) * ritz.vectors.rightCols(kept).rowwise().reverse();
      result.next_value = kept < size ? ritz.values[size - 1 - kept] : 0;
      return result;
    }
    if (next == 0)
      throw Error(ErrorCode::not_converged, fmt::format("{} of {} eigenvalues have converged with {} vectors",
                                                        converged, wanted, before));
    block = next;
  }
  throw Error(ErrorCode::not_converged, "the start vectors have no mass");
}

}  // namespace isopatch::solvers
