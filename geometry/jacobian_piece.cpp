#include "geometry/jacobian_piece.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/determinant_bounds.hpp"

namespace isopatch::geometry {
// Both divide by the weight that makes the bound hold for the numerator's sign.
double JacobianPiece::lower() const {
  const double n = numerator.coefficients.minCoeff() - error;
  return n * scale / std::pow(n < 0 ? lowest_weight : highest_weight, 4);
}

double JacobianPiece::upper() const {
  const double n = numerator.coefficients.maxCoeff() + error;
  return n * scale / std::pow(n > 0 ? lowest_weight : highest_weight, 4);
}

double JacobianPiece::corner_numerator(int corner) const {
  const auto& [p, q, r] = numerator.degree;
  const int u = (corner & 1) != 0 ? p : 0;
  const int v = (corner & 2) != 0 ? q : 0;
  const int w = (corner & 4) != 0 ? r : 0;
  return numerator.coefficients[u + (p + 1) * (v + (q + 1) * w)];
}

int JacobianPiece::lowest_corner() const {
  int lowest = 0;
  for (int corner = 1; corner < 8; ++corner)
    if (corner_numerator(corner) < corner_numerator(lowest)) lowest = corner;
  return lowest;
}

Parameter<3> JacobianPiece::corner_parameter(int corner) const {
  Parameter<3> result = low;
  for (int d = 0; d < 3; ++d)
    if (((corner >> d) & 1) != 0) result[d] = high[d];
  return result;
}

std::array<JacobianPiece, 2> JacobianPiece::halved() const {
  const int direction = most_curved_direction(numerator);
  std::array<BernsteinPolynomial, 2> numerators = halves(numerator, direction);
  const double middle = 0.5 * (low[direction] + high[direction]);
  std::array<JacobianPiece, 2> parts;
  for (std::size_t i = 0; i < 2; ++i) {
    parts[i] = {std::move(numerators[i]),
                error + halving_error,
                halving_error,
                scale,
                lowest_weight,
                highest_weight,
                low,
                high,
                depth + 1};
    (i == 0 ? parts[i].high : parts[i].low)[direction] = middle;
  }
  return parts;
}

CentredVolume centred(const NurbsVolume& volume) {
  const Eigen::Matrix3Xd& given = volume.control_points();
  const Eigen::Vector3d middle = 0.5 * given.rowwise().minCoeff() + 0.5 * given.rowwise().maxCoeff();
  Eigen::Matrix3Xd points = given.colwise() - middle;
  double radius = points.cwiseAbs().maxCoeff();
  if (!(radius > 0)) radius = 1;
  return {NurbsVolume(volume.knots(), points / radius, volume.weights() / volume.weights().maxCoeff()),
          radius};
}

JacobianPiece jacobian_piece(const NurbsVolume& element, double radius) {
  JacobianExpansion expansion = expand_jacobian(element);
  JacobianPiece piece;
  piece.low = element.low();
  piece.high = element.high();
  piece.error = expansion.error;
  const auto& degree = expansion.numerator.degree;
  piece.halving_error = (*std::max_element(degree.begin(), degree.end()) + 2) * unit_roundoff *
                        expansion.numerator.coefficients.cwiseAbs().maxCoeff();
  piece.scale = radius * radius * radius / (piece.high - piece.low).prod();
  piece.lowest_weight = expansion.lowest_weight;
  piece.highest_weight = expansion.highest_weight;
  piece.numerator = std::move(expansion.numerator);
  return piece;
}

}  // namespace isopatch::geometry
