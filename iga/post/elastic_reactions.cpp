#include "iga/post/elastic_reactions.hpp"

#include <Eigen/Geometry>

#include "iga/assembly/support_stiffness.hpp"

namespace isopatch::iga {

ElasticReactions elastic_reactions(const ElasticityProblem& problem, const Eigen::Matrix3Xd& displacement,
                                   const std::vector<PatchSpace>& spaces,
                                   const std::vector<PatchLayers>& parts) {
  const Discretization& d = problem.discretization;
  ElasticReactions result;
  result.forces = Eigen::Matrix3Xd::Zero(3, displacement.cols());
  for (const Support& support : problem.supports) {
    Reaction& reaction = result.reactions.emplace_back();
    reaction.support = support.name;
    const Springs springs = springs_of(problem, support);
    if (springs.empty()) continue;
    Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, displacement.cols());
    support_stiffness(spaces, parts, springs).add_forces(displacement, forces);
    for (std::size_t p = 0; p < d.patches.size(); ++p)
      for (int i = 0; i < d.patches[p].size(); ++i) {
        const Eigen::Vector3d force = -forces.col(d.first_node[p] + i);
        reaction.force += force;
        reaction.moment += Eigen::Vector3d(d.patches[p].control_points().col(i)).cross(force);
      }
    result.energy += 0.5 * forces.cwiseProduct(displacement).sum();
    result.forces += forces;
  }
  return result;
}

ElasticReactions summed(ElasticReactions share, const solvers::Processes& processes) {
  if (processes.count() == 1) return share;
  for (Reaction& reaction : share.reactions)
    for (Eigen::Vector3d* of : {&reaction.force, &reaction.moment})
      processes.sum(Eigen::Map<Eigen::VectorXd>(of->data(), 3));
  share.energy = processes.sum(share.energy);
  return share;
}

}  // namespace isopatch::iga
