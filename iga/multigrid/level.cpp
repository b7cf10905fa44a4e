#include "iga/multigrid/level.hpp"

#include <algorithm>

#include "geometry/base/dense_matrices.hpp"
#include "geometry/splines/transfer.hpp"
#include "iga/internal/dense_along.hpp"

namespace isopatch::iga {
namespace {

using geometry::KnotVector;

// Fills in all but spaces and first_node.
void number_rows(Level& level, const std::vector<int>& global_of,
                 const std::vector<const SupportFrame*>& frame_of_global, const Distribution& distribution,
                 const solvers::Processes& processes) {
  level.global_of = global_of;
  LocalRows local = local_rows({global_of, static_cast<int>(frame_of_global.size())}, level.first_node,
                               distribution, processes);
  level.rows = std::move(local.rows);
  level.row_of_node = std::move(local.numbering.row_of_node);
  std::vector<const SupportFrame*> frame_of_row;
  for (const int c : level.rows.global_of_local())
    frame_of_row.push_back(frame_of_global[static_cast<std::size_t>(c)]);
  level.free = FreeDirections(frame_of_row);
  level.parts = layers_of(distribution, level.spaces, processes.rank());
  for (const auto& sharing : processes_of_patches(distribution, static_cast<int>(level.spaces.size())))
    level.is_primary.push_back(sharing.front() == processes.rank());
}

// The function of the finest space at the same end, or between the ends, along one direction.
int representative(int i, int count, int fine_count) {
  if (i == 0) return 0;
  if (i == count - 1) return fine_count - 1;
  return std::clamp(static_cast<int>(std::int64_t{i} * (fine_count - 1) / (count - 1)), 1, fine_count - 2);
}

// Supports hold whole faces or edges, so a coarse function has the frame of any fine one on the same ones; of
// parts of faces that of the fine one at the same place, which is right but at the rim.
std::vector<const SupportFrame*> coarse_frames(const Level& coarse, const GlobalNodes& global,
                                               const Level& finest, const std::vector<SupportFrame>& frames) {
  std::vector<const SupportFrame*> result(static_cast<std::size_t>(global.count()));
  for (std::size_t p = 0; p < coarse.spaces.size(); ++p) {
    const auto n = coarse.spaces[p].sizes();
    const auto m = finest.spaces[p].sizes();
    int node = coarse.first_node[p];
    for (int k = 0; k < n[2]; ++k)
      for (int j = 0; j < n[1]; ++j)
        for (int i = 0; i < n[0]; ++i, ++node) {
          const int fine = representative(i, n[0], m[0]) +
                           m[0] * (representative(j, n[1], m[1]) + m[1] * representative(k, n[2], m[2]));
          const int c = finest.global_of[static_cast<std::size_t>(finest.first_node[p] + fine)];
          result[static_cast<std::size_t>(global.global_of[static_cast<std::size_t>(node)])] =
              &frames[static_cast<std::size_t>(c)];
        }
  }
  return result;
}

// The weights of coarser functions with the same denominator; empty if there are none.
Eigen::VectorXd coarser_weights(const PatchSpace& fine, const PatchSpace& coarse) {
  Eigen::VectorXd weights = fine.weights;
  std::array<int, 3> sizes = fine.sizes();
  std::array<int, 3> back = coarse.sizes();
  std::array<Eigen::MatrixXd, 3> up;
  for (std::size_t d = 0; d < 3; ++d) {
    up[d] = Eigen::MatrixXd(geometry::transfer(coarse.knots[d], fine.knots[d]));
    weights = apply_dense_along(weights, sizes, static_cast<int>(d), pseudo_inverse(up[d]));
  }
  Eigen::VectorXd again = weights;
  for (std::size_t d = 0; d < 3; ++d) again = apply_dense_along(again, back, static_cast<int>(d), up[d]);
  const bool same = (again - fine.weights).cwiseAbs().maxCoeff() < 1e-10 * fine.weights.maxCoeff();
  return same && weights.minCoeff() > 0 ? weights : Eigen::VectorXd();
}

// Gives the coarser functions the denominators of the finer ones, which keeps the spaces nested, if that can
// be in all patches: traces must match.
void add_weights(const Level& fine, Level& coarse) {
  std::vector<Eigen::VectorXd> weights;
  for (std::size_t p = 0; p < fine.spaces.size(); ++p) {
    weights.emplace_back();
    if (!fine.spaces[p].is_rational()) continue;
    weights.back() = coarser_weights(fine.spaces[p], coarse.spaces[p]);
    if (weights.back().size() == 0) return;
  }
  for (std::size_t p = 0; p < fine.spaces.size(); ++p) coarse.spaces[p].weights = std::move(weights[p]);
}

int highest_degree(const std::vector<PatchSpace>& spaces) {
  int highest = 0;
  for (const PatchSpace& space : spaces)
    for (const KnotVector& knots : space.knots) highest = std::max(highest, knots.degree());
  return highest;
}

bool has_one_element(const PatchSpace& space) {
  return std::all_of(space.knots.begin(), space.knots.end(),
                     [](const KnotVector& knots) { return knots.element_count() == 1; });
}

}  // namespace

KnotVector coarser_knots(const KnotVector& knots) {
  const std::vector<double> breaks = knots.breaks();
  const std::vector<int> multiplicities = knots.multiplicities();
  const int elements = knots.element_count();
  std::vector<double> kept;
  for (int i = 0; i <= elements; ++i) {
    // With an odd number, pairs of elements from both ends leave one or three in the middle.
    const bool keep = elements % 2 == 0 || 2 * i < elements ? i % 2 == 0 : (elements - i) % 2 == 0;
    if (!keep) continue;
    kept.insert(kept.end(), static_cast<std::size_t>(multiplicities[static_cast<std::size_t>(i)]),
                breaks[static_cast<std::size_t>(i)]);
  }
  return KnotVector(knots.degree(), kept);
}

Level finest_level(const std::vector<PatchSpace>& spaces, const GlobalNodes& global,
                   const std::vector<SupportFrame>& frames, const Distribution& distribution,
                   const solvers::Processes& processes) {
  Level level;
  level.spaces = spaces;
  level.first_node = first_nodes(spaces);
  std::vector<const SupportFrame*> of_global;
  for (const SupportFrame& frame : frames) of_global.push_back(&frame);
  number_rows(level, global.global_of, of_global, distribution, processes);
  return level;
}

std::optional<Level> coarser_level(const geometry::MultiPatch& model, const Level& level, const Level& finest,
                                   const std::vector<SupportFrame>& frames, const Distribution& distribution,
                                   const solvers::Processes& processes) {
  const bool lower_degree = std::all_of(level.spaces.begin(), level.spaces.end(), has_one_element);
  const int lower = highest_degree(level.spaces) > 2 ? 2 : 1;
  Level coarse;
  bool changed = false;
  std::vector<std::array<int, 3>> sizes;
  coarse.first_node = {0};
  for (const PatchSpace& space : level.spaces) {
    PatchSpace next{space.geometry, space.knots, {}, space.reversed};
    for (KnotVector& knots : next.knots) {
      const int before = knots.size();
      knots = lower_degree ? KnotVector::bezier(std::min(knots.degree(), lower), knots.first(), knots.last())
                           : coarser_knots(knots);
      changed = changed || knots.size() != before;
    }
    sizes.push_back(next.sizes());
    coarse.first_node.push_back(coarse.first_node.back() + next.size());
    coarse.spaces.push_back(std::move(next));
  }
  if (!changed) return std::nullopt;
  add_weights(level, coarse);
  const GlobalNodes global = global_nodes(model, sizes);
  number_rows(coarse, global.global_of, coarse_frames(coarse, global, finest, frames), distribution,
              processes);
  return coarse;
}

}  // namespace isopatch::iga
