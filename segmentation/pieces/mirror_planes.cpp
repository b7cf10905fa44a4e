#include "segmentation/pieces/mirror_planes.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>

namespace isopatch::segmentation {
namespace {

using geometry::Brep;
using geometry::Carrier;
using geometry::PlaneSurface;
using geometry::SurfaceKind;

/// Sines and shares of the size that count as none.
constexpr double same = 1e-7;

struct SeenFace {
  std::optional<Carrier> carrier;
  double area;
};

std::vector<SeenFace> seen_faces(const Brep& solid) {
  std::vector<SeenFace> result;
  for (int f = 0; f < static_cast<int>(solid.faces().size()); ++f)
    result.push_back({solid.carrier(FaceId(f)), solid.area(FaceId(f))});
  return result;
}

bool is_round(const SeenFace& face) {
  return face.carrier &&
         (face.carrier->kind == SurfaceKind::cylinder || face.carrier->kind == SurfaceKind::cone);
}

/// Where the surface has its middle, nearly.
Eigen::Vector3d middle_of(const Brep& solid) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  double area = 0;
  for (const geometry::FaceTriangles& face : tessellate(solid).faces)
    for (const auto triangle : face.triangles.colwise()) {
      const Eigen::Vector3d a = face.points.col(triangle[0]), b = face.points.col(triangle[1]),
                            c = face.points.col(triangle[2]);
      const double size = (b - a).cross(c - a).norm() / 2;
      sum += size * (a + b + c) / 3;
      area += size;
    }
  return sum / area;
}

class Normals {
 public:
  void add(const Eigen::Vector3d& normal) {
    constexpr std::size_t most = 24;
    if (normal.norm() < 1e-9 || all.size() == most) return;
    const Eigen::Vector3d unit = normal.normalized();
    if (std::none_of(all.begin(), all.end(),
                     [&](const Eigen::Vector3d& known) { return known.cross(unit).norm() < same; }))
      all.push_back(unit);
  }
  std::vector<Eigen::Vector3d> all;
};

std::vector<Eigen::Vector3d> normals(const std::vector<SeenFace>& faces) {
  Normals result;
  for (int i = 0; i < 3; ++i) result.add(Eigen::Vector3d::Unit(i));
  for (const SeenFace& face : faces)
    if (face.carrier && face.carrier->kind == SurfaceKind::plane) result.add(face.carrier->axis);
  for (std::size_t i = 0; i < faces.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      if (!is_round(faces[i]) || !is_round(faces[j])) continue;
      const Carrier &a = *faces[i].carrier, &b = *faces[j].carrier;
      if (a.axis.cross(b.axis).norm() > same) continue;
      const Eigen::Vector3d between = b.origin - a.origin;
      result.add(between - between.dot(a.axis) * a.axis);
    }
  return result.all;
}

/// The exact place of a plane of symmetry: through an axis, or half way between two planes or axes. Nothing
/// if none is near enough to the middle.
std::optional<double> place_along(const Eigen::Vector3d& normal, const std::vector<SeenFace>& faces,
                                  double middle, double size) {
  std::optional<double> best;
  const auto consider = [&](double at) {
    if (std::abs(at - middle) < 2e-3 * size && (!best || std::abs(at - middle) < std::abs(*best - middle)))
      best = at;
  };
  std::vector<double> planes, axes;
  for (const SeenFace& face : faces) {
    if (!face.carrier) continue;
    const double at = face.carrier->origin.dot(normal);
    if (face.carrier->kind == SurfaceKind::plane) {
      if (face.carrier->axis.cross(normal).norm() < same) planes.push_back(at);
    } else if (face.carrier->kind == SurfaceKind::sphere || std::abs(face.carrier->axis.dot(normal)) < same) {
      axes.push_back(at);
    }
  }
  for (const std::vector<double>& places : {planes, axes})
    for (std::size_t i = 0; i < places.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) consider((places[i] + places[j]) / 2);
  for (const double at : axes) consider(at);
  return best;
}

class Reflection {
 public:
  Reflection(const Eigen::Vector3d& normal, double at) : normal_(normal), at_(at) {}

  Eigen::Vector3d point(const Eigen::Vector3d& p) const { return p - 2 * (p.dot(normal_) - at_) * normal_; }
  Eigen::Vector3d direction(const Eigen::Vector3d& v) const { return v - 2 * v.dot(normal_) * normal_; }

 private:
  Eigen::Vector3d normal_;
  double at_;
};

/// Whether one surface is the image of another.
bool is_image(const Carrier& a, const Carrier& b, const Reflection& mirror, double size) {
  const auto near = [&](double x, double y) { return std::abs(x - y) < 1e-6 * size; };
  if (a.kind != b.kind || !near(a.second_radius, b.second_radius)) return false;
  const Eigen::Vector3d off = mirror.point(a.origin) - b.origin, axis = mirror.direction(a.axis);
  if (a.kind == SurfaceKind::sphere) return near(a.radius, b.radius) && near(off.norm(), 0);
  if (axis.cross(b.axis).norm() > 1e-6) return false;
  if (a.kind == SurfaceKind::plane) return near(off.dot(b.axis), 0);
  const bool same_axis = near((off - off.dot(b.axis) * b.axis).norm(), 0);
  if (a.kind == SurfaceKind::cone)  // the apex says more than the radius at an origin anywhere
    return same_axis && near(std::abs(a.half_angle.radians()), std::abs(b.half_angle.radians()));
  return same_axis && near(a.radius, b.radius) && (a.kind != SurfaceKind::torus || near(off.norm(), 0));
}

bool looks_symmetric(const std::vector<SeenFace>& faces, const Reflection& mirror, double size) {
  return std::all_of(faces.begin(), faces.end(), [&](const SeenFace& face) {
    return std::any_of(faces.begin(), faces.end(), [&](const SeenFace& other) {
      if (std::abs(face.area - other.area) > 1e-6 * face.area) return false;
      if (!face.carrier || !other.carrier) return !face.carrier && !other.carrier;
      return is_image(*face.carrier, *other.carrier, mirror, size);
    });
  });
}

}  // namespace

std::vector<PlaneSurface> mirror_planes(const Brep& solid) {
  const std::vector<SeenFace> faces = seen_faces(solid);
  const Eigen::Vector3d middle = middle_of(solid);
  std::vector<PlaneSurface> result;
  for (const Eigen::Vector3d& normal : normals(faces)) {
    const auto at = place_along(normal, faces, middle.dot(normal), solid.size());
    if (!at || !looks_symmetric(faces, Reflection(normal, *at), solid.size())) continue;
    const Eigen::Vector3d x = normal.unitOrthogonal();
    result.push_back({*at * normal + (middle - middle.dot(normal) * normal), x, normal.cross(x)});
  }
  return result;
}

}  // namespace isopatch::segmentation
