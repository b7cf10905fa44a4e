#include "app/problem/face_part.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "geometry/base/error.hpp"
#include "geometry/common_refinement.hpp"
#include "geometry/patch_face.hpp"
#include "iga/problem/loads.hpp"

namespace isopatch::app {
namespace {

// How far the nearest of 9 x 9 points of a face is outside of a region, m.
double gap(const iga::Region& region, const geometry::NurbsVolume& patch, geometry::Side side) {
  constexpr int samples = 9;
  const geometry::NurbsSurface surface = geometry::face_surface(patch, side);
  double nearest = std::numeric_limits<double>::infinity();
  for (int j = 0; j < samples; ++j)
    for (int i = 0; i < samples; ++i) {
      const geometry::Parameter<2> share(i / (samples - 1.0), j / (samples - 1.0));
      const Eigen::Vector3d place =
          surface.point(surface.low() + (surface.high() - surface.low()).cwiseProduct(share));
      double outside = 0;
      for (const iga::Quadric& bound : region.bounds) outside = std::max(outside, -bound.at(place));
      nearest = std::min(nearest, outside);
    }
  return nearest;
}

// Whether two faces that do not match share places of a region: of 4 x 4 points of each pair of elements.
bool share_some_of(const iga::Region& region, const geometry::MultiPatch& model,
                   const geometry::NonMatchingInterface& pair) {
  constexpr int points = 4;
  const auto surface = [&](const geometry::PatchFace& face) {
    return geometry::face_surface(model.patch(face.patch), face.side);
  };
  const geometry::NurbsSurface first = surface(pair.first), second = surface(pair.second);
  const auto divided = [](const geometry::NurbsSurface& of) {
    return geometry::DividedSurface{&of, {of.knots(0).breaks(), of.knots(1).breaks()}};
  };
  for (const geometry::SharedCell& cell : geometry::common_refinement(
           divided(first), divided(second), points, model.tolerance().same_point * model.size()))
    for (const geometry::SharedPoint& point : cell.points)
      if (region.contains(first.point(point.first))) return true;
  return false;
}

}  // namespace

iga::Region part_of(const FaceSelection& selection) {
  iga::Region result;
  if (!selection.part) return result;
  const FaceConditions& part = *selection.part;
  try {
    if (part.plane) result = std::move(result) & iga::half_space(part.plane->point, part.plane->normal);
    if (part.cylinder)
      result = std::move(result) &
               iga::inside_cylinder(part.cylinder->point, part.cylinder->axis, part.cylinder->radius);
    if (part.sphere)
      result = std::move(result) & iga::inside_sphere(part.sphere->centre, part.sphere->radius);
    if (part.box) result = std::move(result) & iga::inside_box(part.box->min, part.box->max);
  } catch (const Error& error) {
    throw error_at(selection.place, error.what(), error.code());
  }
  return result;
}

std::vector<geometry::PatchFace> faces_reaching_into(const iga::Region& region,
                                                     const geometry::MultiPatch& model,
                                                     const std::vector<geometry::PatchFace>& faces,
                                                     const Place& place) {
  std::vector<geometry::PatchFace> result;
  for (const geometry::PatchFace& face : faces)
    if (iga::area_of(model.patches(), {face}, region) > 0) result.push_back(face);
  if (!result.empty()) return result;
  std::pair<double, std::string> nearest{std::numeric_limits<double>::infinity(), ""};
  for (const geometry::PatchFace& face : faces)
    nearest = std::min(nearest, {gap(region, model.patch(face.patch), face.side), model.label(face)});
  throw error_at(
      place, fmt::format("part: none of the faces has an area in there; {} comes nearest", nearest.second));
}

void refuse_covered_part(const iga::Region& region, const geometry::MultiPatch& model,
                         const std::vector<geometry::PatchFace>& faces, const Place& place) {
  for (const geometry::NonMatchingInterface& pair : model.non_matching())
    for (const geometry::PatchFace& face : faces) {
      if ((face != pair.first && face != pair.second) || !share_some_of(region, model, pair)) continue;
      throw error_at(
          place, fmt::format("part: {} covers some of the part of face {}, and a support or load "
                             "would act beneath it too; make the part smaller",
                             model.label(face == pair.first ? pair.second : pair.first), model.label(face)));
    }
}

}  // namespace isopatch::app
