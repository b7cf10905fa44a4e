#include "iga/estimate/singular_places.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <numbers>
#include <set>

#include "geometry/base/angle.hpp"
#include "iga/coupling/global_nodes.hpp"
#include "iga/estimate/internal/held_places.hpp"

namespace isopatch::iga {
namespace {

using geometry::NurbsVolume;
using geometry::PatchEdge;
using geometry::PatchFace;

constexpr Angle straight_angle = Angle::degrees(180);
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

// The edges of patches that are one edge of the part, by the global nodes on them.
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
    const std::vector<EdgeOfPatch>& members = members_.at(nodes_of(of));
    bool on_boundary = false, clamped = false, open = false;
    for (const EdgeOfPatch& member : members) {
      if (lines_.contains(member)) return "a line that is held";
      for (const PatchFace& face : faces_at(member)) {
        if (!boundary_.contains(face)) continue;
        on_boundary = true;
        clamped = clamped || clamped_.contains(face);
        open = open || !supported_.contains(face);
      }
    }
    const std::vector<int> nodes = nodes_of(of);
    if (!on_boundary ||
        std::all_of(nodes.begin(), nodes.end(), [&](int node) { return node == nodes.front(); }))
      return std::nullopt;
    const Angle angle = largest_angle(members);
    if (angle > straight_angle + angle_tolerance)
      return fmt::format("a re-entrant edge of {:.0f} degrees", angle.degrees());
    if (clamped && open && angle > harmless_if_clamped + angle_tolerance) return "the end of a clamped face";
    if (!open) return std::nullopt;
    const auto& materials = problem_.materials;
    const Material& first = materials[static_cast<std::size_t>(members.front().patch)];
    for (const EdgeOfPatch& member : members) {
      const Material& other = materials[static_cast<std::size_t>(member.patch)];
      if (other.lambda != first.lambda || other.mu != first.mu) return "an edge where materials meet";
    }
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
  Angle largest_angle(const std::vector<EdgeOfPatch>& members) const {
    double largest = 0;
    for (const double share : edge_samples) {
      double sum = 0;
      for (const EdgeOfPatch& member : members)
        sum += angle_at(problem_.discretization.patches[static_cast<std::size_t>(member.patch)], member.edge,
                        is_turned(member) ? 1 - share : share);
      largest = std::max(largest, sum);
    }
    return Angle::radians(largest);
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
