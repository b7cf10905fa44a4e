#include "iga/problem/internal/held_parts.hpp"

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "iga/problem/internal/face_quadrature.hpp"

namespace isopatch::iga {
namespace {

[[noreturn]] void reject_region(const Support& support) {
  throw Error(ErrorCode::invalid_argument,
              fmt::format("'{}': no area of its faces lies in the region that it holds", support.name));
}

}  // namespace

std::vector<int> held_control_points(const geometry::NurbsVolume& patch, geometry::Side side,
                                     const Region& region) {
  const std::vector<int> all = geometry::face_control_points(patch.sizes(), side);
  if (region.is_everywhere()) return all;
  const geometry::NurbsSurface surface = geometry::face_surface(patch, side);
  const std::vector<double> u = surface.knots(0).greville(), v = surface.knots(1).greville();
  const double slack = place_slack(patch);
  std::vector<int> result;
  for (std::size_t j = 0; j < v.size(); ++j)
    for (std::size_t i = 0; i < u.size(); ++i)
      if (region.contains(surface.point({u[i], v[j]}), slack)) result.push_back(all[i + u.size() * j]);
  return result;
}

std::vector<SprungPoint> springs_in_region(const ElasticityProblem& problem, const Support& support,
                                           const ElasticSupport& springs) {
  validate(springs, support.name);
  std::vector<SprungPoint> result;
  for (const geometry::PatchFace& face : support.faces) {
    const geometry::NurbsVolume& patch =
        problem.discretization.patches.at(static_cast<std::size_t>(face.patch.value));
    FaceQuadrature(patch, face.side, support.region)
        .for_each([&](const FacePoint& point, const DirectionTable::Element& u, Eigen::Index qu,
                      const DirectionTable::Element& v, Eigen::Index qv) {
          result.push_back(
              {{face.patch, geometry::on_side(patch, face.side, {u.nodes[qu], v.nodes[qv]}), point.area},
               point.area * springs.at(point.normal)});
        });
  }
  if (result.empty()) reject_region(support);
  return result;
}

std::vector<SprungPoint> held_points(const ElasticityProblem& problem, const Support& support) {
  if (support.points.empty()) return {};
  const auto* prescribed = std::get_if<PrescribedDisplacement>(&support.condition);
  if (!prescribed)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("'{}': points have no normal; give displacement components", support.name));
  Eigen::Matrix3d directions = Eigen::Matrix3d::Zero();
  bool moves = !prescribed->gradient.isZero(0);
  for (int d = 0; d < 3; ++d)
    if (const auto& value = prescribed->value[static_cast<std::size_t>(d)]) {
      directions(d, d) = 1;
      moves = moves || *value != 0;
    }
  if (moves)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("'{}': points inside of patches can be held where they are and not moved: their "
                            "displacement must be 0",
                            support.name));
  std::vector<SprungPoint> result;
  for (const PatchPoint& point : support.points) {
    const auto p = static_cast<std::size_t>(point.patch.value);
    const double stiffness =
        stiffer_than_part * young(problem.materials.at(p)) * problem.discretization.model.size();
    result.push_back({point, point.weight * stiffness * directions});
  }
  return result;
}

}  // namespace isopatch::iga
