#include "geometry/conformity.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>

#include "geometry/base/error.hpp"
#include "geometry/face_match.hpp"
#include "geometry/measures.hpp"
#include "geometry/splines/grid.hpp"
#include "geometry/surface_foot.hpp"
#include "geometry/touching_boxes.hpp"

namespace isopatch::geometry {
namespace {

/// Share of a face's own width above which a difference is a different face, not a badly made one.
constexpr double near_miss_of_face = 0.02;

struct FreeFace {
  PatchFace face;
  NurbsSurface surface;
  Eigen::AlignedBox3d box;
  Eigen::Vector3d middle;
  double width = 0;  ///< the smaller length of the two lines through the middle
};

double width(const NurbsSurface& surface) {
  constexpr int segments = 16;
  const Parameter<2> middle = unscaled(surface, {0.5, 0.5});
  double smallest = std::numeric_limits<double>::infinity();
  for (std::size_t d = 0; d < 2; ++d) {
    GridParameters<2> line = {std::vector{middle[0]}, std::vector{middle[1]}};
    const KnotVector& knots = surface.knots()[d];
    line[d].clear();
    for (int i = 0; i <= segments; ++i) line[d].push_back(knots.first() + knots.length() * i / segments);
    const Eigen::Matrix3Xd points = points_on_grid(surface, line);
    smallest =
        std::min(smallest, (points.rightCols(segments) - points.leftCols(segments)).colwise().norm().sum());
  }
  return smallest;
}

std::vector<FreeFace> free_faces(const std::vector<NurbsVolume>& patches,
                                 const std::vector<PatchFace>& faces) {
  std::vector<FreeFace> result;
  for (const PatchFace& face : faces) {
    FreeFace free{
        face, face_surface(patches[static_cast<std::size_t>(face.patch.value)], face.side), {}, {}, 0};
    for (const auto& point : free.surface.control_points().colwise()) free.box.extend(point);
    free.middle = free.surface.point(unscaled(free.surface, {0.5, 0.5}));
    free.width = width(free.surface);
    result.push_back(std::move(free));
  }
  return result;
}

std::string text(const Eigen::Vector3d& point) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", point[0], point[1], point[2]);
}

// Whether the second face lies outside the first one's patch where the two differ most: a gap. Of an overlap,
// and of the two sides of a wall, each lies inside.
bool is_gap(const std::vector<NurbsVolume>& patches, const FreeFace& first, const FaceMatch& match) {
  const NurbsVolume& patch = patches[static_cast<std::size_t>(first.face.patch.value)];
  const Eigen::Vector3d outward =
      outward_normal(patch, first.face.side, unscaled(first.surface, match.parameter));
  return outward.dot(match.second_point - match.first_point) > 0.5 * match.distance;
}

bool is_near_miss(const std::vector<NurbsVolume>& patches, const FreeFace& a, const FreeFace& b,
                  const FaceMatch& match, double limit) {
  if (match.distance > std::min(limit, near_miss_of_face * std::min(a.width, b.width))) return false;
  if (is_gap(patches, a, match)) return true;
  if (a.face.patch == b.face.patch) return false;  // sides of one patch beside a sharp edge
  const auto across = [&](const FreeFace& f) {
    return thickness(patches[static_cast<std::size_t>(f.face.patch.value)], f.face.side);
  };
  // The sides of a wall are at least as far apart as the layers between them are thick.
  return match.distance < 0.5 * std::max(across(a), across(b));
}

void check_near_misses(const std::vector<NurbsVolume>& patches, const std::vector<FreeFace>& faces,
                       const Tolerance& tolerance, double size, const FaceLabel& label) {
  std::vector<Eigen::Vector3d> middles;
  for (const FreeFace& face : faces) middles.push_back(face.middle);
  const double limit = tolerance.near_miss * size;
  std::string message;
  int count = 0;
  for (const auto& [i, j] : close_pairs(middles, limit)) {
    const FaceMatch match = match_faces(faces[i].surface, faces[j].surface);
    if (!is_near_miss(patches, faces[i], faces[j], match, limit) || ++count > 1) continue;
    message = fmt::format(
        "faces {} and {} nearly meet: they differ by up to {:.3g} at {}, {:.2g} of the model's size, and "
        "{:.2g} is "
        "allowed. Mend the model, or raise same_point (in a study: model.same_point) above {:.2g}; if the "
        "two are "
        "meant to be apart, lower near_miss (model.near_miss) below it",
        label(faces[i].face), label(faces[j].face), match.distance, text(match.first_point),
        match.distance / size, tolerance.same_point, match.distance / size);
  }
  if (count > 1) message += fmt::format(" ({} more pairs like this)", count - 1);
  if (count > 0) throw Error(ErrorCode::not_conforming, message);
}

// Whether at least three of five points of one face, no three of them in line, are on the other.
bool lies_on(const FreeFace& face, const FreeFace& other, double same_point) {
  int inside = 0;
  for (const Parameter<2>& at : {Parameter<2>(0.5, 0.5), Parameter<2>(0.23, 0.31), Parameter<2>(0.71, 0.19),
                                 Parameter<2>(0.83, 0.77), Parameter<2>(0.36, 0.86)}) {
    const Eigen::Vector3d point = face.surface.point(unscaled(face.surface, at));
    if (other.box.squaredExteriorDistance(point) > same_point * same_point) continue;
    if (surface_foot(other.surface, point, same_point).distance <= same_point && ++inside == 3) return true;
  }
  return false;
}

void check_other_parameters(const std::vector<FreeFace>& faces, double same_point, const FaceLabel& label) {
  std::vector<Eigen::AlignedBox3d> boxes;
  for (const FreeFace& face : faces) boxes.push_back(face.box);
  for (const auto& [i, j] : touching_boxes(boxes, same_point)) {
    const FreeFace& a = faces[i];
    const FreeFace& b = faces[j];
    if (!lies_on(a, b, same_point) && !lies_on(b, a, same_point)) continue;
    throw Error(
        ErrorCode::not_conforming,
        fmt::format("faces {} and {} lie on one another, but are parametrized differently or have different "
                    "outlines, so they cannot be joined; split or reparametrize the patches so that the "
                    "faces agree point by point, or set non_matching = \"nitsche\" or \"mortar\" "
                    "(in a study: coupling.non_matching), which couple them as they are",
                    label(a.face), label(b.face)));
  }
}

}  // namespace

void check_conforming(const std::vector<NurbsVolume>& patches, const std::vector<PatchFace>& faces,
                      const Tolerance& tolerance, double size, const FaceLabel& label) {
  const std::vector<FreeFace> free = free_faces(patches, faces);
  check_near_misses(patches, free, tolerance, size, label);
  check_other_parameters(free, tolerance.same_point * size, label);
}

void check_stated(const std::vector<NurbsVolume>& patches, const std::vector<Interface>& found,
                  const std::vector<StatedInterface>& all_stated, const Tolerance& tolerance, double size,
                  const FaceLabel& label) {
  const auto order = [](const Interface& interface) { return std::pair(interface.first, interface.second); };
  for (const StatedInterface& given : all_stated) {
    const StatedInterface stated = given.second < given.first ? exchanged(given) : given;
    const std::pair pair(stated.first, stated.second);
    const auto at = std::lower_bound(found.begin(), found.end(), pair,
                                     [&](const Interface& i, const auto& key) { return order(i) < key; });
    if (at != found.end() && order(*at) == pair) continue;
    const auto surface = [&](PatchFace f) {
      return face_surface(patches[static_cast<std::size_t>(f.patch.value)], f.side);
    };
    const FaceMatch match = match_faces(surface(given.first), surface(given.second));
    if (match.distance <= tolerance.same_point * size)
      throw Error(
          ErrorCode::not_conforming,
          fmt::format("the faces of the stated interface {} - {} lie on each other, but not as it says: "
                      "their directions run otherwise. Correct its directions, or leave the interfaces "
                      "out, so that they are found from the geometry",
                      label(given.first), label(given.second)));
    throw Error(
        ErrorCode::not_conforming,
        fmt::format(
            "the stated interface {} - {} is not one: the faces differ by up to {:.3g} at {}, {:.2g} of "
            "the model's size, and {:.2g} is allowed. Correct the list, mend the model, or raise "
            "same_point (in a study: model.same_point)",
            label(given.first), label(given.second), match.distance, text(match.first_point),
            match.distance / size, tolerance.same_point));
  }
}

}  // namespace isopatch::geometry
