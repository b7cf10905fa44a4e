#include "segmentation/sweeps/internal/halved_rings.hpp"

#include <map>

#include "geometry/base/error.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::EdgeUse;

class RingDivider {
 public:
  RingDivider(FilletRings& rings, double share) : rings_(rings), share_(share) {}

  void divide(int edge) {
    const int outer = rings_.rings.at(edge), inner = static_cast<int>(rings_.quads.quads.size());
    const Quad whole = rings_.quads.quads[static_cast<std::size_t>(outer)];
    const EdgeUse far = whole.sides[2];
    QuadEdge middle = at(far.edge.value);
    middle.start = divided(at(edge).start);
    middle.end = divided(at(edge).end);
    const int between = add(middle);
    rings_.offsets[between] = share_ * rings_.offsets.at(far.edge.value);
    const auto rest = [&](std::size_t side) {
      return EdgeUse{EdgeId(rests_.at(whole.sides[side].edge.value)), whole.sides[side].reversed};
    };
    rings_.quads.quads[static_cast<std::size_t>(outer)].sides[2].edge = EdgeId(between);
    rings_.quads.quads.push_back(
        {whole.region, {EdgeUse{EdgeId(between), !far.reversed}, rest(1), far, rest(3)}});
    rings_.halves[edge] = {outer, inner, between};
  }

  /// Their radials would end on both.
  void require_whole_neighbours() const {
    for (const auto& [edge, quad] : rings_.rings)
      if (!rings_.halves.contains(edge) &&
          (rings_.middles.contains(at(edge).start) || rings_.middles.contains(at(edge).end)))
        throw Error(ErrorCode::unsupported, "a round on a rim goes on as one in a corner");
  }

 private:
  const QuadEdge& at(int edge) const { return rings_.quads.edges[static_cast<std::size_t>(edge)]; }
  int add(const QuadEdge& edge) {
    rings_.quads.edges.push_back(edge);
    return static_cast<int>(rings_.quads.edges.size()) - 1;
  }

  /// Where the radial of a vertex is divided.
  int divided(int vertex) {
    const auto known = rings_.middles.find(vertex);
    if (known != rings_.middles.end()) return known->second;
    const int radial = rings_.radials.at(vertex), made = static_cast<int>(rings_.quads.vertices.size());
    QuadEdge near = at(radial), rest = near;
    const bool outwards = near.start == vertex;  // from the outline on
    const double share = outwards ? share_ : 1 - share_, cut = near.low + share * (near.high - near.low);
    const auto place = [&](int number) { return rings_.quads.vertices[static_cast<std::size_t>(number)]; };
    rings_.quads.vertices.push_back((1 - share) * place(near.start) + share * place(near.end));
    (outwards ? near.end : near.start) = made;
    (outwards ? near.high : near.low) = cut;
    (outwards ? rest.start : rest.end) = made;
    (outwards ? rest.low : rest.high) = cut;
    rings_.quads.edges[static_cast<std::size_t>(radial)] = near;
    rests_[radial] = rings_.inner_radials[vertex] = add(rest);
    return rings_.middles[vertex] = made;
  }

  FilletRings& rings_;
  double share_;
  std::map<int, int> rests_;  // by radial
};

}  // namespace

void divide_rings(FilletRings& rings, const std::vector<int>& edges, double share) {
  RingDivider divider(rings, share);
  for (const int edge : edges) divider.divide(edge);
  divider.require_whole_neighbours();
}

}  // namespace isopatch::segmentation
