#include "app/problem/edge_selection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "app/base/engineering_units.hpp"
#include "app/base/place_tolerance.hpp"

namespace isopatch::app {
namespace {

using geometry::MultiPatch;
using geometry::PatchEdge;
using geometry::PatchFace;
using geometry::Side;

// The two sides of a patch that meet in an edge.
std::array<Side, 2> sides(const PatchEdge& edge) {
  const auto [first, second] = geometry::tangents(geometry::side_of(edge.along, false));
  return {geometry::side_of(first, edge.high[0]), geometry::side_of(second, edge.high[1])};
}

// How far the farthest of 17 points of an edge is from fulfilling the conditions, m.
double farthest(const MultiPatch& model, const iga::SupportedEdge& held, const FaceConditions& conditions) {
  constexpr int samples = 17;
  const geometry::NurbsVolume& patch = model.patch(held.patch);
  geometry::Parameter<3> parameter = patch.low();
  for (const Side side : sides(held.edge)) {
    const int d = geometry::direction(side);
    if (geometry::is_high(side)) parameter[d] = patch.high()[d];
  }
  const int along = held.edge.along;
  double result = 0;
  for (int i = 0; i < samples; ++i) {
    const double share = i / (samples - 1.0);
    parameter[along] = (1 - share) * patch.low()[along] + share * patch.high()[along];
    result = std::max(result, distance(conditions, patch.point(parameter)));
  }
  return result;
}

std::vector<iga::SupportedEdge> edges_of(const std::vector<PatchFace>& faces) {
  std::vector<iga::SupportedEdge> result;
  for (const PatchFace& face : faces)
    for (const PatchEdge& edge : geometry::all_edges()) {
      const auto meeting = sides(edge);
      if (std::find(meeting.begin(), meeting.end(), face.side) != meeting.end())
        result.push_back({face.patch, edge});
    }
  std::sort(result.begin(), result.end());
  result.erase(std::unique(result.begin(), result.end()), result.end());
  return result;
}

}  // namespace

std::vector<iga::SupportedEdge> select_edges(const MultiPatch& model, const std::vector<PatchFace>& faces,
                                             const FaceConditions& conditions, const Place& place) {
  const double tolerance = conditions.tolerance.value_or(place_tolerance * model.size());
  std::vector<std::pair<double, iga::SupportedEdge>> candidates;
  std::vector<iga::SupportedEdge> result;
  for (const iga::SupportedEdge& held : edges_of(faces)) {
    candidates.emplace_back(farthest(model, held, conditions), held);
    if (candidates.back().first <= tolerance) result.push_back(held);
  }
  if (!result.empty()) return result;
  std::sort(candidates.begin(), candidates.end());
  std::string nearest;
  for (std::size_t i = 0; i < std::min<std::size_t>(3, candidates.size()); ++i)
    nearest += fmt::format("{}{} (up to {} away)", i ? ", " : "", label(model, candidates[i].second),
                           with_unit(candidates[i].first, "m"));
  throw error_at(
      place,
      fmt::format("edges: no edge of the support's faces lies there. Nearest: {}; the tolerance is {}. "
                  "Only edges of patches can be held; patches may have to be cut there",
                  nearest, with_unit(tolerance, "m")));
}

std::string label(const MultiPatch& model, const iga::SupportedEdge& held) {
  const auto meeting = sides(held.edge);
  return model.label({held.patch, meeting[0]}) + "+" +
         std::string(name(model.to_input({held.patch, meeting[1]}).side));
}

}  // namespace isopatch::app
