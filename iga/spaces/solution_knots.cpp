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

// What a direction of a patch is asked for.
struct Wanted {
  int degree = 0;
  int elements = 0;
  double max_size = 0;  // 0: no limit
  int refine = 0;
};

Wanted wanted_of(const DiscretizationOptions& options, std::size_t direction) {
  return {options.degree[direction], options.elements_per_direction[direction], options.max_size,
          options.refine};
}

// What a patch of its own is asked for beyond all others.
Wanted more(Wanted wanted, const PatchRefinement& own, std::size_t direction) {
  wanted.degree = std::max(wanted.degree, own.degree[direction]);
  wanted.elements = std::max(wanted.elements, own.elements_per_direction[direction]);
  if (own.max_size > 0)
    wanted.max_size = wanted.max_size > 0 ? std::min(wanted.max_size, own.max_size) : own.max_size;
  wanted.refine += own.refine;
  return wanted;
}

// Of each direction: 3 * patch + direction.
std::vector<Wanted> all_wanted(const DiscretizationOptions& options, std::size_t patches) {
  std::vector<Wanted> result;
  for (std::size_t i = 0; i < 3 * patches; ++i) result.push_back(wanted_of(options, i % 3));
  for (const PatchRefinement& own : options.patches)
    for (const int patch : own.patches) {
      if (patch < 0 || static_cast<std::size_t>(patch) >= patches)
        throw Error(ErrorCode::invalid_argument,
                    fmt::format("patch {} is to be refined, of {} patches", patch, patches));
      for (std::size_t d = 0; d < 3; ++d) {
        Wanted& of = result[3 * static_cast<std::size_t>(patch) + d];
        of = more(of, own, d);
      }
    }
  return result;
}

// A direction as it is to be divided.
struct Division {
  int degree = 0;
  int parts = 1;  // of each span
};

Division division(const geometry::MultiPatch& model, const KnotVector& knots, std::size_t index,
                  const Wanted& wanted) {
  const int elements = knots.element_count();
  Division result{std::max(knots.degree(), wanted.degree),
                  std::max(1, (wanted.elements + elements - 1) / elements)};
  if (wanted.max_size > 0) {
    const double longest = longest_element(model.patches()[index / 3], static_cast<int>(index % 3));
    result.parts =
        std::max(result.parts, static_cast<int>(std::min(1e4, std::ceil(longest / wanted.max_size - 1e-9))));
  }
  return result;
}

// The most that any of the directions which interfaces tie together has.
void spread(const std::vector<int>& groups, std::vector<Division>& divisions) {
  std::vector<Division> most(divisions.size());
  for (std::size_t i = 0; i < divisions.size(); ++i) {
    Division& of_group = most[static_cast<std::size_t>(groups[i])];
    of_group.degree = std::max(of_group.degree, divisions[i].degree);
    of_group.parts = std::max(of_group.parts, divisions[i].parts);
  }
  for (std::size_t i = 0; i < divisions.size(); ++i) divisions[i] = most[static_cast<std::size_t>(groups[i])];
}

// What all patches are asked for is the same for directions that interfaces tie together; what some are asked
// for is so if it is to spread.
std::vector<Division> divisions_of(const geometry::MultiPatch& model, const DirectionKnots& knots,
                                   const DiscretizationOptions& options) {
  const std::vector<int> groups = tied_directions(model);
  std::vector<Division> result;
  for (std::size_t i = 0; i < knots.size(); ++i)
    result.push_back(division(model, knots[i], i, wanted_of(options, i % 3)));
  spread(groups, result);
  if (options.patches.empty()) {
    for (Division& one : result) one.parts <<= options.refine;
    return result;
  }
  const std::vector<Wanted> wanted = all_wanted(options, knots.size() / 3);
  for (std::size_t i = 0; i < knots.size(); ++i) {
    const Division own = division(model, knots[i], i, wanted[i]);
    result[i].degree = std::max(result[i].degree, own.degree);
    result[i].parts = std::max(result[i].parts << options.refine, own.parts << wanted[i].refine);
  }
  if (options.spread) spread(groups, result);
  return result;
}

// Whether two knot vectors are one, scaled and perhaps turned around.
bool is_same(const KnotVector& first, const KnotVector& second, bool flipped, double same_knot) {
  if (first.degree() != second.degree() || first.size() != second.size()) return false;
  const KnotVector scaled =
      geometry::rescaled(flipped ? geometry::reversed(second) : second, first.first(), first.last());
  return std::equal(first.knots().begin(), first.knots().end(), scaled.knots().begin(),
                    [&](double a, double b) { return std::abs(a - b) <= same_knot * first.length(); });
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
    for (int d = 0; d < 3; ++d) knots.push_back(patch.knots(d));
  knots = matched(model, std::move(knots));
  const std::vector<Division> divisions = divisions_of(model, knots, options);
  std::vector<int> multiplicities(knots.size());
  for (std::size_t i = 0; i < knots.size(); ++i) {
    knots[i] = geometry::with_degree_raised(knots[i], divisions[i].degree - knots[i].degree());
    const int smoothness =
        options.continuity < 0 ? knots[i].degree() - 1 : std::min(options.continuity, knots[i].degree() - 1);
    multiplicities[i] = knots[i].degree() - smoothness;
    knots[i] = subdivided(knots[i], divisions[i].parts, multiplicities[i]);
  }
  if (options.knots.empty()) return knots;
  insert_places(options.knots, multiplicities, model.tolerance().same_knot, knots);
  return options.spread ? matched(model, std::move(knots)) : knots;
}

geometry::MultiPatch solution_model(const geometry::MultiPatch& model, const DirectionKnots& knots) {
  std::vector<bool> apart;
  for (const geometry::Interface& interface : model.interfaces()) {
    const auto pairs = tied_pairs(interface);
    apart.push_back(std::any_of(pairs.begin(), pairs.end(), [&](const TiedPair& pair) {
      return !is_same(knots[pair.first], knots[pair.second], pair.flipped, model.tolerance().same_knot);
    }));
  }
  return model.with_apart(apart);
}

}  // namespace isopatch::iga
