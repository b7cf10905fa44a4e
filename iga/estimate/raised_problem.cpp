#include "iga/estimate/raised_problem.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/base/error.hpp"
#include "geometry/splines/refine.hpp"
#include "geometry/splines/transfer.hpp"

namespace isopatch::iga {
namespace {

using geometry::NurbsVolume;

NurbsVolume::KnotVectors raised_knots(const NurbsVolume& patch) {
  NurbsVolume::KnotVectors knots = patch.knots();
  for (geometry::KnotVector& along : knots) along = geometry::with_degree_raised(along, 1);
  return knots;
}

// As many points as the solution had, so that its forces are those that balanced its loads, and enough for
// the products of the raised functions.
GaussPoints raised_points(const GaussPoints& points, const NurbsVolume& raised) {
  GaussPoints result = points;
  for (int d = 0; d < 3; ++d) {
    int& along = result[static_cast<std::size_t>(d)];
    along = std::max(along, raised.degree(d) + 1);
  }
  return result;
}

}  // namespace

ElasticityProblem with_degree_raised(const ElasticityProblem& problem, int points) {
  const Discretization& given = problem.discretization;
  ElasticityProblem result{{given.model, {}, {0}, {}}, problem.materials,    problem.supports,
                           problem.surface_loads,      problem.volume_loads, problem.temperatures,
                           problem.point_loads};
  Discretization& raised = result.discretization;
  for (std::size_t p = 0; p < given.patches.size(); ++p) {
    const NurbsVolume::KnotVectors knots = raised_knots(given.patches[p]);
    const double nodes = raised.first_node.back() + 1.0 * knots[0].size() * knots[1].size() * knots[2].size();
    if (3 * nodes > 2e9)
      throw Error(
          ErrorCode::unsupported,
          fmt::format("{:.3g} control points of one degree more, up to patch {}, are more than 32-bit "
                      "indices can count",
                      nodes, p));
    raised.first_node.push_back(static_cast<int>(nodes));
    raised.patches.push_back(geometry::refined(given.patches[p], knots));
    raised.gauss_points.push_back(
        raised_points(given.points_of(static_cast<int>(p), points), raised.patches.back()));
  }
  return result;
}

Eigen::Matrix3Xd in_raised_space(const ElasticityProblem& problem, const ElasticityProblem& raised,
                                 const std::vector<Eigen::Matrix3Xd>& displacement) {
  const Discretization& fine = raised.discretization;
  Eigen::Matrix3Xd result(3, fine.node_count());
  for (std::size_t p = 0; p < fine.patches.size(); ++p) {
    const NurbsVolume& patch = problem.discretization.patches[p];
    result.middleCols(fine.first_node[p], fine.patches[p].size()) =
        geometry::refined(NurbsVolume(patch.knots(), displacement[p], patch.weights()),
                          fine.patches[p].knots())
            .control_points();
  }
  return result;
}

}  // namespace isopatch::iga
