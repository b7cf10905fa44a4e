#include "iga/problem/springs.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "geometry/base/error.hpp"

namespace isopatch::iga {
namespace {

// Of the stiffness of a part, which is about Young's modulus over its size.
constexpr double stiffer = 1e4;

std::vector<SprungFace> of_elastic(const Support& support, const ElasticSupport& springs) {
  const auto [normal, tangential] = springs;
  if (!(normal >= 0) || !(tangential >= 0) || !std::isfinite(normal) || !std::isfinite(tangential))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("'{}': an elastic support has the stiffness {} across and {} N/m^3 along its "
                            "faces; both must be finite and not negative",
                            support.name, normal, tangential));
  std::vector<SprungFace> result;
  for (const geometry::PatchFace& face : support.faces)
    result.push_back({face, [springs](const Eigen::Vector3d&, const Eigen::Vector3d& n) {
                        return Eigen::Matrix3d(springs.tangential * Eigen::Matrix3d::Identity() +
                                               (springs.normal - springs.tangential) * n * n.transpose());
                      }});
  return result;
}

// Of a hold along one direction of cylinder coordinates.
std::vector<SprungFace> of_cylindrical(const ElasticityProblem& problem, const Support& support,
                                       const CylindricalSupport& about) {
  std::vector<SprungFace> result;
  const Eigen::Vector3d axis = about.axis.normalized();
  for (const geometry::PatchFace& face : support.faces) {
    const double stiffness = stiffer *
                             young(problem.materials.at(static_cast<std::size_t>(face.patch.value))) /
                             problem.discretization.model.size();
    result.push_back({face,
                      [=](const Eigen::Vector3d& place, const Eigen::Vector3d&) {
                        const Eigen::Vector3d arm = place - about.point;
                        const Eigen::Vector3d radial = (arm - axis * axis.dot(arm)).normalized();
                        const Eigen::Vector3d held = about.radial ? radial : axis.cross(radial);
                        return Eigen::Matrix3d(stiffness * held * held.transpose());
                      },
                      true});
  }
  return result;
}

}  // namespace

bool is_sprung(const CylindricalSupport& support) {
  return support.radial != support.tangential;
}

std::vector<SprungFace> sprung_faces(const ElasticityProblem& problem, const Support& support) {
  if (const auto* springs = std::get_if<ElasticSupport>(&support.condition))
    return of_elastic(support, *springs);
  const auto* about = std::get_if<CylindricalSupport>(&support.condition);
  if (about && is_sprung(*about)) return of_cylindrical(problem, support, *about);
  return {};
}

std::vector<SprungFace> sprung_faces(const ElasticityProblem& problem) {
  std::vector<SprungFace> result;
  for (const Support& support : problem.supports)
    for (SprungFace& face : sprung_faces(problem, support)) result.push_back(std::move(face));
  return result;
}

}  // namespace isopatch::iga
