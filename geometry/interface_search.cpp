#include "geometry/interface_search.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "geometry/base/error.hpp"
#include "geometry/collapse.hpp"
#include "geometry/face_match.hpp"
#include "geometry/splines/grid.hpp"

namespace isopatch::geometry {
namespace {

// +1 if the cross product of a side's tangents points out of a right-handed patch.
int outward_sign(Side side) {
  return (is_high(side) ? 1 : -1) * (direction(side) == 1 ? -1 : 1);
}

int determinant(const FaceOrientation& orientation) {
  const int turns = int(orientation.swapped) + int(orientation.flip_first) + int(orientation.flip_second);
  return turns % 2 == 0 ? 1 : -1;
}

void check_sides(const Interface& found, const FaceLabel& label) {
  const int same_way =
      outward_sign(found.first.side) * outward_sign(found.second.side) * determinant(found.orientation);
  if (same_way > 0)
    throw Error(
        ErrorCode::not_conforming,
        fmt::format("faces {} and {} are the same surface, but their patches lie on the same side of it, so "
                    "they overlap; is a patch in the model twice?",
                    label(found.first), label(found.second)));
}

void check_thickness(const std::vector<NurbsVolume>& patches, const Interface& found, double same_point,
                     double size, const FaceLabel& label) {
  if (found.first.patch != found.second.patch || found.second.side != opposite(found.first.side)) return;
  const NurbsVolume& patch = patches[static_cast<std::size_t>(found.first.patch.value)];
  const double across = thickness(patch, found.first.side);
  if (!(across < 10 * same_point)) return;
  Parameter<3> at;
  for (int d = 0; d < 3; ++d) at[d] = patch.knots(d).first() + patch.knots(d).length() / 2;
  const Eigen::Vector3d middle = patch.point(at);
  throw Error(
      ErrorCode::not_conforming,
      fmt::format("the patch between faces {} and {} is {:.3g} thick at ({:.6g}, {:.6g}, {:.6g}), and "
                  "points nearer than {:.3g} count as one; make it thicker, remove it, or lower "
                  "same_point to {:.1g} (in a study: model.same_point)",
                  label(found.first), label(found.second), across, middle[0], middle[1], middle[2],
                  same_point, across / size / 20));
}

void check_at_most_two(const std::vector<Interface>& interfaces, const FaceLabel& label) {
  std::vector<PatchFace> used;
  for (const Interface& i : interfaces) {
    used.push_back(i.first);
    used.push_back(i.second);
  }
  std::sort(used.begin(), used.end());
  const auto twice = std::adjacent_find(used.begin(), used.end());
  if (twice == used.end()) return;
  std::string others;
  for (const Interface& i : interfaces) {
    if (i.first != *twice && i.second != *twice) continue;
    others += fmt::format("{}{}", others.empty() ? "" : ", ", label(i.first == *twice ? i.second : i.first));
  }
  throw Error(
      ErrorCode::not_conforming,
      fmt::format(
          "more than two faces in one place: {} coincides with {}; an interface joins exactly two, so "
          "patches overlap or one is in the model twice",
          label(*twice), others));
}

// By the smaller and the larger face of a pair.
using StatedOrientations = std::map<std::pair<PatchFace, PatchFace>, FaceOrientation>;

StatedOrientations orientations_of(const std::vector<StatedInterface>& stated) {
  StatedOrientations result;
  for (const StatedInterface& given : stated) {
    const StatedInterface ordered = given.second < given.first ? exchanged(given) : given;
    result.emplace(std::pair(ordered.first, ordered.second), ordered.orientation);
  }
  return result;
}

}  // namespace

double thickness(const NurbsVolume& patch, Side side) {
  constexpr int segments = 16;
  std::array<std::vector<double>, 3> line;
  for (int d = 0; d < 3; ++d) {
    const KnotVector& knots = patch.knots(d);
    auto& parameters = line[static_cast<std::size_t>(d)];
    if (d != direction(side))
      parameters.push_back(0.5 * (knots.first() + knots.last()));
    else
      for (int i = 0; i <= segments; ++i) parameters.push_back(knots.first() + knots.length() * i / segments);
  }
  const Eigen::Matrix3Xd points = points_on_grid(patch, line);
  return (points.rightCols(segments) - points.leftCols(segments)).colwise().norm().sum();
}

std::vector<std::pair<std::size_t, std::size_t>> close_pairs(const std::vector<Eigen::Vector3d>& points,
                                                             double radius) {
  // A direction in which few models have many faces at the same height.
  const Eigen::Vector3d along = Eigen::Vector3d(0.577, 0.347, 0.739).normalized();
  std::vector<std::pair<double, std::size_t>> heights;
  for (std::size_t i = 0; i < points.size(); ++i) heights.emplace_back(along.dot(points[i]), i);
  std::sort(heights.begin(), heights.end());
  std::vector<std::pair<std::size_t, std::size_t>> pairs;
  for (std::size_t a = 0; a < heights.size(); ++a)
    for (std::size_t b = a + 1; b < heights.size() && heights[b].first - heights[a].first <= radius; ++b) {
      const auto [i, j] = std::minmax(heights[a].second, heights[b].second);
      if ((points[i] - points[j]).norm() <= radius) pairs.emplace_back(i, j);
    }
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

FaceSets find_interfaces(const std::vector<NurbsVolume>& patches, const std::vector<StatedInterface>& stated,
                         const Tolerance& tolerance, double size, const FaceLabel& label) {
  const double same_point = tolerance.same_point * size;
  FaceSets sets;
  std::vector<PatchFace> faces;
  std::vector<NurbsSurface> surfaces;
  std::vector<Eigen::Vector3d> middles;  // the same point of a face in all its orientations
  for (std::size_t p = 0; p < patches.size(); ++p)
    for (const Side side : all_sides) {
      const PatchFace face{PatchId(static_cast<int>(p)), side};
      if (is_collapsed(patches[p], side, same_point)) {
        sets.degenerate.push_back(face);
        continue;
      }
      faces.push_back(face);
      surfaces.push_back(face_surface(patches[p], side));
      middles.push_back(surfaces.back().point(unscaled(surfaces.back(), {0.5, 0.5})));
    }
  const StatedOrientations orientations = orientations_of(stated);
  std::vector<bool> joined(faces.size(), false);
  for (const auto& [i, j] : close_pairs(middles, 2 * same_point)) {
    const auto known = orientations.find({faces[i], faces[j]});
    const FaceMatch match = known == orientations.end()
                                ? match_faces(surfaces[i], surfaces[j])
                                : match_faces(surfaces[i], surfaces[j], known->second);
    if (match.distance > same_point) continue;
    const Interface found{faces[i], faces[j], match.orientation, match.distance};
    check_thickness(patches, found, same_point, size, label);
    sets.interfaces.push_back(found);
    joined[i] = joined[j] = true;
  }
  check_at_most_two(sets.interfaces, label);
  for (const Interface& found : sets.interfaces) check_sides(found, label);
  for (std::size_t i = 0; i < faces.size(); ++i)
    if (!joined[i]) sets.boundary.push_back(faces[i]);
  return sets;
}

}  // namespace isopatch::geometry
