#include "segmentation/profiles/internal/divide_polygon.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <unordered_map>

#include "segmentation/profiles/internal/triangulate.hpp"

namespace isopatch::segmentation::planar {

using Eigen::Vector2d;
using std::numbers::pi;

namespace {

/// Between two places: along the polygon, or straight across it.
enum Way { along = 0, across = 1 };

class PolygonDivider {
 public:
  PolygonDivider(const ShapeRules& rules, const std::vector<Curve>& curves, const std::vector<Node>& nodes,
                 std::vector<Place> places, bool triangles)
      : rules_(rules),
        curves_(curves),
        nodes_(nodes),
        places_(std::move(places)),
        triangles_(triangles),
        count_(static_cast<int>(places_.size())),
        table_(static_cast<std::size_t>(2 * (count_ + 1) * (count_ + 1)), -1),
        costs_(table_.size(), refused),
        from_(static_cast<std::size_t>(count_ + 1)),
        to_(static_cast<std::size_t>(count_ + 1)) {
    const auto fixed =
        std::find_if(places_.begin(), places_.end(), [](const Place& place) { return !place.optional; });
    std::rotate(places_.begin(), fixed, places_.end());
    places_.push_back(places_.front());
    smallest_ = triangles ? std::min(rules.smallest, rules.smallest_in_triangle) : rules.smallest;
    enter_directions();
    enter_stretches();
    enter_chords();
    enter_least();
  }

  std::optional<Division> divide(int region, double bound) {
    for (int span = triangles_ ? 2 : 3; span < count_; ++span)
      for (int i = 0; i + span < count_; ++i) {
        const int number = table(i, i + span, across);
        if (number < 0) continue;
        Choice choice;
        const double cost = close(i, i + span, links_[number], choice, bound - least_outside(i, i + span));
        links_[number].cost = cost;
        links_[number].choice = choice;
        if (cost < refused) offer(i, i + span, across);
      }
    int last = -1;
    double best = bound;
    Choice choice;
    for (int q = count_ - 1; q >= 2; --q) {
      if (table(q, count_, along) >= 0) {
        const Link& closing = link(q, count_, along);
        Link turned = closing;  // seen from place 0
        turned.start = wrapped(closing.end + pi);
        turned.end = wrapped(closing.start + pi);
        Choice found;
        const double cost = close(0, q, turned, found, best, q);
        if (cost < best) {
          best = cost;
          last = q;
          choice = found;
        }
      }
      if (!places_[q].optional) break;
    }
    if (last < 0) return std::nullopt;
    Division result{best, {}};
    collect(0, choice, last, side_of(last, count_, along), region, result.cells);
    return result;
  }

 private:
  struct Choice {
    int k = -1, l = -1;  ///< l = -1: a triangle
    Way ik = along, kl = along, lj = along;
  };
  struct Link {
    double cost = refused;  ///< of what lies between it and the polygon
    double start = 0, end = 0, length = 0;
    double turning = 0, slant = 0;
    bool straight = true;
    Choice choice;
  };

  /// A link that cells may have as a side, by its other end.
  struct Offer {
    int place;
    Way way;
    int link;     ///< its number
    double cost;  ///< the link's
  };

  std::size_t place_in_table(int i, int j, Way way) const {
    return static_cast<std::size_t>(2 * (i * (count_ + 1) + j) + way);
  }
  int& table(int i, int j, Way way) { return table_[place_in_table(i, j, way)]; }
  Link& link(int i, int j, Way way) { return links_[static_cast<std::size_t>(table(i, j, way))]; }
  void enter(int i, int j, Way way, const Link& made) {
    table(i, j, way) = static_cast<int>(links_.size());
    links_.push_back(made);
  }
  void offer(int i, int j, Way way) {
    const auto insert = [](std::vector<Offer>& offers, const Offer& made) {
      const auto later = [](const Offer& a, const Offer& b) {
        return std::pair(a.place, a.way) < std::pair(b.place, b.way);
      };
      offers.insert(std::upper_bound(offers.begin(), offers.end(), made, later), made);
    };
    const int number = table(i, j, way);
    const double cost = links_[static_cast<std::size_t>(number)].cost;
    insert(from_[static_cast<std::size_t>(i)], {j, way, number, cost});
    insert(to_[static_cast<std::size_t>(j)], {i, way, number, cost});
    costs_[place_in_table(i, j, way)] = cost;
  }

  /// Every place that is not optional is a corner of cells; n corners take n / 2 - 1 quadrilaterals.
  void enter_least() {
    least_before_.push_back(0);
    for (int i = 0; i <= count_; ++i)
      least_before_.push_back(least_before_.back() + (places_[i].optional ? 0 : 0.5));
  }
  /// What cells beyond a chord cost at least.
  double least_outside(int i, int j) const {
    return std::max(1.0, least_before_[count_] - least_before_[j + 1] + least_before_[i]);
  }
  /// What cells cost at least that have all places between two as corners.
  double least_between(int i, int j) const { return least_before_[j] - least_before_[i + 1]; }
  static double wrapped(double angle) {
    while (angle < 0) angle += 2 * pi;
    while (angle >= 2 * pi) angle -= 2 * pi;
    return angle;
  }
  /// Of directions in [0, 2 pi).
  static double between(double leaving, double arriving) {
    const double angle = arriving - leaving;
    return angle < 0 ? angle + 2 * pi : angle;
  }
  static double opposite(double direction) { return direction < pi ? direction + pi : direction - pi; }
  const Vector2d& point(int place) const { return nodes_[places_[place].node].point; }

  void enter_directions() {
    for (int i = 0; i < count_; ++i) {
      shapes_of_links_.push_back(side_shape(curves_, nodes_, places_[i].link));
      leaving_.push_back(wrapped(shapes_of_links_.back().start_direction));
      arriving_.push_back(wrapped(shapes_of_links_.back().end_direction));
    }
    leaving_.push_back(leaving_.front());
  }

  bool continues(int place) const {
    const Side &before = places_[place - 1].link, &after = places_[place].link;
    return places_[place].optional && before.curve >= 0 && before.curve == after.curve &&
           before.reversed == after.reversed;
  }

  void enter_stretches() {
    for (int i = 0; i < count_; ++i) {
      double length = 0, turning = 0;
      for (int j = i + 1; j <= count_ && (j == i + 1 || continues(j - 1)); ++j) {
        const SideShape& piece = shapes_of_links_[j - 1];
        length += piece.length;
        turning += piece.turning;
        if (turning > rules_.largest_turn) break;
        enter(i, j, along,
              {0, leaving_[i], arriving_[j - 1], length, turning, piece.slant, piece.straight, {}});
        offer(i, j, along);
      }
    }
  }

  void enter_chords() {
    for (int i = 0; i < count_; ++i)
      for (int j = i + 2; j < count_; ++j) {
        if (places_[i].node == places_[j].node) continue;
        const Vector2d d = point(j) - point(i);
        const double direction = wrapped(std::atan2(d.y(), d.x()));
        if (!inside(i, direction) || !inside(j, opposite(direction)) || !visible(i, j)) continue;
        enter(i, j, across, {refused, direction, direction, d.norm(), 0, slant_of(d), true, {}});
      }
  }

  /// Whether a direction leads from a place into the polygon, by the least angle.
  bool inside(int place, double direction) const {
    const double back = opposite(arriving_[place == 0 ? count_ - 1 : place - 1]);
    double whole = between(leaving_[place], back);
    if (whole < 1e-9) whole = 2 * pi;
    const double part = between(leaving_[place], direction);
    return part >= smallest_ && whole - part >= smallest_;
  }

  bool visible(int i, int j) const {
    const int a = places_[i].node, b = places_[j].node;
    for (int k = 0; k < count_; ++k) {
      const Side& side = places_[k].link;
      if (side.from == a || side.to == a || side.from == b || side.to == b) continue;
      const SideShape& shape = shapes_of_links_[k];
      if (shape.straight) {
        if (segments_meet(point(i), point(j), shape.points.front(), shape.points.back())) return false;
        continue;
      }
      const Vector2d& middle = shape.points[SideShape::samples / 2];
      if (segments_meet(point(i), point(j), shape.points.front(), middle) ||
          segments_meet(point(i), point(j), middle, shape.points.back()))
        return false;
    }
    return true;
  }

  /// The cheapest cell on the inner side of a link from i to j (seen from i) with all that lies beyond it.
  /// @param root number of the place at which the last stretch begins, if the link is that
  double close(int i, int j, const Link& closing, Choice& choice, double bound, int root = -1) {
    double best = bound;
    const double at_i = closing.start;
    for (const Offer& one : from_[static_cast<std::size_t>(i)]) {
      if (one.place >= j) break;
      const double rest = std::max(0.0, least_between(one.place, j) - 0.5);
      if (!(one.cost + rest + 1 < best)) continue;
      const Link& first = links_[static_cast<std::size_t>(one.link)];
      const double angle_i = between(first.start, at_i);
      if (triangles_) try_triangles(i, one.place, j, one.way, first, angle_i, best, choice, root);
      const double so_far = first.cost + corner_cost(rules_, angle_i) + 1;
      if (!(so_far + rest < best)) continue;
      try_quads(i, one.place, j, one.way, first, closing, so_far, best, choice, root);
    }
    if (best < bound) return best;
    return refused;
  }

  void try_quads(int i, int k, int j, Way ik, const Link& first, const Link& closing, double so_far,
                 double& best, Choice& choice, int root) {
    const double back_k = opposite(first.end), from_j = opposite(closing.end);
    const std::vector<Offer>& thirds = to_[static_cast<std::size_t>(j)];
    const auto beyond_k =
        std::partition_point(thirds.begin(), thirds.end(), [&](const Offer& one) { return one.place <= k; });
    for (auto offer = beyond_k; offer != thirds.end(); ++offer) {
      const Offer& one = *offer;
      const int l = one.place;
      if (!(so_far + one.cost + least_between(k, l) < best)) continue;
      const Link& third = links_[static_cast<std::size_t>(one.link)];
      double with_j = refused;
      for (const Way kl : {along, across}) {
        if (!(so_far + one.cost + costs_[place_in_table(k, l, kl)] < best)) continue;
        const Link& second = links_[static_cast<std::size_t>(table(k, l, kl))];
        // At j the cell's side leaves against the link.
        if (with_j == refused)
          with_j = so_far + third.cost + corner_cost(rules_, between(from_j, opposite(third.end)));
        double cost = with_j + second.cost;
        if (!(cost < best)) continue;
        cost += corner_cost(rules_, between(second.start, back_k));
        if (!(cost < best)) continue;
        cost += corner_cost(rules_, between(third.start, opposite(second.end)));
        if (!(cost < best)) continue;
        cost += sides_cost(rules_, first, second, third, closing);
        if (!(cost < best)) continue;
        if (!(first.straight && second.straight && third.straight && closing.straight) &&
            !stands({i, k, l, j}, {ik, kl, one.way}, root))
          continue;
        best = cost;
        choice = {k, l, ik, kl, one.way};
      }
    }
  }

  void try_triangles(int i, int k, int j, Way ik, const Link& first, double angle_i, double& best,
                     Choice& choice, int root) {
    if (angle_i < rules_.smallest_in_triangle || angle_i > rules_.largest_in_triangle) return;
    for (const Way kj : {along, across}) {
      if (table(k, j, kj) < 0) continue;
      const Link& second = link(k, j, kj);
      if (!(first.cost + second.cost + rules_.triangle < best)) continue;
      const SideShape a = shape_of(i, k, ik), b = shape_of(k, j, kj), c = closing_shape(i, j, root);
      const double cost = first.cost + second.cost + cost_of(rules_, {&a, &b, &c, nullptr}, 3);
      if (!(cost < best)) continue;
      best = cost;
      choice = {k, -1, ik, kj, along};
    }
  }

  bool stands(const std::array<int, 4>& p, const std::array<Way, 3>& ways, int root) {
    const SideShape &a = shape_of(p[0], p[1], ways[0]), &b = shape_of(p[1], p[2], ways[1]),
                    &c = shape_of(p[2], p[3], ways[2]);
    const SideShape d = closing_shape(p[0], p[3], root);
    return map_stands({&a, &b, &c, &d}, rules_.smallest_jacobian, rules_.thinnest);
  }

  SideShape closing_shape(int i, int j, int root) {
    return root >= 0 ? shape_of(root, count_, along) : turned(shape_of(i, j, across));
  }

  const SideShape& shape_of(int i, int j, Way way) {
    if (way == along && j == i + 1) return shapes_of_links_[i];
    const auto [entry, is_new] = shapes_.try_emplace(2 * (i * (count_ + 1) + j) + way);
    if (is_new) entry->second = side_shape(curves_, nodes_, side_of(i, j, way));
    return entry->second;
  }

  Side side_of(int i, int j, Way way) const {
    const int from = places_[i].node, to = places_[j].node;
    if (way == across) return {from, to};
    Side result = places_[i].link;
    for (int k = i + 1; k < j; ++k) {
      const double span = places_[k].link.high - places_[k].link.low;
      (result.reversed ? result.low : result.high) += result.reversed ? -span : span;
    }
    result.to = to;
    const double turns = result.curve >= 0 ? std::floor(result.low + 1e-12) : 0;
    result.low -= turns;
    result.high -= turns;
    return result;
  }

  void collect(int i, const Choice& choice, int j, const Side& closing, int region,
               std::vector<Cell>& cells) {
    const auto enter = [&](int from, int to, Way way) {
      if (way == across)
        collect(from, link(from, to, across).choice, to, Side{places_[to].node, places_[from].node}, region,
                cells);
      return side_of(from, to, way);
    };
    Cell cell{region, choice.l < 0 ? 3 : 4, {}};
    cell.sides[0] = enter(i, choice.k, choice.ik);
    if (choice.l < 0) {
      cell.sides[1] = enter(choice.k, j, choice.kl);
      cell.sides[2] = closing;
    } else {
      cell.sides[1] = enter(choice.k, choice.l, choice.kl);
      cell.sides[2] = enter(choice.l, j, choice.lj);
      cell.sides[3] = closing;
    }
    cells.push_back(cell);
  }

  const ShapeRules& rules_;
  const std::vector<Curve>& curves_;
  const std::vector<Node>& nodes_;
  std::vector<Place> places_;  // the first again at the end
  bool triangles_;
  int count_;
  double smallest_ = 0;
  std::vector<int> table_;     // numbers of links by ends and way, -1 where there is none
  std::vector<double> costs_;  // likewise, of those that cells may have as a side
  std::vector<Link> links_;
  std::vector<std::vector<Offer>> from_, to_;  // by place, in order of the other end
  std::vector<double> least_before_;
  std::vector<SideShape> shapes_of_links_;
  std::vector<double> leaving_, arriving_;  // directions of the link that follows each place, at its ends
  std::unordered_map<int, SideShape> shapes_;
};

}  // namespace

std::optional<Division> divide_polygon(const ShapeRules& rules, const std::vector<Curve>& curves,
                                       const std::vector<Node>& nodes, std::vector<Place> places, int region,
                                       double bound, bool triangles) {
  return PolygonDivider(rules, curves, nodes, std::move(places), triangles).divide(region, bound);
}

}  // namespace isopatch::segmentation::planar
