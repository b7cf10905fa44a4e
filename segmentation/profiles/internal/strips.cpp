#include "segmentation/profiles/internal/strips.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "geometry/base/union_find.hpp"
#include "segmentation/profiles/internal/relax.hpp"

namespace isopatch::segmentation::planar {

namespace {

/// Where a side is in a cell.
int place_of(const Cell& cell, const Side& side) {
  int k = 0;
  while (key_of(cell.sides[k]) != key_of(side)) ++k;
  return k;
}

/// Walks from a side of a cell over opposite sides; the rungs met, each as the cell walked into last has it
/// turned round, so that they all point one way.
struct Walk {
  std::vector<Side> rungs;
  std::vector<int> cells;
  bool closed = false;
};

Walk walk_from(const CellMesh& mesh, const Neighbours& neighbours, int cell, int side) {
  Walk result;
  const Side start = mesh.cells[cell].sides[side];
  result.rungs.push_back(start);
  for (Side rung = start; cell >= 0;) {
    result.cells.push_back(cell);
    rung = turned(mesh.cells[cell].sides[(place_of(mesh.cells[cell], rung) + 2) % 4]);
    if (key_of(rung) == key_of(start)) {
      result.closed = true;
      return result;
    }
    result.rungs.push_back(rung);
    cell = neighbours.across(turned(rung));
    if (result.cells.size() > 2 * mesh.cells.size()) return {};
  }
  return result;
}

/// What joins the ends of rungs.
class Joint {
 public:
  Joint(const std::vector<Curve>& curves, const CellMesh& mesh, const Strip& strip)
      : curves_(curves), mesh_(mesh), strip_(strip), sets_(static_cast<int>(mesh.nodes.size())) {}

  std::optional<CellMesh> make() {
    for (const Side& rung : strip_.rungs) sets_.unite(rung.from, rung.to);
    collect_gone();
    if (!place_nodes() || !replace_sides()) return std::nullopt;
    CellMesh result{nodes_, {}};
    std::set<SideKey> met;
    for (std::size_t c = 0; c < mesh_.cells.size(); ++c) {
      if (gone_.contains(static_cast<int>(c))) continue;
      Cell cell = mesh_.cells[c];
      std::set<int> corners;
      for (int k = 0; k < 4; ++k) {
        cell.sides[k] = moved(cell.sides[k]);
        corners.insert(cell.sides[k].from);
        if (cell.sides[k].curve >= 0 && cell.sides[k].low >= cell.sides[k].high) return std::nullopt;
        if (!met.insert(key_of(cell.sides[k])).second) return std::nullopt;  // cells would lie on another
      }
      if (corners.size() < 4) return std::nullopt;
      result.cells.push_back(cell);
    }
    if (result.cells.empty()) return std::nullopt;
    return result;
  }

 private:
  void collect_gone() {
    std::set<SideKey> rungs;
    for (const Side& rung : strip_.rungs) {
      rungs.insert(key_of(rung));
      rungs.insert(key_across(rung));
    }
    for (std::size_t c = 0; c < mesh_.cells.size(); ++c)
      for (int k = 0; k < 2; ++k)
        if (rungs.contains(key_of(mesh_.cells[c].sides[k])) &&
            rungs.contains(key_of(mesh_.cells[c].sides[k + 2]))) {
          gone_.insert(static_cast<int>(c));
          long_sides_.emplace_back(mesh_.cells[c].sides[1 - k], mesh_.cells[c].sides[3 - k]);
        }
  }

  /// Nodes that are one go where the one is that may move least.
  bool place_nodes() {
    nodes_ = mesh_.nodes;
    std::map<int, std::vector<int>> sets;
    for (const Side& rung : strip_.rungs)
      for (const int node : {rung.from, rung.to}) sets[sets_.find(node)].push_back(node);
    for (auto& [root, members] : sets) {
      std::sort(members.begin(), members.end());
      members.erase(std::unique(members.begin(), members.end()), members.end());
      int given = -1;
      std::vector<int> cuts;
      Eigen::Vector2d sum = Eigen::Vector2d::Zero();
      for (const int node : members) {
        if (mesh_.nodes[node].given && std::exchange(given, node) >= 0) return false;
        if (mesh_.nodes[node].is_cut()) cuts.push_back(node);
        sum += mesh_.nodes[node].point / static_cast<double>(members.size());
      }
      Node at{sum, false, -1, 0};
      if (given >= 0) {
        at = mesh_.nodes[given];
        for (const int cut : cuts)
          if (!slides_to(cut, given)) return false;
      } else if (cuts.size() == 1) {
        at = mesh_.nodes[cuts.front()];
      } else if (cuts.size() == 2) {
        const Side* along = rung_between(cuts[0], cuts[1]);
        if (along == nullptr || along->curve < 0) return false;
        const double middle = (along->low + along->high) / 2;
        shift(along->curve, along->reversed ? along->to : along->from, middle - along->low);
        shift(along->curve, along->reversed ? along->from : along->to, middle - along->high);
        const Curve& curve = curves_[along->curve];
        at = {curve.at(middle), false, along->curve, curve.closed() ? middle - std::floor(middle) : middle};
      } else if (!cuts.empty()) {
        return false;
      }
      nodes_[root] = at;
    }
    return true;
  }

  /// A cut goes along its curve to where another node of the same rung is.
  bool slides_to(int cut, int other) {
    const Side* along = rung_between(cut, other);
    if (along == nullptr || along->curve < 0) return false;
    const bool at_low = (along->reversed ? along->to : along->from) == cut;
    shift(along->curve, cut, (at_low ? 1 : -1) * (along->high - along->low));
    return true;
  }

  const Side* rung_between(int a, int b) const {
    for (const Side& rung : strip_.rungs)
      if ((rung.from == a && rung.to == b) || (rung.from == b && rung.to == a)) return &rung;
    return nullptr;
  }

  void shift(int curve, int node, double by) { shifts_[{curve, node}] = by; }

  /// Both long sides of a quadrilateral that is gone become one: a piece of a curve, if one of them is.
  bool replace_sides() {
    for (const auto& [a, b] : long_sides_) {
      if (a.curve >= 0 && b.curve >= 0) return false;
      if (a.curve >= 0) chords_[ends_of(b)] = a;
      if (b.curve >= 0) chords_[ends_of(a)] = b;
    }
    return true;
  }
  std::pair<int, int> ends_of(const Side& side) {
    const std::pair<int, int> ends = std::minmax(sets_.find(side.from), sets_.find(side.to));
    return ends;
  }

  Side moved(Side side) {
    const int from = sets_.find(side.from), to = sets_.find(side.to);
    if (side.curve < 0) {
      const auto curved = chords_.find(ends_of(side));
      if (curved == chords_.end()) return {from, to};
      side = curved->second;
      if (sets_.find(side.from) != from) side = turned(side);
    }
    for (const bool at_start : {true, false}) {
      const auto by = shifts_.find({side.curve, at_start ? side.from : side.to});
      if (by != shifts_.end()) (at_start == side.reversed ? side.high : side.low) += by->second;
    }
    side.from = from;
    side.to = to;
    return side;
  }

  const std::vector<Curve>& curves_;
  const CellMesh& mesh_;
  const Strip& strip_;
  UnionFind sets_;
  std::set<int> gone_;
  std::vector<std::pair<Side, Side>> long_sides_;
  std::vector<Node> nodes_;
  std::map<std::pair<int, int>, double> shifts_;  // by curve and node: of the curve's parameter
  std::map<std::pair<int, int>, Side> chords_;    // which become pieces of curves
};

}  // namespace

std::vector<Strip> strips_of(const CellMesh& mesh) {
  const Neighbours neighbours(mesh);
  std::vector<Strip> result;
  std::set<std::pair<int, int>> seen;  // cell, direction
  for (int c = 0; c < static_cast<int>(mesh.cells.size()); ++c)
    for (int k = 0; k < 2; ++k) {
      if (seen.contains({c, k})) continue;
      // To one end first, then all the way back.
      Walk walk = walk_from(mesh, neighbours, c, k);
      if (walk.rungs.empty()) continue;
      if (!walk.closed) {
        const Side last = turned(walk.rungs.back());
        const int cell = walk.cells.back();
        walk = walk_from(mesh, neighbours, cell, place_of(mesh.cells[cell], last));
      }
      std::set<int> met;
      bool simple = true;
      for (std::size_t i = 0; i < walk.cells.size(); ++i) {
        const int cell = walk.cells[i];
        const Side& rung = walk.rungs[i];
        seen.insert({cell, place_of(mesh.cells[cell], rung) % 2});
        simple = met.insert(cell).second && simple;
      }
      if (simple) result.push_back({walk.rungs});
    }
  return result;
}

std::optional<CellMesh> without_strip(const std::vector<Curve>& curves, const CellMesh& mesh,
                                      const Strip& strip) {
  return Joint(curves, mesh, strip).make();
}

namespace {

/// With corners and Jacobians no worse than these.
ShapeRules bounded(ShapeRules rules, double degrees, double jacobian) {
  const double angle = degrees * std::numbers::pi / 180;
  rules.smallest = std::max(rules.smallest, angle);
  rules.largest = std::min(rules.largest, std::numbers::pi - angle);
  rules.smallest_jacobian = std::max(rules.smallest_jacobian, jacobian);
  rules.thinnest = std::max(rules.thinnest, 0.3);
  return rules;
}

/// Bounds that are worth a quadrilateral: what moves with inclined walls must stand there as well.
ShapeRules good_rules(const ShapeRules& rules) {
  return bounded(rules, 25, 0.25);
}

/// The least scaled Jacobian of all.
double poorest(const std::vector<Curve>& curves, const CellMesh& mesh) {
  double least = 1;
  for (const Cell& cell : mesh.cells) {
    std::array<SideShape, 4> shapes;
    for (std::size_t k = 0; k < 4; ++k) shapes[k] = side_shape(curves, mesh.nodes, cell.sides[k]);
    least = std::min(least, least_jacobian({&shapes[0], &shapes[1], &shapes[2], &shapes[3]}));
  }
  return least;
}

/// Their number, and more where some are poor.
double dearness(const SearchInput& input, const CellMesh& mesh) {
  const double least = poorest(input.curves, mesh);
  return static_cast<double>(mesh.cells.size()) / std::clamp(least, 0.01, input.rules.good_jacobian);
}

SearchInput with_rules(const SearchInput& input, const ShapeRules& rules) {
  return {rules, input.curves, input.shared, input.candidates, input.near_corners};
}

/// Good bounds, or as good as a mesh keeps them.
ShapeRules kept_rules(const ShapeRules& rules, const std::vector<Curve>& curves, const CellMesh& mesh) {
  constexpr double round_off = 1e-6;
  ShapeRules result = good_rules(rules);
  for (const Cell& cell : mesh.cells) {
    std::array<SideShape, 4> shapes;
    for (std::size_t k = 0; k < 4; ++k) shapes[k] = side_shape(curves, mesh.nodes, cell.sides[k]);
    const std::array<const SideShape*, 4> sides = {&shapes[0], &shapes[1], &shapes[2], &shapes[3]};
    result.smallest_jacobian = std::min(result.smallest_jacobian, least_jacobian(sides) - round_off);
    result.thinnest = std::min(result.thinnest, thinness(sides) - round_off);
    for (std::size_t k = 0; k < 4; ++k) {
      const double angle =
          angle_between(shapes[k].start_direction, shapes[(k + 3) % 4].end_direction + std::numbers::pi);
      result.smallest = std::min(result.smallest, angle - round_off);
      result.largest = std::max(result.largest, angle + round_off);
    }
  }
  return result;
}

/// Of a quadrilateral: smaller steps follow each other for long and take none away.
constexpr double least_gain = 0.01;

/// The cheapest of some meshes with one strip less, if it costs less than a mesh does.
std::optional<Search> one_strip_less(const SearchInput& input, const Search& now) {
  std::vector<std::pair<double, Search>> tried;
  for (const Strip& strip : strips_of(now.mesh())) {
    std::optional<CellMesh> mesh = without_strip(input.curves, now.mesh(), strip);
    if (!mesh) continue;
    Search next(input, std::move(*mesh), 0, true);
    next.settle(4);
    tried.emplace_back(next.cost(), std::move(next));
  }
  std::stable_sort(tried.begin(), tried.end(),
                   [](const auto& a, const auto& b) { return a.first < b.first; });
  constexpr std::size_t most = 6;  // are looked at closely
  std::optional<Search> best;
  for (std::size_t i = 0; i < std::min(most, tried.size()); ++i) {
    Search& next = tried[i].second;
    next.polish();
    next.improve(2 * static_cast<int>(next.mesh().cells.size()));
    next.polish();
    if (next.is_valid() && next.cost() < (best ? best->cost() : now.cost() - least_gain))
      best = std::move(next);
  }
  return best;
}

void take_strips_out(const SearchInput& input, Search& best, int windows) {
  for (bool again = true; again;) {
    while (std::optional<Search> next = one_strip_less(input, best)) best = std::move(*next);
    const double before = best.cost();
    best.improve(windows);
    best.polish();
    again = best.cost() < before - least_gain;
  }
}

/// Keeps tighter bounds, one after the other, as long as some quadrilaterals are poor: nodes move, windows
/// are divided anew, into more quadrilaterals if need be. Enters what comes of it.
void tighten(const SearchInput& given, CellMesh mesh, int windows, std::vector<CellMesh>& made) {
  struct Bounds {
    double degrees, jacobian;
  };
  constexpr Bounds steps[] = {{25, 0.25}, {30, 0.3}, {30, 0.4}};
  for (const Bounds& step : steps) {
    if (poorest(given.curves, mesh) >= given.rules.good_jacobian) return;
    const SearchInput input = with_rules(given, bounded(given.rules, step.degrees, step.jacobian));
    Search search(input, mesh, 0, true);
    search.polish();
    if (!search.is_valid()) {
      search.improve(windows);
      search.polish();
    }
    if (!search.is_valid()) return;
    mesh = search.mesh();
    made.push_back(mesh);
  }
}

}  // namespace

CellMesh with_fewer_strips(const SearchInput& given, CellMesh mesh, int windows) {
  const SearchInput good = with_rules(given, good_rules(given.rules));
  Search best(good, mesh, 0, true);
  if (best.triangles() > 0) return mesh;
  std::vector<CellMesh> made = {mesh};
  const auto enter = [&](const CellMesh& found) {
    made.push_back(found);
    tighten(given, found, windows, made);
  };
  if (!best.is_valid()) {
    best.polish();
    best.remove_triangles(60);
    best.improve(windows);
    best.polish();
  }
  if (best.is_valid()) take_strips_out(good, best, windows);
  if (best.is_valid()) enter(best.mesh());
  const bool enough = best.is_valid() && best.mesh().cells.size() <= mesh.cells.size() &&
                      given.rules.good_jacobian <= good.rules.smallest_jacobian;
  const SearchInput kept = with_rules(given, kept_rules(given.rules, given.curves, mesh));
  best = Search(kept, mesh, 0, true);
  if (!enough && best.is_valid()) {
    take_strips_out(kept, best, windows);
    enter(best.mesh());
  }
  return *std::min_element(made.begin(), made.end(), [&](const CellMesh& a, const CellMesh& b) {
    return dearness(given, a) < dearness(given, b);
  });
}

}  // namespace isopatch::segmentation::planar
