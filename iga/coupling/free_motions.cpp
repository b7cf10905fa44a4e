#include "iga/coupling/free_motions.hpp"

#include <Eigen/Geometry>
#include <algorithm>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/measures.hpp"
#include "iga/problem/internal/face_quadrature.hpp"
#include "iga/problem/springs.hpp"

namespace isopatch::iga {
namespace {

using Vector6 = Eigen::Matrix<double, 6, 1>;
using Gram = Eigen::Matrix<double, 6, 6>;

/// Of the part's size: thinner patches are none (`Tolerance::same_point`), and places of CAD files are no
/// better.
constexpr double least_arm = 2e-7;

void hold(const FreeMotions& body, const Eigen::Vector3d& place, const Eigen::Vector3d& direction,
          Gram& gram) {
  const Vector6 row = motion_along(body, place, direction);
  gram += row * row.transpose();
}

void hold_by_frames(const FreeMotions& body, const Discretization& d, const GlobalNodes& global,
                    const std::vector<SupportFrame>& frames, Gram& gram) {
  for (const PatchId patch : body.patches) {
    const auto p = static_cast<std::size_t>(patch.value);
    for (int i = 0; i < d.patches[p].size(); ++i) {
      const SupportFrame& frame =
          frames[static_cast<std::size_t>(global.global_of[static_cast<std::size_t>(d.first_node[p] + i)])];
      for (int k = frame.free; k < 3; ++k)
        hold(body, d.patches[p].control_points().col(i), frame.axes.col(k), gram);
    }
  }
}

void hold_by_springs(const FreeMotions& body, const ElasticityProblem& problem, Gram& gram) {
  const auto is_of_body = [&](PatchId patch) {
    return std::find(body.patches.begin(), body.patches.end(), patch) != body.patches.end();
  };
  // Soft springs hold as well as stiff ones.
  const auto hold_by = [&](const Eigen::Vector3d& place, const Eigen::Matrix3d& stiffness) {
    const PrincipalAxes springs = principal_axes(stiffness);
    for (int k = 0; k < 3; ++k)
      if (springs.values[k] > 1e-12 * springs.values[2]) hold(body, place, springs.axes.col(k), gram);
  };
  const Springs springs = springs_of(problem);
  for (const SprungFace& sprung : springs.faces)
    if (is_of_body(sprung.face.patch))
      for (const FacePoint& point : face_points(problem.discretization.model.patches(), {sprung.face}))
        hold_by(point.place, sprung.stiffness(point.place, point.normal));
  for (const SprungPoint& sprung : springs.points)
    if (is_of_body(sprung.place.patch))
      hold_by(problem.discretization.model.patch(sprung.place.patch).point(sprung.place.parameter),
              sprung.stiffness);
}

}  // namespace

Vector6 motion_along(const FreeMotions& body, const Eigen::Vector3d& place,
                     const Eigen::Vector3d& direction) {
  const Eigen::Vector3d arm = (place - body.centre) / body.size;
  Vector6 row;
  row << direction, arm.cross(direction);
  return row;
}

std::vector<FreeMotions> free_motions(const ElasticityProblem& problem, const GlobalNodes& global,
                                      const std::vector<SupportFrame>& frames) {
  const Discretization& d = problem.discretization;
  std::vector<FreeMotions> result;
  for (const std::vector<PatchId>& patches : d.model.bodies()) {
    FreeMotions body{.patches = patches, .motions = {}};
    Eigen::AlignedBox3d extent;
    for (const PatchId patch : patches) {
      body.centre += d.patches[static_cast<std::size_t>(patch.value)].control_points().rowwise().mean() /
                     double(patches.size());
      extent.extend(geometry::box(d.model.patch(patch)));
    }
    body.size = extent.diagonal().norm();
    Gram gram = Gram::Zero();
    hold_by_frames(body, d, global, frames, gram);
    hold_by_springs(body, problem, gram);
    const SymmetricEigen eigen = symmetric_eigen(gram);
    // A support that holds a motion only by round-off is none. The edge of a thin sheet holds it by half its
    // thickness, of which these are the squares.
    const double threshold = least_arm * least_arm * std::max(eigen.values[5], 1e-300);
    Eigen::Index free = 0;
    while (free < 6 && eigen.values[free] <= threshold) ++free;
    if (free == 0) continue;
    body.motions = eigen.vectors.leftCols(free);
    result.push_back(std::move(body));
  }
  return result;
}

}  // namespace isopatch::iga
