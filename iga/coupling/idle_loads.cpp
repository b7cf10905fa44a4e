#include "iga/coupling/idle_loads.hpp"

#include <map>

#include "iga/problem/loads.hpp"

namespace isopatch::iga {
namespace {

// What a load puts on each global node, N.
std::map<int, Eigen::Vector3d> forces_of(const ElasticityProblem& problem, const SurfaceLoad& load,
                                         const GlobalNodes& global) {
  const Discretization& d = problem.discretization;
  std::map<int, Eigen::Vector3d> forces;
  for (const geometry::PatchFace& face : load.faces) {
    const auto p = static_cast<std::size_t>(face.patch.value);
    const Eigen::Matrix3Xd on_face = face_load(d.patches[p], face.side, load.traction, load.region);
    const std::vector<int> indices = geometry::face_control_points(d.patches[p].sizes(), face.side);
    for (std::size_t i = 0; i < indices.size(); ++i) {
      const int node = d.first_node[p] + indices[i];
      const auto found =
          forces.try_emplace(global.global_of[static_cast<std::size_t>(node)], Eigen::Vector3d::Zero()).first;
      found->second += on_face.col(static_cast<Eigen::Index>(i));
    }
  }
  return forces;
}

}  // namespace

std::vector<std::string> idle_loads(const ElasticityProblem& problem, const GlobalNodes& global,
                                    const std::vector<SupportFrame>& frames) {
  constexpr double round_off = 1e-9;  // beside the load itself
  std::vector<std::string> result;
  for (const SurfaceLoad& load : problem.surface_loads) {
    double all = 0, free = 0;
    for (const auto& [global_node, force] : forces_of(problem, load, global)) {
      const SupportFrame& frame = frames[static_cast<std::size_t>(global_node)];
      all += force.norm();
      free += (frame.axes.leftCols(frame.free).transpose() * force).norm();
    }
    if (all > 0 && free <= round_off * all) result.push_back(load.name);
  }
  return result;
}

}  // namespace isopatch::iga
