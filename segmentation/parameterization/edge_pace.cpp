#include "segmentation/parameterization/internal/edge_pace.hpp"

#include <algorithm>
#include <cmath>

#include "geometry/splines/refine.hpp"
#include "segmentation/parameterization/internal/best_face_map.hpp"
#include "segmentation/parameterization/internal/edge_samples.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::KnotVector;

/// Sides of a rectangle are straight to this share of its extent.
constexpr double straight = 1e-9;
/// Blocks agree on an edge's pace if their points are this close, as a share of the size.
constexpr double same_place = 1e-6;
/// A pace whose slowest part is below this share of the mean would make patches poor.
constexpr double least_speed = 0.1;

/// A pace of an edge of a block, in the cube's direction, with the knots that are exact there.
struct Candidate {
  SidePace pace;
  std::vector<KnotVector> knots;
  std::optional<geometry::NurbsCurve> exact = {};
};

double identity(double share) {
  return share;
}

/// Side k of a face along an edge.
struct EdgeSide {
  const QuadFace* face = nullptr;
  std::size_t k = 0;
};

std::array<EdgeSide, 2> sides_at(const Hexahedron& block, int edge) {
  std::array<EdgeSide, 2> result;
  std::size_t found = 0;
  for (const Side side : geometry::all_sides) {
    const auto edges = geometry::side_edges(side);
    const auto at = std::find(edges.begin(), edges.end(), edge);
    if (at != edges.end() && found < 2)
      result[found++] = {&block.face(side), static_cast<std::size_t>(at - edges.begin())};
  }
  return result;
}

/// The direction of the domain along which a curve runs straight, if it does.
std::optional<int> axis_of(const DomainCurve& curve) {
  Eigen::Vector2d low = curve(0), high = low;
  for (int i = 1; i <= 16; ++i) {
    const Eigen::Vector2d point = curve(i / 16.0);
    low = low.cwiseMin(point);
    high = high.cwiseMax(point);
  }
  const Eigen::Vector2d extent = high - low;
  const int axis = extent[0] > extent[1] ? 0 : 1;
  if (!(extent[1 - axis] <= straight * extent[axis])) return std::nullopt;
  return axis;
}

/// Whether a face's outline is a rectangle of its domain.
bool is_rectangle(const QuadFace& face) {
  const auto s = axis_of(face.sides[0]), t = axis_of(face.sides[2]);
  return s && t && *s != *t && axis_of(face.sides[1]) == s && axis_of(face.sides[3]) == t;
}

/// Where a curve that is monotone along an axis has gone a share of its way, by halving.
SidePace inverse_of(const DomainCurve& curve, int axis) {
  const double first = curve(0)[axis], way = curve(1)[axis] - first;
  const auto share_at = [=](double t) { return (curve(t)[axis] - first) / way; };
  bool even = true;
  for (int i = 1; i < 16; ++i) even = even && std::abs(share_at(i / 16.0) - i / 16.0) < 1e-13;
  if (even) return identity;
  return [=](double share) {
    if (share <= 0 || share >= 1) return share <= 0 ? 0.0 : 1.0;
    double low = 0, high = 1;
    for (int i = 0; i < 54; ++i) {
      const double middle = (low + high) / 2;
      (share_at(middle) < share ? low : high) = middle;
    }
    return (low + high) / 2;
  };
}

/// A knot vector between two of its parameters, over [0, 1]; turned around where last < first.
KnotVector piece_of(const KnotVector& knots, double first, double last) {
  const double low = std::min(first, last), high = std::max(first, last);
  const double near = 1e-10 * knots.length();
  const int p = knots.degree();
  const auto order = static_cast<std::size_t>(p) + 1;
  std::vector<double> result(order, 0);
  for (const double knot : knots.knots())
    if (knot > low + near && knot < high - near) result.push_back((knot - low) / (high - low));
  result.insert(result.end(), order, 1);
  const KnotVector piece(p, result);
  return first < last ? piece : reversed(piece);
}

std::optional<Candidate> pace_of_surface(const EdgeSide& side) {
  const QuadFace& face = *side.face;
  if (!face.spline || !is_rectangle(face)) return std::nullopt;
  const DomainCurve& curve = face.sides[side.k];
  const int axis = *axis_of(curve);
  const KnotVector& knots = face.spline->along[static_cast<std::size_t>(axis)];
  return Candidate{inverse_of(curve, axis), {piece_of(knots, curve(0)[axis], curve(1)[axis])}};
}

std::optional<Candidate> pace_of_curve(const std::array<EdgeSide, 2>& sides) {
  if (const auto& exact = sides[0].face->edges[sides[0].k].exact)
    return Candidate{exact->pace, {exact->curve.knots(0)}, exact->curve};
  const std::optional<KnotVector>& knots = sides[0].face->edges[sides[0].k].knots;
  if (!knots || !sides[0].face->is_affine || !sides[1].face->is_affine) return std::nullopt;
  return Candidate{identity, {*knots}};
}

/// @param splines  whether splines are kept, or arcs alone
std::optional<Candidate> candidate_of(const std::array<EdgeSide, 2>& sides, bool splines) {
  if (!splines) {
    const bool is_arc = sides[0].face->edges[sides[0].k].exact.has_value();
    return is_arc ? pace_of_curve(sides) : std::nullopt;
  }
  const auto first = pace_of_surface(sides[0]), second = pace_of_surface(sides[1]);
  if (!first && !second) return pace_of_curve(sides);
  Candidate result = first ? *first : *second;
  if (first && second) result.knots.push_back(second->knots[0]);
  return result;
}

/// An edge's points in all faces around it, in the edge's direction, as its paces have them.
std::vector<Eigen::Matrix3Xd> paths(const HexComplex& complex, const HexEdge& edge,
                                    const std::vector<SidePace>& paces, int pieces) {
  std::vector<Eigen::Matrix3Xd> result;
  for (std::size_t u = 0; u < edge.uses.size(); ++u) {
    const HexEdgeUse& use = edge.uses[u];
    for (const EdgeSide& side : sides_at(complex.block(use.edge.block), use.edge.edge)) {
      Eigen::Matrix3Xd points(3, pieces + 1);
      for (int i = 0; i <= pieces; ++i) {
        const double share = double(use.reversed ? pieces - i : i) / pieces;
        points.col(i) = side.face->surface(side.face->sides[side.k](paces[u](share)));
      }
      result.push_back(points);
    }
  }
  return result;
}

bool agree(const std::vector<Eigen::Matrix3Xd>& paths, double size) {
  return std::all_of(paths.begin(), paths.end(), [&](const Eigen::Matrix3Xd& path) {
    return (path - paths.front()).colwise().norm().maxCoeff() < same_place * size;
  });
}

bool is_steady(const Eigen::Matrix3Xd& path) {
  const Eigen::Index pieces = path.cols() - 1;
  const Eigen::VectorXd lengths = (path.rightCols(pieces) - path.leftCols(pieces)).colwise().norm();
  return lengths.minCoeff() > least_speed * lengths.mean();
}

/// The paces of an edge in its uses' blocks, in the cubes' directions; empty for arc length.
std::vector<SidePace> settled(const HexComplex& complex, const HexEdge& edge, bool splines,
                              EdgeShape& shape) {
  std::vector<SidePace> paces;
  std::vector<KnotVector> knots;
  std::vector<geometry::NurbsCurve> exact;
  for (const HexEdgeUse& use : edge.uses) {
    const auto found = candidate_of(sides_at(complex.block(use.edge.block), use.edge.edge), splines);
    paces.push_back(found ? found->pace : identity);
    if (found)
      for (const KnotVector& k : found->knots) knots.push_back(use.reversed ? reversed(k) : k);
    if (found && found->exact)
      exact.push_back(use.reversed ? geometry::reversed(*found->exact, 0) : *found->exact);
  }
  if (knots.empty()) return {};
  const auto found = paths(complex, edge, paces, 32);
  if (!agree(found, complex.size) || !is_steady(found.front())) return {};
  shape.knots = std::move(knots);
  if (exact.size() == edge.uses.size()) shape.exact = exact.front();
  return paces;
}

void choose_paces(HexComplex& complex, const std::vector<bool>& keeps_splines) {
  std::vector<std::array<SidePace, 12>> paces(complex.blocks.size());
  for (std::size_t e = 0; e < complex.edges.size(); ++e) {
    const HexEdge& edge = complex.topology.edges[e];
    const bool splines = keeps_splines[static_cast<std::size_t>(edge.sheet.value)];
    const std::vector<SidePace> found = settled(complex, edge, splines, complex.edges[e]);
    for (std::size_t u = 0; u < found.size(); ++u) {
      const BlockEdge at = edge.uses[u].edge;
      paces[static_cast<std::size_t>(at.block.value)][static_cast<std::size_t>(at.edge)] = found[u];
    }
  }
  for (std::size_t b = 0; b < complex.blocks.size(); ++b)
    for (const Side side : geometry::all_sides) {
      std::array<SidePace, 4> of_face;
      const auto edges = geometry::side_edges(side);
      for (std::size_t k = 0; k < 4; ++k) of_face[k] = paces[b][static_cast<std::size_t>(edges[k])];
      FaceMap& map = complex.maps[b][static_cast<std::size_t>(side)];
      if (std::any_of(of_face.begin(), of_face.end(), [](const SidePace& pace) { return bool(pace); }))
        map = best_face_map(map.face(), of_face);
    }
}

/// Whether a side of a block has an edge that is run through at another pace than that of arc length.
bool has_paces(const HexComplex& complex, std::size_t block, Side side) {
  const auto edges = geometry::side_edges(side);
  return std::any_of(edges.begin(), edges.end(), [&](int edge) {
    const HexEdgeId id = complex.topology.at(BlockEdge{BlockId(static_cast<int>(block)), edge});
    return !complex.edges[static_cast<std::size_t>(id.value)].knots.empty();
  });
}

}  // namespace

void choose_paces(HexComplex& complex) {
  choose_paces(complex, std::vector<bool>(complex.topology.sheets.size(), true));
}

bool has_paces(const HexComplex& complex) {
  return std::any_of(complex.edges.begin(), complex.edges.end(),
                     [](const EdgeShape& edge) { return !edge.knots.empty(); });
}

HexComplex with_splines_of(const HexComplex& complex, const std::vector<bool>& sheets) {
  HexComplex result = without_paces(complex);
  choose_paces(result, sheets);
  locate_vertices(result);
  return result;
}

HexComplex without_paces(HexComplex complex) {
  for (std::size_t b = 0; b < complex.blocks.size(); ++b)
    for (const Side side : geometry::all_sides)
      if (has_paces(complex, b, side)) {
        FaceMap& map = complex.maps[b][static_cast<std::size_t>(side)];
        map = best_face_map(map.face());
      }
  for (EdgeShape& edge : complex.edges) {
    edge.knots.clear();
    edge.exact.reset();
  }
  locate_vertices(complex);
  return complex;
}

}  // namespace isopatch::segmentation
