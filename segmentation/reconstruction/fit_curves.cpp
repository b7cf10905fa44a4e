#include "segmentation/reconstruction/internal/fit_curves.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "geometry/base/sparse_lu.hpp"
#include "geometry/splines/basis.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::KnotVector;
using geometry::NurbsCurve;

constexpr int curve_degree = 3;
constexpr int most_curve_rounds = 12;
// Of the largest entry of the equations: decides what points leave open, and nothing else.
constexpr double smoothing = 1e-9;

KnotVector knots_at(const std::set<double>& breaks) {
  std::vector<double> knots(curve_degree, 0.0);
  knots.insert(knots.end(), breaks.begin(), breaks.end());
  knots.insert(knots.end(), curve_degree, 1.0);
  return KnotVector(curve_degree, std::move(knots));
}

/// The normal equations of all points, and of vanishing differences of third order between control points.
class CurveEquations {
 public:
  CurveEquations(const KnotVector& knots, const CurveSample& sample)
      : matrix_(Eigen::MatrixXd::Zero(knots.size(), knots.size())),
        right_(Eigen::MatrixXd::Zero(knots.size(), 3)) {
    for (Eigen::Index i = 0; i < sample.t.size(); ++i) {
      const geometry::BasisValues at = geometry::basis(knots, sample.t[i]);
      const Eigen::VectorXd row = at.values.row(0).transpose();
      matrix_.block(at.first, at.first, row.size(), row.size()) += row * row.transpose();
      right_.middleRows(at.first, row.size()) += row * sample.points.col(i).transpose();
    }
    smooth();
  }

  /// Control points, the first and the last given.
  Eigen::Matrix3Xd solved(const Eigen::Vector3d& first, const Eigen::Vector3d& last) {
    const Eigen::Index n = matrix_.rows();
    for (const auto& [row, value] : {std::pair(Eigen::Index(0), first), std::pair(n - 1, last)}) {
      matrix_.row(row).setZero();
      matrix_(row, row) = 1;
      right_.row(row) = value.transpose();
    }
    return solve_by_lu(Eigen::SparseMatrix<double>(matrix_.sparseView()), right_)->transpose();
  }

 private:
  void smooth() {
    const double weight = smoothing * matrix_.diagonal().maxCoeff();
    const Eigen::Vector4d third(-1, 3, -3, 1);
    for (Eigen::Index i = 0; i + 3 < matrix_.rows(); ++i)
      matrix_.block<4, 4>(i, i) += weight * third * third.transpose();
  }

  Eigen::MatrixXd matrix_, right_;
};

NurbsCurve fitted(const KnotVector& knots, const CurveSample& sample) {
  CurveEquations equations(knots, sample);
  return NurbsCurve({knots}, equations.solved(sample.points.col(0), sample.points.col(sample.t.size() - 1)));
}

double off_at(const NurbsCurve& curve, const CurveSample& sample, Eigen::Index i) {
  return (curve.point(geometry::Parameter<1>(sample.t[i])) - sample.points.col(i)).norm();
}

}  // namespace

FittedCurves fit_curves(const std::vector<CurveSample>& samples, double tolerance) {
  std::set<double> breaks{0, 1};
  FittedCurves result;
  for (int round = 0; round < most_curve_rounds; ++round) {
    const KnotVector knots = knots_at(breaks);
    result = {};
    std::set<double> halved;
    for (const CurveSample& sample : samples) {
      result.curves.push_back(fitted(knots, sample));
      std::vector<int> inside(static_cast<std::size_t>(knots.size()), 0);
      for (Eigen::Index i = 0; i < sample.t.size(); ++i)
        ++inside[static_cast<std::size_t>(knots.span(sample.t[i]))];
      for (Eigen::Index i = 0; i < sample.t.size(); ++i) {
        const double off = off_at(result.curves.back(), sample, i);
        result.largest = std::max(result.largest, off);
        const int span = knots.span(sample.t[i]);
        const auto k = static_cast<std::size_t>(span);
        if (off > tolerance && inside[k] > 1) halved.insert((knots.knots()[k] + knots.knots()[k + 1]) / 2);
      }
    }
    if (halved.empty()) break;
    breaks.insert(halved.begin(), halved.end());
  }
  return result;
}

CurveSample by_length(const Eigen::Matrix3Xd& points) {
  CurveSample result{Eigen::VectorXd::Zero(points.cols()), points};
  for (Eigen::Index i = 1; i < points.cols(); ++i)
    result.t[i] = result.t[i - 1] + (points.col(i) - points.col(i - 1)).norm();
  result.t /= result.t[points.cols() - 1];
  return result;
}

}  // namespace isopatch::segmentation
