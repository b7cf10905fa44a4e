#include "geometry/models/twisted_beam.hpp"

#include <cmath>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/models/check_option.hpp"
#include "geometry/models/model_builder.hpp"
#include "geometry/splines/arc.hpp"
#include "geometry/splines/basis.hpp"

namespace isopatch::geometry {
namespace {

constexpr const char* twisted_beam_model_name = "twisted_beam";

// Coefficients of cos and sin of sweep * t, t in [0, 1]: interpolated at the breaks, with the slopes at both
// ends. The error is at most 5/384 of the piece's angle to the fourth power, 8e-7 for 5 degrees (Hall, Meyer
// 1976).
Eigen::MatrixX2d turn(const KnotVector& knots, double sweep) {
  const auto n = static_cast<Eigen::Index>(knots.size());
  Eigen::MatrixXd collocation = Eigen::MatrixXd::Zero(n, n);
  Eigen::MatrixX2d wanted(n, 2);
  const auto set_row = [&](Eigen::Index row, double t, int order) {
    const BasisValues values = basis(knots, t, order);
    collocation.row(row).segment(values.first, values.values.cols()) = values.values.row(order);
    if (order == 0)
      wanted.row(row) << std::cos(sweep * t), std::sin(sweep * t);
    else
      wanted.row(row) << -sweep * std::sin(sweep * t), sweep * std::cos(sweep * t);
  };
  const std::vector<double> breaks = knots.breaks();
  for (std::size_t i = 0; i < breaks.size(); ++i) set_row(static_cast<Eigen::Index>(i), breaks[i], 0);
  set_row(n - 2, knots.first(), 1);
  set_row(n - 1, knots.last(), 1);
  return solve_by_lu(collocation, wanted);
}

}  // namespace

void validate(const TwistedBeamOptions& options) {
  check_length(twisted_beam_model_name, "length", options.length);
  check_length(twisted_beam_model_name, "width", options.width);
  check_length(twisted_beam_model_name, "depth", options.depth);
  check_angle(twisted_beam_model_name, "twist", options.twist, Angle::degrees(720));
}

PatchSet twisted_beam_model(const TwistedBeamOptions& options) {
  validate(options);
  const KnotVector along = KnotVector::uniform(3, arc_piece_count(options.twist, Angle::degrees(5)));
  const Eigen::MatrixX2d axes = turn(along, options.twist.radians());
  const std::vector<double> places = along.greville();
  Eigen::Matrix3Xd points(3, 4 * along.size());
  Eigen::Index column = 0;
  for (const double z : {-0.5 * options.depth, 0.5 * options.depth})
    for (const double y : {-0.5 * options.width, 0.5 * options.width})
      for (Eigen::Index i = 0; i < axes.rows(); ++i) {
        const double cosine = axes(i, 0);
        const double sine = axes(i, 1);
        points.col(column++) << options.length * places[static_cast<std::size_t>(i)], y * cosine - z * sine,
            y * sine + z * cosine;
      }
  const KnotVector across = KnotVector::bezier(1);
  ModelBuilder builder;
  builder.add(NurbsVolume({along, across, across}, points), {{Side::west, "root"},
                                                             {Side::east, "tip"},
                                                             {Side::south, "sides"},
                                                             {Side::north, "sides"},
                                                             {Side::front, "sides"},
                                                             {Side::back, "sides"}});
  return builder.patches();
}

}  // namespace isopatch::geometry
