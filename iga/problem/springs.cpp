#include "iga/problem/springs.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <iterator>

#include "iga/problem/internal/held_parts.hpp"

namespace isopatch::iga {
namespace {

std::vector<SprungFace> of_elastic(const Support& support, const ElasticSupport& springs) {
  validate(springs, support.name);
  std::vector<SprungFace> result;
  for (const geometry::PatchFace& face : support.faces)
    result.push_back(
        {face, [springs](const Eigen::Vector3d&, const Eigen::Vector3d& n) { return springs.at(n); }});
  return result;
}

// Of a hold along one direction of cylinder coordinates.
std::vector<SprungFace> of_cylindrical(const ElasticityProblem& problem, const Support& support,
                                       const CylindricalSupport& about) {
  std::vector<SprungFace> result;
  const Eigen::Vector3d axis = about.axis.normalized();
  for (const geometry::PatchFace& face : support.faces) {
    const double stiffness = stiffer_than_part *
                             young(problem.materials.at(static_cast<std::size_t>(face.patch.value))) /
                             problem.discretization.model.size();
    result.push_back({face,
                      [=, region = support.region](const Eigen::Vector3d& place, const Eigen::Vector3d&) {
                        if (!region.contains(place)) return Eigen::Matrix3d(Eigen::Matrix3d::Zero());
                        const Eigen::Vector3d arm = place - about.point;
                        const Eigen::Vector3d radial = (arm - axis * axis.dot(arm)).normalized();
                        const Eigen::Vector3d held = about.radial ? radial : axis.cross(radial);
                        return Eigen::Matrix3d(stiffness * held * held.transpose());
                      },
                      true});
  }
  return result;
}

std::vector<SprungFace> whole_faces(const ElasticityProblem& problem, const Support& support) {
  if (const auto* springs = std::get_if<ElasticSupport>(&support.condition))
    return of_elastic(support, *springs);
  const auto* about = std::get_if<CylindricalSupport>(&support.condition);
  if (about && is_sprung(*about)) return of_cylindrical(problem, support, *about);
  return {};
}

}  // namespace

bool is_sprung(const CylindricalSupport& support) {
  return support.radial != support.tangential;
}

Springs springs_of(const ElasticityProblem& problem, const Support& support) {
  Springs result;
  const auto* springs = std::get_if<ElasticSupport>(&support.condition);
  if (springs && !support.region.is_everywhere())
    result.points = springs_in_region(problem, support, *springs);
  else
    result.faces = whole_faces(problem, support);
  for (SprungPoint& point : held_points(problem, support)) result.points.push_back(std::move(point));
  return result;
}

Springs springs_of(const ElasticityProblem& problem) {
  Springs result;
  for (const Support& support : problem.supports) {
    Springs more = springs_of(problem, support);
    std::move(more.faces.begin(), more.faces.end(), std::back_inserter(result.faces));
    std::move(more.points.begin(), more.points.end(), std::back_inserter(result.points));
  }
  return result;
}

Springs holds_among(const Springs& springs) {
  Springs result;
  std::copy_if(springs.faces.begin(), springs.faces.end(), std::back_inserter(result.faces),
               [](const SprungFace& face) { return face.is_hold; });
  return result;
}

Springs without_holds(Springs springs) {
  std::erase_if(springs.faces, [](const SprungFace& face) { return face.is_hold; });
  return springs;
}

Springs held_everywhere(Springs springs) {
  for (SprungFace& face : springs.faces) face.is_hold = false;
  return springs;
}

}  // namespace isopatch::iga
