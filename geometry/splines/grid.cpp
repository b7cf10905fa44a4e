#include "geometry/splines/grid.hpp"

#include "geometry/splines/basis.hpp"
#include "geometry/splines/tensor.hpp"

namespace isopatch::geometry {

Eigen::SparseMatrix<double, Eigen::RowMajor> collocation(const KnotVector& knots,
                                                         const std::vector<double>& parameters, int order) {
  const auto rows = static_cast<Eigen::Index>(parameters.size());
  Eigen::SparseMatrix<double, Eigen::RowMajor> matrix(rows, knots.size());
  matrix.reserve(Eigen::VectorXi::Constant(rows, knots.degree() + 1));
  for (Eigen::Index i = 0; i < rows; ++i) {
    const BasisValues values = basis(knots, parameters[static_cast<std::size_t>(i)], order);
    for (int j = 0; j <= knots.degree(); ++j) matrix.insert(i, values.first + j) = values.values(order, j);
  }
  matrix.makeCompressed();
  return matrix;
}

template <int D>
Eigen::Matrix3Xd points_on_grid(const Nurbs<D>& spline,
                                const std::type_identity_t<GridParameters<D>>& parameters) {
  Eigen::Matrix4Xd values = spline.homogeneous();
  std::array<int, D> sizes = spline.sizes();
  for (int d = 0; d < D; ++d) {
    const auto k = static_cast<std::size_t>(d);
    values = apply_along<D>(values, sizes, d, collocation(spline.knots(d), parameters[k]));
    sizes[k] = static_cast<int>(parameters[k].size());
  }
  return values.topRows<3>().array().rowwise() / values.row(3).array();
}

template Eigen::Matrix3Xd points_on_grid(const Nurbs<1>&, const GridParameters<1>&);
template Eigen::Matrix3Xd points_on_grid(const Nurbs<2>&, const GridParameters<2>&);
template Eigen::Matrix3Xd points_on_grid(const Nurbs<3>&, const GridParameters<3>&);

}  // namespace isopatch::geometry
