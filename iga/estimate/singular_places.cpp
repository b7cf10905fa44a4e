#include "iga/estimate/singular_places.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numbers>
#include <set>

#include "geometry/base/angle.hpp"
#include "geometry/surface_foot.hpp"
#include "iga/coupling/global_nodes.hpp"
#include "iga/estimate/internal/held_places.hpp"

namespace isopatch::iga {
namespace {

using geometry::NurbsVolume;
using geometry::PatchEdge;
using geometry::PatchFace;

constexpr Angle straight_angle = Angle::degrees(180);
constexpr Angle full_angle = Angle::degrees(360);
constexpr Angle angle_tolerance = Angle::degrees(5);
constexpr Angle harmless_if_clamped = Angle::degrees(60);
constexpr std::array<double, 5> edge_samples = {0.1, 0.3, 0.5, 0.7, 0.9};

struct EdgeOfPatch {
  int patch = 0;
  PatchEdge edge;
  auto operator<=>(const EdgeOfPatch&) const = default;
};

std::array<int, 2> across(const PatchEdge& edge) {
  return {edge.along == 0 ? 1 : 0, edge.along == 2 ? 1 : 2};
}

std::array<PatchFace, 2> faces_at(const EdgeOfPatch& of) {
  const auto [a, b] = across(of.edge);
  return {PatchFace{PatchId(of.patch), geometry::side_of(a, of.edge.high[0])},
          PatchFace{PatchId(of.patch), geometry::side_of(b, of.edge.high[1])}};
}

// The angle between the two faces of a patch at a share of the way along one of its edges; none where the
// edge or a face is collapsed there.
double angle_at(const NurbsVolume& patch, const PatchEdge& edge, double share) {
  const auto [a, b] = across(edge);
  geometry::Parameter<3> parameter = patch.low();
  parameter[edge.along] += share * (patch.high() - patch.low())[edge.along];
  if (edge.high[0]) parameter[a] = patch.high()[a];
  if (edge.high[1]) parameter[b] = patch.high()[b];
  const Eigen::Matrix3d jacobian = patch.jacobian(parameter);
  const Eigen::Vector3d tangent = jacobian.col(edge.along).normalized();
  const auto inward = [&](int d, bool high) {
    const Eigen::Vector3d along = jacobian.col(d) * (high ? -1 : 1);
    return Eigen::Vector3d(along - along.dot(tangent) * tangent);
  };
  const Eigen::Vector3d first = inward(a, edge.high[0]), second = inward(b, edge.high[1]);
  const double angle = std::atan2(first.cross(second).norm(), first.dot(second));
  return std::isfinite(angle) ? angle : 0;
}

// The edges of patches that are one edge of the part: by the global nodes on them, and across faces that do
// not match by where they lie.
class PartEdges {
 public:
  explicit PartEdges(const ElasticityProblem& problem)
      : problem_(problem), global_(global_nodes(problem.discretization)) {
    const Discretization& d = problem.discretization;
    for (int p = 0; p < d.patch_count(); ++p)
      for (const PatchEdge& edge : geometry::all_edges()) members_[nodes_of({p, edge})].push_back({p, edge});
    boundary_.insert(d.model.boundary_faces().begin(), d.model.boundary_faces().end());
    for (const Support& support : problem.supports) {
      if (!support.region.is_everywhere()) continue;  // ends inside of faces
      const auto* given = std::get_if<PrescribedDisplacement>(&support.condition);
      if (given && std::all_of(given->value.begin(), given->value.end(),
                               [](const auto& component) { return component.has_value(); }))
        clamped_.insert(support.faces.begin(), support.faces.end());
      supported_.insert(support.faces.begin(), support.faces.end());
      for (const SupportedEdge& held : support.edges) lines_.insert({held.patch.value, held.edge});
    }
  }

  std::optional<std::string> why_singular(const EdgeOfPatch& of) const {
    const std::vector<int> nodes = nodes_of(of);
    if (std::all_of(nodes.begin(), nodes.end(), [&](int node) { return node == nodes.front(); }))
      return std::nullopt;
    Surroundings all;
    for (const double share : edge_samples) all = together(std::move(all), around(of, share));
    bool on_boundary = all.meets_others && all.angle < full_angle - angle_tolerance, clamped = false,
         open = false;
    const auto look_at = [&](const PatchFace& face) {
      clamped = clamped || clamped_.contains(face);
      open = open || !supported_.contains(face);
    };
    for (const EdgeOfPatch& edge : all.edges) {
      if (lines_.contains(edge)) return "a line that is held";
      for (const PatchFace& face : faces_at(edge)) {
        if (!boundary_.contains(face)) continue;
        on_boundary = on_boundary || !all.meets_others;
        look_at(face);
      }
    }
    for (const PatchFace& face : all.faces) look_at(face);
    if (!on_boundary) return std::nullopt;
    if (all.angle > straight_angle + angle_tolerance)
      return fmt::format("a re-entrant edge of {:.0f} degrees", all.angle.degrees());
    if (clamped && open && all.angle > harmless_if_clamped + angle_tolerance)
      return "the end of a clamped face";
    if (open && has_several_materials(all)) return "an edge where materials meet";
    return std::nullopt;
  }

 private:
  std::vector<int> nodes_of(const EdgeOfPatch& of) const {
    const Discretization& d = problem_.discretization;
    const auto p = static_cast<std::size_t>(of.patch);
    std::vector<int> nodes;
    for (const int i : geometry::edge_control_points(d.patches[p].sizes(), of.edge))
      nodes.push_back(global_.global_of[static_cast<std::size_t>(d.first_node[p] + i)]);
    if (nodes.back() < nodes.front()) std::reverse(nodes.begin(), nodes.end());
    return nodes;
  }
  bool is_turned(const EdgeOfPatch& of) const {
    const Discretization& d = problem_.discretization;
    const auto p = static_cast<std::size_t>(of.patch);
    const std::vector<int> line = geometry::edge_control_points(d.patches[p].sizes(), of.edge);
    const auto global = [&](int i) {
      return global_.global_of[static_cast<std::size_t>(d.first_node[p] + i)];
    };
    return global(line.back()) < global(line.front());
  }
  // What touches an edge: edges of patches, and faces of others in whose inside it lies.
  struct Surroundings {
    std::set<EdgeOfPatch> edges;
    std::set<PatchFace> faces;
    bool meets_others = false;        // at faces that do not match
    Angle angle = Angle::radians(0);  // of all material, the largest of those seen
  };
  static Surroundings together(Surroundings a, const Surroundings& b) {
    a.edges.insert(b.edges.begin(), b.edges.end());
    a.faces.insert(b.faces.begin(), b.faces.end());
    a.meets_others = a.meets_others || b.meets_others;
    a.angle = std::max(a.angle, b.angle);
    return a;
  }

  // @param share  of the way along the edge
  Surroundings around(const EdgeOfPatch& of, double share) const {
    Surroundings result;
    double sum = 0;
    std::vector<std::pair<EdgeOfPatch, double>> left = {{of, share}};
    while (!left.empty()) {
      const auto [edge, at] = left.back();
      left.pop_back();
      if (result.edges.contains(edge)) continue;
      const double along = is_turned(edge) ? 1 - at : at;
      for (const EdgeOfPatch& member : members_.at(nodes_of(edge))) {
        const double here = is_turned(member) ? 1 - along : along;
        result.edges.insert(member);
        sum += angle_at(patch(member.patch), member.edge, here);
        for (const PatchFace& face : faces_at(member))
          for (const PatchFace& other : beyond(face)) {
            result.meets_others = true;
            if (result.faces.contains(other)) continue;
            const std::optional<Place> place = place_on(other, point_of(member, here));
            if (!place) continue;
            if (place->edge) {
              left.emplace_back(*place->edge, place->share);
            } else {
              result.faces.insert(other);
              sum += straight_angle.radians();
            }
          }
      }
    }
    result.angle = Angle::radians(sum);
    return result;
  }

  // The faces on the other side of one that does not match them.
  std::vector<PatchFace> beyond(const PatchFace& face) const {
    std::vector<PatchFace> result;
    for (const geometry::NonMatchingInterface& pair : problem_.discretization.model.non_matching()) {
      if (pair.first == face) result.push_back(pair.second);
      if (pair.second == face) result.push_back(pair.first);
    }
    return result;
  }

  // A point on a face: on an edge of the patch, or else inside the face.
  struct Place {
    std::optional<EdgeOfPatch> edge;
    double share = 0;
  };
  // Nothing where the point is not on the face, or in a corner of it.
  std::optional<Place> place_on(const PatchFace& face, const Eigen::Vector3d& point) const {
    const geometry::MultiPatch& model = problem_.discretization.model;
    const double same = model.tolerance().same_point * model.size();
    const NurbsVolume& of = patch(face.patch.value);
    const geometry::NurbsSurface surface = geometry::face_surface(of, face.side);
    const geometry::SurfaceFoot foot = geometry::surface_foot(surface, point, 0.1 * same);
    if (foot.distance > same) return std::nullopt;
    const geometry::Parameter<3> at = geometry::on_side(of, face.side, foot.parameter);
    const auto tangents = geometry::tangents(face.side);
    std::optional<Place> result = Place{};
    for (std::size_t d = 0; d < 2; ++d) {
      const double low = surface.low()[static_cast<Eigen::Index>(d)],
                   high = surface.high()[static_cast<Eigen::Index>(d)];
      const double here = (foot.parameter[static_cast<Eigen::Index>(d)] - low) / (high - low);
      if (std::min(here, 1 - here) > 1e-6) continue;
      if (result->edge) return std::nullopt;
      const int along = tangents[1 - d], across_face = tangents[d], normal = geometry::direction(face.side);
      PatchEdge edge{along, {}};
      const bool of_face = here > 0.5, of_side = geometry::is_high(face.side);
      edge.high = across_face < normal ? std::array{of_face, of_side} : std::array{of_side, of_face};
      result->edge = EdgeOfPatch{face.patch.value, edge};
      result->share = (at[along] - of.low()[along]) / (of.high() - of.low())[along];
    }
    return result;
  }

  Eigen::Vector3d point_of(const EdgeOfPatch& of, double share) const {
    const NurbsVolume& volume = patch(of.patch);
    const auto [a, b] = across(of.edge);
    geometry::Parameter<3> at = volume.low();
    at[of.edge.along] += share * (volume.high() - volume.low())[of.edge.along];
    if (of.edge.high[0]) at[a] = volume.high()[a];
    if (of.edge.high[1]) at[b] = volume.high()[b];
    return volume.point(at);
  }

  bool has_several_materials(const Surroundings& all) const {
    const auto material = [&](int p) -> const Material& {
      return problem_.materials[static_cast<std::size_t>(p)];
    };
    const Material& first = material(all.edges.begin()->patch);
    const auto differs = [&](int p) {
      return material(p).lambda != first.lambda || material(p).mu != first.mu;
    };
    return std::any_of(all.edges.begin(), all.edges.end(),
                       [&](const EdgeOfPatch& edge) { return differs(edge.patch); }) ||
           std::any_of(all.faces.begin(), all.faces.end(),
                       [&](const PatchFace& face) { return differs(face.patch.value); });
  }

  const NurbsVolume& patch(int p) const {
    return problem_.discretization.patches[static_cast<std::size_t>(p)];
  }

  const ElasticityProblem& problem_;
  GlobalNodes global_;
  std::map<std::vector<int>, std::vector<EdgeOfPatch>> members_;
  std::set<PatchFace> boundary_, clamped_, supported_;
  std::set<EdgeOfPatch> lines_;
};

// Whether a parameter lies within a quarter of an element of an end of a direction.
bool is_near_end(const geometry::KnotVector& knots, double parameter, bool high) {
  const std::vector<double> breaks = knots.breaks();
  const std::size_t last = breaks.size() - 1;
  const double element = high ? breaks[last] - breaks[last - 1] : breaks[1] - breaks[0];
  return (high ? breaks[last] - parameter : parameter - breaks[0]) <= 0.25 * element;
}

}  // namespace

std::vector<std::optional<std::string>> singular_places(const ElasticityProblem& problem,
                                                        const std::vector<PatchPlace>& places) {
  std::vector<std::optional<std::string>> result;
  if (places.empty()) return result;
  const PartEdges edges(problem);
  for (const PatchPlace& place : places) {
    const NurbsVolume& patch = problem.discretization.patches[static_cast<std::size_t>(place.patch)];
    result.emplace_back();
    for (const PatchEdge& edge : geometry::all_edges()) {
      const auto [a, b] = across(edge);
      const bool near = is_near_end(patch.knots(a), place.parameter[a], edge.high[0]) &&
                        is_near_end(patch.knots(b), place.parameter[b], edge.high[1]);
      if (!near || result.back()) continue;
      result.back() = edges.why_singular({place.patch, edge});
    }
    if (!result.back()) result.back() = why_held_singular(problem, place);
  }
  return result;
}

}  // namespace isopatch::iga
