#include "iga/assembly/internal/side_grid.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/base/larger.hpp"
#include "geometry/quadrature.hpp"
#include "geometry/splines/grid.hpp"
#include "geometry/splines/tensor.hpp"

namespace isopatch::iga {
namespace {

using geometry::Side;
using Parameters = std::array<std::vector<double>, 2>;
using Tables = std::array<Eigen::SparseMatrix<double, Eigen::RowMajor>, 3>;

// A product of lines' splines, each by its own table of values or derivatives. (rows, points of all tables)
template <int Rows>
Eigen::Matrix<double, Rows, Eigen::Dynamic> on_tables(Eigen::Matrix<double, Rows, Eigen::Dynamic> values,
                                                      std::array<int, 3> sizes, int across,
                                                      const Tables& tables) {
  // Across first: only what lies on the sheet is left then.
  for (int step = 0; step < 3; ++step) {
    const int d = step == 0 ? across : step <= across ? step - 1 : step;
    const auto& table = tables[static_cast<std::size_t>(d)];
    values = geometry::apply_along<3>(values, sizes, d, table);
    sizes[static_cast<std::size_t>(d)] = static_cast<int>(table.rows());
  }
  return values;
}

// Values, or first derivatives by one direction, of splines on a sheet.
class OnSheet {
 public:
  OnSheet(const std::array<geometry::KnotVector, 3>& knots, Side side, double across, const Parameters& along)
      : across_(geometry::direction(side)) {
    const auto tangents = geometry::tangents(side);
    std::array<std::vector<double>, 3> parameters;
    parameters[static_cast<std::size_t>(across_)] = {across};
    for (std::size_t d = 0; d < 2; ++d) parameters[static_cast<std::size_t>(tangents[d])] = along[d];
    for (std::size_t d = 0; d < 3; ++d) {
      sizes_[d] = knots[d].size();
      for (int order = 0; order < 2; ++order)
        tables_[static_cast<std::size_t>(order)][d] = geometry::collocation(knots[d], parameters[d], order);
    }
  }

  // @param by  the direction of the patch to differentiate along; -1: none
  template <int Rows>
  Eigen::Matrix<double, Rows, Eigen::Dynamic> operator()(
      const Eigen::Matrix<double, Rows, Eigen::Dynamic>& coefficients, int by) const {
    Tables chosen;
    for (std::size_t d = 0; d < 3; ++d) chosen[d] = tables_[static_cast<int>(d) == by ? 1 : 0][d];
    return on_tables<Rows>(coefficients, sizes_, across_, chosen);
  }

 private:
  int across_;
  std::array<int, 3> sizes_;
  std::array<Tables, 2> tables_;  // by order
};

double end_of(const geometry::KnotVector& knots, Side side) {
  return geometry::is_high(side) ? knots.last() : knots.first();
}

}  // namespace

SideFunctions::SideFunctions(const PatchSpace& space, Side side, int first_node)
    : space_(&space), side_(side), first_node_(first_node) {
  const auto sizes = space.sizes();
  const std::array<int, 3> strides = {1, sizes[0], sizes[0] * sizes[1]};
  const auto across = static_cast<std::size_t>(geometry::direction(side));
  const auto along = geometry::tangents(side);
  for (std::size_t d = 0; d < 2; ++d) stride_[d] = strides[static_cast<std::size_t>(along[d])];
  const bool high = geometry::is_high(side);
  first_ = first_node + (high ? strides[across] * (sizes[across] - 1) : 0);
  behind_ = high ? -strides[across] : strides[across];
  const geometry::KnotVector& knots = space.knots[across];
  const auto slopes = geometry::collocation(knots, {end_of(knots, side)}, 1);
  slope_ = high ? std::array{slopes.coeff(0, knots.size() - 1), slopes.coeff(0, knots.size() - 2)}
                : std::array{slopes.coeff(0, 0), slopes.coeff(0, 1)};
}

const geometry::KnotVector& SideFunctions::knots(int along) const {
  return space_->knots[static_cast<std::size_t>(geometry::tangents(side_)[static_cast<std::size_t>(along)])];
}

double SideFunctions::weight(int i, int j, int layer) const {
  return space_->is_rational() ? space_->weights[node(i, j, layer) - first_node_] : 1.0;
}

Sheet sheet(const geometry::NurbsVolume& patch, Side side, double across, const Parameters& along) {
  const OnSheet on_sheet(patch.knots(), side, across, along);
  const Eigen::Matrix4Xd coefficients = patch.homogeneous();
  const Eigen::Matrix4Xd values = on_sheet(coefficients, -1);
  const auto derivative = [&](int direction) -> Eigen::Matrix3Xd {
    const Eigen::Matrix4Xd by = on_sheet(coefficients, direction);
    if (!patch.is_rational()) return by.topRows<3>() / patch.weights()[0];
    const Eigen::RowVectorXd slope = by.row(3).cwiseQuotient(values.row(3));
    return ((by.topRows<3>() - values.topRows<3>() * slope.asDiagonal()).array().rowwise() /
            values.row(3).array());
  };
  const auto tangents = geometry::tangents(side);
  return {{derivative(tangents[0]), derivative(tangents[1])}, derivative(geometry::direction(side))};
}

Eigen::MatrixXd weight_sums(const SideFunctions& functions, const Parameters& along, bool derivatives) {
  const PatchSpace& space = functions.space();
  const Side side = functions.side();
  const int across = geometry::direction(side);
  const OnSheet on_sheet(space.knots, side, end_of(space.knots[static_cast<std::size_t>(across)], side),
                         along);
  const Eigen::Matrix<double, 1, Eigen::Dynamic> weights = space.weights.transpose();
  const auto tangents = geometry::tangents(side);
  const Eigen::Matrix<double, 1, Eigen::Dynamic> values = on_sheet(weights, -1);
  if (!derivatives) return values;
  Eigen::MatrixXd result(4, values.cols());
  result.row(0) = values;
  result.row(1) = on_sheet(weights, tangents[0]);
  result.row(2) = on_sheet(weights, tangents[1]);
  result.row(3) = on_sheet(weights, across);
  return result;
}

Eigen::MatrixXd trace_constants(const SideFunctions& functions) {
  constexpr int points = 3;
  const PatchSpace& space = functions.space();
  const Side side = functions.side();
  const auto across = static_cast<std::size_t>(geometry::direction(side));
  const geometry::QuadratureRule rule = geometry::gauss_legendre(points);
  Parameters along;
  for (std::size_t d = 0; d < 2; ++d) {
    const std::vector<double> breaks = functions.knots(static_cast<int>(d)).breaks();
    for (std::size_t e = 0; e + 1 < breaks.size(); ++e)
      for (const double share : rule.nodes)
        along[d].push_back(breaks[e] + share * (breaks[e + 1] - breaks[e]));
  }
  const std::vector<double> breaks = space.knots[across].breaks();
  const bool high = geometry::is_high(side);
  const double from = high ? breaks[breaks.size() - 2] : breaks[0];
  const double length = (high ? breaks.back() : breaks[1]) - from;
  const auto normals = [](const Sheet& of) {
    Eigen::Matrix3Xd result(3, of.across.cols());
    for (Eigen::Index q = 0; q < result.cols(); ++q)
      result.col(q) = Eigen::Vector3d(of.along[0].col(q)).cross(Eigen::Vector3d(of.along[1].col(q)));
    return result;
  };
  const Eigen::RowVectorXd areas =
      normals(sheet(*space.geometry, side, end_of(space.knots[across], side), along)).colwise().norm();
  const auto count = static_cast<Eigen::Index>(along[0].size());
  Eigen::MatrixXd thickness =
      Eigen::MatrixXd::Constant(count / points, static_cast<Eigen::Index>(along[1].size()) / points,
                                std::numeric_limits<double>::infinity());
  for (const double share : rule.nodes) {
    const Sheet at = sheet(*space.geometry, side, from + share * length, along);
    const Eigen::Matrix3Xd cofactors = normals(at);
    for (Eigen::Index q = 0; q < areas.size(); ++q) {
      double& least = thickness(q % count / points, q / count / points);
      least = smaller(least, std::abs(cofactors.col(q).dot(at.across.col(q))) * length / areas[q]);
    }
  }
  const int degree = space.knots[across].degree();
  return (degree + 1) * (degree + 1) / thickness.array();
}

std::array<int, 2> points_of_rectangle(const SideFunctions& own, const SideFunctions& other) {
  const auto along = geometry::tangents(own.side()), of_other = geometry::tangents(other.side());
  const int least =
      std::max(other.space().points_along(of_other[0], 0), other.space().points_along(of_other[1], 0));
  return {std::max(own.space().points_along(along[0], 0), least),
          std::max(own.space().points_along(along[1], 0), least)};
}

}  // namespace isopatch::iga
