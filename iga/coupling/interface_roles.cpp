#include "iga/coupling/interface_roles.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>
#include <utility>

#include "geometry/base/error.hpp"

namespace isopatch::iga {
namespace {

using geometry::PatchFace;

// Softer, then finer: what comes first in this order suffers the other's displacements.
struct Compliance {
  double young = 0;             // Pa
  double area_of_function = 0;  // of the face's, for comparison only
};

bool is_before(const Compliance& a, const Compliance& b) {
  return a.young != b.young ? a.young < b.young : a.area_of_function <= b.area_of_function * (1 + 1e-9);
}

// The square of a diagonal over the number of functions: higher degrees count as smaller elements do.
double area_of_function(const geometry::NurbsVolume& patch, geometry::Side side) {
  const geometry::NurbsSurface surface = geometry::face_surface(patch, side);
  return (surface.control_points().rightCols<1>() - surface.control_points().leftCols<1>()).squaredNorm() /
         (surface.knots(0).size() * surface.knots(1).size());
}

Compliance compliance(const Discretization& discretization, const std::vector<Material>& materials,
                      const PatchFace& face) {
  const auto p = static_cast<std::size_t>(face.patch.value);
  return {young(materials[p]), area_of_function(discretization.patches[p], face.side)};
}

// In proportion to what a side's traction needs as penalty, Pa/m: stiffness by (degree + 1)^2 / thickness of
// the element in the middle of the face.
double penalty(const Discretization& discretization, const std::vector<Material>& materials,
               const PatchFace& face) {
  const auto p = static_cast<std::size_t>(face.patch.value);
  const geometry::NurbsVolume& patch = discretization.patches[p];
  const int across = geometry::direction(face.side);
  const std::vector<double> breaks = patch.knots(across).breaks();
  geometry::Parameter<2> middle;
  for (int d = 0; d < 2; ++d) {
    const int direction = geometry::tangents(face.side)[static_cast<std::size_t>(d)];
    const std::vector<double> along = patch.knots(direction).breaks();
    middle[d] = (along.front() + along.back()) / 2;
  }
  geometry::Parameter<3> behind = geometry::on_side(patch, face.side, middle);
  const Eigen::Vector3d on_face = patch.point(behind);
  behind[across] = geometry::is_high(face.side) ? breaks[breaks.size() - 2] : breaks[1];
  const int degree = patch.knots(across).degree();
  return young(materials[p]) * (degree + 1) * (degree + 1) / (patch.point(behind) - on_face).norm();
}

// Faces that meet directly or through others, by the side of the surface on which their patches lie.
using TwoSides = std::array<std::vector<PatchFace>, 2>;

class MeetingFaces {
 public:
  explicit MeetingFaces(const geometry::MultiPatch& model) : model_(model) {
    for (const geometry::NonMatchingInterface& interface : model.non_matching()) {
      neighbours_[interface.first].push_back(interface.second);
      neighbours_[interface.second].push_back(interface.first);
    }
    for (const auto& [face, neighbours] : neighbours_)
      if (!side_of_.contains(face)) begin_with(face);
  }
  const std::vector<TwoSides>& groups() const { return groups_; }
  const std::vector<PatchFace>& neighbours(const PatchFace& face) const { return neighbours_.at(face); }

 private:
  void begin_with(const PatchFace& first) {
    TwoSides& group = groups_.emplace_back();
    std::vector<PatchFace> open = {first};
    side_of_[first] = 0;
    while (!open.empty()) {
      const PatchFace face = open.back();
      open.pop_back();
      const int side = side_of_.at(face);
      group[static_cast<std::size_t>(side)].push_back(face);
      for (const PatchFace& neighbour : neighbours_.at(face)) {
        const auto [found, is_new] = side_of_.try_emplace(neighbour, 1 - side);
        if (is_new) open.push_back(neighbour);
        if (found->second == side)
          throw Error(ErrorCode::unsupported,
                      fmt::format("the mortar method needs two sides, and {} lies between others that lie on "
                                  "one another; set non_matching = \"nitsche\"",
                                  model_.label(neighbour)));
      }
    }
    for (std::vector<PatchFace>& faces : group) std::sort(faces.begin(), faces.end());
  }

  const geometry::MultiPatch& model_;
  std::map<PatchFace, std::vector<PatchFace>> neighbours_;
  std::map<PatchFace, int> side_of_;
  std::vector<TwoSides> groups_;
};

// The first face that others cover in part only; none: the end.
std::vector<PatchFace>::const_iterator uncovered(const geometry::MultiPatch& model,
                                                 const std::vector<PatchFace>& faces) {
  const std::vector<PatchFace>& boundary = model.boundary_faces();
  return std::find_if(faces.begin(), faces.end(), [&](const PatchFace& face) {
    return std::find(boundary.begin(), boundary.end(), face) != boundary.end();
  });
}

struct SlaveSide {
  std::size_t side = 0;
  std::string reason;
};

SlaveSide slave_side(const Discretization& discretization, const std::vector<Material>& materials,
                     const TwoSides& sides, MortarSide wish) {
  const geometry::MultiPatch& model = discretization.model;
  const std::array open = {uncovered(model, sides[0]), uncovered(model, sides[1])};
  const std::array can_be = {open[0] == sides[0].end(), open[1] == sides[1].end()};
  if (!can_be[0] && !can_be[1])
    throw Error(ErrorCode::unsupported,
                fmt::format("the mortar method needs a side that the other covers all over, and of {} and {} "
                            "parts stay free; set non_matching = \"nitsche\", or divide the patches there",
                            model.label(*open[0]), model.label(*open[1])));
  if (can_be[0] != can_be[1])
    return {can_be[0] ? std::size_t{0} : 1, "the only side that is covered all over"};
  // Of each side what comes first.
  std::array<Compliance, 2> of_sides;
  for (std::size_t s = 0; s < 2; ++s) {
    of_sides[s] = compliance(discretization, materials, sides[s].front());
    for (const PatchFace& face : sides[s]) {
      const Compliance own = compliance(discretization, materials, face);
      if (is_before(own, of_sides[s])) of_sides[s] = own;
    }
  }
  const std::size_t first = is_before(of_sides[0], of_sides[1]) ? 0 : 1;
  if (wish == MortarSide::other) return {1 - first, "asked for: the other side"};
  return {first, of_sides[0].young != of_sides[1].young            ? "the softer side"
                 : is_before(of_sides[1 - first], of_sides[first]) ? "the first of two equal sides"
                                                                   : "the finer side"};
}

}  // namespace

std::vector<CoupledFaces> coupled_faces(const Discretization& discretization,
                                        const std::vector<Material>& materials) {
  std::vector<CoupledFaces> result;
  for (const geometry::NonMatchingInterface& interface : discretization.model.non_matching()) {
    // Equal but for round-off: the first.
    const bool is_first = penalty(discretization, materials, interface.first) <=
                          penalty(discretization, materials, interface.second) * (1 + 1e-9);
    result.push_back(is_first ? CoupledFaces{interface.first, interface.second}
                              : CoupledFaces{interface.second, interface.first});
  }
  return result;
}

std::vector<MortarFace> mortar_faces(const Discretization& discretization,
                                     const std::vector<Material>& materials, MortarSide side) {
  const MeetingFaces meeting(discretization.model);
  std::vector<MortarFace> result;
  for (const TwoSides& sides : meeting.groups()) {
    const SlaveSide slaves = slave_side(discretization, materials, sides, side);
    for (const PatchFace& face : sides[slaves.side])
      result.push_back({face, meeting.neighbours(face), slaves.reason});
  }
  std::sort(result.begin(), result.end(),
            [](const MortarFace& a, const MortarFace& b) { return a.slave < b.slave; });
  return result;
}

}  // namespace isopatch::iga
