#include "geometry/jacobian_grid.hpp"

#include <vector>

#include "geometry/splines/basis.hpp"

namespace isopatch::geometry {
namespace {

/// Basis functions at one parameter: the first one that is not zero, values and derivatives of all of them.
using Row = BasisValues;

std::vector<Row> rows_at(const KnotVector& knots, const std::vector<double>& parameters) {
  std::vector<Row> result;
  for (const double t : parameters) result.push_back(basis(knots, t, 1));
  return result;
}

/// What is contracted: orders of differentiation along the three directions.
struct Order {
  std::array<int, 3> along;
};
constexpr std::array<Order, 4> orders = {{{{1, 0, 0}}, {{0, 1, 0}}, {{0, 0, 1}}, {{0, 0, 0}}}};

/// A volume's coordinates one by one, homogeneous if it is rational, and the basis functions on a grid.
class GridSums {
 public:
  GridSums(const NurbsVolume& volume, const GridParameters<3>& parameters)
      : sizes_(volume.sizes()), rational_(volume.is_rational()) {
    for (std::size_t d = 0; d < 3; ++d) rows_[d] = rows_at(volume.knots()[d], parameters[d]);
    const Eigen::Index layer = Eigen::Index(sizes_[0]) * sizes_[1];
    const auto add = [&](const Eigen::RowVectorXd& values) {
      coordinates_.emplace_back(values.reshaped(layer, sizes_[2]));
    };
    if (rational_) {
      const Eigen::Matrix4Xd homogeneous = volume.homogeneous();
      for (int c = 0; c < 4; ++c) add(homogeneous.row(c));
    } else {
      for (int c = 0; c < 3; ++c) add(volume.control_points().row(c));
    }
  }

  std::size_t fields() const { return rational_ ? 4 : 3; }
  int count(std::size_t direction) const { return static_cast<int>(rows_[direction].size()); }

  /// Sums along the third direction at one of its parameters, then along the second at all of them: for each
  /// field and coordinate (parameters of the second direction, control points of the first).
  void enter_layer(int third) {
    const Row& row = rows_[2][static_cast<std::size_t>(third)];
    for (std::size_t c = 0; c < coordinates_.size(); ++c)
      for (std::size_t f = 0; f < fields(); ++f) {
        const Eigen::VectorXd layer = coordinates_[c].middleCols(row.first, row.values.cols()) *
                                      row.values.row(orders[f].along[2]).transpose();
        layers_[f][c] = along_second(layer.reshaped(sizes_[0], sizes_[1]), orders[f].along[1]);
      }
  }

  /// The sums along the first direction, of the present layer.
  Eigen::ArrayXd line(std::size_t field, std::size_t coordinate, int first) const {
    const Row& row = rows_[0][static_cast<std::size_t>(first)];
    return (layers_[field][coordinate].middleCols(row.first, row.values.cols()) *
            row.values.row(orders[field].along[0]).transpose())
        .array();
  }

 private:
  Eigen::MatrixXd along_second(const Eigen::MatrixXd& layer, int order) const {
    Eigen::MatrixXd result(count(1), layer.rows());
    for (int j = 0; j < count(1); ++j) {
      const Row& row = rows_[1][static_cast<std::size_t>(j)];
      scratch_.noalias() = layer.middleCols(row.first, row.values.cols()) * row.values.row(order).transpose();
      result.row(j) = scratch_;
    }
    return result;
  }

  std::array<int, 3> sizes_;
  bool rational_;
  std::array<std::vector<Row>, 3> rows_;
  std::vector<Eigen::MatrixXd> coordinates_;  ///< (layer, third direction), by coordinate
  std::array<std::array<Eigen::MatrixXd, 4>, 4> layers_;
  mutable Eigen::VectorXd scratch_;
};

}  // namespace

Eigen::ArrayXd JacobianLine::determinants() const {
  const auto& [u, v, w] = columns;
  return u.col(0) * (v.col(1) * w.col(2) - v.col(2) * w.col(1)) +
         u.col(1) * (v.col(2) * w.col(0) - v.col(0) * w.col(2)) +
         u.col(2) * (v.col(0) * w.col(1) - v.col(1) * w.col(0));
}

Eigen::ArrayXd JacobianLine::squared_lengths() const {
  const auto squared = [](const Eigen::ArrayX3d& column) {
    return column.col(0).square() + column.col(1).square() + column.col(2).square();
  };
  return squared(columns[0]) * squared(columns[1]) * squared(columns[2]);
}

void for_each_line(const NurbsVolume& volume, const GridParameters<3>& parameters,
                   const std::function<void(const JacobianLine&)>& visit) {
  GridSums sums(volume, parameters);
  JacobianLine line;
  for (auto& column : line.columns) column.resize(sums.count(1), 3);
  for (line.third = 0; line.third < sums.count(2); ++line.third) {
    sums.enter_layer(line.third);
    for (line.first = 0; line.first < sums.count(0); ++line.first) {
      for (std::size_t d = 0; d < 3; ++d)
        for (int c = 0; c < 3; ++c)
          line.columns[d].col(c) = sums.line(d, static_cast<std::size_t>(c), line.first);
      if (volume.is_rational()) {
        const Eigen::ArrayXd weight = sums.line(3, 3, line.first);
        for (int c = 0; c < 3; ++c) {
          const Eigen::ArrayXd point = sums.line(3, static_cast<std::size_t>(c), line.first) / weight;
          for (std::size_t d = 0; d < 3; ++d)
            line.columns[d].col(c) = (line.columns[d].col(c) - sums.line(d, 3, line.first) * point) / weight;
        }
      }
      visit(line);
    }
  }
}

}  // namespace isopatch::geometry
