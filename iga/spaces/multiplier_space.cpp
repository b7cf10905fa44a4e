#include "iga/spaces/multiplier_space.hpp"

#include <Eigen/LU>
#include <vector>

#include "geometry/splines/basis.hpp"

namespace isopatch::iga {
namespace {

// The derivative of an order of every function of a line, in the middle of an element.
Eigen::RowVectorXd derivatives(const geometry::KnotVector& knots, int element, int order) {
  const std::vector<double> breaks = knots.breaks();
  const auto e = static_cast<std::size_t>(element);
  const double middle = 0.5 * (breaks[e] + breaks[e + 1]);
  const int span = knots.span(middle), degree = knots.degree();
  Eigen::RowVectorXd result = Eigen::RowVectorXd::Zero(knots.size());
  result.segment(span - degree, degree + 1) = geometry::basis_on_span(knots, span, middle, order).row(order);
  return result;
}

}  // namespace

Eigen::SparseMatrix<double> multiplier_coefficients(const geometry::KnotVector& knots) {
  const int size = knots.size(), degree = knots.degree(), elements = knots.element_count();
  if (size < 3) return Eigen::MatrixXd::Ones(size, 1).sparseView();
  // What must vanish: the highest derivatives on both ends' elements, scaled alike.
  Eigen::MatrixXd highest(2, size);
  highest.row(0) = derivatives(knots, 0, degree);
  highest.row(1) =
      elements > 1 ? derivatives(knots, elements - 1, degree) : derivatives(knots, 0, degree - 1);
  Eigen::Matrix2d of_ends;
  of_ends << highest.leftCols<1>(), highest.rightCols<1>();
  const Eigen::MatrixXd of_first_and_last = -of_ends.inverse() * highest;
  std::vector<Eigen::Triplet<double>> entries;
  for (int i = 1; i + 1 < size; ++i) {
    entries.emplace_back(i, i - 1, 1.0);
    for (const auto& [row, value] :
         {std::pair(0, of_first_and_last(0, i)), std::pair(size - 1, of_first_and_last(1, i))})
      if (value != 0) entries.emplace_back(row, i - 1, value);
  }
  Eigen::SparseMatrix<double> result(size, size - 2);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace isopatch::iga
