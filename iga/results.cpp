#include "iga/results.hpp"

#include <Eigen/Geometry>

#include "iga/element.hpp"

namespace isopatch::iga {
namespace {

geometry::QuadratureRule even_points(int degree) {
  return {Eigen::VectorXd::LinSpaced(degree + 1, 0.0, 1.0), Eigen::VectorXd::Ones(degree + 1)};
}

}  // namespace

Extremum max_displacement(const ElasticField& field) {
  Extremum result;
  result.value = -1;
  ElementValues values;
  for (std::size_t p = 0; p < field.patches.size(); ++p) {
    const auto& patch = field.patches[p];
    const ElementEvaluator evaluator(
        patch, {even_points(patch.degree(0)), even_points(patch.degree(1)), even_points(patch.degree(2))});
    for (std::int64_t e = 0; e < evaluator.element_count(); ++e) {
      evaluator.evaluate(e, values);
      Eigen::Matrix3Xd u(3, static_cast<Eigen::Index>(values.functions.size()));
      for (Eigen::Index a = 0; a < u.cols(); ++a)
        u.col(a) = field.displacement[p].col(values.functions[static_cast<std::size_t>(a)]);
      Eigen::Index at = 0;
      const double longest = (u * values.values).colwise().norm().maxCoeff(&at);
      if (longest > result.value)
        result = {longest, values.places.col(at), static_cast<int>(p), evaluator.parameter(e, at)};
    }
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
      for (int k = frame.free; k < 3; ++k) {
        Reaction& reaction = reactions[static_cast<std::size_t>(frame.support[static_cast<std::size_t>(k)])];
        const Eigen::Vector3d force = frame.axes.col(k) * frame.axes.col(k).dot(forces.col(node));
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
