#include "segmentation/parameterization/internal/complex_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "geometry/base/error.hpp"
#include "geometry/splines/grid.hpp"
#include "geometry/splines/refine.hpp"
#include "geometry/splines/transfer.hpp"
#include "segmentation/parameterization/internal/coons.hpp"
#include "segmentation/parameterization/internal/edge_samples.hpp"
#include "segmentation/parameterization/internal/exact_face.hpp"
#include "segmentation/parameterization/internal/start_knots.hpp"

namespace isopatch::segmentation {
namespace {

using Shares = std::vector<double>;

constexpr int samples_a_span = 8;
/// Share of the tolerance that edges may use; the rest is for the faces that keep them.
constexpr double for_edges = 0.4;
constexpr double for_faces = 0.8;

std::size_t number_of(HexEdgeId edge) {
  return static_cast<std::size_t>(edge.value);
}

KnotVector knots_along(const HexComplex& complex, const ComplexFit& fit, BlockId block, int direction) {
  const BlockEdge edge{block, 4 * direction};
  const KnotVector knots = edge_knots(complex, fit, number_of(complex.topology.at(edge)));
  return is_reversed(complex.topology, edge) ? reversed(knots) : knots;
}

/// The sides of a face as the complex' edges; `turned` says whether the edge runs against the face's frame.
struct FaceSide {
  std::size_t edge = 0;
  bool turned = false;
};

std::array<FaceSide, 4> sides_of(const HexComplex& complex, std::size_t face) {
  const BlockSide first = complex.topology.faces[face].uses[0].side;
  const auto edges = geometry::side_edges(first.side);
  std::array<FaceSide, 4> result;
  for (std::size_t k = 0; k < 4; ++k) {
    const BlockEdge edge{first.block, edges[k]};
    result[k] = {number_of(complex.topology.at(edge)), is_reversed(complex.topology, edge)};
  }
  return result;
}

RationalNet in_frame(const RationalNet& net, bool turned_around) {
  if (!turned_around) return net;
  return {net.points.rowwise().reverse(), net.weights.reverse()};
}

/// A face's net with its edges' control points on its boundary and the blend inside.
RationalNet framed_net(const HexComplex& complex, const ComplexFit& fit, std::size_t face,
                       const std::array<KnotVector, 2>& knots) {
  const Eigen::Index n = knots[0].size(), m = knots[1].size();
  RationalNet net = RationalNet::of_size(n * m);
  const auto sides = sides_of(complex, face);
  for (std::size_t k = 0; k < 4; ++k) {
    const RationalNet edge = in_frame(fit.edges[sides[k].edge], sides[k].turned);
    for (Eigen::Index i = 0; i < edge.weights.size(); ++i) {
      const Eigen::Index at = k < 2 ? i + (k == 1 ? n * (m - 1) : 0) : n * i + (k == 3 ? n - 1 : 0);
      net.points.col(at) = edge.points.col(i);
      net.weights[at] = edge.weights[i];
    }
  }
  return coons_net(knots, std::move(net));
}

geometry::NurbsSurface surface_of(const std::array<KnotVector, 2>& knots, const RationalNet& net) {
  return {knots, net.points, net.weights};
}

/// Adds the transfinite blend of what is given on the four sides of a grid.
template <class Points>
void add_blend(Points& grid, const std::array<Points, 4>& sides, const Shares& s, const Shares& t) {
  const auto n = static_cast<Eigen::Index>(s.size()), m = static_cast<Eigen::Index>(t.size());
  for (Eigen::Index j = 0; j < m; ++j)
    for (Eigen::Index i = 0; i < n; ++i) {
      const double x = s[static_cast<std::size_t>(i)], y = t[static_cast<std::size_t>(j)];
      grid.col(i + n * j) += (1 - y) * sides[0].col(i) + y * sides[1].col(i) + (1 - x) * sides[2].col(j) +
                             x * sides[3].col(j) -
                             (1 - y) * ((1 - x) * sides[0].col(0) + x * sides[0].col(n - 1)) -
                             y * ((1 - x) * sides[1].col(0) + x * sides[1].col(n - 1));
    }
}

/// What a face's net is fitted to.
struct FaceTarget {
  Eigen::Matrix3Xd surface;  ///< points of the surface whose sides lie nearest to the complex' edges
  Eigen::Matrix3Xd points;   ///< the same, moved so that the sides are the edges
};

FaceTarget face_target(const HexComplex& complex, std::size_t face, const Shares& s, const Shares& t) {
  const FaceMap& map = complex.map(complex.topology.faces[face]);
  const auto sides = sides_of(complex, face);
  std::array<Eigen::Matrix2Xd, 4> shift;
  std::array<Eigen::Matrix3Xd, 4> off;
  for (std::size_t k = 0; k < 4; ++k) {
    const Shares& along = k < 2 ? s : t;
    const Eigen::Matrix3Xd edge =
        sample_edge(complex, sides[k].edge, sides[k].turned ? turned(along) : along).points;
    const Eigen::Matrix2Xd own = map.side_domain(static_cast<int>(k), along);
    Eigen::Matrix2Xd nearest = own;
    for (Eigen::Index i = 0; i < own.cols(); ++i) nearest.col(i) = project(map, edge.col(i), own.col(i));
    shift[k] = nearest - own;
    off[k] = edge - map.on_surface(nearest);
  }
  Eigen::Matrix2Xd domain = map.domain_grid(s, t);
  add_blend(domain, shift, s, t);
  FaceTarget result{map.on_surface(domain), {}};
  result.points = result.surface;
  add_blend(result.points, off, s, t);
  return result;
}

/// Spans to be halved, by sheet.
using Marks = std::vector<std::vector<bool>>;

void mark(Marks& marks, const HexComplex& complex, std::size_t edge, std::size_t span, bool turned_around) {
  const HexEdge& found = complex.topology.edges[edge];
  auto& spans = marks[static_cast<std::size_t>(found.sheet.value)];
  spans[found.against_sheet != turned_around ? spans.size() - 1 - span : span] = true;
}

bool any(const Marks& marks) {
  return std::any_of(marks.begin(), marks.end(), [](const auto& spans) {
    return std::find(spans.begin(), spans.end(), true) != spans.end();
  });
}

/// Of the range. Narrower ones are where an edge jumps, as beside vertices that are one but for a gap: no
/// knots follow it.
constexpr double narrowest_span = 1e-6;

/// Halves the marked spans, as far as the limits allow; returns whether any was.
bool halve(const HexComplex& complex, ComplexFit& fit, Marks marks) {
  bool changed = false;
  for (std::size_t k = 0; k < marks.size(); ++k) {
    if (complex.topology.sheets[k].symmetric)
      for (std::size_t i = 0; i < marks[k].size(); ++i)
        if (marks[k][i]) marks[k][marks[k].size() - 1 - i] = true;
    const std::vector<double> breaks = fit.sheets[k].breaks();
    std::vector<double> inserted;
    for (std::size_t i = 0; i < marks[k].size(); ++i)
      if (marks[k][i] && breaks[i + 1] - breaks[i] > narrowest_span)
        inserted.push_back((breaks[i] + breaks[i + 1]) / 2);
    if (inserted.empty() || static_cast<int>(marks[k].size() + inserted.size()) > fit.most_spans[k]) continue;
    fit.sheets[k] = geometry::with_knots(fit.sheets[k], inserted);
    changed = true;
  }
  return changed;
}

/// What was asked for, or what leaves room for three halvings of the spans that input brings along.
std::vector<int> most_spans(const std::vector<KnotVector>& start, const FitOptions& options) {
  std::vector<int> result;
  for (const KnotVector& knots : start) {
    const int spans = knots.element_count();
    result.push_back(spans > options.start_spans ? std::max(options.max_spans, 8 * spans)
                                                 : options.max_spans);
  }
  return result;
}

Marks no_marks(const ComplexFit& fit) {
  Marks marks;
  for (const KnotVector& knots : fit.sheets)
    marks.emplace_back(static_cast<std::size_t>(knots.element_count()), false);
  return marks;
}

std::size_t span_of(const std::vector<double>& breaks, double t) {
  const auto above = std::upper_bound(breaks.begin(), breaks.end() - 1, t);
  return static_cast<std::size_t>(above - breaks.begin()) - 1;
}

/// A knot vector with the breaks of a finer one, from which it may differ by round-off.
KnotVector with_breaks_of(const KnotVector& knots, const KnotVector& fine) {
  const std::vector<double> breaks = fine.breaks();
  std::vector<double> result = knots.knots();
  for (double& knot : result)
    knot = *std::min_element(breaks.begin(), breaks.end(),
                             [&](double a, double b) { return std::abs(a - knot) < std::abs(b - knot); });
  return {knots.degree(), result};
}

/// An edge that is taken as it is, on the knots of its sheet.
std::optional<RationalNet> exact_edge(const HexComplex& complex, std::size_t edge, const KnotVector& knots) {
  const auto& exact = complex.edges[edge].exact;
  if (!exact || exact->degree(0) > knots.degree()) return std::nullopt;
  const geometry::NurbsCurve curve({with_breaks_of(exact->knots(0), knots)}, exact->control_points(),
                                   exact->weights());
  const geometry::NurbsCurve fine = geometry::refined(curve, {knots});
  RationalNet result{fine.control_points(), fine.weights()};
  const auto& ends = complex.topology.edges[edge].vertices;
  result.points.leftCols(1) = complex.vertex(ends[0]);
  result.points.rightCols(1) = complex.vertex(ends[1]);
  // Round-off: elsewhere these are corners without a weight.
  result.weights[0] = result.weights[result.weights.size() - 1] = 1;
  return result;
}

Marks fit_edges(const HexComplex& complex, ComplexFit& fit) {
  Marks marks = no_marks(fit);
  for (std::size_t e = 0; e < complex.edges.size(); ++e) {
    const KnotVector knots = edge_knots(complex, fit, e);
    const Shares at = fitting_parameters(knots, samples_a_span);
    const EdgeSamples samples = sample_edge(complex, e, at);
    const auto& ends = complex.topology.edges[e].vertices;
    fit.edge_gap[e] = samples.gap;
    if (const std::optional<RationalNet> exact = exact_edge(complex, e, knots)) {
      fit.edges[e] = *exact;
      continue;
    }
    fit.edges[e] = RationalNet::polynomial(
        fit_curve(knots, at, samples.points, complex.vertex(ends[0]), complex.vertex(ends[1])));
    const Eigen::Matrix3Xd points =
        geometry::points_on_grid(geometry::NurbsCurve({knots}, fit.edges[e].points), {at});
    const Eigen::VectorXd errors = (points - samples.points).colwise().norm();
    const std::vector<double> breaks = knots.breaks();
    // The ends are the vertices, which no knot brings closer.
    for (std::size_t i = 1; i + 1 < at.size(); ++i)
      if (errors[static_cast<Eigen::Index>(i)] > for_edges * fit.tolerance)
        mark(marks, complex, e, span_of(breaks, at[i]), false);
  }
  return marks;
}

void mark_face(Marks& marks, const HexComplex& complex, std::size_t face,
               const std::array<KnotVector, 2>& knots, const std::array<Shares, 2>& at,
               const Eigen::Matrix3Xd& target, const Eigen::VectorXd& errors, double tolerance) {
  const auto sides = sides_of(complex, face);
  bool marked = false;
  for (int d = 0; d < 2; ++d) {
    const std::vector<double> lines = line_errors(knots, at, target, d);
    const FaceSide& side = sides[d == 0 ? 0 : 2];
    for (std::size_t span = 0; span < lines.size(); ++span)
      if (lines[span] > 0.5 * for_faces * tolerance) {
        mark(marks, complex, side.edge, span, side.turned);
        marked = true;
      }
  }
  if (marked) return;
  Eigen::Index worst = 0;
  errors.maxCoeff(&worst);
  const auto n = static_cast<Eigen::Index>(at[0].size());
  for (std::size_t d = 0; d < 2; ++d) {
    const auto index = static_cast<std::size_t>(d == 0 ? worst % n : worst / n);
    const FaceSide& side = sides[d == 0 ? 0 : 2];
    mark(marks, complex, side.edge, span_of(knots[d].breaks(), at[d][index]), side.turned);
  }
}

struct FittedFace {
  std::array<KnotVector, 2> knots;
  std::array<Shares, 2> at;
  FaceTarget target;
  Eigen::VectorXd errors;
};

/// @return  without errors where `has_fair_weights` has become false
FittedFace fit_face(const HexComplex& complex, ComplexFit& fit, std::size_t face) {
  FittedFace result;
  result.knots = face_knots(complex, fit, face);
  result.at = {fitting_parameters(result.knots[0], samples_a_span),
               fitting_parameters(result.knots[1], samples_a_span)};
  const RationalNet framed = framed_net(complex, fit, face, result.knots);
  const FaceMap& map = complex.map(complex.topology.faces[face]);
  fit.made_of_edges[face] = false;
  if (framed.is_rational()) {
    if (auto exact = exact_face(map, result.knots, framed, result.at, for_faces * fit.tolerance)) {
      fit.faces[face] = std::move(exact->net);
      fit.made_of_edges[face] = true;
      result.errors = exact->deviations.values;
      fit.face_deviation[face] = result.errors.maxCoeff();
      fit.face_deviations[face] = std::move(exact->deviations);
      return result;
    }
    fit.has_fair_weights = fit.has_fair_weights && has_fair_weights(framed);
    if (!fit.has_fair_weights) return result;
  }
  result.target = face_target(complex, face, result.at[0], result.at[1]);
  fit.faces[face] = fit_surface(result.knots, result.at, result.target.points, framed);
  const Eigen::Matrix3Xd points =
      geometry::points_on_grid(surface_of(result.knots, fit.faces[face]), {result.at[0], result.at[1]});
  result.errors = (points - result.target.points).colwise().norm();
  DeviationGrid& deviations = fit.face_deviations[face];
  deviations = {result.at[0], result.at[1], (points - result.target.surface).colwise().norm()};
  fit.face_deviation[face] = deviations.values.maxCoeff();
  return result;
}

/// Distance of a point from a curve, from a parameter near its foot.
double distance(const SpaceCurve& curve, const Eigen::Vector3d& point, double t) {
  double best = (curve(t) - point).norm();
  for (int i = 0; i < 8; ++i) {
    const double h = t > 0.5 ? -1e-6 : 1e-6;
    const Eigen::Vector3d here = curve(t), slope = (curve(t + h) - here) / h;
    if (!(slope.squaredNorm() > 0)) break;
    const double next = std::clamp(t + slope.dot(point - here) / slope.squaredNorm(), 0.0, 1.0);
    const double now = (curve(next) - point).norm();
    if (!(now < best * (1 - 1e-6))) break;
    best = now;
    t = next;
  }
  return best;
}

/// Counts the distance of a face's sides from the edges that the solid has there: its surface alone does not
/// tell where the solid ends. Where already the fit's aim is off them, no knots mend it.
void measure_edges(const HexComplex& complex, ComplexFit& fit, std::size_t face) {
  const BlockSide first = complex.topology.faces[face].uses[0].side;
  const FaceMap& map = complex.map(first);
  const double known_to = complex.block(first.block).edge_uncertainty;
  DeviationGrid& grid = fit.face_deviations[face];
  const auto n = static_cast<Eigen::Index>(grid.s.size()), m = static_cast<Eigen::Index>(grid.t.size());
  const Eigen::Matrix3Xd points =
      geometry::points_on_grid(surface_of(face_knots(complex, fit, face), fit.faces[face]), {grid.s, grid.t});
  fit.off_edges[face] = 0;
  const auto sides = sides_of(complex, face);
  for (std::size_t k = 0; k < 4; ++k) {
    const SpaceCurve& curve = map.face().edges[k].curve;
    if (!curve) continue;
    const Shares& along = k < 2 ? grid.s : grid.t;
    const Eigen::Matrix3Xd aim =
        sample_edge(complex, sides[k].edge, sides[k].turned ? turned(along) : along).points;
    for (std::size_t i = 0; i < along.size(); ++i) {
      const auto j = static_cast<Eigen::Index>(i);
      const Eigen::Index at = k < 2 ? j + (k == 1 ? n * (m - 1) : 0) : n * j + (k == 3 ? n - 1 : 0);
      const double t = map.side_parameter(static_cast<int>(k), along[i]);
      fit.off_edges[face] = std::max(fit.off_edges[face], distance(curve, aim.col(j), t) - known_to);
      grid.values[at] = std::max(grid.values[at], distance(curve, points.col(at), t) - known_to);
    }
  }
  fit.face_deviation[face] = grid.values.maxCoeff();
}

Marks fit_faces(const HexComplex& complex, ComplexFit& fit) {
  Marks marks = no_marks(fit);
  for (std::size_t f = 0; f < complex.topology.faces.size(); ++f) {
    const FittedFace fitted = fit_face(complex, fit, f);
    if (!fit.has_fair_weights) break;
    if (fitted.errors.maxCoeff() > for_faces * fit.tolerance)
      mark_face(marks, complex, f, fitted.knots, fitted.at, fitted.target.points, fitted.errors,
                fit.tolerance);
  }
  return marks;
}

}  // namespace

void validate(const FitOptions& options) {
  const auto check = [](bool good, const std::string& what) {
    if (!good) throw Error(ErrorCode::invalid_argument, what);
  };
  check(options.degree >= 2 && options.degree <= 8,
        fmt::format("degree is {}; its range is 2 to 8", options.degree));
  check(options.tolerance >= 1e-8 && options.tolerance <= 0.1,
        fmt::format("tolerance is {}; its range is 1e-8 to 0.1", options.tolerance));
  check(options.start_spans >= 1 && options.start_spans <= 64,
        fmt::format("start_spans is {}; its range is 1 to 64", options.start_spans));
  check(options.max_spans >= options.start_spans && options.max_spans <= 1024,
        fmt::format("max_spans is {}; its range is start_spans to 1024", options.max_spans));
}

ComplexFit fit(const HexComplex& complex, const FitOptions& options) {
  validate(options);
  ComplexFit fit;
  fit.tolerance = options.tolerance * complex.size;
  fit.sheets = start_knots(complex, options.degree, options.start_spans);
  fit.most_spans = most_spans(fit.sheets, options);
  fit.edges.resize(complex.edges.size());
  fit.edge_gap.assign(complex.edges.size(), 0);
  fit.faces.resize(complex.topology.faces.size());
  fit.made_of_edges.assign(complex.topology.faces.size(), false);
  fit.face_deviation.assign(complex.topology.faces.size(), 0);
  fit.face_deviations.resize(complex.topology.faces.size());
  fit.off_edges.assign(complex.topology.faces.size(), 0);
  for (;; ++fit.rounds) {
    Marks marks = fit_edges(complex, fit);
    const bool edges_open = any(marks);
    if (edges_open && halve(complex, fit, marks)) continue;
    marks = fit_faces(complex, fit);
    if (!fit.has_fair_weights) return fit;
    if (any(marks) && halve(complex, fit, marks)) continue;
    for (std::size_t f = 0; f < complex.topology.faces.size(); ++f) measure_edges(complex, fit, f);
    return fit;
  }
}

void refit_face(const HexComplex& complex, ComplexFit& fit, std::size_t face) {
  fit_face(complex, fit, face);
  measure_edges(complex, fit, face);
}

KnotVector edge_knots(const HexComplex& complex, const ComplexFit& fit, std::size_t edge) {
  const HexEdge& found = complex.topology.edges[edge];
  const KnotVector& knots = fit.sheets[static_cast<std::size_t>(found.sheet.value)];
  return found.against_sheet ? reversed(knots) : knots;
}

std::array<KnotVector, 2> face_knots(const HexComplex& complex, const ComplexFit& fit, std::size_t face) {
  const BlockSide first = complex.topology.faces[face].uses[0].side;
  const auto along = geometry::tangents(first.side);
  return {knots_along(complex, fit, first.block, along[0]), knots_along(complex, fit, first.block, along[1])};
}

std::array<KnotVector, 3> block_knots(const HexComplex& complex, const ComplexFit& fit, BlockId block) {
  return {knots_along(complex, fit, block, 0), knots_along(complex, fit, block, 1),
          knots_along(complex, fit, block, 2)};
}

std::vector<int> points_in_block(const HexComplex& complex, const ComplexFit& fit, const HexFaceUse& use) {
  const auto knots = block_knots(complex, fit, use.side.block);
  const std::array<int, 3> sizes{knots[0].size(), knots[1].size(), knots[2].size()};
  const std::vector<int> on_side = geometry::face_control_points(sizes, use.side.side);
  const auto along = geometry::tangents(use.side.side);
  const int n = sizes[static_cast<std::size_t>(along[0])], m = sizes[static_cast<std::size_t>(along[1])];
  const FaceOrientation& o = use.orientation;
  const int own_n = o.swapped ? m : n, own_m = o.swapped ? n : m;
  std::vector<int> result;
  for (int j = 0; j < own_m; ++j)
    for (int i = 0; i < own_n; ++i) {
      int a = o.swapped ? j : i, b = o.swapped ? i : j;
      if (o.flip_first) a = n - 1 - a;
      if (o.flip_second) b = m - 1 - b;
      result.push_back(on_side[static_cast<std::size_t>(a + n * b)]);
    }
  return result;
}

RationalNet block_net(const HexComplex& complex, const ComplexFit& fit, BlockId block) {
  const auto knots = block_knots(complex, fit, block);
  RationalNet net = RationalNet::of_size(Eigen::Index(knots[0].size()) * knots[1].size() * knots[2].size());
  for (const HexFaceId f : complex.topology.block(block).faces)
    for (const HexFaceUse& use : complex.topology.face(f).uses) {
      if (use.side.block != block) continue;
      const std::vector<int> where = points_in_block(complex, fit, use);
      const RationalNet& face = fit.faces[static_cast<std::size_t>(f.value)];
      for (std::size_t i = 0; i < where.size(); ++i) {
        net.points.col(where[i]) = face.points.col(static_cast<Eigen::Index>(i));
        net.weights[where[i]] = face.weights[static_cast<Eigen::Index>(i)];
      }
    }
  return coons_net(knots, std::move(net));
}

}  // namespace isopatch::segmentation
