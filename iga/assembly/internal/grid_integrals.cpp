#include "iga/assembly/internal/grid_integrals.hpp"

namespace isopatch::iga {

FunctionPairs::FunctionPairs(const LineTable& first, const LineTable& second)
    : numbers_(Eigen::MatrixXi::Constant(first.cols(), second.cols(), -1)) {
  for (Eigen::Index point = 0; point < first.rows(); ++point)
    for (LineTable::InnerIterator a(first, point); a; ++a)
      for (LineTable::InnerIterator b(second, point); b; ++b) numbers_(a.col(), b.col()) = 0;
  for (int a = 0; a < numbers_.rows(); ++a)
    for (int b = 0; b < numbers_.cols(); ++b)
      if (numbers_(a, b) == 0) {
        numbers_(a, b) = static_cast<int>(pairs_.size());
        pairs_.push_back({a, b});
      }
}

LineTable FunctionPairs::products(const LineTable& first, const LineTable& second) const {
  std::vector<Eigen::Triplet<double>> entries;
  for (int point = 0; point < first.rows(); ++point)
    for (LineTable::InnerIterator a(first, point); a; ++a)
      for (LineTable::InnerIterator b(second, point); b; ++b)
        entries.emplace_back(numbers_(a.col(), b.col()), point, a.value() * b.value());
  LineTable result(static_cast<Eigen::Index>(pairs_.size()), first.rows());
  result.setFromTriplets(entries.begin(), entries.end());
  return result;
}

Rows grid_integrals(const LineTable& pairs_0, const LineTable& pairs_1, const GridFields& fields) {
  const Rows summed = pairs_0 * fields.values;  // (pairs 0, fields * points 1)
  const Eigen::Index points = pairs_1.cols(), pairs = pairs_0.rows();
  Rows turned(points, fields.count * pairs);
  for (Eigen::Index f = 0; f < fields.count; ++f)
    turned.middleCols(f * pairs, pairs) = summed.middleCols(f * points, points).transpose();
  return pairs_1 * turned;
}

}  // namespace isopatch::iga
