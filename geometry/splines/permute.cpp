#include "geometry/splines/permute.hpp"

#include <algorithm>
#include <numeric>

#include "geometry/base/error.hpp"

namespace isopatch::geometry {

template <int D>
Nurbs<D> permuted(const Nurbs<D>& spline, const std::type_identity_t<std::array<int, D>>& from) {
  std::array<int, D> identity;
  std::iota(identity.begin(), identity.end(), 0);
  if (!std::is_permutation(from.begin(), from.end(), identity.begin()))
    throw Error(ErrorCode::invalid_argument, "permuted: every direction must appear exactly once");
  std::array<int, D> old_stride;
  int stride = 1;
  for (std::size_t d = 0; d < D; ++d) {
    old_stride[d] = stride;
    stride *= spline.knots()[d].size();
  }
  typename Nurbs<D>::KnotVectors knots;
  for (std::size_t d = 0; d < D; ++d) knots[d] = spline.knots(from[d]);
  Eigen::Matrix3Xd points(3, spline.size());
  Eigen::VectorXd weights(spline.size());
  for (int i = 0; i < spline.size(); ++i) {
    int source = 0;
    int rest = i;
    for (std::size_t d = 0; d < D; ++d) {
      source += (rest % knots[d].size()) * old_stride[static_cast<std::size_t>(from[d])];
      rest /= knots[d].size();
    }
    points.col(i) = spline.control_points().col(source);
    weights[i] = spline.weights()[source];
  }
  return Nurbs<D>(std::move(knots), std::move(points), std::move(weights));
}

template Nurbs<1> permuted(const Nurbs<1>&, const std::array<int, 1>&);
template Nurbs<2> permuted(const Nurbs<2>&, const std::array<int, 2>&);
template Nurbs<3> permuted(const Nurbs<3>&, const std::array<int, 3>&);

}  // namespace isopatch::geometry
