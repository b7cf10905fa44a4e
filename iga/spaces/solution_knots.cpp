#include "iga/spaces/solution_knots.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "geometry/base/error.hpp"
#include "geometry/splines/refine.hpp"
#include "geometry/splines/transfer.hpp"

namespace isopatch::iga {
namespace {

using geometry::KnotVector;
using geometry::NurbsVolume;

// Every span cut into `parts` equal ones, all inner knots with at least the given multiplicity.
KnotVector subdivided(const KnotVector& knots, int parts, int least_multiplicity) {
  const std::vector<double> breaks = knots.breaks();
  const std::vector<int> multiplicities = knots.multiplicities();
  std::vector<double> inserted;
  for (std::size_t e = 0; e + 1 < breaks.size(); ++e) {
    if (e > 0)
      inserted.insert(inserted.end(),
                      static_cast<std::size_t>(std::max(0, least_multiplicity - multiplicities[e])),
                      breaks[e]);
    for (int k = 1; k < parts; ++k)
      inserted.insert(inserted.end(), static_cast<std::size_t>(std::max(1, least_multiplicity)),
                      breaks[e] + (breaks[e + 1] - breaks[e]) * k / parts);
  }
  return geometry::with_knots(knots, inserted);
}

// Bound of the length of any element along a direction if it is cut into equal parts: degree times the
// longest leg of the control polygon of its Bezier form bounds the speed (up to the weights' ratio for
// rational patches).
double longest_element(const NurbsVolume& patch, int direction) {
  auto knots = patch.knots();
  knots[static_cast<std::size_t>(direction)] = geometry::bezier_knots(patch.knots(direction));
  const NurbsVolume split = geometry::refined(patch, knots);
  const int p = split.degree(direction);
  int stride = 1;
  for (int d = 0; d < direction; ++d) stride *= split.size(d);
  double longest = 0;
  for (int i = 0; i < split.size(); ++i) {
    const int along = (i / stride) % split.size(direction);
    if (along + 1 >= split.size(direction)) continue;
    longest = std::max(longest,
                       p * (split.control_points().col(i + stride) - split.control_points().col(i)).norm());
  }
  return longest;
}

// Parts per span, equal for all directions that interfaces tie together.
std::vector<int> parts_per_span(const geometry::MultiPatch& model, const DirectionKnots& knots,
                                const DiscretizationOptions& options) {
  std::vector<int> parts(knots.size(), 1);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::size_t d = i % 3;
    const int elements = knots[i].element_count();
    parts[i] = std::max(parts[i], (options.elements_per_direction[d] + elements - 1) / elements);
    if (options.max_size > 0) {
      const double longest = longest_element(model.patches()[i / 3], static_cast<int>(d));
      parts[i] =
          std::max(parts[i], static_cast<int>(std::min(1e4, std::ceil(longest / options.max_size - 1e-9))));
    }
  }
  const std::vector<int> groups = tied_directions(model);
  std::vector<int> most(parts.size(), 1);
  for (std::size_t i = 0; i < parts.size(); ++i) {
    int& of_group = most[static_cast<std::size_t>(groups[i])];
    of_group = std::max(of_group, parts[i]);
  }
  for (std::size_t i = 0; i < parts.size(); ++i)
    parts[i] = most[static_cast<std::size_t>(groups[i])] << options.refine;
  return parts;
}

void insert_places(const std::vector<KnotPlace>& places, const std::vector<int>& multiplicities,
                   double same_knot, DirectionKnots& knots) {
  for (const KnotPlace& place : places) {
    const auto i = static_cast<std::size_t>(3 * place.patch + place.direction);
    if (place.patch < 0 || place.direction < 0 || place.direction > 2 || i >= knots.size())
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("a knot in direction {} of patch {}, of {} patches", place.direction,
                              place.patch, knots.size() / 3));
    KnotVector& along = knots[i];
    const std::vector<double> breaks = along.breaks();
    const bool is_there = std::any_of(breaks.begin(), breaks.end(), [&](double other) {
      return std::abs(other - place.parameter) <= same_knot * along.length();
    });
    if (is_there) continue;
    along = geometry::with_knots(
        along, std::vector<double>(static_cast<std::size_t>(multiplicities[i]), place.parameter));
  }
}

}  // namespace

DirectionKnots solution_knots(const geometry::MultiPatch& model, const DiscretizationOptions& options) {
  validate(options);
  DirectionKnots knots;
  for (const NurbsVolume& patch : model.patches())
    for (int d = 0; d < 3; ++d)
      knots.push_back(geometry::with_degree_raised(
          patch.knots(d), std::max(0, options.degree[static_cast<std::size_t>(d)] - patch.degree(d))));
  knots = matched(model, std::move(knots));
  const std::vector<int> parts = parts_per_span(model, knots, options);
  std::vector<int> multiplicities(knots.size());
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const int smoothness =
        options.continuity < 0 ? knots[i].degree() - 1 : std::min(options.continuity, knots[i].degree() - 1);
    multiplicities[i] = knots[i].degree() - smoothness;
    knots[i] = subdivided(knots[i], parts[i], multiplicities[i]);
  }
  if (options.knots.empty()) return knots;
  insert_places(options.knots, multiplicities, model.tolerance().same_knot, knots);
  return matched(model, std::move(knots));
}

}  // namespace isopatch::iga
