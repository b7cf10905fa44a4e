#include "iga/coupling/free_body_support.hpp"

#include "geometry/base/dense_matrices.hpp"
#include "iga/coupling/free_motions.hpp"
#include "iga/problem/corners.hpp"

namespace isopatch::iga {
namespace {

// A direction that a corner of a patch is free to move in.
struct Candidate {
  int global_node = -1;
  int axis = 0;
  double held = 0;        // length of what it holds of the motions left
  Eigen::VectorXd along;  // its components in their basis
};

Candidate best_candidate(const Discretization& d, const FreeMotions& body, const Eigen::MatrixXd& motions,
                         const GlobalNodes& global, const std::vector<SupportFrame>& frames) {
  constexpr double same = 1e-6;  // of equally good ones the first, whatever round-off says
  Candidate best;
  for (const PatchId patch : body.patches)
    for (const PatchCorner& corner : corners_of(patch)) {
      const int node = node_of(d, corner);
      const int c = global.global_of[static_cast<std::size_t>(node)];
      const SupportFrame& frame = frames[static_cast<std::size_t>(c)];
      for (int axis = 0; axis < frame.free; ++axis) {
        const Eigen::VectorXd along =
            motions.transpose() * motion_along(body, place_of(d, corner), frame.axes.col(axis));
        if (along.norm() > best.held * (1 + same)) best = {c, axis, along.norm(), along};
      }
    }
  return best;
}

// Makes a free axis of a frame a fixed one.
void fix(SupportFrame& frame, int axis, int support) {
  const Eigen::Vector3d direction = frame.axes.col(axis);
  const int last = --frame.free;
  for (int k = axis; k < last; ++k) frame.axes.col(k) = Eigen::Vector3d(frame.axes.col(k + 1));
  frame.axes.col(last) = direction;
  frame.direction[static_cast<std::size_t>(last)] = direction;
  frame.support[static_cast<std::size_t>(last)] = support;
}

// The motions that do not move along a condition.
Eigen::MatrixXd without(const Eigen::MatrixXd& motions, const Eigen::VectorXd& along) {
  const Eigen::Index count = motions.cols();
  const SymmetricEigen eigen = symmetric_eigen(along * along.transpose());
  return motions * eigen.vectors.leftCols(count - 1);
}

}  // namespace

void hold_free_bodies(const ElasticityProblem& problem, int support, const GlobalNodes& global,
                      std::vector<SupportFrame>& frames) {
  for (const FreeMotions& body : free_motions(problem, global, frames)) {
    Eigen::MatrixXd motions = body.motions;
    while (motions.cols() > 0) {
      const Candidate best = best_candidate(problem.discretization, body, motions, global, frames);
      if (best.global_node < 0) break;  // a body without corners apart; `require_supported` names it
      fix(frames[static_cast<std::size_t>(best.global_node)], best.axis, support);
      motions = without(motions, best.along);
    }
  }
}

}  // namespace isopatch::iga
