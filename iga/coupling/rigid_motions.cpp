#include "iga/coupling/rigid_motions.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <cmath>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/base/error.hpp"
#include "iga/coupling/free_motions.hpp"

namespace isopatch::iga {
namespace {

std::string text(const Eigen::Vector3d& v) {
  const auto clean = [](double x) { return std::abs(x) < 5e-7 ? 0.0 : x; };
  return fmt::format("({:.4g}, {:.4g}, {:.4g})", clean(v[0]), clean(v[1]), clean(v[2]));
}

// A direction and its opposite are the same motion; the first clear component is shown positive. Coordinate
// axes by their names.
std::string direction_text(const Eigen::Vector3d& unit) {
  for (int d = 0; d < 3; ++d)
    if (std::abs(unit[d]) > 1 - 1e-9) return std::string(1, "xyz"[d]);
  for (int d = 0; d < 3; ++d)
    if (std::abs(unit[d]) > 1e-6) return text(unit[d] > 0 ? unit : Eigen::Vector3d(-unit));
  return text(unit);
}

// Orthonormal directions of the space that the given ones span, as near to the coordinate axes as they can
// be: of a plane that holds y and z these, whatever the given ones are.
std::vector<Eigen::Vector3d> readable_directions(const std::vector<Eigen::Vector3d>& orthonormal) {
  Eigen::Matrix3d projection = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& direction : orthonormal) projection += direction * direction.transpose();
  std::vector<Eigen::Vector3d> result;
  for (std::size_t k = 0; k < orthonormal.size(); ++k) {
    int nearest = 0;
    for (int d = 1; d < 3; ++d)
      if (projection(d, d) > projection(nearest, nearest) + 1e-9) nearest = d;
    result.push_back(projection.col(nearest).normalized());
    projection -= result.back() * result.back().transpose();
  }
  return result;
}

// Motions u(x) = t + w x (x - centre) / size with coordinates (t, w), spanned by the columns of `null_space`:
// pure translations first, then one rotation for each remaining dimension.
std::vector<std::string> described(const Eigen::MatrixXd& null_space, const Eigen::Vector3d& centre,
                                   double size) {
  const Eigen::MatrixXd turning = null_space.bottomRows<3>();
  const SymmetricEigen rotations = symmetric_eigen(turning.transpose() * turning);
  const Eigen::MatrixXd mixed = null_space * rotations.vectors;
  std::vector<Eigen::Vector3d> shifts, turns, shifts_of_turns;
  for (Eigen::Index k = 0; k < mixed.cols(); ++k) {
    const double square = rotations.values[k];
    if (square < 1e-12) {
      shifts.push_back(mixed.col(k).head<3>());
    } else {
      turns.push_back(mixed.col(k).tail<3>() / std::sqrt(square));
      shifts_of_turns.push_back(mixed.col(k).head<3>() / std::sqrt(square));
    }
  }
  std::vector<std::string> motions;
  for (const Eigen::Vector3d& direction : readable_directions(shifts))
    motions.push_back("translation along " + direction_text(direction));
  for (const Eigen::Vector3d& direction : readable_directions(turns)) {
    Eigen::Vector3d t = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < turns.size(); ++k) t += turns[k].dot(direction) * shifts_of_turns[k];
    const Eigen::Vector3d through = centre + size * direction.cross(t);
    motions.push_back(fmt::format("rotation about the axis through {} m along {}", text(through),
                                  direction_text(direction)));
  }
  return motions;
}

}  // namespace

std::vector<FreeBody> free_bodies(const ElasticityProblem& problem, const GlobalNodes& global,
                                  const std::vector<SupportFrame>& frames) {
  std::vector<FreeBody> result;
  for (const FreeMotions& body : free_motions(problem, global, frames))
    result.push_back({body.patches, described(body.motions, body.centre, body.size)});
  return result;
}

void require_supported(const ElasticityProblem& problem, const GlobalNodes& global,
                       const std::vector<SupportFrame>& frames) {
  const std::vector<FreeBody> bodies = free_bodies(problem, global, frames);
  if (bodies.empty()) return;
  std::string message = "the supports leave rigid motions:";
  for (const FreeBody& body : bodies) {
    std::vector<int> patches;
    for (const PatchId patch : body.patches) patches.push_back(patch.value);
    const bool all = static_cast<int>(patches.size()) == problem.discretization.patch_count();
    message += fmt::format("\n  {} can still move: {}",
                           all ? "the part" : fmt::format("the body of patches {}", fmt::join(patches, ", ")),
                           fmt::join(body.motions, "; "));
  }
  message +=
      "\nadd supports (a face clamped in all components holds a body; free_body "
      "= true holds one whose loads balance)";
  if (bodies.size() > 1) message += ", or check whether the bodies should share interfaces";
  throw Error(ErrorCode::free_body, message);
}

}  // namespace isopatch::iga
