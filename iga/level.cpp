#include "iga/level.hpp"

#include <algorithm>

namespace isopatch::iga {
namespace {

using geometry::KnotVector;

// Fills in all but spaces and first_node.
void number_rows(Level& level, const std::vector<int>& class_of,
                 const std::vector<const Frame*>& frame_of_class, const Distribution& distribution,
                 const solvers::Processes& processes) {
  level.class_of = class_of;
  LocalRows local = local_rows({class_of, static_cast<int>(frame_of_class.size())}, level.first_node,
                               distribution, processes);
  level.rows = std::move(local.rows);
  level.row_of_node = std::move(local.numbering.row_of_node);
  std::vector<const Frame*> frame_of_row;
  for (const int c : level.rows.global_of_local())
    frame_of_row.push_back(frame_of_class[static_cast<std::size_t>(c)]);
  level.free = FreeDirections(frame_of_row);
  level.parts = parts_of(distribution, level.spaces, processes.rank());
  for (const auto& sharing : processes_of_patches(distribution, static_cast<int>(level.spaces.size())))
    level.is_primary.push_back(sharing.front() == processes.rank());
}

// The function of the finest space at the same end, or between the ends, along one direction.
int representative(int i, int count, int fine_count) {
  if (i == 0) return 0;
  if (i == count - 1) return fine_count - 1;
  return std::clamp(static_cast<int>(std::int64_t{i} * (fine_count - 1) / (count - 1)), 1, fine_count - 2);
}

// Supports hold whole faces, so a coarse function has the frame of any fine one on the same faces.
std::vector<const Frame*> coarse_frames(const Level& coarse, const NodeClasses& classes, const Level& finest,
                                        const std::vector<Frame>& frames) {
  std::vector<const Frame*> result(static_cast<std::size_t>(classes.count()));
  for (std::size_t p = 0; p < coarse.spaces.size(); ++p) {
    const auto n = coarse.spaces[p].sizes();
    const auto m = finest.spaces[p].sizes();
    int node = coarse.first_node[p];
    for (int k = 0; k < n[2]; ++k)
      for (int j = 0; j < n[1]; ++j)
        for (int i = 0; i < n[0]; ++i, ++node) {
          const int fine = representative(i, n[0], m[0]) +
                           m[0] * (representative(j, n[1], m[1]) + m[1] * representative(k, n[2], m[2]));
          const int c = finest.class_of[static_cast<std::size_t>(finest.first_node[p] + fine)];
          result[static_cast<std::size_t>(classes.class_of[static_cast<std::size_t>(node)])] =
              &frames[static_cast<std::size_t>(c)];
        }
  }
  return result;
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

Level finest_level(const Discretization& d, const NodeClasses& classes, const std::vector<Frame>& frames,
                   const Distribution& distribution, const solvers::Processes& processes) {
  Level level;
  level.spaces = isoparametric_spaces(d);
  level.first_node = d.first_node;
  std::vector<const Frame*> of_class;
  for (const Frame& frame : frames) of_class.push_back(&frame);
  number_rows(level, classes.class_of, of_class, distribution, processes);
  return level;
}

std::optional<Level> coarser_level(const geometry::MultiPatch& model, const Level& level, const Level& finest,
                                   const std::vector<Frame>& frames, const Distribution& distribution,
                                   const solvers::Processes& processes) {
  const bool lower_degree = std::all_of(level.spaces.begin(), level.spaces.end(), has_one_element);
  Level coarse;
  bool changed = false;
  std::vector<std::array<int, 3>> sizes;
  coarse.first_node = {0};
  for (const PatchSpace& space : level.spaces) {
    PatchSpace next{space.geometry, space.knots, {}, space.reversed};
    for (KnotVector& knots : next.knots) {
      const int before = knots.size();
      knots = lower_degree ? KnotVector::bezier(1, knots.first(), knots.last()) : coarser_knots(knots);
      changed = changed || knots.size() != before;
    }
    sizes.push_back(next.sizes());
    coarse.first_node.push_back(coarse.first_node.back() + next.size());
    coarse.spaces.push_back(std::move(next));
  }
  if (!changed) return std::nullopt;
  const NodeClasses classes = node_classes(model, sizes);
  number_rows(coarse, classes.class_of, coarse_frames(coarse, classes, finest, frames), distribution,
              processes);
  return coarse;
}

}  // namespace isopatch::iga
