#pragma once

#include <random>
#include <vector>

#include "geometry/splines/nurbs.hpp"

namespace isopatch::geometry::test {

/// Up to four elements of random lengths on a random range, inner knots of random multiplicity up to the
/// degree.
inline KnotVector random_knots(std::mt19937& random, int degree) {
  std::uniform_real_distribution<double> length(0.2, 2);
  std::uniform_int_distribution<int> multiplicity(1, degree);
  std::uniform_int_distribution<int> inner(0, 3);
  double t = length(random) - 1;
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, t);
  for (int i = inner(random); i > 0; --i)
    knots.insert(knots.end(), static_cast<std::size_t>(multiplicity(random)), t += length(random));
  knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, t + length(random));
  return KnotVector(degree, knots);
}

template <int D>
Nurbs<D> random_nurbs(std::mt19937& random, int max_degree, bool rational) {
  std::uniform_int_distribution<int> degree(1, max_degree);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  std::uniform_real_distribution<double> weight(0.5, 2);
  typename Nurbs<D>::KnotVectors knots;
  Eigen::Index count = 1;
  for (KnotVector& k : knots) {
    k = random_knots(random, degree(random));
    count *= k.size();
  }
  Eigen::Matrix3Xd points(3, count);
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(count);
  for (Eigen::Index i = 0; i < points.size(); ++i) points.data()[i] = coordinate(random);
  if (rational)
    for (Eigen::Index i = 0; i < count; ++i) weights[i] = weight(random);
  return Nurbs<D>(knots, points, weights);
}

template <int D>
Parameter<D> random_parameter(std::mt19937& random, const Nurbs<D>& spline) {
  std::uniform_real_distribution<double> share(0, 1);
  Parameter<D> result;
  for (int d = 0; d < D; ++d) result[d] = spline.knots(d).first() + share(random) * spline.knots(d).length();
  return result;
}

/// A point by de Casteljau's algorithm: the plain reference, for a single Bezier piece.
template <int D>
Eigen::Vector3d de_casteljau(const Nurbs<D>& piece, const Parameter<D>& parameter) {
  Eigen::Matrix4Xd rest = piece.homogeneous();
  Eigen::Index inner = rest.cols();
  for (int d = D - 1; d >= 0; --d) {
    const double share = (parameter[d] - piece.knots(d).first()) / piece.knots(d).length();
    inner /= piece.size(d);
    for (Eigen::Index left = piece.size(d) - 1; left > 0; --left)
      for (Eigen::Index i = 0; i < left * inner; ++i)
        rest.col(i) = (1 - share) * rest.col(i) + share * rest.col(i + inner);
  }
  return rest.col(0).head<3>() / rest(3, 0);
}

}  // namespace isopatch::geometry::test
