#include "verification/suites/node_forces.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "geometry/base/larger.hpp"
#include "iga/coupling/global_nodes.hpp"
#include "iga/coupling/support_frames.hpp"

namespace isopatch::verification {
namespace {

// Patches that are joined to `start` without the interface `left_out`.
std::vector<PatchId> piece_of(const geometry::MultiPatch& model, PatchId start, std::size_t left_out) {
  std::vector<PatchId> piece = {start};
  for (std::size_t next = 0; next < piece.size(); ++next)
    for (std::size_t i = 0; i < model.interfaces().size(); ++i) {
      const geometry::Interface& interface = model.interfaces()[i];
      if (i == left_out || (interface.first.patch != piece[next] && interface.second.patch != piece[next]))
        continue;
      const PatchId other =
          interface.first.patch == piece[next] ? interface.second.patch : interface.first.patch;
      if (std::find(piece.begin(), piece.end(), other) == piece.end()) piece.push_back(other);
    }
  return piece;
}

}  // namespace

Eigen::Matrix3Xd node_forces(const iga::ElasticityProblem& problem,
                             const std::vector<iga::Multiplier>& multipliers) {
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, problem.discretization.node_count());
  for (const iga::Multiplier& m : multipliers) {
    forces.col(m.second_node) += m.force;
    forces.col(m.first_node) -= m.force;
  }
  return forces;
}

Resultant resultant(const iga::ElasticityProblem& problem, const Eigen::Matrix3Xd& forces,
                    const std::vector<PatchId>& patches) {
  const iga::Discretization& d = problem.discretization;
  Resultant result;
  for (const PatchId id : patches) {
    const auto p = static_cast<std::size_t>(id.value);
    for (int i = 0; i < d.patches[p].size(); ++i) {
      const Eigen::Vector3d force = forces.col(d.first_node[p] + i);
      result.force += force;
      result.moment += Eigen::Vector3d(d.patches[p].control_points().col(i)).cross(force);
    }
  }
  return result;
}

std::vector<int> untouched_patches(const iga::ElasticityProblem& problem) {
  const iga::Discretization& d = problem.discretization;
  const iga::GlobalNodes global = iga::global_nodes(d);
  const std::vector<iga::SupportFrame> frames = iga::support_frames(problem, global);
  std::vector<int> result;
  for (int patch = 0; patch < d.patch_count(); ++patch) {
    const auto p = static_cast<std::size_t>(patch);
    bool free = true;
    for (int node = d.first_node[p]; node < d.first_node[p + 1]; ++node)
      free = free &&
             frames[static_cast<std::size_t>(global.global_of[static_cast<std::size_t>(node)])].free == 3;
    if (free) result.push_back(patch);
  }
  return result;
}

std::vector<Cut> cuts_of(const iga::ElasticityProblem& problem) {
  const geometry::MultiPatch& model = problem.discretization.model;
  const std::vector<int> untouched = untouched_patches(problem);
  const auto is_free = [&](const std::vector<PatchId>& piece) {
    return std::all_of(piece.begin(), piece.end(), [&](PatchId id) {
      return std::find(untouched.begin(), untouched.end(), id.value) != untouched.end();
    });
  };
  std::vector<Cut> result;
  for (std::size_t i = 0; i < model.interfaces().size(); ++i) {
    const geometry::Interface& interface = model.interfaces()[i];
    const std::vector<PatchId> first = piece_of(model, interface.first.patch, i);
    if (std::find(first.begin(), first.end(), interface.second.patch) != first.end()) continue;
    const std::vector<PatchId> second = piece_of(model, interface.second.patch, i);
    if (is_free(first) || is_free(second))
      result.push_back(
          {model.label(interface.first), model.label(interface.second), is_free(first) ? first : second});
  }
  return result;
}

double largest_jump(const iga::ElasticityProblem& problem, const iga::ElasticitySolution& solution) {
  const iga::GlobalNodes global = iga::global_nodes(problem.discretization);
  Eigen::Matrix3Xd u(3, problem.discretization.node_count());
  for (std::size_t p = 0; p < solution.field.displacement.size(); ++p)
    u.middleCols(problem.discretization.first_node[p], solution.field.displacement[p].cols()) =
        solution.field.displacement[p];
  double jump = 0;
  for (int c = 0; c < global.count(); ++c)
    for (const int node : global.nodes_of(c))
      jump = larger(jump, (u.col(node) - u.col(global.nodes_of(c)[0])).norm());
  return jump / u.colwise().norm().maxCoeff<Eigen::PropagateNaN>();
}

double multiplier_difference(const std::vector<iga::Multiplier>& a, const std::vector<iga::Multiplier>& b) {
  double apart = 0;
  double size = 0;
  bool same = a.size() == b.size() && !a.empty();
  for (std::size_t i = 0; same && i < a.size(); ++i) {
    same = a[i].first_node == b[i].first_node && a[i].second_node == b[i].second_node;
    apart = larger(apart, (a[i].force - b[i].force).norm());
    size = larger(size, a[i].force.norm());
  }
  return same ? apart / size : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace isopatch::verification
