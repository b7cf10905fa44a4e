#include "geometry/multi_patch.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "geometry/base/error.hpp"
#include "geometry/base/union_find.hpp"
#include "geometry/conformity.hpp"
#include "geometry/interface_search.hpp"
#include "geometry/measures.hpp"
#include "geometry/scaled_jacobian.hpp"
#include "geometry/splines/refine.hpp"

namespace isopatch::geometry {
namespace {

/// Below this share of the columns' lengths the sign of det J at one point says nothing.
constexpr double unclear_sign = 1e-3;

// By the sign of det J at the middle; where that is not clear, by its sum over a grid.
bool is_left_handed(const NurbsVolume& patch) {
  const Parameter<3> range = patch.high() - patch.low();
  const double middle = scaled_jacobian(patch.jacobian(patch.low() + 0.5 * range));
  if (std::abs(middle) > unclear_sign) return middle < 0;
  constexpr int n = 5;
  double sum = 0;
  for (int i = 0; i < n * n * n; ++i) {
    const Parameter<3> share((i % n + 0.5) / n, (i / n % n + 0.5) / n, (i / n / n + 0.5) / n);
    sum += patch.jacobian(patch.low() + share.cwiseProduct(range)).determinant();
  }
  return sum < 0;
}

void check_face(PatchFace face, std::size_t patches, const std::string& where) {
  const int side = static_cast<int>(face.side);
  if (face.patch.value < 0 || static_cast<std::size_t>(face.patch.value) >= patches || side < 0 || side > 5)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("{}: no face {}:{}; there are {} patches, counted from 0, with sides {} to {}",
                            where, face.patch.value,
                            side >= 0 && side < 6 ? std::string(name(face.side)) : fmt::format("{}", side),
                            patches, name(Side::west), name(Side::back)));
}

void check_input(const PatchSet& set, const Tolerance& tolerance) {
  if (set.patches.empty()) throw Error(ErrorCode::invalid_argument, "a model needs at least one patch");
  if (!(tolerance.same_point > 0 && tolerance.same_point < 1e-2))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("same_point is {}; its range is (0, 1e-2)", tolerance.same_point));
  if (!(tolerance.near_miss > tolerance.same_point && tolerance.near_miss < 0.1))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("near_miss is {}; its range is (same_point, 0.1), and same_point is {}",
                            tolerance.near_miss, tolerance.same_point));
  if (!(tolerance.same_knot > 0 && tolerance.same_knot < 1e-3))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("same_knot is {}; its range is (0, 1e-3)", tolerance.same_knot));
  for (const Boundary& boundary : set.boundaries)
    for (const PatchFace& face : boundary.faces)
      check_face(face, set.patches.size(), fmt::format("boundary '{}'", boundary.name));
  for (const StatedInterface& stated : set.interfaces)
    for (const PatchFace& face : {stated.first, stated.second})
      check_face(face, set.patches.size(), "list of interfaces");
}

double diagonal(const std::vector<NurbsVolume>& patches) {
  Eigen::AlignedBox3d box;
  for (const NurbsVolume& patch : patches)
    for (const auto& point : patch.control_points().colwise()) box.extend(point);
  const double size = box.diagonal().norm();
  if (!(size > 0) || !std::isfinite(size))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("the diagonal of the model's box is {}; is the model a point, "
                            "or in a wrong unit?",
                            size));
  return size;
}

}  // namespace

PatchFace MultiPatch::from_input(PatchFace face) const {
  if (was_reversed(face.patch) && direction(face.side) == 0) face.side = opposite(face.side);
  return face;
}

Parameter<3> MultiPatch::from_input(PatchId id, const Parameter<3>& parameter) const {
  if (!was_reversed(id)) return parameter;
  const KnotVector& knots = patch(id).knots(0);
  return {knots.first() + (knots.last() - parameter[0]), parameter[1], parameter[2]};
}

std::string MultiPatch::label(PatchFace face) const {
  return fmt::format("{}:{}", face.patch.value, name(to_input(face).side));
}

std::vector<std::vector<PatchId>> MultiPatch::bodies() const {
  UnionFind joined(patch_count());
  for (const Interface& i : interfaces_) joined.unite(i.first.patch.value, i.second.patch.value);
  for (const NonMatchingInterface& i : non_matching_) joined.unite(i.first.patch.value, i.second.patch.value);
  std::vector<std::vector<PatchId>> found(patches_.size());
  for (int i = 0; i < patch_count(); ++i)
    found[static_cast<std::size_t>(joined.find(i))].push_back(PatchId(i));
  std::erase_if(found, [](const auto& body) { return body.empty(); });
  return found;
}

MultiPatch MultiPatch::with_apart(const std::vector<bool>& apart) const {
  MultiPatch result = *this;
  result.interfaces_.clear();
  for (std::size_t i = 0; i < interfaces_.size(); ++i) {
    const Interface& interface = interfaces_[i];
    if (apart[i])
      result.non_matching_.push_back(
          {std::min(interface.first, interface.second), std::max(interface.first, interface.second), 0});
    else
      result.interfaces_.push_back(interface);
  }
  std::sort(result.non_matching_.begin(), result.non_matching_.end(), [](const auto& a, const auto& b) {
    return std::pair(a.first, a.second) < std::pair(b.first, b.second);
  });
  return result;
}

std::string MultiPatch::patch_name(PatchId id) const {
  const auto i = static_cast<std::size_t>(id.value);
  return i < names_.size() ? names_[i] : "";
}

Eigen::AlignedBox3d box(const MultiPatch& model) {
  Eigen::AlignedBox3d result;
  for (const NurbsVolume& patch : model.patches()) result.extend(box(patch));
  return result;
}

MultiPatch connect(PatchSet set, const Tolerance& tolerance) {
  check_input(set, tolerance);
  MultiPatch model;
  model.tolerance_ = tolerance;
  model.size_ = diagonal(set.patches);
  for (NurbsVolume& patch : set.patches) {
    model.reversed_.push_back(is_left_handed(patch));
    model.patches_.push_back(model.reversed_.back() ? reversed(patch, 0) : std::move(patch));
  }
  for (Boundary& boundary : set.boundaries)
    for (PatchFace& face : boundary.faces) face = model.from_input(face);
  for (StatedInterface& stated : set.interfaces)
    stated = turned_around(stated, model.was_reversed(stated.first.patch),
                           model.was_reversed(stated.second.patch));
  model.boundaries_ = std::move(set.boundaries);
  model.names_ = std::move(set.names);

  const FaceLabel label = [&](PatchFace face) { return model.label(face); };
  FaceSets found = find_interfaces(model.patches_, set.interfaces, tolerance, model.size_, label);
  check_stated(model.patches_, found.interfaces, set.interfaces, tolerance, model.size_, label);
  if (tolerance.keep_non_matching) {
    NonMatchingFaces apart =
        find_non_matching(model.patches_, found.boundary, tolerance.same_point * model.size_, label);
    found.boundary = std::move(apart.boundary);
    model.non_matching_ = std::move(apart.interfaces);
    model.partly_covered_ = std::move(apart.partly_covered);
  }
  std::vector<PatchFace> alone;
  std::set_difference(found.boundary.begin(), found.boundary.end(), model.partly_covered_.begin(),
                      model.partly_covered_.end(), std::back_inserter(alone));
  check_conforming(model.patches_, alone, tolerance, model.size_, label);
  model.interfaces_ = std::move(found.interfaces);
  model.boundary_faces_ = std::move(found.boundary);
  model.degenerate_faces_ = std::move(found.degenerate);
  return model;
}

}  // namespace isopatch::geometry
