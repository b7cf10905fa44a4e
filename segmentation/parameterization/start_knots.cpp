#include "segmentation/parameterization/internal/start_knots.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace isopatch::segmentation {
namespace {

using geometry::KnotVector;

/// Knots closer than this share of the range are one.
constexpr double same_knot = 1e-7;

/// Input that brings more spans along any direction is fitted anew.
constexpr int most_own_spans = 256;

/// Inner breaks with multiplicities, increasing.
struct Break {
  double at = 0;
  int multiplicity = 1;
};
using Breaks = std::vector<Break>;

void add(Breaks& breaks, const Break& added) {
  const auto near = std::find_if(breaks.begin(), breaks.end(),
                                 [&](const Break& b) { return std::abs(b.at - added.at) < same_knot; });
  if (near != breaks.end()) {
    near->multiplicity = std::max(near->multiplicity, added.multiplicity);
    return;
  }
  breaks.insert(std::find_if(breaks.begin(), breaks.end(), [&](const Break& b) { return b.at > added.at; }),
                added);
}

void add_equal(Breaks& breaks, int spans) {
  for (int i = 1; i < spans; ++i) add(breaks, {double(i) / spans, 1});
}

/// The breaks of a spline, seen from a space of a higher degree: as smooth there as they are.
void add_spline(Breaks& breaks, const KnotVector& knots, int degree, bool mirrored) {
  const std::vector<double> at = knots.breaks();
  const std::vector<int> multiplicities = knots.multiplicities();
  for (std::size_t i = 1; i + 1 < at.size(); ++i)
    add(breaks, {mirrored ? 1 - at[i] : at[i], multiplicities[i] + degree - knots.degree()});
}

/// Half turns that the edge makes on its way, rounded up, if it goes around more than once.
int winding_spans(const HexComplex& complex, const HexEdge& edge) {
  double turning = 0;
  for (const HexEdgeUse& use : edge.uses)
    for (const Side side : geometry::all_sides) {
      const auto edges = geometry::side_edges(side);
      for (std::size_t k = 0; k < 4; ++k)
        if (edges[k] == use.edge.edge)
          turning = std::max(turning, complex.map({use.edge.block, side}).side_turning(static_cast<int>(k)));
    }
  return turning > 2 * std::numbers::pi ? static_cast<int>(std::ceil(turning / std::numbers::pi)) : 1;
}

KnotVector knots_of(const Breaks& breaks, int degree) {
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0);
  for (const Break& b : breaks)
    knots.insert(knots.end(), static_cast<std::size_t>(std::min(b.multiplicity, degree)), b.at);
  knots.insert(knots.end(), static_cast<std::size_t>(degree) + 1, 1);
  return {degree, knots};
}

}  // namespace

std::vector<KnotVector> start_knots(const HexComplex& complex, int degree, int spans) {
  const HexTopology& topology = complex.topology;
  std::vector<int> equal(topology.sheets.size(), spans);
  for (const HexEdge& edge : topology.edges) {
    int& count = equal[static_cast<std::size_t>(edge.sheet.value)];
    count = std::min(std::max(count, winding_spans(complex, edge)), most_own_spans);
  }
  std::vector<Breaks> own(topology.sheets.size());
  for (std::size_t k = 0; k < own.size(); ++k) add_equal(own[k], equal[k]);
  for (std::size_t e = 0; e < complex.edges.size(); ++e) {
    const HexEdge& edge = topology.edges[e];
    const auto k = static_cast<std::size_t>(edge.sheet.value);
    for (const KnotVector& knots : complex.edges[e].knots) {
      if (knots.degree() > degree) continue;
      add_spline(own[k], knots, degree, edge.against_sheet);
      if (topology.sheets[k].symmetric) add_spline(own[k], knots, degree, !edge.against_sheet);
    }
  }
  std::vector<KnotVector> result;
  for (std::size_t k = 0; k < own.size(); ++k)
    result.push_back(static_cast<int>(own[k].size()) < most_own_spans
                         ? knots_of(own[k], degree)
                         : KnotVector::uniform(degree, equal[k]));
  return result;
}

}  // namespace isopatch::segmentation
