#include "iga/results.hpp"

#include <Eigen/Geometry>

#include "geometry/splines/grid.hpp"

namespace isopatch::iga {
namespace {

// Every element's ends and `degree` - 1 parameters evenly between them.
std::vector<double> grid_parameters(const geometry::KnotVector& knots) {
  const std::vector<double> breaks = knots.breaks();
  std::vector<double> result = {knots.first()};
  for (std::size_t e = 0; e + 1 < breaks.size(); ++e)
    for (int k = 1; k <= knots.degree(); ++k)
      result.push_back(breaks[e] + (breaks[e + 1] - breaks[e]) * k / knots.degree());
  return result;
}

}  // namespace

Extremum max_displacement(const ElasticField& field) {
  Extremum result;
  result.value = -1;
  for (std::size_t p = 0; p < field.patches.size(); ++p) {
    const geometry::NurbsVolume& patch = field.patches[p];
    const geometry::GridParameters<3> grid = {
        grid_parameters(patch.knots(0)), grid_parameters(patch.knots(1)), grid_parameters(patch.knots(2))};
    const geometry::NurbsVolume moved(patch.knots(), field.displacement[p], patch.weights());
    Eigen::Index at = 0;
    const double longest = geometry::points_on_grid(moved, grid).colwise().norm().maxCoeff(&at);
    if (longest <= result.value) continue;
    const auto m = static_cast<Eigen::Index>(grid[0].size());
    const auto n = static_cast<Eigen::Index>(grid[1].size());
    const geometry::Parameter<3> parameter(grid[0][static_cast<std::size_t>(at % m)],
                                           grid[1][static_cast<std::size_t>(at / m % n)],
                                           grid[2][static_cast<std::size_t>(at / m / n)]);
    result = {longest, patch.point(parameter), static_cast<int>(p), parameter};
  }
  return result;
}

std::vector<Reaction> support_reactions(const ElasticityProblem& problem, const NodeClasses& classes,
                                        const std::vector<Frame>& frames, const Eigen::Matrix3Xd& forces) {
  const Discretization& d = problem.discretization;
  std::vector<Reaction> reactions;
  for (const Support& support : problem.supports)
    reactions.push_back({support.name, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
  for (int patch = 0; patch < d.patch_count(); ++patch) {
    const auto p = static_cast<std::size_t>(patch);
    for (int i = 0; i < d.patches[p].size(); ++i) {
      const int node = d.first_node[p] + i;
      const Frame& frame = frames[static_cast<std::size_t>(classes.class_of[static_cast<std::size_t>(node)])];
      // The residual is a sum of forces along the supports' own directions, which are triangular in the axes.
      Eigen::Vector3d rest = forces.col(node);
      for (int k = frame.free; k < 3; ++k) {
        const Eigen::Vector3d& direction = frame.direction[static_cast<std::size_t>(k)];
        const Eigen::Vector3d force =
            direction * (frame.axes.col(k).dot(rest) / frame.axes.col(k).dot(direction));
        rest -= force;
        Reaction& reaction = reactions[static_cast<std::size_t>(frame.support[static_cast<std::size_t>(k)])];
        reaction.force += force;
        // Rigid rotations have the control points' own displacements as coefficients, so this moment is
        // exact.
        reaction.moment += Eigen::Vector3d(d.patches[p].control_points().col(i)).cross(force);
      }
    }
  }
  return reactions;
}

}  // namespace isopatch::iga
