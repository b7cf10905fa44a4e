#pragma once

#include <Eigen/Core>
#include <concepts>
#include <functional>
#include <utility>

namespace isopatch::solvers {

/// A linear map of vectors, for example the product with a matrix that is never assembled.
using LinearOperator = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

/// The same of several vectors at once: columns in, columns out.
using BlockOperator = std::function<Eigen::MatrixXd(const Eigen::MatrixXd&)>;

/// A linear map of a vector that may know how to take several for less than one after the other costs.
class VectorsOperator {
 public:
  VectorsOperator() = default;
  template <std::invocable<const Eigen::VectorXd&> Map>
  VectorsOperator(Map one) : one_(std::move(one)) {}  // NOLINT: a map of one vector is one
  VectorsOperator(LinearOperator one, BlockOperator several)
      : one_(std::move(one)), several_(std::move(several)) {}

  explicit operator bool() const { return static_cast<bool>(one_); }
  Eigen::VectorXd operator()(const Eigen::VectorXd& x) const { return one_(x); }
  /// Of each column.
  Eigen::MatrixXd of_each(const Eigen::MatrixXd& x) const;

 private:
  LinearOperator one_;
  BlockOperator several_;
};

}  // namespace isopatch::solvers
