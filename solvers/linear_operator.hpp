#pragma once

#include <Eigen/Core>
#include <functional>

namespace isopatch::solvers {

/// A linear map of vectors, for example the product with a matrix that is never assembled.
using LinearOperator = std::function<Eigen::VectorXd(const Eigen::VectorXd&)>;

}  // namespace isopatch::solvers
