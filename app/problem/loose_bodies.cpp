#include "app/problem/loose_bodies.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <limits>
#include <map>

#include "app/base/engineering_units.hpp"
#include "geometry/measures.hpp"
#include "iga/spaces/elastic_field.hpp"

namespace isopatch::app {
namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;
using geometry::MultiPatch;
using geometry::NurbsVolume;

constexpr double near = 0.05;  // of the smaller body

// A patch with what searches in it need.
struct Searched {
  iga::ElasticField field;  // the patch alone, at rest
  AlignedBox3d box;
  int body = 0;
  std::vector<Vector3d> on_faces;  // of the boundary
  std::vector<Vector3d> inside;
};

struct Found {
  double distance = std::numeric_limits<double>::infinity();
  double depth = 0;
  Vector3d place = Vector3d::Zero();
};

std::vector<Vector3d> face_points(const MultiPatch& model, PatchId id) {
  constexpr std::array<double, 5> shares = {0, 0.25, 0.5, 0.75, 1};
  std::vector<Vector3d> points;
  for (const geometry::PatchFace& face : model.boundary_faces()) {
    if (face.patch != id) continue;
    const auto surface = geometry::face_surface(model.patch(id), face.side);
    const geometry::Parameter<2> range = surface.high() - surface.low();
    for (const double u : shares)
      for (const double v : shares)
        points.push_back(surface.point(surface.low() + range.cwiseProduct(geometry::Parameter<2>(u, v))));
  }
  return points;
}

std::vector<Vector3d> inner_points(const NurbsVolume& patch) {
  constexpr std::array<double, 3> shares = {0.2, 0.5, 0.8};
  std::vector<Vector3d> points;
  for (const double u : shares)
    for (const double v : shares)
      for (const double w : shares)
        points.push_back(patch.point(
            patch.low() + (patch.high() - patch.low()).cwiseProduct(geometry::Parameter<3>(u, v, w))));
  return points;
}

Searched searched(const MultiPatch& model, PatchId id) {
  const NurbsVolume& patch = model.patch(id);
  Searched result;
  result.field = {{patch}, {Eigen::Matrix3Xd(Eigen::Matrix3Xd::Zero(3, patch.size()))}, {iga::Material{}}};
  result.box = geometry::box(patch);
  result.on_faces = face_points(model, id);
  result.inside = inner_points(patch);
  return result;
}

// How deep a parameter lies inside a patch: the distance to the nearest of the six sides, as the map is
// there.
double depth_at(const NurbsVolume& patch, const geometry::Parameter<3>& at) {
  const Eigen::Matrix3d jacobian = patch.jacobian(at);
  const double determinant = std::abs(jacobian.determinant());
  double depth = std::numeric_limits<double>::infinity();
  for (int d = 0; d < 3; ++d) {
    const Vector3d across = jacobian.col((d + 1) % 3).cross(jacobian.col((d + 2) % 3));
    const double left = std::min(at[d] - patch.low()[d], patch.high()[d] - at[d]);
    depth = std::min(depth, left * determinant / std::max(across.norm(), 1e-300));
  }
  return depth;
}

// Holds a point against a patch; points further than `reach` from its box are not looked at.
void look(const Vector3d& point, const Searched& other, double reach, double same, Found& found) {
  if (other.box.exteriorDistance(point) > std::min(reach, found.distance)) return;
  const iga::Location location = iga::locate(other.field, point);
  if (location.distance <= same) {
    const double depth = depth_at(other.field.patches[0], location.parameter);
    if (depth <= found.depth && found.distance == 0) return;
    found = {0, std::max(depth, found.depth), point};
  } else if (location.distance < found.distance) {
    found.distance = location.distance;
    found.place = point;
  }
}

// To and fro between two patches, from a point of the first: towards the gap's narrowest place.
void narrow(const Searched& first, const Searched& second, Found& found) {
  Vector3d point = found.place;
  for (int i = 0; i < 20; ++i) {
    const Searched& other = i % 2 == 0 ? second : first;
    const iga::Location location = iga::locate(other.field, point);
    point = other.field.patches[0].point(location.parameter);
    if (location.distance < found.distance) {
      found.distance = location.distance;
      found.place = point;
    }
  }
}

bool is_worse(const Found& a, const Found& b) {
  return a.depth > b.depth || (a.depth == b.depth && a.distance < b.distance);
}

Found between_bodies(const Searched& a, const Searched& b, double reach, double same) {
  Found worst;
  for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    Found found;
    for (const Vector3d& point : from->on_faces) look(point, *to, reach, same, found);
    for (const Vector3d& point : from->inside) look(point, *to, reach, same, found);
    if (found.distance > 0 && found.distance < std::numeric_limits<double>::infinity())
      narrow(*from, *to, found);
    if (is_worse(found, worst)) worst = found;
  }
  return worst;
}

// Inner points only: on faces the patches of a body meet.
Found within_body(const Searched& a, const Searched& b, double same) {
  Found found;
  for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)})
    for (const Vector3d& point : from->inside)
      if (to->box.contains(point)) look(point, *to, 0, same, found);
  return found;
}

class Report {
 public:
  Report(const MultiPatch& model, const std::vector<std::string>& names)
      : model_(model), names_(names), same_(model.tolerance().same_point * model.size()) {
    bodies_ = model.bodies();
    for (int i = 0; i < model.patch_count(); ++i) patches_.push_back(searched(model, PatchId(i)));
    for (std::size_t b = 0; b < bodies_.size(); ++b) {
      AlignedBox3d box;
      for (const PatchId id : bodies_[b]) {
        patches_[static_cast<std::size_t>(id.value)].body = static_cast<int>(b);
        box.extend(patches_[static_cast<std::size_t>(id.value)].box);
      }
      sizes_.push_back(box.diagonal().norm());
    }
  }

  std::vector<Warning> warnings() const {
    std::vector<Warning> result;
    std::map<std::pair<int, int>, std::pair<Found, Warning>> of_bodies;
    for (std::size_t i = 0; i < patches_.size(); ++i)
      for (std::size_t j = i + 1; j < patches_.size(); ++j) {
        const Searched& a = patches_[i];
        const Searched& b = patches_[j];
        if (a.body != b.body) {
          const double reach = near * std::min(size_of(a), size_of(b));
          if (a.box.exteriorDistance(b.box) > reach) continue;
          const Found found = between_bodies(a, b, reach, same_);
          if (found.distance > reach) continue;
          const std::pair<int, int> pair = std::minmax(a.body, b.body);
          const auto known = of_bodies.find(pair);
          if (known != of_bodies.end() && !is_worse(found, known->second.first)) continue;
          of_bodies[pair] = {found, about_bodies(static_cast<int>(i), static_cast<int>(j), found)};
        } else if (a.box.intersects(b.box)) {
          const Found found = within_body(a, b, same_);
          // Patches of a body may differ by its gaps.
          if (found.depth > 2 * model_.tolerance().near_miss * model_.size())
            result.push_back(about_patches(static_cast<int>(i), static_cast<int>(j), found));
        }
      }
    for (const auto& [pair, found] : of_bodies) result.push_back(found.second);
    return result;
  }

 private:
  double size_of(const Searched& patch) const { return sizes_[static_cast<std::size_t>(patch.body)]; }

  std::string patch_name(int patch) const {
    const auto p = static_cast<std::size_t>(patch);
    return p < names_.size() && !names_[p].empty() ? fmt::format("'{}'", names_[p])
                                                   : fmt::format("patch {}", patch);
  }
  std::string body_name(int patch) const {
    const int body = patches_[static_cast<std::size_t>(patch)].body;
    const std::size_t count = bodies_[static_cast<std::size_t>(body)].size();
    return count == 1 ? fmt::format("body {} ({})", body, patch_name(patch))
                      : fmt::format("body {} ({} of {} patches)", body, patch_name(patch), count);
  }

  Warning about_bodies(int i, int j, const Found& found) const {
    const std::string place = place_with_unit(found.place, model_.size());
    const std::string both = fmt::format("{} and {}", body_name(i), body_name(j));
    std::string text;
    if (found.depth > same_)
      text = fmt::format(
          "{} run into each other, {} deep at {}; nothing holds them together, and what both fill counts "
          "twice. Move them apart, or make them one body whose faces match",
          both, with_unit(found.depth, "m"), place);
    else if (found.distance == 0)
      text = fmt::format(
          "{} touch at {}, but share no face, so nothing holds them together. If they should be one "
          "body, give them faces that match",
          both, place);
    else
      text = fmt::format(
          "{} are {} apart at {} and nothing holds them together. If they should be one body, close "
          "the gap in the model, or let model.same_point span it where it is below 1 % of the size",
          both, with_unit(found.distance, "m"), place);
    return {text, i, found.place};
  }

  Warning about_patches(int i, int j, const Found& found) const {
    return {fmt::format("{} and {} of body {} run through each other, {} deep at {}; what both fill counts "
                        "twice. Mend their shapes there",
                        patch_name(i), patch_name(j), patches_[static_cast<std::size_t>(i)].body,
                        with_unit(found.depth, "m"), place_with_unit(found.place, model_.size())),
            i, found.place};
  }

  const MultiPatch& model_;
  const std::vector<std::string>& names_;
  std::vector<std::vector<PatchId>> bodies_;
  std::vector<Searched> patches_;
  std::vector<double> sizes_;
  double same_;
};

}  // namespace

std::vector<Warning> loose_body_warnings(const MultiPatch& model, const std::vector<std::string>& names) {
  if (model.patch_count() == 1) return {};
  return Report(model, names).warnings();
}

}  // namespace isopatch::app
