#include "iga/stiffness_operator.hpp"

#include <fmt/format.h>
#include <omp.h>

#include <algorithm>
#include <utility>

#include "geometry/base/error.hpp"
#include "iga/internal/parallel_for.hpp"
#include "iga/internal/patch_operator.hpp"

namespace isopatch::iga {
namespace {

void check(const std::vector<PatchSpace>& spaces, const std::vector<PatchPart>& parts,
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
  for (const PatchPart& part : parts) {
    if (part.patch < 0 || part.patch >= static_cast<int>(spaces.size()))
      reject(fmt::format("a part belongs to patch {} of {}", part.patch, spaces.size()));
    const int layers = spaces[static_cast<std::size_t>(part.patch)].knots[2].element_count();
    if (part.first_layer < 0 || part.last_layer > layers || part.first_layer > part.last_layer)
      reject(fmt::format("a part has layers {} .. {} of patch {}, which has {}", part.first_layer,
                         part.last_layer, part.patch, layers));
  }
}

struct Task {
  int patch;
  SweepBox box;
};

bool overlap(const std::array<std::array<int, 2>, 3>& a, const std::array<std::array<int, 2>, 3>& b) {
  for (std::size_t d = 0; d < 3; ++d)
    if (a[d][1] < b[d][0] || b[d][1] < a[d][0]) return false;
  return true;
}

// Boxes of one patch by colour: those of one colour have no function in common.
std::vector<std::vector<Task>> coloured(int patch, const PatchOperator& kernel,
                                        const std::vector<SweepBox>& boxes) {
  std::vector<std::vector<Task>> colours;
  std::vector<std::vector<std::array<std::array<int, 2>, 3>>> taken;
  for (const SweepBox& box : boxes) {
    const auto functions = kernel.functions_of(box);
    std::size_t colour = 0;
    while (colour < taken.size() && std::any_of(taken[colour].begin(), taken[colour].end(),
                                                [&](const auto& other) { return overlap(functions, other); }))
      ++colour;
    if (colour == taken.size()) {
      taken.emplace_back();
      colours.emplace_back();
    }
    taken[colour].push_back(functions);
    colours[colour].push_back({patch, box});
  }
  return colours;
}

}  // namespace

struct StiffnessOperator::State {
  std::vector<Material> materials;
  std::vector<std::int64_t> first_node = {0};
  std::vector<std::unique_ptr<const PatchOperator>> kernels;  // of each patch that has a part
  std::vector<std::vector<Task>> colours;                     // of one colour: no function in common

  // Runs body(kernel, first node, box, scratch) for all boxes, colour by colour.
  template <class Body>
  void for_each_box(Body body) const {
    std::vector<PatchOperatorScratch> scratch(static_cast<std::size_t>(omp_get_max_threads()));
    for (const std::vector<Task>& tasks : colours)
      parallel_for(static_cast<std::int64_t>(tasks.size()), [&](std::int64_t i, int thread) {
        const Task& task = tasks[static_cast<std::size_t>(i)];
        const auto patch = static_cast<std::size_t>(task.patch);
        body(*kernels[patch], first_node[patch], task.box, scratch[static_cast<std::size_t>(thread)]);
      });
  }
};

StiffnessOperator::StiffnessOperator(const std::vector<PatchSpace>& spaces, std::vector<PatchPart> parts,
                                     std::vector<Material> materials, int points) {
  check(spaces, parts, materials, points);
  auto state = std::make_shared<State>();
  state->materials = std::move(materials);
  std::vector<std::vector<SweepBox>> boxes(spaces.size());
  state->kernels.resize(spaces.size());
  for (const PatchSpace& space : spaces) state->first_node.push_back(state->first_node.back() + space.size());
  for (const PatchPart& part : parts) {
    const auto patch = static_cast<std::size_t>(part.patch);
    if (part.first_layer == part.last_layer) continue;
    if (!state->kernels[patch])
      state->kernels[patch] =
          std::make_unique<PatchOperator>(part.patch, spaces[patch], state->materials[patch], points);
    const std::vector<SweepBox> more = state->kernels[patch]->boxes(part.first_layer, part.last_layer);
    boxes[patch].insert(boxes[patch].end(), more.begin(), more.end());
  }
  for (std::size_t p = 0; p < spaces.size(); ++p) {
    if (!state->kernels[p]) continue;
    const auto colours = coloured(static_cast<int>(p), *state->kernels[p], boxes[p]);
    if (colours.size() > state->colours.size()) state->colours.resize(colours.size());
    for (std::size_t c = 0; c < colours.size(); ++c)
      state->colours[c].insert(state->colours[c].end(), colours[c].begin(), colours[c].end());
  }
  state_ = std::move(state);
}

Eigen::Matrix3Xd StiffnessOperator::apply(const Eigen::Matrix3Xd& displacement) const {
  if (displacement.cols() != node_count())
    throw Error(ErrorCode::invalid_argument, fmt::format("the displacement has {} nodes, the operator {}",
                                                         displacement.cols(), node_count()));
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, displacement.cols());
  state_->for_each_box([&](const PatchOperator& kernel, std::int64_t first, const SweepBox& box,
                           PatchOperatorScratch& scratch) {
    kernel.add_forces(box, displacement.data() + 3 * first, forces.data() + 3 * first, scratch);
  });
  return forces;
}

std::vector<Eigen::Matrix3d> StiffnessOperator::diagonal_blocks() const {
  Eigen::Matrix<double, 6, Eigen::Dynamic> sums(6, node_count());
  sums.setZero();
  state_->for_each_box(
      [&](const PatchOperator& kernel, std::int64_t first, const SweepBox& box,
          PatchOperatorScratch& scratch) { kernel.add_squares(box, sums.data() + 6 * first, scratch); });
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
  for (const std::vector<Task>& tasks : state_->colours)
    result += static_cast<std::int64_t>(tasks.size() * sizeof(Task));
  return result;
}

}  // namespace isopatch::iga
