#include "iga/post/results.hpp"

#include <omp.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "iga/internal/parallel_for.hpp"
#include "iga/spaces/internal/element_tensors.hpp"

namespace isopatch::iga {
namespace {

// The ends of the unit interval and `degree` - 1 parameters evenly between them.
geometry::QuadratureRule even_grid(int degree) {
  const Eigen::VectorXd weights = Eigen::VectorXd::Ones(degree + 1);
  return {Eigen::VectorXd::LinSpaced(degree + 1, 0, 1), weights};
}

// Largest length squared in some elements, and where.
struct Longest {
  double squared = -1;
  std::int64_t element = 0;
  Eigen::Index point = 0;
};

Longest longest_in(const ElementTensors& tensors, const geometry::NurbsVolume& patch,
                   const Eigen::Matrix3Xd& displacement, std::int64_t first, std::int64_t last,
                   TensorBuffers<4>& buffers) {
  Longest result;
  for (std::int64_t element = first; element < last; ++element) {
    gather(tensors, element, displacement, patch.weights(), buffers.coefficients);
    tensors.values(element, buffers);
    for (std::size_t q = 0; q < buffers.at[0].size(); ++q) {
      const FieldLanes<4>& u = buffers.at[0][q];
      const double squared = u.head<3>().matrix().squaredNorm() / (u[3] * u[3]);
      if (is_larger(squared, result.squared)) result = {squared, element, static_cast<Eigen::Index>(q)};
    }
  }
  return result;
}

}  // namespace

Extremum max_displacement(const ElasticField& field, const std::vector<PatchLayers>& parts) {
  constexpr std::int64_t per_task = 64;
  Extremum result;
  result.value = -1;
  std::vector<TensorBuffers<4>> buffers(static_cast<std::size_t>(omp_get_max_threads()));
  for (const PatchLayers& part : parts) {
    if (part.first_layer == part.last_layer) continue;
    const auto p = static_cast<std::size_t>(part.patch);
    const geometry::NurbsVolume& patch = field.patches[p];
    const ElementTensors tensors(
        patch, {even_grid(patch.degree(0)), even_grid(patch.degree(1)), even_grid(patch.degree(2))});
    const std::int64_t layer = tensors.element_count() / patch.knots(2).element_count();
    const std::int64_t begin = layer * part.first_layer, end = layer * part.last_layer;
    std::vector<Longest> found(static_cast<std::size_t>((end - begin + per_task - 1) / per_task));
    parallel_for(static_cast<std::int64_t>(found.size()), [&](std::int64_t task, int thread) {
      const std::int64_t first = begin + task * per_task;
      found[static_cast<std::size_t>(task)] =
          longest_in(tensors, patch, field.displacement[p], first, std::min(end, first + per_task),
                     buffers[static_cast<std::size_t>(thread)]);
    });
    // The first of equal ones, for any number of threads.
    Longest longest;
    for (const Longest& other : found)
      if (is_larger(other.squared, longest.squared)) longest = other;
    if (!is_larger(std::sqrt(longest.squared), result.value)) continue;
    const geometry::Parameter<3> parameter = tensors.parameter(longest.element, longest.point);
    result = {std::sqrt(longest.squared), patch.point(parameter), part.patch, parameter};
  }
  return result;
}

Extremum max_displacement(const ElasticField& field) {
  std::vector<PatchLayers> parts;
  for (std::size_t p = 0; p < field.patches.size(); ++p)
    parts.push_back({static_cast<int>(p), 0, field.patches[p].knots(2).element_count()});
  return max_displacement(field, parts);
}

std::vector<Reaction> support_reactions(const ElasticityProblem& problem, const GlobalNodes& global,
                                        const std::vector<SupportFrame>& frames,
                                        const Eigen::Matrix3Xd& forces) {
  const Discretization& d = problem.discretization;
  std::vector<Reaction> reactions;
  for (const Support& support : problem.supports)
    reactions.push_back({support.name, Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero()});
  for (int patch = 0; patch < d.patch_count(); ++patch) {
    const auto p = static_cast<std::size_t>(patch);
    for (int i = 0; i < d.patches[p].size(); ++i) {
      const int node = d.first_node[p] + i;
      const SupportFrame& frame =
          frames[static_cast<std::size_t>(global.global_of[static_cast<std::size_t>(node)])];
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
