#include "iga/elastic_field.hpp"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/measures.hpp"
#include "geometry/splines/basis.hpp"

namespace isopatch::iga {
namespace {

using geometry::NurbsVolume;
using geometry::Parameter;

// The same functions with the displacement in place of the control points.
NurbsVolume displacement_map(const ElasticField& field, int patch) {
  const auto p = static_cast<std::size_t>(patch);
  return NurbsVolume(field.patches[p].knots(), field.displacement[p], field.patches[p].weights());
}

Parameter<3> clamped(const NurbsVolume& patch, const Parameter<3>& parameter) {
  return parameter.cwiseMax(patch.low()).cwiseMin(patch.high());
}

// Gauss-Newton for the closest point, with the parameter kept in the domain and steps halved while they do
// not help.
Location closest(const NurbsVolume& patch, int index, const Eigen::Vector3d& place, Parameter<3> start) {
  Location best{index, start, (patch.point(start) - place).norm()};
  for (int iteration = 0; iteration < 50; ++iteration) {
    const Eigen::Matrix3d jacobian = patch.jacobian(best.parameter);
    Parameter<3> step = jacobian.fullPivLu().solve(place - patch.point(best.parameter));
    // Directions that point out of the domain are dropped and the others solved for again.
    std::vector<int> kept;
    for (int d = 0; d < 3; ++d) {
      const double target = best.parameter[d] + step[d];
      const bool stuck = (best.parameter[d] <= patch.knots(d).first() && target < best.parameter[d]) ||
                         (best.parameter[d] >= patch.knots(d).last() && target > best.parameter[d]);
      if (!stuck) kept.push_back(d);
    }
    if (kept.empty()) break;
    if (kept.size() < 3) {
      Eigen::MatrixXd reduced(3, kept.size());
      for (std::size_t k = 0; k < kept.size(); ++k)
        reduced.col(static_cast<Eigen::Index>(k)) = jacobian.col(kept[k]);
      const Eigen::VectorXd part = reduced.colPivHouseholderQr().solve(place - patch.point(best.parameter));
      step.setZero();
      for (std::size_t k = 0; k < kept.size(); ++k) step[kept[k]] = part[static_cast<Eigen::Index>(k)];
    }
    bool moved = false;
    for (int halving = 0; halving < 12 && !moved; ++halving, step *= 0.5) {
      const Parameter<3> next = clamped(patch, best.parameter + step);
      const double distance = (patch.point(next) - place).norm();
      if (distance < best.distance) {
        best = {index, next, distance};
        moved = true;
      }
    }
    if (!moved) break;
  }
  return best;
}

}  // namespace

double von_mises(const Eigen::Matrix3d& stress) {
  const Eigen::Matrix3d deviator = stress - stress.trace() / 3 * Eigen::Matrix3d::Identity();
  return std::sqrt(1.5) * deviator.norm();
}

FieldValues evaluate(const ElasticField& field, int patch, const Parameter<3>& parameter) {
  const auto p = static_cast<std::size_t>(patch);
  const NurbsVolume map = displacement_map(field, patch);
  const Eigen::Matrix3d jacobian = field.patches[p].jacobian(parameter);
  const Eigen::Matrix3d gradient = map.jacobian(parameter) * jacobian.inverse();
  FieldValues values;
  values.place = field.patches[p].point(parameter);
  values.displacement = map.point(parameter);
  values.strain = 0.5 * (gradient + gradient.transpose());
  values.stress = stress(values.strain, field.materials[p]);
  values.von_mises = von_mises(values.stress);
  values.jacobian = jacobian.determinant();
  return values;
}

Location locate(const ElasticField& field, const Eigen::Vector3d& place) {
  Location best;
  best.distance = std::numeric_limits<double>::infinity();
  for (std::size_t p = 0; p < field.patches.size(); ++p) {
    const NurbsVolume& patch = field.patches[p];
    if (geometry::box(patch).exteriorDistance(place) > best.distance) continue;
    // The nearest of a grid of points with two per element starts the iteration.
    Parameter<3> start = patch.low();
    double nearest = std::numeric_limits<double>::infinity();
    std::array<std::vector<double>, 3> grid;
    for (int d = 0; d < 3; ++d) {
      const std::vector<double> breaks = patch.knots(d).breaks();
      for (std::size_t e = 0; e + 1 < breaks.size(); ++e)
        for (const double share : {0.25, 0.75})
          grid[static_cast<std::size_t>(d)].push_back(breaks[e] + share * (breaks[e + 1] - breaks[e]));
    }
    for (const double w : grid[2]) {
      for (const double v : grid[1]) {
        for (const double u : grid[0]) {
          const double distance = (patch.point({u, v, w}) - place).norm();
          if (distance < nearest) {
            nearest = distance;
            start = {u, v, w};
          }
        }
      }
    }
    const Location found = closest(patch, static_cast<int>(p), place, start);
    if (found.distance < best.distance) best = found;
  }
  return best;
}

}  // namespace isopatch::iga
