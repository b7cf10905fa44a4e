#include "iga/operator/stiffness_operator.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <span>
#include <utility>

#include "geometry/base/error.hpp"
#include "iga/internal/parallel_for.hpp"
#include "iga/operator/internal/patch_operator.hpp"

namespace isopatch::iga {
namespace {

void check(const std::vector<PatchSpace>& spaces, const std::vector<PatchLayers>& parts,
           const std::vector<Material>& materials, int points) {
  const auto reject = [](const std::string& what) { throw Error(ErrorCode::invalid_argument, what); };
  if (materials.size() != spaces.size())
    reject(fmt::format("there are {} materials for {} patches; each patch needs one", materials.size(),
                       spaces.size()));
  if (points < 0 || points > 64) reject(fmt::format("{} Gauss points are outside 0 .. 64", points));
  for (std::size_t p = 0; p < spaces.size(); ++p)
    if (spaces[p].is_rational() && spaces[p].weights.size() != spaces[p].size())
      reject(fmt::format("patch {} has {} functions and {} weights", p, spaces[p].size(),
                         spaces[p].weights.size()));
  for (const PatchLayers& part : parts) {
    if (part.patch < 0 || part.patch >= static_cast<int>(spaces.size()))
      reject(fmt::format("a part belongs to patch {} of {}", part.patch, spaces.size()));
    const int layers = spaces[static_cast<std::size_t>(part.patch)].knots[2].element_count();
    if (part.first_layer < 0 || part.last_layer > layers || part.first_layer > part.last_layer)
      reject(fmt::format("a part has layers {} .. {} of patch {}, which has {}", part.first_layer,
                         part.last_layer, part.patch, layers));
  }
}

void require_nodes(const Eigen::Matrix3Xd& displacement, int nodes) {
  if (displacement.cols() != nodes)
    throw Error(ErrorCode::invalid_argument,
                fmt::format("the displacement has {} nodes, the operator {}", displacement.cols(), nodes));
}

// What one box gives, added up afterwards: so a box needs nobody's leave to write, and the sums of a node are
// added in the order of the boxes.
struct Task {
  int patch;
  ElementBox box;
  BoxFunctions functions;
  std::ptrdiff_t start;  // of its functions among those of all boxes
};

// Functions of a patch with one index in direction 3.
struct Plane {
  int patch;
  int index;
};

// Adds what a box has for one plane of its patch, C numbers a function.
template <int C>
void add_plane(const Task& task, int plane, const double* sums, const std::array<int, 3>& sizes, double* to) {
  const auto& [first, count] = task.functions;
  const int k = plane - first[2];
  if (k < 0 || k >= count[2]) return;
  const std::ptrdiff_t length = static_cast<std::ptrdiff_t>(C) * count[0];
  const double* from = sums + C * task.start + length * count[1] * k;
  for (int j = first[1]; j < first[1] + count[1]; ++j, from += length) {
    double* const line = to + C * (first[0] + static_cast<std::ptrdiff_t>(sizes[0]) *
                                                  (j + static_cast<std::ptrdiff_t>(sizes[1]) * plane));
    for (std::ptrdiff_t i = 0; i < length; ++i) line[i] += from[i];
  }
}

}  // namespace

struct StiffnessOperator::State {
  std::vector<Material> materials;
  std::vector<std::array<int, 3>> sizes;  // of the patches
  std::vector<std::int64_t> first_node = {0};
  std::vector<std::unique_ptr<const PatchOperator>> kernels;  // of each patch that has a part
  std::vector<Task> tasks;                                    // patch by patch
  std::vector<std::size_t> first_task = {0};                  // of each patch
  std::vector<Plane> planes;                                  // of all patches
  std::ptrdiff_t functions = 0;                               // of all boxes

  void add_tasks(int patch, const std::vector<ElementBox>& boxes) {
    const auto p = static_cast<std::size_t>(patch);
    for (const ElementBox& box : boxes) {
      tasks.push_back({patch, box, kernels[p]->functions_of(box), functions});
      functions += tasks.back().functions.count();
    }
    first_task.push_back(tasks.size());
    for (int k = 0; k < sizes[p][2]; ++k) planes.push_back({patch, k});
  }

  // Several times C numbers per node: the sums of what body(kernel, first node, box, each time's C numbers of
  // each of the box's functions, scratch) adds to zeros.
  template <int C, class Body>
  std::vector<Eigen::Matrix<double, C, Eigen::Dynamic>> sums_of_boxes(std::size_t times, Body body) const {
    std::vector<PatchOperatorScratch> scratch(static_cast<std::size_t>(omp_get_max_threads()));
    const std::ptrdiff_t length = C * functions;
    const auto results = std::make_unique_for_overwrite<double[]>(times * static_cast<std::size_t>(length));
    parallel_for(static_cast<std::int64_t>(tasks.size()), [&](std::int64_t i, int thread) {
      const Task& task = tasks[static_cast<std::size_t>(i)];
      const auto patch = static_cast<std::size_t>(task.patch);
      std::vector<double*> own;
      for (std::size_t t = 0; t < times; ++t) {
        own.push_back(results.get() + static_cast<std::ptrdiff_t>(t) * length + C * task.start);
        std::fill_n(own.back(), C * task.functions.count(), 0.0);
      }
      body(*kernels[patch], first_node[patch], task.box, std::span<double* const>(own),
           scratch[static_cast<std::size_t>(thread)]);
    });
    std::vector<Eigen::Matrix<double, C, Eigen::Dynamic>> sums;
    for (std::size_t t = 0; t < times; ++t) sums.emplace_back(C, first_node.back());
    parallel_for(static_cast<std::int64_t>(planes.size()), [&](std::int64_t i, int) {
      const Plane& plane = planes[static_cast<std::size_t>(i)];
      const auto patch = static_cast<std::size_t>(plane.patch);
      const std::int64_t nodes = std::int64_t{sizes[patch][0]} * sizes[patch][1];
      for (std::size_t t = 0; t < times; ++t) {
        sums[t].middleCols(first_node[patch] + nodes * plane.index, nodes).setZero();
        for (std::size_t k = first_task[patch]; k < first_task[patch + 1]; ++k)
          add_plane<C>(tasks[k], plane.index, results.get() + static_cast<std::ptrdiff_t>(t) * length,
                       sizes[patch], sums[t].col(first_node[patch]).data());
      }
    });
    return sums;
  }
};

StiffnessOperator::StiffnessOperator(const std::vector<PatchSpace>& spaces, std::vector<PatchLayers> parts,
                                     std::vector<Material> materials, int points) {
  check(spaces, parts, materials, points);
  auto state = std::make_shared<State>();
  state->materials = std::move(materials);
  std::vector<std::vector<ElementBox>> boxes(spaces.size());
  state->kernels.resize(spaces.size());
  for (const PatchSpace& space : spaces) {
    state->sizes.push_back(space.sizes());
    state->first_node.push_back(state->first_node.back() + space.size());
  }
  for (const PatchLayers& part : parts) {
    const auto patch = static_cast<std::size_t>(part.patch);
    if (part.first_layer == part.last_layer) continue;
    if (!state->kernels[patch])
      state->kernels[patch] =
          std::make_unique<PatchOperator>(part.patch, spaces[patch], state->materials[patch], points);
    const std::vector<ElementBox> more = state->kernels[patch]->boxes(part.first_layer, part.last_layer);
    boxes[patch].insert(boxes[patch].end(), more.begin(), more.end());
  }
  for (std::size_t p = 0; p < spaces.size(); ++p) state->add_tasks(static_cast<int>(p), boxes[p]);
  state_ = std::move(state);
}

Eigen::Matrix3Xd StiffnessOperator::apply(const Eigen::Matrix3Xd& displacement) const {
  require_nodes(displacement, node_count());
  return std::move(state_
                       ->sums_of_boxes<3>(
                           1,
                           [&](const PatchOperator& kernel, std::int64_t first, const ElementBox& box,
                               std::span<double* const> forces, PatchOperatorScratch& scratch) {
                             kernel.add_forces(box, displacement.data() + 3 * first, forces.front(), scratch);
                           })
                       .front());
}

std::vector<Eigen::Matrix3Xd> StiffnessOperator::apply(
    const std::vector<Eigen::Matrix3Xd>& displacements) const {
  constexpr std::size_t most_together = PatchOperator::most_together;
  std::vector<Eigen::Matrix3Xd> result;
  for (std::size_t begin = 0; begin < displacements.size();) {
    const std::size_t left = displacements.size() - begin;
    const std::size_t rounds = (left + most_together - 1) / most_together;
    const std::size_t count = (left + rounds - 1) / rounds;
    for (std::size_t i = begin; i < begin + count; ++i) require_nodes(displacements[i], node_count());
    if (count == 1) {
      result.push_back(apply(displacements[begin]));
    } else {
      for (Eigen::Matrix3Xd& forces : state_->sums_of_boxes<3>(
               count, [&](const PatchOperator&kernel, std::int64_t first, const ElementBox&box,
                          std::span<double*const> of_box, PatchOperatorScratch&scratch) {
                 std::vector<const double*> of_patch;
                 for (std::size_t i = begin; i < begin + count; ++i)
                   of_patch.push_back(displacements[i].data() + 3 * first);
                 kernel.add_forces(box, of_patch, of_box, scratch);
               }))
        result.push_back(std::move(forces));
    }
    begin += count;
  }
  return result;
}

std::vector<Eigen::Matrix3d> StiffnessOperator::diagonal_blocks() const {
  const Eigen::Matrix<double, 6, Eigen::Dynamic> sums =
      std::move(state_
                    ->sums_of_boxes<6>(1,
                                       [](const PatchOperator& kernel, std::int64_t, const ElementBox& box,
                                          std::span<double* const> own, PatchOperatorScratch& scratch) {
                                         kernel.add_squares(box, own.front(), scratch);
                                       })
                    .front());
  std::vector<Eigen::Matrix3d> blocks(static_cast<std::size_t>(node_count()));
  for (std::size_t p = 0; p + 1 < state_->first_node.size(); ++p) {
    const Material& material = state_->materials[p];
    for (std::int64_t node = state_->first_node[p]; node < state_->first_node[p + 1]; ++node) {
      const auto s = sums.col(node);
      Eigen::Matrix3d& block = blocks[static_cast<std::size_t>(node)];
      block << s[0], s[3], s[4], s[3], s[1], s[5], s[4], s[5], s[2];
      const double shear = material.mu * block.trace();
      block *= material.lambda + material.mu;
      block.diagonal().array() += shear;
    }
  }
  return blocks;
}

int StiffnessOperator::node_count() const {
  return static_cast<int>(state_->first_node.back());
}

std::int64_t StiffnessOperator::bytes() const {
  std::int64_t result = 0;
  for (const auto& kernel : state_->kernels)
    if (kernel) result += kernel->bytes();
  return result + static_cast<std::int64_t>(state_->tasks.size() * sizeof(Task) +
                                            state_->planes.size() * sizeof(Plane));
}

}  // namespace isopatch::iga
