#include "iga/gauss_points.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "geometry/scaled_jacobian.hpp"
#include "geometry/splines/basis.hpp"
#include "iga/element_tables.hpp"

namespace isopatch::iga {
namespace {

using Eigen::Index;
using Eigen::Matrix3d;
using Eigen::Matrix4Xd;
using Eigen::Vector3d;
using geometry::NurbsVolume;

constexpr int samples = 16;            // on a line through an element: degrees up to 15 are told apart
constexpr double exact = 1e-9;         // relative, of cofactors
constexpr double of_an_energy = 2e-2;  // relative, of cofactors squared over det J
constexpr int most_for_energy = 4;     // points more than degree + 1: beyond that a pole is near
constexpr int most_more = 8;           // points more than degree + 1
constexpr std::size_t most_elements = 8;

// Orthonormal Legendre polynomials on [0, 1] times the weights at the sample points, a row each.
const Eigen::MatrixXd& legendre_rows() {
  static const Eigen::MatrixXd rows = [] {
    const geometry::QuadratureRule rule = geometry::gauss_legendre(samples);
    Eigen::MatrixXd result(samples, samples);
    for (int q = 0; q < samples; ++q) {
      const double x = 2 * rule.nodes[q] - 1;
      double before = 0, here = 1;
      for (int k = 0; k < samples; ++k) {
        result(k, q) = std::sqrt(2.0 * k + 1) * here * rule.weights[q];
        const double next = ((2 * k + 1) * x * here - k * before) / (k + 1);
        before = here;
        here = next;
      }
    }
    return result;
  }();
  return rows;
}

// Degree of the polynomials that all columns are, to `tolerance` times `scale`. (samples, functions)
template <class Columns>
int degree_of(const Columns& functions, double tolerance, double scale) {
  const Eigen::MatrixXd coefficients = legendre_rows() * functions;
  int degree = samples - 1;
  double tail = 0;
  while (degree > 0) {
    tail += coefficients.row(degree).squaredNorm();
    if (!(std::sqrt(tail) <= tolerance * scale)) break;
    --degree;
  }
  return degree;
}

// Some of the elements of a direction, spread evenly, both ends among them.
std::vector<int> some_elements(int count, std::size_t most) {
  std::set<int> chosen;
  for (std::size_t i = 0; i < most; ++i)
    chosen.insert(static_cast<int>(std::lround(static_cast<double>(i) * (count - 1) /
                                               static_cast<double>(std::max<std::size_t>(1, most - 1)))));
  return {chosen.begin(), chosen.end()};
}

// Where a direction is crossed, and how long the element is there.
struct Crossing {
  geometry::BasisValues basis;
  double length;
};

std::vector<Crossing> crossings(const geometry::KnotVector& knots) {
  const std::vector<double> breaks = knots.breaks();
  const std::size_t last = breaks.size() - 2;
  std::vector<Crossing> result;
  for (const auto& [element, share] :
       {std::pair(std::size_t{0}, 0.1), std::pair(last / 2, 0.5), std::pair(last, 0.9)}) {
    const double length = breaks[element + 1] - breaks[element];
    result.push_back({geometry::basis(knots, breaks[element] + share * length, 1), length});
  }
  return result;
}

// Coefficients along direction d of the homogeneous map and of its derivatives across, on one line.
struct MapLine {
  Matrix4Xd value, across_a, across_b;
};

class Choice {
 public:
  Choice(const NurbsVolume& patch, int direction)
      : patch_(patch),
        d_(direction),
        a_((direction + 1) % 3),
        b_((direction + 2) % 3),
        homogeneous_(patch.homogeneous()),
        table_(direction_table(patch.knots(direction), geometry::gauss_legendre(samples))),
        breaks_(patch.knots(direction).breaks()) {}

  int points() const {
    int result = patch_.degree(d_) + 1;
    const std::vector<int> elements = some_elements(static_cast<int>(table_.elements.size()), most_elements);
    for (const Crossing& a : crossings(patch_.knots(a_)))
      for (const Crossing& b : crossings(patch_.knots(b_))) {
        const MapLine line = along(a.basis, b.basis);
        for (const int element : elements) result = std::max(result, on_element(line, element, a, b));
      }
    return std::min(result, patch_.degree(d_) + 1 + most_more);
  }

 private:
  MapLine along(const geometry::BasisValues& a, const geometry::BasisValues& b) const {
    const std::array<Index, 3> stride = {1, patch_.size(0), Index{patch_.size(0)} * patch_.size(1)};
    const auto of = [&](int direction) { return stride[static_cast<std::size_t>(direction)]; };
    MapLine line;
    for (Matrix4Xd* part : {&line.value, &line.across_a, &line.across_b}) part->setZero(4, patch_.size(d_));
    for (Index j = 0; j < b.values.cols(); ++j)
      for (Index i = 0; i < a.values.cols(); ++i) {
        const Index start = (a.first + i) * of(a_) + (b.first + j) * of(b_);
        for (Index k = 0; k < patch_.size(d_); ++k) {
          const auto h = homogeneous_.col(start + k * of(d_));
          line.value.col(k) += a.values(0, i) * b.values(0, j) * h;
          line.across_a.col(k) += a.values(1, i) * b.values(0, j) * h;
          line.across_b.col(k) += a.values(0, i) * b.values(1, j) * h;
        }
      }
    return line;
  }

  int on_element(const MapLine& line, int number, const Crossing& a, const Crossing& b) const {
    const auto e = static_cast<std::size_t>(number);
    const DirectionTable::Element& element = table_.elements[e];
    const double length = breaks_[e + 1] - breaks_[e];
    // Cofactors of the three columns over the weight, what rational functions add, and their products over
    // the determinant. All are per length of the element.
    Eigen::Matrix<double, samples, 3> own, rate;
    Eigen::Matrix<double, samples, 6> across;
    Eigen::Matrix<double, samples, 6> squares;
    for (int q = 0; q < samples; ++q) {
      const auto at = [&](const Matrix4Xd& coefficients, const Eigen::MatrixXd& functions) {
        return Eigen::Vector4d(coefficients.middleCols(element.first, functions.cols()) *
                               functions.row(q).transpose());
      };
      const Eigen::Vector4d h = at(line.value, element.values);
      const std::array<Eigen::Vector4d, 3> derivatives = {length * at(line.value, element.derivatives),
                                                          a.length * at(line.across_a, element.values),
                                                          b.length * at(line.across_b, element.values)};
      Matrix3d jacobian;
      for (int k = 0; k < 3; ++k) {
        const Eigen::Vector4d& derivative = derivatives[static_cast<std::size_t>(k)];
        jacobian.col(k) = (derivative.head<3>() - derivative[3] * h.head<3>() / h[3]) / h[3];
      }
      Matrix3d cofactors;
      for (int k = 0; k < 3; ++k)
        cofactors.col(k) = jacobian.col((k + 1) % 3).cross(jacobian.col((k + 2) % 3)) / h[3];
      const double determinant = h[3] * jacobian.col(0).dot(cofactors.col(0));
      own.row(q) = cofactors.col(0).transpose();
      across.row(q) << cofactors.col(1).transpose(), cofactors.col(2).transpose();
      Vector3d sum = Vector3d::Zero();
      for (int k = 0; k < 3; ++k)
        sum += derivatives[static_cast<std::size_t>(k)][3] / h[3] * cofactors.col(k);
      rate.row(q) = sum.transpose();
      const Matrix3d products = cofactors.transpose() * cofactors / determinant;
      squares.row(q) << products.diagonal().transpose(), products(0, 1), products(1, 2), products(2, 0);
    }
    const double root = std::sqrt(static_cast<double>(samples));
    const double area = std::max(own.norm(), across.norm()) / root;
    const int p = patch_.degree(d_);
    // Of degree p - 1 along its own direction is a derivative, p all else that cofactors are multiplied by.
    int degree = p - 1 + degree_of(own, exact, area);
    degree = std::max(degree, p + degree_of(across, exact, area));
    if (patch_.is_rational()) degree = std::max(degree, p + degree_of(rate, exact, area));
    const int for_energy = std::min(2 * p + degree_of(squares, of_an_energy, squares.norm() / root),
                                    2 * (p + most_for_energy) + 1);
    degree = std::max(degree, for_energy);
    return degree / 2 + 1;  // n points integrate degree 2 n - 1
  }

  const NurbsVolume& patch_;
  int d_, a_, b_;
  Matrix4Xd homogeneous_;
  DirectionTable table_;
  std::vector<double> breaks_;
};

// Whether the map is affine: control points at the averages of knots.
bool is_affine(const NurbsVolume& patch) {
  if (patch.is_rational()) return false;
  const Matrix3d jacobian = patch.jacobian(patch.low());
  const Vector3d start = patch.control_points().col(0);
  std::array<std::vector<double>, 3> greville;
  for (int d = 0; d < 3; ++d) greville[static_cast<std::size_t>(d)] = patch.knots(d).greville();
  const double size = (patch.control_points().col(patch.size() - 1) - start).cwiseAbs().maxCoeff();
  Index index = 0;
  for (const double w : greville[2])
    for (const double v : greville[1])
      for (const double u : greville[0]) {
        const Vector3d expected = start + jacobian * (Vector3d(u, v, w) - patch.low());
        // Round-off of coordinates that may be far from the origin.
        const double allowed = 1e-12 * (size + start.cwiseAbs().maxCoeff());
        if (!((patch.control_points().col(index++) - expected).cwiseAbs().maxCoeff() <= allowed))
          return false;
      }
  return true;
}

// Whether the map is folded or collapsed somewhere, ends included: there the integrands have no degree, and
// more points only come nearer to where det J is not positive.
bool degenerates(const NurbsVolume& patch) {
  constexpr int steps = 6;
  const Vector3d range = patch.high() - patch.low();
  for (int k = 0; k <= steps; ++k)
    for (int j = 0; j <= steps; ++j)
      for (int i = 0; i <= steps; ++i) {
        const Matrix3d jacobian = patch.jacobian(patch.low() + range.cwiseProduct(Vector3d(i, j, k) / steps));
        if (!(geometry::scaled_jacobian(jacobian) > 0.01)) return true;
      }
  return false;
}

}  // namespace

GaussPoints gauss_points(const NurbsVolume& patch) {
  const GaussPoints least = {patch.degree(0) + 1, patch.degree(1) + 1, patch.degree(2) + 1};
  if (is_affine(patch)) return least;
  const GaussPoints chosen = {Choice(patch, 0).points(), Choice(patch, 1).points(),
                              Choice(patch, 2).points()};
  return chosen == least || degenerates(patch) ? least : chosen;
}

std::array<geometry::QuadratureRule, 3> gauss_rules(const GaussPoints& points) {
  return {geometry::gauss_legendre(points[0]), geometry::gauss_legendre(points[1]),
          geometry::gauss_legendre(points[2])};
}

}  // namespace isopatch::iga
