#include "segmentation/profiles/internal/best_mesh.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>

#include "geometry/base/error.hpp"
#include "segmentation/profiles/division_error.hpp"
#include "segmentation/profiles/internal/midpoint_division.hpp"
#include "segmentation/profiles/internal/ring.hpp"
#include "segmentation/profiles/internal/shared_cuts.hpp"
#include "segmentation/profiles/internal/strips.hpp"

namespace isopatch::segmentation::planar {

namespace {

CellMesh last_resort(const SearchInput& input, const CellMesh& mesh) {
  CellMesh result = midpoint_division(input.curves, mesh);
  for (const Cell& cell : result.cells) {
    std::array<SideShape, 4> shapes;
    for (std::size_t k = 0; k < 4; ++k) shapes[k] = side_shape(input.curves, result.nodes, cell.sides[k]);
    if (least_jacobian({&shapes[0], &shapes[1], &shapes[2], &shapes[3]}) <= 0)
      throw DivisionError(cell.region, shapes[0].points.front());
  }
  return result;
}

/// The regions' divisions as one mesh; cuts of shared edges are equal where regions meet.
CellMesh joined(const Profile& profile, const std::vector<bool>& shared,
                const std::vector<const CellMesh*>& parts) {
  CellMesh result;
  for (const Eigen::Vector2d& vertex : profile.vertices) result.nodes.push_back({vertex, true, -1, 0});
  std::map<std::pair<int, double>, int> cuts;
  for (const CellMesh* part : parts) {
    std::vector<int> numbers(part->nodes.size(), -1);
    const auto number = [&](int node) {
      const Node& there = part->nodes[node];
      if (there.given) return node;
      if (numbers[node] >= 0) return numbers[node];
      const int next = static_cast<int>(result.nodes.size());
      numbers[node] = there.is_cut() && shared[there.curve]
                          ? cuts.try_emplace({there.curve, there.at}, next).first->second
                          : next;
      if (numbers[node] == next) result.nodes.push_back(there);
      return numbers[node];
    };
    for (Cell cell : part->cells) {
      for (int k = 0; k < cell.count; ++k) {
        cell.sides[k].from = number(cell.sides[k].from);
        cell.sides[k].to = number(cell.sides[k].to);
      }
      result.cells.push_back(cell);
    }
  }
  return result;
}

/// Divides regions one by one, for given cuts of the edges that they share.
class RegionSearches {
 public:
  RegionSearches(const SearchInput& input, const Profile& profile, const QuadrangulationOptions& options,
                 int searches)
      : input_(input), profile_(profile), options_(options), searches_(searches) {}

  struct Whole {
    CellMesh mesh;
    double cost = 0;
    std::vector<int> open;  ///< regions for which no division within the rules has been found
  };

  /// Each region as it is, with no more cuts of shared edges; nothing for those with holes or many corners.
  Whole divide_as_they_are(const CutPlaces& shared_cuts) {
    std::vector<const CellMesh*> parts;
    Whole result;
    for (std::size_t r = 0; r < profile_.regions.size(); ++r) {
      if (!profile_.regions[r].wanted) continue;
      const Found& found = as_it_is(static_cast<int>(r), shared_cuts);
      result.cost += found.cost;
      if (!found.valid) result.open.push_back(static_cast<int>(r));
      parts.push_back(&found.mesh);
    }
    if (result.open.empty()) result.mesh = joined(profile_, input_.shared, parts);
    return result;
  }

  Whole divide(const CutPlaces& shared_cuts) {
    const CutPlaces places = places_to_start(shared_cuts);
    const CellMesh start = triangles_of(profile_, input_.curves, places);
    std::vector<const CellMesh*> parts;
    Whole result;
    for (std::size_t r = 0; r < profile_.regions.size(); ++r) {
      if (!profile_.regions[r].wanted) continue;
      const Found& found = best_of(static_cast<int>(r), start, places);
      result.cost += found.cost;
      if (!found.valid) result.open.push_back(static_cast<int>(r));
      parts.push_back(&found.mesh);
    }
    result.mesh = joined(profile_, input_.shared, parts);
    return result;
  }

 private:
  struct Found {
    CellMesh mesh;
    double cost = 0;
    bool valid = false;
  };

  /// Cuts of all edges; of shared ones more than given where outlines would meet as polygons, even in number
  /// for each region.
  CutPlaces places_to_start(CutPlaces shared_cuts) const {
    const auto all = [&](const CutPlaces& cuts) {
      return even_places(input_.curves, input_.shared, cuts, std::numbers::pi / 12);
    };
    CutPlaces result = all(shared_cuts);
    bool more = false;
    for (std::size_t e = 0; e < result.size(); ++e) {
      if (!input_.shared[e] || result[e] == shared_cuts[e]) continue;
      shared_cuts[e] = result[e];
      more = true;
    }
    return more ? all(made_even(profile_, input_.curves, std::move(shared_cuts))) : result;
  }

  /// A region, and the cuts of the edges that it shares.
  using Key = std::pair<int, CutPlaces>;

  Key key(int region, const CutPlaces& places) const {
    CutPlaces cuts;
    for (const auto& loop : profile_.regions[static_cast<std::size_t>(region)].loops)
      for (const geometry::EdgeUse& use : loop)
        cuts.push_back(input_.shared[use.edge.value] ? places[use.edge.value] : std::vector<double>{});
    return {region, std::move(cuts)};
  }

  const Found& best_of(int region, const CellMesh& start, const CutPlaces& places) {
    const auto [entry, is_new] = found_.try_emplace(key(region, places));
    if (is_new) entry->second = search(region, start, as_it_is(region, places));
    return entry->second;
  }

  const Found& as_it_is(int region, const CutPlaces& shared_cuts) {
    const auto [entry, is_new] = as_they_are_.try_emplace(key(region, shared_cuts));
    if (!is_new) return entry->second;
    const auto outline = outline_of_region(profile_, input_.curves, shared_cuts, region);
    if (!outline) return entry->second;
    Search search(input_, {outline->nodes, {}}, options_.seed);
    if (!search.fill(outline->places, region)) return entry->second;
    if (search.mesh().cells.size() > 1) search.improve(windows(search));
    return entry->second = {search.mesh(), search.cost(), search.is_valid()};
  }

  /// How many windows are tried.
  int windows(const Search& search) const {
    return static_cast<int>(options_.effort * (search.mesh().cells.size() + 5) / 40);
  }

  /// @param as_it_is  one that is known, if valid
  Found search(int region, const CellMesh& start, const Found& as_it_is) const {
    if (as_it_is.valid && as_it_is.mesh.cells.size() == 1) return as_it_is;
    CellMesh part{start.nodes, {}};
    for (const Cell& cell : start.cells)
      if (cell.region == region) part.cells.push_back(cell);
    const std::optional<CellMesh> ring = ring_start(input_.curves, part, input_.shared);
    std::optional<Search> best;
    const auto consider = [&](unsigned seed, int patience) {
      const bool in_ring = ring && seed % 2 == 0;
      Search next(input_, in_ring ? *ring : part, options_.seed + seed);
      if (in_ring) next.polish();
      next.remove_triangles(patience);
      next.improve(windows(next));
      if (!best || next.cost() < best->cost()) best = std::move(next);
    };
    for (int s = 0; s < searches_; ++s) {
      const std::size_t cells = best ? best->mesh().cells.size() : 0;
      if (s > 0 && best->is_valid() && (cells == 1 || static_cast<std::size_t>(s) * cells > 150))
        break;  // large drawings have no time for more
      consider(static_cast<unsigned>(s), 60);
    }
    if (std::optional<Search> rings = best_ring(part); rings && rings->cost() < best->cost())
      best = std::move(rings);
    for (unsigned again = 0; again < 3 && !best->is_valid() && !as_it_is.valid; ++again)
      consider(10 + again, 150);
    if (as_it_is.valid && as_it_is.cost <= best->cost()) return as_it_is;
    return {best->mesh(), best->cost(), best->is_valid()};
  }

  /// Of rings around quadrilaterals the best that is valid.
  std::optional<Search> best_ring(const CellMesh& part) const {
    std::optional<Search> best;
    for (CellMesh& ring : rings_around_quads(input_.curves, part, input_.shared)) {
      Search next(input_, std::move(ring), options_.seed);
      next.polish();
      if (next.is_valid() && (!best || next.cost() < best->cost())) best = std::move(next);
    }
    if (best) best->improve(windows(*best));
    return best;
  }

  const SearchInput& input_;
  const Profile& profile_;
  const QuadrangulationOptions& options_;
  int searches_;
  std::map<Key, Found> found_, as_they_are_;
};

/// Those of the first that are in the second too, all of the first if none is.
std::vector<int> open_in_both(const std::vector<int>& first, const std::vector<int>& second) {
  std::vector<int> result;
  std::set_intersection(first.begin(), first.end(), second.begin(), second.end(), std::back_inserter(result));
  return result.empty() ? first : result;
}

/// Whether further cuts have opened many more regions than they closed: the next would open more still.
bool spreads(std::size_t open, std::size_t least) {
  constexpr std::size_t some = 4;
  return open >= std::max(2 * least, least + some);
}

/// Closes what single regions left open, if that goes with shared cuts elsewhere.
void mend(RegionSearches::Whole& whole, const SearchInput& input, const QuadrangulationOptions& options) {
  Search search(input, whole.mesh, options.seed, true);
  search.polish();
  search.remove_triangles(60);
  search.improve(static_cast<int>(options.effort * (search.mesh().cells.size() + 5) / 80));
  search.polish();
  if (search.is_valid()) whole = {search.mesh(), search.cost(), {}};
}

/// The wanted region with most cuts of the edges that it shares around its holes, circles but for; none where
/// there are no such cuts.
std::optional<int> surrounding_region(const SearchInput& input, const Profile& profile,
                                      const CutPlaces& places) {
  std::optional<int> result;
  std::size_t most = 0;
  for (std::size_t r = 0; r < profile.regions.size(); ++r) {
    const ProfileRegion& region = profile.regions[r];
    if (!region.wanted) continue;
    std::size_t count = 0;
    for (std::size_t l = 1; l < region.loops.size(); ++l)
      for (const geometry::EdgeUse& use : region.loops[l]) {
        const auto e = static_cast<std::size_t>(use.edge.value);
        if (input.shared[e] && !input.curves[e].closed()) count += places[e].size();
      }
    if (count <= most) continue;
    most = count;
    result = static_cast<int>(r);
  }
  return result;
}

/// Cuts of shared edges as one region would have them that need not agree with the others; nothing where it
/// cannot be divided.
std::optional<CutPlaces> places_of_one(const SearchInput& input, Profile profile,
                                       const QuadrangulationOptions& options, int region) {
  SearchInput alone = input;
  alone.shared.assign(input.shared.size(), false);
  for (std::size_t r = 0; r < profile.regions.size(); ++r)
    profile.regions[r].wanted = static_cast<int>(r) == region;
  const RegionSearches::Whole whole =
      RegionSearches(alone, profile, options, 4).divide(CutPlaces(input.curves.size()));
  if (!whole.open.empty()) return std::nullopt;
  CutPlaces result(input.curves.size());
  std::set<int> used;
  for (const Cell& cell : whole.mesh.cells)
    for (int k = 0; k < cell.count; ++k) used.insert(cell.sides[k].from);
  for (const int number : used) {
    const Node& node = whole.mesh.nodes[static_cast<std::size_t>(number)];
    if (node.is_cut() && input.shared[static_cast<std::size_t>(node.curve)])
      result[static_cast<std::size_t>(node.curve)].push_back(node.at);
  }
  for (std::vector<double>& places : result) std::sort(places.begin(), places.end());
  return result;
}

bool any_is_shared(const SearchInput& input) {
  return std::any_of(input.shared.begin(), input.shared.end(), [](bool shared) { return shared; });
}

}  // namespace

DraftedMesh drafted_mesh(const SearchInput& input, const Profile& profile,
                         const QuadrangulationOptions& options) {
  const bool any_shared = any_is_shared(input);
  RegionSearches searches(input, profile, options, any_shared ? 3 : 4);
  std::optional<RegionSearches::Whole> best;
  const auto consider = [&](CutPlaces places) {
    for (int round = 0; round < 10; ++round) {
      RegionSearches::Whole whole = searches.divide(places);
      RegionSearches::Whole as_they_are = options.thorough ? searches.divide_as_they_are(places) : whole;
      if (options.thorough && any_shared && !whole.open.empty()) mend(whole, input, options);
      const bool done = as_they_are.open.empty() || whole.open.empty() || !any_shared ||
                        (best && spreads(whole.open.size(), best->open.size()));
      if (!done)
        places = further_places(profile, input.curves, places, open_in_both(whole.open, as_they_are.open));
      const auto rank = [](const RegionSearches::Whole& w) { return std::pair(w.open.size(), w.cost); };
      if (as_they_are.open.empty() && rank(as_they_are) < rank(whole)) whole = std::move(as_they_are);
      if (!best || rank(whole) < rank(*best)) best = std::move(whole);
      if (done) break;
    }
  };
  const CutPlaces places = shared_places(profile, input.curves, {}),
                  diagonal = shared_places(profile, input.curves, {true});
  consider(places);
  if (diagonal != places) consider(diagonal);
  const std::optional<int> around =
      options.thorough ? surrounding_region(input, profile, places) : std::nullopt;
  if (around)
    if (std::optional<CutPlaces> own = places_of_one(input, profile, options, *around))
      consider(made_even(profile, input.curves, *std::move(own)));
  Search last(input, std::move(best->mesh), options.seed, true);
  last.polish();
  if (any_shared) {
    last.improve(static_cast<int>(options.effort * (last.mesh().cells.size() + 5) / 80));
    last.polish();
  }
  return {last.mesh(), last.cost(), last.is_valid()};
}

CellMesh finished_mesh(const SearchInput& input, const DraftedMesh& draft,
                       const QuadrangulationOptions& options) {
  if (!draft.is_valid) return last_resort(input, draft.mesh);
  // The search of a single region sees its strips itself.
  if (!any_is_shared(input) || !options.thorough) return draft.mesh;
  const int windows = static_cast<int>(options.effort * (draft.mesh.cells.size() + 5) / 40);
  return with_fewer_strips(input, draft.mesh, windows);
}

}  // namespace isopatch::segmentation::planar
