#include "geometry/splines/transfer.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/base/error.hpp"
#include "geometry/splines/basis.hpp"

namespace isopatch::geometry {
namespace {

// Assembles a transfer matrix row by row; `row(i, span)` gives the weights of fine coefficient i on the
// coarse functions that live on coarse span `span`.
template <class Row>
TransferMatrix by_rows(const KnotVector& coarse, const KnotVector& fine, Row row) {
  TransferMatrix matrix(fine.size(), coarse.size());
  matrix.reserve(Eigen::VectorXi::Constant(fine.size(), coarse.degree() + 1));
  const auto& knots = fine.knots();
  for (int i = 0; i < fine.size(); ++i) {
    // Any nonempty span in the support of the fine function will do; the middle one keeps the blossom's
    // arguments close to it.
    const auto middle = static_cast<std::size_t>(i + (fine.degree() + 1) / 2);
    std::size_t at = middle;
    while (at > static_cast<std::size_t>(i) && knots[at] == knots[at + 1]) --at;
    if (knots[at] == knots[at + 1])
      for (at = middle; knots[at] == knots[at + 1];) ++at;
    const int span = coarse.span(0.5 * (knots[at] + knots[at + 1]));
    const Eigen::RowVectorXd weights = row(i, span);
    for (int j = 0; j <= coarse.degree(); ++j)
      if (weights[j] != 0) matrix.insert(i, span - coarse.degree() + j) = weights[j];
  }
  matrix.makeCompressed();
  return matrix;
}

Eigen::VectorXd knots_after(const KnotVector& knots, int i, int count) {
  return Eigen::Map<const Eigen::VectorXd>(knots.knots().data() + i + 1, count);
}

TransferMatrix insertion(const KnotVector& coarse, const KnotVector& fine) {
  return by_rows(coarse, fine, [&](int i, int span) {
    return blossom_row(coarse, span, knots_after(fine, i, fine.degree()));
  });
}

TransferMatrix raise_once(const KnotVector& coarse, const KnotVector& fine) {
  return by_rows(coarse, fine, [&](int i, int span) {
    const int q = fine.degree();
    const Eigen::VectorXd arguments = knots_after(fine, i, q);
    Eigen::RowVectorXd sum = Eigen::RowVectorXd::Zero(q);
    Eigen::VectorXd rest = arguments.tail(q - 1);
    for (int left_out = 0; left_out < q; ++left_out) {
      sum += blossom_row(coarse, span, rest);
      if (left_out + 1 < q) rest[left_out] = arguments[left_out];
    }
    return Eigen::RowVectorXd(sum / q);
  });
}

void check_nested(const KnotVector& raised, const KnotVector& fine) {
  const bool contained =
      raised.first() == fine.first() && raised.last() == fine.last() &&
      std::includes(fine.knots().begin(), fine.knots().end(), raised.knots().begin(), raised.knots().end());
  if (!contained)
    throw Error(ErrorCode::invalid_argument, "transfer: the fine knots do not contain the coarse ones");
}

}  // namespace

KnotVector with_knots(const KnotVector& knots, const std::vector<double>& inserted) {
  std::vector<double> all = knots.knots();
  for (const double t : inserted) {
    if (!(t > knots.first() && t < knots.last()))
      throw Error(ErrorCode::invalid_argument, fmt::format("cannot insert knot {}: it is not inside ({}, {})",
                                                           t, knots.first(), knots.last()));
    all.push_back(t);
  }
  std::sort(all.begin(), all.end());
  return KnotVector(knots.degree(), std::move(all));
}

KnotVector with_degree_raised(const KnotVector& knots, int times) {
  if (times < 0)
    throw Error(ErrorCode::invalid_argument, fmt::format("cannot raise the degree {} times", times));
  std::vector<double> all;
  const std::vector<double> breaks = knots.breaks();
  const std::vector<int> multiplicities = knots.multiplicities();
  for (std::size_t i = 0; i < breaks.size(); ++i)
    all.insert(all.end(), static_cast<std::size_t>(multiplicities[i] + times), breaks[i]);
  return KnotVector(knots.degree() + times, std::move(all));
}

TransferMatrix transfer(const KnotVector& coarse, const KnotVector& fine) {
  if (fine.degree() < coarse.degree())
    throw Error(ErrorCode::invalid_argument,
                fmt::format("transfer: the fine degree {} is below the coarse degree {}", fine.degree(),
                            coarse.degree()));
  KnotVector raised = coarse;
  TransferMatrix matrix(coarse.size(), coarse.size());
  matrix.setIdentity();
  while (raised.degree() < fine.degree()) {
    const KnotVector next = with_degree_raised(raised, 1);
    matrix = TransferMatrix(raise_once(raised, next) * matrix);
    raised = next;
  }
  check_nested(raised, fine);
  if (raised == fine) return matrix;
  return TransferMatrix(insertion(raised, fine) * matrix);
}

KnotVector bezier_knots(const KnotVector& knots) {
  std::vector<double> all;
  for (const double t : knots.breaks()) all.insert(all.end(), static_cast<std::size_t>(knots.degree()), t);
  all.insert(all.begin(), knots.first());
  all.push_back(knots.last());
  return KnotVector(knots.degree(), std::move(all));
}

}  // namespace isopatch::geometry
