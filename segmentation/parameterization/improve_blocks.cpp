#include "segmentation/parameterization/internal/improve_blocks.hpp"

#include <algorithm>
#include <map>
#include <set>

#include "geometry/hex/cube.hpp"
#include "geometry/scaled_jacobian.hpp"
#include "geometry/splines/transfer.hpp"

namespace isopatch::segmentation {
namespace {

using Triplets = std::vector<Eigen::Triplet<double>>;

std::array<int, 3> sizes_of(const std::array<KnotVector, 3>& knots) {
  return {knots[0].size(), knots[1].size(), knots[2].size()};
}

Eigen::Index index_of(const std::array<int, 3>& n, int i, int j, int k) {
  return i + Eigen::Index(n[0]) * (j + Eigen::Index(n[1]) * k);
}

/// Mean lengths of a net's twelve edges, by direction.
Eigen::Vector3d mean_lengths(const std::array<int, 3>& n, const Eigen::Matrix3Xd& net) {
  Eigen::Vector3d sum(0, 0, 0);
  for (int e = 0; e < 12; ++e) {
    const int d = e / 4;
    std::array<int, 3> at{};
    const std::array<int, 2> others = geometry::other_directions(d);
    for (std::size_t i = 0; i < 2; ++i)
      at[static_cast<std::size_t>(others[i])] = (e >> i & 1) ? n[static_cast<std::size_t>(others[i])] - 1 : 0;
    Eigen::Vector3d last = net.col(index_of(n, at[0], at[1], at[2]));
    for (int i = 1; i < n[static_cast<std::size_t>(d)]; ++i) {
      at[static_cast<std::size_t>(d)] = i;
      const Eigen::Vector3d next = net.col(index_of(n, at[0], at[1], at[2]));
      sum[d] += (next - last).norm() / 4;
      last = next;
    }
  }
  return sum;
}

/// For `MovableBlock`: nothing of a B-spline.
Eigen::VectorXd weights_of(const geometry::NurbsVolume& patch) {
  return patch.is_rational() ? patch.weights() : Eigen::VectorXd();
}

/// Variables move control points by about the block's size.
double step_of(const Eigen::Vector3d& lengths) {
  return std::cbrt(lengths.prod());
}

// One variable for each coordinate of each inner control point, from `first` on.
int add_interior(Triplets& moves, const std::array<int, 3>& n, double step, int first) {
  for (int k = 1; k + 1 < n[2]; ++k)
    for (int j = 1; j + 1 < n[1]; ++j)
      for (int i = 1; i + 1 < n[0]; ++i)
        for (int c = 0; c < 3; ++c) moves.emplace_back(3 * index_of(n, i, j, k) + c, first++, step);
  return first;
}

Eigen::SparseMatrix<double, Eigen::RowMajor> matrix_of(const Triplets& moves, Eigen::Index rows,
                                                       int columns) {
  Eigen::SparseMatrix<double, Eigen::RowMajor> result(rows, columns);
  result.setFromTriplets(moves.begin(), moves.end());
  return result;
}

/// Knots of a space within a patch's, with few spans.
KnotVector coarse_knots(const KnotVector& knots, int spans) {
  const std::vector<double> breaks = knots.breaks();
  std::vector<double> kept;
  for (int i = 1; i < spans; ++i) {
    const double t = knots.first() + knots.length() * i / spans;
    if (std::find(breaks.begin(), breaks.end(), t) != breaks.end()) kept.push_back(t);
  }
  return geometry::with_knots(KnotVector::bezier(knots.degree(), knots.first(), knots.last()), kept);
}

// Moves of the inner control points by splines of a coarser space that vanish on the boundary.
Eigen::SparseMatrix<double, Eigen::RowMajor> coarse_moves(const std::array<KnotVector, 3>& knots, int spans,
                                                          double step) {
  std::array<geometry::TransferMatrix, 3> to_fine;
  std::array<int, 3> coarse{};
  for (std::size_t d = 0; d < 3; ++d) {
    const KnotVector few = coarse_knots(knots[d], spans);
    to_fine[d] = geometry::transfer(few, knots[d]);
    coarse[d] = few.size();
  }
  const std::array<int, 3> n = sizes_of(knots);
  using Row = geometry::TransferMatrix::InnerIterator;
  const auto inner = [&](const Row& entry, std::size_t d) {
    return entry.col() > 0 && entry.col() + 1 < coarse[d];
  };
  Triplets moves;
  for (int k = 1; k + 1 < n[2]; ++k)
    for (int j = 1; j + 1 < n[1]; ++j)
      for (int i = 1; i + 1 < n[0]; ++i)
        for (Row z(to_fine[2], k); z; ++z)
          for (Row y(to_fine[1], j); y; ++y)
            for (Row x(to_fine[0], i); x; ++x) {
              if (!inner(x, 0) || !inner(y, 1) || !inner(z, 2)) continue;
              const auto at = static_cast<int>(
                  x.col() - 1 + (coarse[0] - 2) * (y.col() - 1 + (coarse[1] - 2) * (z.col() - 1)));
              for (int c = 0; c < 3; ++c)
                moves.emplace_back(3 * index_of(n, i, j, k) + c, 3 * at + c,
                                   step * x.value() * y.value() * z.value());
            }
  return matrix_of(moves, 3 * Eigen::Index(n[0]) * n[1] * n[2],
                   3 * (coarse[0] - 2) * (coarse[1] - 2) * (coarse[2] - 2));
}

Eigen::Matrix3Xd moved(const MovableBlock& block, const Eigen::VectorXd& variables) {
  const Eigen::VectorXd moves = block.moves * variables;
  return block.points + moves.reshaped(3, moves.size() / 3);
}

void look_at(MovableBlock& block, const geometry::Parameter<3>& place) {
  for (std::size_t d = 0; d < 3; ++d) {
    const double t = place[static_cast<Eigen::Index>(d)];
    if (t > block.knots[d].first() && t < block.knots[d].last()) block.extra[d].push_back(t);
  }
}

/// A face whose inner control points slide: two variables each, of the domain.
struct SlidingFace {
  int first_variable = 0;
  std::array<KnotVector, 2> knots;
  double step = 0;  ///< of the domain, a unit of a variable
};

/// S_u and S_v at the parameters where the face's inner control points sit, (3, 2) each, in the net's order.
std::vector<Eigen::Matrix<double, 3, 2>> tangents_at_greville(const FaceMap& map,
                                                              const std::array<KnotVector, 2>& knots,
                                                              double step) {
  const Eigen::Matrix2Xd at = map.domain_grid(knots[0].greville(), knots[1].greville());
  std::vector<Eigen::Matrix<double, 3, 2>> result;
  for (Eigen::Index i = 0; i < at.cols(); ++i) {
    Eigen::Matrix<double, 3, 2> columns;
    for (int d = 0; d < 2; ++d) {
      const Eigen::Vector2d h = 1e-4 * step * Eigen::Vector2d::Unit(d);
      columns.col(d) = (map.face().surface(at.col(i) + h) - map.face().surface(at.col(i) - h)) / 2e-4;
    }
    result.push_back(columns);
  }
  return result;
}

geometry::NurbsSurface displacement(const SlidingFace& face, const Eigen::VectorXd& variables,
                                    double factor) {
  const int n = face.knots[0].size(), m = face.knots[1].size();
  Eigen::Matrix3Xd net = Eigen::Matrix3Xd::Zero(3, Eigen::Index(n) * m);
  int variable = face.first_variable;
  for (int j = 1; j + 1 < m; ++j)
    for (int i = 1; i + 1 < n; ++i, variable += 2)
      net.col(i + n * j).head<2>() = factor * face.step * variables.segment<2>(variable);
  return {face.knots, net};
}

/// Whether a face may slide: one that is made of its edges would leave its surface, unless that is plane.
bool may_slide(const HexComplex& complex, const ComplexFit& fit, std::size_t face) {
  return !fit.made_of_edges[face] || complex.map(complex.topology.faces[face]).face().is_affine;
}

/// The problem of faces sliding on their surfaces.
struct SlidingProblem {
  std::vector<BlockId> blocks;               ///< of the complex
  std::vector<MovableBlock> movable;         ///< one each
  std::map<std::size_t, SlidingFace> faces;  ///< by face of the complex
};

SlidingProblem sliding_problem(const HexComplex& complex, const ComplexFit& fit, const BlockPatches& given,
                               const std::vector<BlockId>& poor_blocks) {
  SlidingProblem problem;
  std::set<BlockId> blocks;
  for (const BlockId b : poor_blocks)
    for (const HexFaceId f : complex.topology.block(b).faces) {
      if (may_slide(complex, fit, static_cast<std::size_t>(f.value)))
        problem.faces[static_cast<std::size_t>(f.value)] = {};
      for (const HexFaceUse& use : complex.topology.face(f).uses) blocks.insert(use.side.block);
    }
  int variables = 0;
  std::map<BlockId, Triplets> moves;
  for (auto& [f, face] : problem.faces) {
    const FaceMap& map = complex.map(complex.topology.faces[f]);
    face = {variables, face_knots(complex, fit, f), map.domain_size()};
    const auto tangents = tangents_at_greville(map, face.knots, face.step);
    const int n = face.knots[0].size(), m = face.knots[1].size();
    for (const HexFaceUse& use : complex.topology.faces[f].uses) {
      const std::vector<int> where = points_in_block(complex, fit, use);
      int variable = face.first_variable;
      for (int j = 1; j + 1 < m; ++j)
        for (int i = 1; i + 1 < n; ++i, variable += 2) {
          const auto at = static_cast<std::size_t>(i + n * j);
          for (int c = 0; c < 3; ++c)
            for (int d = 0; d < 2; ++d)
              moves[use.side.block].emplace_back(3 * where[at] + c, variable + d, tangents[at](c, d));
        }
    }
    variables += 2 * std::max(n - 2, 0) * std::max(m - 2, 0);
  }
  for (const BlockId b : blocks) {
    const auto knots = block_knots(complex, fit, b);
    const auto& patch = given.patches[static_cast<std::size_t>(b.value)];
    const auto& net = patch.control_points();
    const Eigen::Vector3d lengths = mean_lengths(sizes_of(knots), net);
    variables = add_interior(moves[b], sizes_of(knots), step_of(lengths), variables);
    problem.blocks.push_back(b);
    problem.movable.push_back(
        {knots, net, {}, lengths, CountedPoints::all_but_corners, {}, weights_of(patch)});
  }
  for (std::size_t i = 0; i < problem.blocks.size(); ++i)
    problem.movable[i].moves =
        matrix_of(moves[problem.blocks[i]], 3 * problem.movable[i].points.cols(), variables);
  return problem;
}

// The largest part of the displacement that leaves the face bijective, among 1, 1/2, 1/4, 1/8; 0 if none
// does.
double slide(FaceMap& map, const SlidingFace& face, const Eigen::VectorXd& variables) {
  const double before = smallest_sine(map);
  for (double factor = 1; factor > 0.1; factor /= 2) {
    const FaceMap candidate = map.moved(displacement(face, variables, factor), map.kind());
    if (smallest_sine(candidate) < std::min(0.05, before)) continue;
    map = candidate;
    return factor;
  }
  return 0;
}

/// The same of a plane face that is made of its edges: its control points move, weights stay.
void slide_in_plane(RationalNet& net, const FaceMap& map, const SlidingFace& face,
                    const Eigen::VectorXd& variables) {
  const auto tangents = tangents_at_greville(map, face.knots, face.step);
  const int n = face.knots[0].size(), m = face.knots[1].size();
  int variable = face.first_variable;
  for (int j = 1; j + 1 < m; ++j)
    for (int i = 1; i + 1 < n; ++i, variable += 2)
      net.points.col(i + n * j) +=
          tangents[static_cast<std::size_t>(i + n * j)] * variables.segment<2>(variable);
}

std::optional<FoldedEdge> folded_edge(const geometry::NurbsVolume& volume) {
  constexpr int steps = 16;
  std::optional<FoldedEdge> worst;
  for (int e = 0; e < 12; ++e) {
    geometry::Parameter<3> at;
    const auto others = geometry::other_directions(geometry::edge_direction(e));
    for (std::size_t i = 0; i < 2; ++i) at[others[i]] = e >> i & 1;
    for (int i = 0; i <= steps; ++i) {
      at[geometry::edge_direction(e)] = double(i) / steps;
      const double scaled = geometry::scaled_jacobian(volume.jacobian(at));
      if (scaled <= 0 && (!worst || scaled < worst->scaled_jacobian)) worst = {at, volume.point(at), scaled};
    }
  }
  return worst;
}

}  // namespace

bool PatchValidity::better_than(const PatchValidity& other) const {
  if (certificate.accepted() != other.certificate.accepted()) return certificate.accepted();
  return quality.min_scaled_jacobian > other.quality.min_scaled_jacobian;
}

PatchValidity validity(const geometry::NurbsVolume& volume) {
  return {geometry::certify_jacobian(volume, {.max_depth = 6}), geometry::quality(volume),
          folded_edge(volume)};
}

ImprovedPatch improve_interior(const geometry::NurbsVolume& patch, double wanted_quality,
                               const OptimizationOptions& options) {
  ImprovedPatch best{patch, validity(patch), 0};
  const std::array<KnotVector, 3>& knots = patch.knots();
  const Eigen::Matrix3Xd& net = patch.control_points();
  const std::array<int, 3> n = sizes_of(knots);
  if (*std::min_element(n.begin(), n.end()) < 3 || best.validity.folded_edge) return best;
  MovableBlock block{
      knots, net, {}, mean_lengths(n, net), CountedPoints::inside_faces_and_interior, {}, weights_of(patch)};
  const double step = step_of(block.lengths);
  const auto is_good_enough = [&](const PatchValidity& validity) {
    return validity.certificate.accepted() && validity.quality.min_scaled_jacobian >= wanted_quality;
  };
  // Few variables first: they get around large folds quickly, and most patches need no more.
  constexpr int most_spans = 64;
  for (const int spans : {2, 4, most_spans}) {
    if (is_good_enough(best.validity) || (spans == most_spans && best.validity.certificate.accepted())) break;
    block.points = best.patch.control_points();
    if (spans == most_spans) {
      Triplets moves;
      const int variables = add_interior(moves, n, step, 0);
      block.moves = matrix_of(moves, 3 * net.cols(), variables);
    } else {
      block.moves = coarse_moves(knots, spans, step);
    }
    constexpr int most_looks = 3;
    for (int look = 0; look < most_looks && !is_good_enough(best.validity); ++look) {
      const OptimizedShapes found = optimize_shapes({block}, options);
      best.evaluations += found.evaluations;
      const Eigen::Matrix3Xd candidate = moved(block, found.variables);
      const geometry::NurbsVolume found_patch(knots, candidate, patch.weights());
      const PatchValidity now = validity(found_patch);
      if (now.better_than(best.validity) || !best.validity.certificate.accepted()) {
        best.patch = found_patch;
        best.validity = now;
      }
      // Where no fold lies between the points looked at, another look finds nothing new.
      if (now.certificate.accepted() || found.smallest_after <= 0) break;
      look_at(block, now.certificate.parameter);
      block.points = candidate;
    }
  }
  return best;
}

bool slide_faces(HexComplex& complex, ComplexFit& fit, BlockPatches& blocks,
                 const std::vector<BlockId>& poor_blocks, double wanted_quality,
                 const OptimizationOptions& options) {
  const SlidingProblem problem = sliding_problem(complex, fit, blocks, poor_blocks);
  const OptimizedShapes found = optimize_shapes(problem.movable, options);
  blocks.evaluations += found.evaluations;
  HexComplex new_complex = complex;
  ComplexFit new_fit = fit;
  for (const auto& [f, face] : problem.faces) {
    FaceMap& map = new_complex.map(complex.topology.faces[f].uses[0].side);
    if (fit.made_of_edges[f])
      slide_in_plane(new_fit.faces[f], map, face, found.variables);
    else if (slide(map, face, found.variables) > 0)
      refit_face(new_complex, new_fit, f);
  }
  BlockPatches changed = blocks;
  bool better = false, worse = false;
  for (std::size_t i = 0; i < problem.blocks.size(); ++i) {
    const auto b = static_cast<std::size_t>(problem.blocks[i].value);
    const auto knots = block_knots(complex, fit, problem.blocks[i]);
    const std::array<int, 3> n = sizes_of(knots);
    RationalNet net = block_net(new_complex, new_fit, problem.blocks[i]);
    const Eigen::Matrix3Xd inside = moved(problem.movable[i], found.variables);
    for (int k = 1; k + 1 < n[2]; ++k)
      for (int j = 1; j + 1 < n[1]; ++j)
        for (int at = 1; at + 1 < n[0]; ++at)
          net.points.col(index_of(n, at, j, k)) = inside.col(index_of(n, at, j, k));
    const ImprovedPatch improved =
        improve_interior({knots, net.points, net.weights}, wanted_quality, options);
    changed.evaluations += improved.evaluations;
    changed.patches[b] = improved.patch;
    changed.validities[b] = improved.validity;
    better = better || improved.validity.better_than(blocks.validities[b]);
    worse =
        worse || (blocks.validities[b].certificate.accepted() && !improved.validity.certificate.accepted());
  }
  blocks.evaluations = changed.evaluations;
  if (!better || worse) return false;
  complex = std::move(new_complex);
  fit = std::move(new_fit);
  blocks = std::move(changed);
  return true;
}

}  // namespace isopatch::segmentation
