#include "geometry/non_matching.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <bitset>

#include "geometry/base/error.hpp"
#include "geometry/face_match.hpp"
#include "geometry/measures.hpp"
#include "geometry/surface_foot.hpp"
#include "geometry/touching_boxes.hpp"

namespace isopatch::geometry {
namespace {

constexpr int points_along = 24;
constexpr std::size_t point_count = std::size_t{points_along} * points_along;
using PointSet = std::bitset<point_count>;

struct TouchedFace {
  PatchFace face;
  NurbsSurface surface;
  Eigen::AlignedBox3d box;
  std::vector<Eigen::Vector3d> points;
  std::vector<Eigen::Vector3d> normals;  // outward
  PointSet covered;
};

TouchedFace touched_face(const std::vector<NurbsVolume>& patches, PatchFace face) {
  const NurbsVolume& patch = patches[static_cast<std::size_t>(face.patch.value)];
  TouchedFace result{face, face_surface(patch, face.side), {}, {}, {}, {}};
  for (const auto& point : result.surface.control_points().colwise()) result.box.extend(point);
  for (int j = 0; j < points_along; ++j)
    for (int i = 0; i < points_along; ++i) {
      const Parameter<2> at =
          unscaled(result.surface, Parameter<2>(i + 0.5, j + 0.5) / static_cast<double>(points_along));
      result.points.push_back(result.surface.point(at));
      result.normals.push_back(outward_normal(patch, face.side, at));
    }
  return result;
}

struct Contact {
  PointSet points;  // of the first face that lie on the second
  double gap = 0;
};

Contact contact(const std::vector<NurbsVolume>& patches, const TouchedFace& first, const TouchedFace& second,
                double same_point, const FaceLabel& label) {
  Contact result;
  for (std::size_t k = 0; k < point_count; ++k) {
    if (second.box.squaredExteriorDistance(first.points[k]) > same_point * same_point) continue;
    const SurfaceFoot foot = surface_foot(second.surface, first.points[k], same_point);
    if (!(foot.distance <= same_point)) continue;
    const Eigen::Vector3d other = outward_normal(patches[static_cast<std::size_t>(second.face.patch.value)],
                                                 second.face.side, foot.parameter);
    const double cosine = other.dot(first.normals[k]);
    if (std::abs(cosine) < 0.9) continue;  // they touch along a line
    if (cosine > 0)
      throw Error(
          ErrorCode::not_conforming,
          fmt::format("faces {} and {} lie on one another, but their patches lie on the same side, so "
                      "they overlap; is a patch in the model twice?",
                      label(first.face), label(second.face)));
    result.points.set(k);
    result.gap = std::max(result.gap, foot.distance);
  }
  return result;
}

}  // namespace

NonMatchingFaces find_non_matching(const std::vector<NurbsVolume>& patches,
                                   const std::vector<PatchFace>& faces, double same_point,
                                   const FaceLabel& label) {
  std::vector<TouchedFace> touched;
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const PatchFace& face : faces) boxes.push_back(touched.emplace_back(touched_face(patches, face)).box);
  NonMatchingFaces result;
  for (const auto& [i, j] : touching_boxes(boxes, same_point)) {
    TouchedFace& a = touched[i];
    TouchedFace& b = touched[j];
    const Contact of_a = contact(patches, a, b, same_point, label);
    const Contact of_b = contact(patches, b, a, same_point, label);
    if (of_a.points.none() && of_b.points.none()) continue;
    a.covered |= of_a.points;
    b.covered |= of_b.points;
    result.interfaces.push_back(
        {std::min(a.face, b.face), std::max(a.face, b.face), std::max(of_a.gap, of_b.gap)});
  }
  std::sort(result.interfaces.begin(), result.interfaces.end(), [](const auto& a, const auto& b) {
    return std::pair(a.first, a.second) < std::pair(b.first, b.second);
  });
  for (const TouchedFace& face : touched) {
    if (face.covered.all()) continue;
    result.boundary.push_back(face.face);
    if (face.covered.any()) result.partly_covered.push_back(face.face);
  }
  std::sort(result.boundary.begin(), result.boundary.end());
  std::sort(result.partly_covered.begin(), result.partly_covered.end());
  return result;
}

}  // namespace isopatch::geometry
