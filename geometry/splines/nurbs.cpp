#include "geometry/splines/nurbs.hpp"

#include <fmt/format.h>

#include <utility>
#include <vector>

#include "geometry/base/error.hpp"
#include "geometry/splines/basis.hpp"

namespace isopatch::geometry {
namespace {

template <int D>
Eigen::Matrix3Xd unit_corners() {
  Eigen::Matrix3Xd corners = Eigen::Matrix3Xd::Zero(3, 1 << D);
  for (int i = 0; i < (1 << D); ++i)
    for (int d = 0; d < D; ++d) corners(d, i) = (i >> d) & 1;
  return corners;
}

// Homogeneous derivatives of a spline at one parameter: entry `order` (mixed radix, first direction
// fastest) up to the orders asked for.
template <int D>
class HomogeneousDerivatives {
 public:
  HomogeneousDerivatives(const Nurbs<D>& spline, const Parameter<D>& parameter,
                         const std::array<int, D>& order)
      : spline_(spline), order_(order) {
    for (std::size_t d = 0; d < D; ++d)
      values_[d] = basis(spline.knots()[d], parameter[static_cast<int>(d)], order[d]);
  }

  Eigen::Vector4d operator()(const std::array<int, D>& order) const {
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    add(D - 1, 0, 1.0, order, sum);
    return sum;
  }

 private:
  void add(int direction, int offset, double factor, const std::array<int, D>& order,
           Eigen::Vector4d& sum) const {
    const auto d = static_cast<std::size_t>(direction);
    const BasisValues& b = values_[d];
    for (int j = 0; j < b.values.cols(); ++j) {
      const int index = offset * spline_.size(direction) + b.first + j;
      const double product = factor * b.values(order[d], j);
      if (direction > 0) {
        add(direction - 1, index, product, order, sum);
      } else {
        const double weighted = product * spline_.weights()[index];
        sum.template head<3>() += weighted * spline_.control_points().col(index);
        sum[3] += weighted;
      }
    }
  }

  const Nurbs<D>& spline_;
  std::array<int, D> order_;
  std::array<BasisValues, D> values_;
};

double binomial(int n, int k) {
  double result = 1;
  for (int i = 1; i <= k; ++i) result = result * (n - k + i) / i;
  return result;
}

// Calls visit(index) for every multi-index 0 <= index <= last, the first entry running fastest.
template <int D, class Visit>
void for_each_index(const std::array<int, D>& last, Visit visit) {
  std::array<int, D> index{};
  while (true) {
    visit(index);
    std::size_t d = 0;
    while (d < D && index[d] == last[d]) index[d++] = 0;
    if (d == D) return;
    ++index[d];
  }
}

}  // namespace

template <int D>
Nurbs<D>::Nurbs() : Nurbs(KnotVectors{}, unit_corners<D>()) {}

template <int D>
Nurbs<D>::Nurbs(KnotVectors knots, Eigen::Matrix3Xd control_points)
    : Nurbs(std::move(knots), control_points, Eigen::VectorXd::Ones(control_points.cols())) {}

template <int D>
Nurbs<D>::Nurbs(KnotVectors knots, Eigen::Matrix3Xd control_points, Eigen::VectorXd weights)
    : knots_(std::move(knots)), control_points_(std::move(control_points)), weights_(std::move(weights)) {
  Eigen::Index expected = 1;
  for (const KnotVector& k : knots_) expected *= k.size();
  if (control_points_.cols() != expected)
    throw Error(ErrorCode::invalid_argument, fmt::format("{} control points, but the knot vectors ask for {}",
                                                         control_points_.cols(), expected));
  if (weights_.size() != expected)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("{} weights for {} control points", weights_.size(), expected));
  for (Eigen::Index i = 0; i < expected; ++i) {
    if (!control_points_.col(i).allFinite())
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("control point {} is not finite: ({}, {}, {})", i, control_points_(0, i),
                              control_points_(1, i), control_points_(2, i)));
    if (!(weights_[i] > 1e-100 && weights_[i] < 1e100))
      throw Error(
          ErrorCode::invalid_argument,
          fmt::format("weight {} is {}; weights must be positive, from 1e-100 to 1e100", i, weights_[i]));
  }
  rational_ = (weights_.array() != weights_[0]).any();
}

template <int D>
Nurbs<D> Nurbs<D>::from_homogeneous(KnotVectors knots, const Eigen::Matrix4Xd& homogeneous) {
  const Eigen::VectorXd weights = homogeneous.row(3).transpose();
  const Eigen::Matrix3Xd points = homogeneous.topRows<3>().array().rowwise() / homogeneous.row(3).array();
  return Nurbs(std::move(knots), points, weights);
}

template <int D>
std::array<int, D> Nurbs<D>::sizes() const {
  std::array<int, D> result;
  for (std::size_t d = 0; d < D; ++d) result[d] = knots_[d].size();
  return result;
}

template <int D>
Eigen::Matrix4Xd Nurbs<D>::homogeneous() const {
  Eigen::Matrix4Xd result(4, size());
  result.topRows<3>() = control_points_.array().rowwise() * weights_.transpose().array();
  result.row(3) = weights_.transpose();
  return result;
}

template <int D>
Parameter<D> Nurbs<D>::low() const {
  Parameter<D> result;
  for (int d = 0; d < D; ++d) result[d] = knots(d).first();
  return result;
}

template <int D>
Parameter<D> Nurbs<D>::high() const {
  Parameter<D> result;
  for (int d = 0; d < D; ++d) result[d] = knots(d).last();
  return result;
}

template <int D>
Eigen::Vector3d Nurbs<D>::point(const Parameter<D>& parameter) const {
  const Eigen::Vector4d h = HomogeneousDerivatives<D>(*this, parameter, {})({});
  return h.template head<3>() / h[3];
}

template <int D>
Eigen::Matrix<double, 3, D> Nurbs<D>::jacobian(const Parameter<D>& parameter) const {
  std::array<int, D> ones;
  ones.fill(1);
  const HomogeneousDerivatives<D> derivatives(*this, parameter, ones);
  const Eigen::Vector4d h = derivatives({});
  const Eigen::Vector3d x = h.template head<3>() / h[3];
  Eigen::Matrix<double, 3, D> result;
  for (int d = 0; d < D; ++d) {
    std::array<int, D> order{};
    order[static_cast<std::size_t>(d)] = 1;
    const Eigen::Vector4d h_d = derivatives(order);
    result.col(d) = (h_d.template head<3>() - h_d[3] * x) / h[3];
  }
  return result;
}

template <int D>
Eigen::Vector3d Nurbs<D>::derivative(const Parameter<D>& parameter, const std::array<int, D>& order) const {
  const HomogeneousDerivatives<D> derivatives(*this, parameter, order);
  const double weight = derivatives({})[3];
  std::vector<Eigen::Vector3d> found;  // S^(k) for every k <= order, in the order of for_each_index
  std::array<int, D> stride;
  int count = 1;
  for (std::size_t d = 0; d < D; ++d) {
    stride[d] = count;
    count *= order[d] + 1;
  }
  for_each_index<D>(order, [&](const std::array<int, D>& k) {
    Eigen::Vector3d value = derivatives(k).template head<3>();
    for_each_index<D>(k, [&](const std::array<int, D>& i) {
      double factor = 1;
      int rest = 0;
      bool zero = true;
      for (std::size_t d = 0; d < D; ++d) {
        factor *= binomial(k[d], i[d]);
        rest += (k[d] - i[d]) * stride[d];
        zero = zero && i[d] == 0;
      }
      if (!zero) value -= factor * derivatives(i)[3] * found[static_cast<std::size_t>(rest)];
    });
    found.push_back(value / weight);
  });
  return found.back();
}

template class Nurbs<1>;
template class Nurbs<2>;
template class Nurbs<3>;

}  // namespace isopatch::geometry
