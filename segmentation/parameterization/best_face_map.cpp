#include "segmentation/parameterization/internal/best_face_map.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <optional>

#include "geometry/base/error.hpp"
#include "segmentation/parameterization/internal/mean_value_map.hpp"
#include "segmentation/parameterization/internal/spline_fit.hpp"

namespace isopatch::segmentation {
namespace {

/// Angles of the blend above this are good enough not to ask for another map.
constexpr double good_sine = 0.3;

/// What leads from the blend to the mean-value map, as a spline with `spans` spans a direction.
geometry::NurbsSurface displacement(const FaceMap& blend, const MeanValueMap& map, int spans) {
  const KnotVector knots = KnotVector::uniform(3, spans);
  const std::vector<double> at = fitting_parameters(knots, 4);
  const Eigen::Matrix2Xd from = blend.domain_grid(at, at);
  const auto n = static_cast<Eigen::Index>(at.size());
  Eigen::Matrix3Xd rest = Eigen::Matrix3Xd::Zero(3, n * n);
  for (Eigen::Index j = 1; j + 1 < n; ++j)
    for (Eigen::Index i = 1; i + 1 < n; ++i)
      rest.col(i + n * j).head<2>() =
          map.domain_point({at[static_cast<std::size_t>(i)], at[static_cast<std::size_t>(j)]}) -
          from.col(i + n * j);
  const Eigen::Matrix3Xd zero = Eigen::Matrix3Xd::Zero(3, Eigen::Index(knots.size()) * knots.size());
  return {{knots, knots}, fit_surface({knots, knots}, {at, at}, rest, zero)};
}

/// Sine of the narrowest corner, which no map can open.
double narrowest_corner(const FaceMap& map) {
  constexpr double near = 1e-3;
  double smallest = 1;
  for (const double s : {0.0, 1.0})
    for (const double t : {0.0, 1.0}) {
      const double along = s == 0 ? near : 1 - near, across = t == 0 ? near : 1 - near;
      const Eigen::Vector3d here = map.grid({s}, {t}), x = map.grid({along}, {t}) - here,
                            y = map.grid({s}, {across}) - here;
      smallest = std::min(smallest, x.cross(y).norm() / (x.norm() * y.norm()));
    }
  return smallest;
}

/// Nothing where slivers of the mesh make it singular: the blend is no worse for that.
std::optional<MeanValueMap> mean_value_map(const FaceMap& blend, const DomainMesh& mesh) {
  try {
    return MeanValueMap(blend, mesh);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::singular_system) throw;
    return std::nullopt;
  }
}

}  // namespace

FaceMap best_face_map(const QuadFace& face) {
  return best_face_map(face, {});
}

FaceMap best_face_map(const QuadFace& face, const std::array<SidePace, 4>& paces) {
  FaceMap blend(face, paces);
  double best = smallest_sine(blend);
  if (best > std::min(good_sine, 0.95 * narrowest_corner(blend))) return blend;
  const std::optional<DomainMesh> mesh = face.mesh ? face.mesh() : std::nullopt;
  if (!mesh) return blend;
  const std::optional<MeanValueMap> mean_value = mean_value_map(blend, *mesh);
  if (!mean_value) return blend;
  FaceMap result = blend;
  for (const int spans : {4, 8, 16, 32}) {
    FaceMap candidate = blend.moved(displacement(blend, *mean_value, spans), FaceMapKind::mean_value);
    const double sine = smallest_sine(candidate);
    if (sine <= best) continue;
    best = sine;
    result = candidate;
    if (best > 0) break;
  }
  return result;
}

}  // namespace isopatch::segmentation
