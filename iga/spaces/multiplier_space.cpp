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

Eigen::SparseMatrix<double> multiplier_coefficients(const geometry::KnotVector& knots,
                                                    const std::array<bool, 2>& reduced) {
  const int size = knots.size(), degree = knots.degree(), last_element = knots.element_count() - 1;
  std::vector<int> removed;  // functions
  if (reduced[0]) removed.push_back(0);
  if (reduced[1]) removed.push_back(size - 1);
  const auto ends = static_cast<int>(removed.size());
  if (size <= ends) return Eigen::MatrixXd::Ones(size, 1).sparseView();
  // What must vanish: the highest derivatives on the ends' elements.
  Eigen::MatrixXd highest(ends, size), of_removed(ends, ends);
  for (int k = 0; k < ends; ++k) {
    const bool is_second_of_one = k == 1 && last_element == 0;
    const int element = removed[static_cast<std::size_t>(k)] == 0 ? 0 : last_element;
    highest.row(k) = derivatives(knots, element, is_second_of_one ? degree - 1 : degree);
  }
  for (int k = 0; k < ends; ++k) of_removed.col(k) = highest.col(removed[static_cast<std::size_t>(k)]);
  Eigen::MatrixXd followers(0, size);
  if (ends > 0) followers = -of_removed.inverse() * highest;
  std::vector<Eigen::Triplet<double>> entries;
  int multiplier = 0;
  for (int i = reduced[0] ? 1 : 0; i < size - (reduced[1] ? 1 : 0); ++i, ++multiplier) {
    entries.emplace_back(i, multiplier, 1.0);
    for (int k = 0; k < ends; ++k)
      if (followers(k, i) != 0)
        entries.emplace_back(removed[static_cast<std::size_t>(k)], multiplier, followers(k, i));
  }
  Eigen::SparseMatrix<double> result(size, size - ends);
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace isopatch::iga
