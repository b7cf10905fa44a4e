#include "segmentation/profiles/internal/search.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <set>

#include "segmentation/profiles/internal/relax.hpp"
#include "segmentation/profiles/internal/ring.hpp"
#include "segmentation/profiles/internal/triangulate.hpp"

namespace isopatch::segmentation::planar {

using Eigen::Vector2d;

Search::Search(const SearchInput& input, CellMesh mesh, unsigned seed, bool slide)
    : input_(&input), mesh_(std::move(mesh)), neighbours_(mesh_), random_(seed + 1), slide_(slide) {
  for (const Cell& cell : mesh_.cells) costs_.push_back(cost_of(input_->rules, input_->curves, mesh_, cell));
}

double Search::chance() {
  return static_cast<double>(random_() - Random::min()) / (Random::max() - Random::min());
}

void Search::polish() {
  for (int again = 0; again < 5; ++again)
    if (settle(10) < 1e-6) break;
}

double Search::settle(int rounds) {
  std::vector<int> all;
  for (int n = 0; n < static_cast<int>(mesh_.nodes.size()); ++n)
    if (may_move(mesh_.nodes[n])) all.push_back(n);
  const double gained = relax(input_->rules, input_->curves, mesh_, neighbours_, all, rounds);
  for (std::size_t c = 0; c < mesh_.cells.size(); ++c)
    costs_[c] = cost_of(input_->rules, input_->curves, mesh_, mesh_.cells[c]);
  return gained;
}

bool Search::may_move(const Node& node) const {
  return slide_ || !node.is_cut() || !input_->shared[node.curve];
}

double Search::cost() const {
  return std::accumulate(costs_.begin(), costs_.end(), 0.0);
}

int Search::triangles() const {
  return static_cast<int>(std::count_if(mesh_.cells.begin(), mesh_.cells.end(),
                                        [](const Cell& cell) { return cell.count == 3; }));
}

bool Search::is_valid() const {
  return triangles() == 0 && std::all_of(costs_.begin(), costs_.end(),
                                         [&](double cost) { return cost < input_->rules.not_valid; });
}

bool Search::fill(const std::vector<Place>& outline, int region) {
  constexpr int candidates[] = {0, 30, 40};  // those left out are drawn by lot
  constexpr std::size_t most = 24;           // corners
  if (outline.size() > most) return false;
  for (const int more : candidates) {
    std::vector<Place> places = outline;
    const std::size_t nodes_before = mesh_.nodes.size();
    add_candidates(places, std::min(static_cast<int>(outline.size()) + more, Try().places));
    std::vector<int> cells(mesh_.cells.size());
    std::iota(cells.begin(), cells.end(), 0);
    const double bound = cells.empty() ? refused : cost() - 1e-6;
    const std::optional<Division> division =
        divide_polygon(input_->rules, input_->curves, mesh_.nodes, places, region, bound, false);
    if (!division || !replace(cells, division->cells, cells.empty() ? -refused : 1e-6, nodes_before))
      mesh_.nodes.resize(nodes_before);
  }
  return !mesh_.cells.empty();
}

void Search::remove_triangles(int tries) {
  int in_vain = 0;
  while (in_vain < tries) {
    std::vector<int> left;
    for (std::size_t c = 0; c < mesh_.cells.size(); ++c)
      if (mesh_.cells[c].count == 3 || costs_[c] >= input_->rules.not_valid)
        left.push_back(static_cast<int>(c));
    if (left.empty()) return;
    Try what;
    what.room = 16 + static_cast<int>(random_() % 24);
    if (in_vain > 8) {
      constexpr int patterns[] = {0, 1, all_around, 2, all_around, 1};
      what.inside = patterns[in_vain % 6];
      what.leave_out = random_() % 2 ? 1 : 0.5;
      what.join_anew = random_() % 3 == 0;
      if (what.inside == all_around || in_vain % 4 == 0) what.room = 80;
    }
    const int cell = in_vain == 0 ? left.front() : left[random_() % left.size()];
    in_vain = divide_anew(cell, what) ? 0 : in_vain + 1;
  }
}

void Search::improve(int windows) {
  int in_vain = 0;
  for (int w = 0; w < windows && in_vain < 60 + 6 * static_cast<int>(mesh_.cells.size()); ++w) {
    int cell = static_cast<int>(random_() % mesh_.cells.size());
    for (int again = 0; again < 2; ++again) {
      const int other = static_cast<int>(random_() % mesh_.cells.size());
      if (costs_[other] > costs_[cell]) cell = other;
    }
    Try what;
    what.room = 4 + static_cast<int>(random_() % 24);
    what.leave_out = random_() % 3 == 0 ? 0.5 : 1;
    const int patterns[] = {0, 0, 0, 0, 1, 2, 4, all_around};
    what.inside = patterns[random_() % 8];
    what.slack = what.inside != 0 ? 1.0 : 0;
    if (what.inside == all_around) what.room = 40;
    what.join_anew = random_() % 2 == 0;
    in_vain = divide_anew(cell, what) ? 0 : in_vain + 1;
  }
}

void Search::add_candidates(std::vector<Place>& places, int limit) {
  struct Candidate {
    std::size_t place;
    double at;
  };
  std::vector<Candidate> all;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Side& link = places[i].link;
    if (link.curve < 0 || input_->shared[link.curve]) continue;
    const bool closed = input_->curves[link.curve].closed();
    for (const double place : input_->candidates[link.curve]) {
      const double near = input_->near_corners ? 0.5 * std::min(place, 1 - place) : 0.03;
      const double margin = closed ? 0.008 : std::min(0.03, near);
      for (const double at : {place, place + 1})
        if (at > link.low + margin && at < link.high - margin) all.push_back({i, at});
    }
  }
  while (all.size() + places.size() > static_cast<std::size_t>(limit) && !all.empty()) {
    std::swap(all[random_() % all.size()], all.back());
    all.pop_back();
  }
  std::vector<Place> result;
  for (std::size_t i = 0; i < places.size(); ++i) {
    std::vector<double> at;
    for (const Candidate& candidate : all)
      if (candidate.place == i) at.push_back(candidate.at);
    std::sort(at.begin(), at.end());
    Place place = places[i];
    if (place.link.reversed) std::reverse(at.begin(), at.end());
    for (const double cut : at) {
      const int curve = place.link.curve, node = static_cast<int>(mesh_.nodes.size());
      mesh_.nodes.push_back({input_->curves[curve].at(cut), false, curve, cut - std::floor(cut)});
      Place first = place;
      first.link.to = node;
      (first.link.reversed ? first.link.low : first.link.high) = cut;
      result.push_back(first);
      place.node = place.link.from = node;
      place.optional = true;
      (place.link.reversed ? place.link.high : place.link.low) = cut;
    }
    result.push_back(place);
  }
  places = std::move(result);
}

bool Search::add_nodes_inside(std::vector<Place>& places, int number, const std::vector<int>& cells) {
  std::vector<Vector2d> outline;
  for (const Place& place : places) {
    const SideShape shape = side_shape(input_->curves, mesh_.nodes, place.link);
    for (int s = 0; s + 1 < SideShape::samples; ++s) outline.push_back(shape.point(s));
  }
  const auto distance = [&](const Vector2d& p) {
    double least = refused;
    for (const Vector2d& q : outline) least = std::min(least, (p - q).norm());
    return least;
  };
  Vector2d pole = Vector2d::Zero();
  double radius = 0;
  for (int sample = 0; sample < 12; ++sample) {  // of random cells, random mixes of their corners
    const Cell& cell = mesh_.cells[cells[random_() % cells.size()]];
    Vector2d sum = Vector2d::Zero();
    double weights = 0;
    for (int k = 0; k < cell.count; ++k) {
      const double weight = 0.2 + chance();
      sum += weight * mesh_.nodes[cell.sides[k].from].point;
      weights += weight;
    }
    const double here = distance(sum / weights);
    if (here > radius) {
      radius = here;
      pole = sum / weights;
    }
  }
  if (radius <= 0) return false;
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), 0U);
  std::sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return (mesh_.nodes[places[a].node].point - pole).norm() <
           (mesh_.nodes[places[b].node].point - pole).norm();
  });
  if (number == all_around) return add_ring_inside(places, outline);
  const std::size_t at = order[random_() % std::min<std::size_t>(order.size(), 12)];
  const Vector2d start = mesh_.nodes[places[at].node].point;
  const Vector2d towards = (start - pole).normalized(), across(-towards.y(), towards.x());
  std::vector<Vector2d> points;
  if (number == 1) points = {pole};
  if (number == 2) points = {pole + 0.5 * radius * towards, pole - 0.5 * radius * towards};
  if (number == 4)
    for (const Vector2d& p : {towards, across, Vector2d(-towards), Vector2d(-across)})
      points.emplace_back(pole + 0.55 * radius * p);
  hang(places, at, points);
  return true;
}

void Search::hang(std::vector<Place>& places, std::size_t at, const std::vector<Vector2d>& points) {
  std::vector<int> way = {places[at].node};
  for (const Vector2d& point : points) {
    way.push_back(static_cast<int>(mesh_.nodes.size()));
    mesh_.nodes.push_back({point, false, -1, 0});
  }
  std::vector<Place> detour;
  for (std::size_t i = 0; i + 1 < way.size(); ++i)
    detour.push_back({way[i], false, Side{way[i], way[i + 1]}});
  for (std::size_t i = way.size() - 1; i > 0; --i)
    detour.push_back({way[i], false, Side{way[i], way[i - 1]}});
  places[at].optional = false;
  places.insert(places.begin() + static_cast<std::ptrdiff_t>(at), detour.begin(), detour.end());
}

bool Search::add_ring_inside(std::vector<Place>& places, const std::vector<Vector2d>& outline) {
  const std::size_t count = places.size();
  std::set<int> met;
  std::vector<SideShape> shapes;
  for (const Place& place : places) {
    if (!met.insert(place.node).second) return false;  // holes or nodes hang on it
    shapes.push_back(side_shape(input_->curves, mesh_.nodes, place.link));
  }
  const std::vector<std::size_t> corners = ring_corners(places, shapes);
  if (corners.size() < 3) return false;
  const double share = 0.15 + 0.55 * chance();
  std::vector<Vector2d> points;
  for (const std::size_t i : corners) {
    const double out = shapes[i].start_direction,
                 in = shapes[(i + count - 1) % count].end_direction + std::numbers::pi;
    const double half = angle_between(out, in) / 2;
    const Vector2d corner = mesh_.nodes[places[i].node].point,
                   way(std::cos(out + half), std::sin(out + half));
    const double room = room_along(corner, way, half, outline);
    if (!(room < refused)) return false;
    points.emplace_back(corner + std::min(0.8, share * (0.8 + 0.4 * chance())) * room * way);
  }
  hang(places, corners.front(), points);
  return true;
}

std::vector<std::size_t> Search::ring_corners(const std::vector<Place>& places,
                                              const std::vector<SideShape>& shapes) {
  constexpr double most = 1.75;  // radians that a side may turn, with some room to move its ends
  const std::size_t count = places.size();
  std::size_t start = 0;
  while (start < count && places[start].optional) ++start;
  start %= count;
  std::vector<std::size_t> result;
  for (std::size_t i = 0; i < count;) {  // stretches between places that are not optional
    std::size_t end = i + 1;
    double turning = shapes[(start + i) % count].turning;
    for (; end < count && places[(start + end) % count].optional; ++end)
      turning += shapes[(start + end) % count].turning;
    const int pieces = static_cast<int>(std::ceil(turning / most)) + (random_() % 12 == 0 ? 1 : 0);
    const double step = turning / pieces;
    double so_far = 0, next = 0;
    for (std::size_t k = i; k < end; ++k) {
      if (so_far >= next - 1e-9) {
        result.push_back((start + k) % count);
        next = turning > 0 ? next + step : refused;
      }
      so_far += shapes[(start + k) % count].turning;
    }
    i = end;
  }
  return result;
}

bool Search::divide_anew(int cell, const Try& what) {
  const std::vector<int> cells = window_around(mesh_, neighbours_, cell, what.room, random_);
  double now = 0;
  bool triangles = false;
  for (const int c : cells) {
    now += costs_[c];
    triangles = triangles || mesh_.cells[c].count == 3 || costs_[c] >= input_->rules.not_valid;
  }
  const std::size_t nodes_before = mesh_.nodes.size();
  std::vector<Place> places;
  if (what.join_anew) {
    std::vector<std::vector<Place>> loops =
        loops_of(input_->curves, mesh_, neighbours_, cells, input_->shared);
    for (std::vector<Place>& loop : loops) add_candidates(loop, what.places / static_cast<int>(loops.size()));
    if (!loops.empty()) places = joined_at_random(input_->curves, mesh_.nodes, loops, random_);
  }
  if (places.empty()) {
    mesh_.nodes.resize(nodes_before);
    places = outline_of(mesh_, neighbours_, cells, input_->shared, what.leave_out, random_);
    add_candidates(places, what.places);
  }
  bool possible =
      std::any_of(places.begin(), places.end(), [](const Place& place) { return !place.optional; }) ||
      what.inside != 0;
  if (what.inside != 0) possible = add_nodes_inside(places, what.inside, cells);
  std::optional<Division> division;
  if (possible)
    division = divide_polygon(input_->rules, input_->curves, mesh_.nodes, places, mesh_.cells[cell].region,
                              now + what.slack - 1e-6, triangles);
  if (division && replace(cells, division->cells, 1e-6, nodes_before)) return true;
  mesh_.nodes.resize(nodes_before);
  return false;
}

bool Search::replace(const std::vector<int>& cells, const std::vector<Cell>& by, double gain,
                     std::size_t nodes_before) {
  CellMesh part;  // what changes: the new cells, and those beside them
  part.nodes.assign(mesh_.nodes.begin(), mesh_.nodes.begin() + static_cast<std::ptrdiff_t>(nodes_before));
  const std::set<int> gone(cells.begin(), cells.end());
  std::map<int, int> numbers;
  std::set<int> moved;
  std::vector<Cell> made = by;
  for (Cell& cell : made)
    for (int k = 0; k < cell.count; ++k)
      for (int* node : {&cell.sides[k].from, &cell.sides[k].to}) {
        if (*node >= static_cast<int>(nodes_before)) {
          const auto [entry, is_new] = numbers.try_emplace(*node, static_cast<int>(part.nodes.size()));
          if (is_new) part.nodes.push_back(mesh_.nodes[*node]);
          *node = entry->second;
        }
        if (may_move(part.nodes[*node])) moved.insert(*node);
      }
  std::set<int> beside;
  for (const int node : moved)
    if (node < neighbours_.nodes())
      for (const int cell : neighbours_.around(node))
        if (!gone.contains(cell)) beside.insert(cell);
  double before = 0, after = 0;
  for (const int cell : gone) before += costs_[cell];
  for (const int cell : beside) {
    before += costs_[cell];
    part.cells.push_back(mesh_.cells[cell]);
  }
  part.cells.insert(part.cells.end(), made.begin(), made.end());
  relax(input_->rules, input_->curves, part, Neighbours(part), {moved.begin(), moved.end()}, 3);
  std::vector<double> costs;
  for (const Cell& cell : part.cells) {
    costs.push_back(cost_of(input_->rules, input_->curves, part, cell));
    after += costs.back();
  }
  if (after > before - gain) return false;
  adopt(std::move(part), costs, gone, beside);
  return true;
}

void Search::adopt(CellMesh part, const std::vector<double>& costs, const std::set<int>& gone,
                   const std::set<int>& beside) {
  std::size_t from_part = 0;
  for (const int cell : beside) {
    mesh_.cells[cell] = part.cells[from_part];
    costs_[cell] = costs[from_part++];
  }
  std::size_t kept = 0;
  for (std::size_t c = 0; c < mesh_.cells.size(); ++c) {
    if (gone.contains(static_cast<int>(c))) continue;
    mesh_.cells[kept] = mesh_.cells[c];
    costs_[kept++] = costs_[c];
  }
  mesh_.cells.resize(kept);
  costs_.resize(kept);
  for (; from_part < part.cells.size(); ++from_part) {
    mesh_.cells.push_back(part.cells[from_part]);
    costs_.push_back(costs[from_part]);
  }
  mesh_.nodes = std::move(part.nodes);
  neighbours_ = Neighbours(mesh_);
}

}  // namespace isopatch::segmentation::planar
