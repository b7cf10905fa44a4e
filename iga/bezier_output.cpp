#include "iga/bezier_output.hpp"

#include <Eigen/LU>

#include "geometry/splines/basis.hpp"
#include "geometry/splines/refine.hpp"
#include "geometry/splines/tensor.hpp"
#include "geometry/splines/transfer.hpp"
#include "iga/element.hpp"

namespace isopatch::iga {
namespace {

using geometry::NurbsVolume;

// Bernstein values at the Gauss points of one direction: from coefficients to values there, and back.
struct GaussInterpolation {
  explicit GaussInterpolation(int degree) : values(degree + 1, degree + 1) {
    const geometry::QuadratureRule rule = geometry::gauss_legendre(degree + 1);
    const geometry::KnotVector knots = geometry::KnotVector::bezier(degree);
    for (Eigen::Index q = 0; q <= degree; ++q)
      values.row(q) = geometry::basis(knots, rule.nodes[q]).values.row(0);
    inverse = values.inverse();
  }
  Eigen::MatrixXd values;
  Eigen::MatrixXd inverse;
};
using Interpolations = std::array<GaussInterpolation, 3>;

// Fields at the Gauss points of one element, one column per point.
struct PointValues {
  Eigen::Matrix<double, 6, Eigen::Dynamic> stress;
  Eigen::RowVectorXd von_mises;
  Eigen::RowVectorXd jacobian;
};

PointValues at_gauss_points(const ElementValues& values, const Eigen::Matrix3Xd& displacement,
                            const Material& material) {
  const Eigen::Index points = values.jacobians.size();
  PointValues result{{6, points}, Eigen::RowVectorXd(points), values.jacobians.transpose()};
  Eigen::Matrix3Xd u(3, static_cast<Eigen::Index>(values.functions.size()));
  for (Eigen::Index a = 0; a < u.cols(); ++a)
    u.col(a) = displacement.col(values.functions[static_cast<std::size_t>(a)]);
  for (Eigen::Index q = 0; q < points; ++q) {
    Eigen::Matrix3d gradient;
    for (int j = 0; j < 3; ++j) gradient.col(j) = u * values.gradients[static_cast<std::size_t>(j)].col(q);
    const Eigen::Matrix3d s = stress(0.5 * (gradient + gradient.transpose()), material);
    result.stress.col(q) << s(0, 0), s(1, 1), s(2, 2), s(0, 1), s(1, 2), s(0, 2);
    result.von_mises[q] = von_mises(s);
  }
  return result;
}

// Coefficients in the cell's rational basis of the functions that take the given values at the Gauss points:
// the numerator, values times weight function, is interpolated, then divided by the weights.
Eigen::MatrixXd coefficients(const Eigen::MatrixXd& values, const NurbsVolume& piece,
                             const Interpolations& interpolations,
                             const Eigen::RowVectorXd& weight_function) {
  Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic> c =
      values.array().rowwise() * weight_function.array();
  for (int d = 0; d < 3; ++d)
    c = geometry::apply_along<3, Eigen::Dynamic>(c, piece.sizes(), d,
                                                 interpolations[static_cast<std::size_t>(d)].inverse);
  return c.array().rowwise() / piece.weights().transpose().array();
}

Eigen::RowVectorXd weight_at_gauss_points(const NurbsVolume& piece, const Interpolations& interpolations) {
  Eigen::Matrix<double, 1, Eigen::Dynamic> w = piece.weights().transpose();
  for (int d = 0; d < 3; ++d)
    w = geometry::apply_along<3, 1>(w, piece.sizes(), d, interpolations[static_cast<std::size_t>(d)].values);
  return w;
}

}  // namespace

geometry::BezierCells bezier_cells(const ElasticField& field, int patch) {
  const auto p = static_cast<std::size_t>(patch);
  const NurbsVolume& volume = field.patches[p];
  const Material& material = field.materials[p];
  const std::vector<NurbsVolume> pieces = geometry::bezier_pieces(volume);
  const std::vector<NurbsVolume> moved =
      geometry::bezier_pieces(NurbsVolume(volume.knots(), field.displacement[p], volume.weights()));
  const Eigen::Index per_cell = pieces.front().size();
  const Eigen::Index total = per_cell * static_cast<Eigen::Index>(pieces.size());

  geometry::BezierCells cells;
  cells.degree = {volume.degree(0), volume.degree(1), volume.degree(2)};
  cells.cell_count = static_cast<int>(pieces.size());
  cells.points.resize(3, total);
  cells.weights.resize(total);
  cells.point_fields = {{"displacement", Eigen::MatrixXd(3, total)},
                        {"stress", Eigen::MatrixXd(6, total)},
                        {"von_mises", Eigen::MatrixXd(1, total)},
                        {"jacobian", Eigen::MatrixXd(1, total)}};
  cells.cell_fields = {{"patch", Eigen::MatrixXd::Constant(1, cells.cell_count, patch)}};

  const Interpolations interpolations = {GaussInterpolation(volume.degree(0)),
                                         GaussInterpolation(volume.degree(1)),
                                         GaussInterpolation(volume.degree(2))};
  const ElementEvaluator evaluator(volume, 0);
  ElementValues values;
  for (std::size_t e = 0; e < pieces.size(); ++e) {
    const Eigen::Index first = per_cell * static_cast<Eigen::Index>(e);
    cells.points.middleCols(first, per_cell) = pieces[e].control_points();
    cells.weights.segment(first, per_cell) = pieces[e].weights();
    cells.point_fields[0].values.middleCols(first, per_cell) = moved[e].control_points();
    evaluator.evaluate(static_cast<std::int64_t>(e), values);
    const PointValues at = at_gauss_points(values, field.displacement[p], material);
    const Eigen::RowVectorXd weight = weight_at_gauss_points(pieces[e], interpolations);
    cells.point_fields[1].values.middleCols(first, per_cell) =
        coefficients(at.stress, pieces[e], interpolations, weight);
    cells.point_fields[2].values.middleCols(first, per_cell) =
        coefficients(at.von_mises, pieces[e], interpolations, weight);
    cells.point_fields[3].values.middleCols(first, per_cell) =
        coefficients(at.jacobian, pieces[e], interpolations, weight);
  }
  return cells;
}

}  // namespace isopatch::iga
