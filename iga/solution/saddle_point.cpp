#include "iga/solution/saddle_point.hpp"

#include <algorithm>

namespace isopatch::iga {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Of every class, the processes that have a node of it, increasing.
std::vector<std::vector<int>> processes_of_classes(const SolutionTask& task, const Level& level) {
  const auto of_patch = processes_of_patches(task.distribution, static_cast<int>(level.spaces.size()));
  std::vector<std::vector<int>> result(static_cast<std::size_t>(task.classes.count()));
  for (std::size_t p = 0; p < of_patch.size(); ++p)
    for (int node = level.first_node[p]; node < level.first_node[p + 1]; ++node) {
      std::vector<int>& all =
          result[static_cast<std::size_t>(level.class_of[static_cast<std::size_t>(node)])];
      all.insert(all.end(), of_patch[p].begin(), of_patch[p].end());
    }
  for (std::vector<int>& all : result) {
    std::sort(all.begin(), all.end());
    all.erase(std::unique(all.begin(), all.end()), all.end());
  }
  return result;
}

// Nodes in the order of all patches, then ties class by class.
solvers::SharedRows saddle_rows(const SolutionTask& task, const Level& level) {
  const std::vector<int>& class_of = task.classes.class_of;
  if (!level.rows.is_distributed())
    return solvers::SharedRows(static_cast<int>(2 * class_of.size()) - task.classes.count());
  const auto of_class = processes_of_classes(task, level);
  std::vector<std::vector<int>> of_row;
  for (const int c : class_of) of_row.push_back(of_class[static_cast<std::size_t>(c)]);
  for (int c = 0; c < task.classes.count(); ++c)
    of_row.insert(of_row.end(), task.classes.of(c).size() - 1, of_class[static_cast<std::size_t>(c)]);
  return solvers::SharedRows(of_row, task.processes);
}

Eigen::Vector3d mean_of(const std::vector<Index>& nodes, const VectorXd& z) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (const Index node : nodes) sum += z.segment<3>(3 * node);
  return sum / static_cast<double>(nodes.size());
}

}  // namespace

SaddlePoint::SaddlePoint(const SolutionTask& task, const Level& level, const ElasticityMultigrid& multigrid,
                         const std::vector<Eigen::Matrix3d>& diagonal)
    : task_(&task),
      level_(&level),
      multigrid_(&multigrid),
      stiffness_(level.spaces, level.parts, task.problem.materials, task.points),
      rows_(saddle_rows(task, level)) {
  // Jumps cost some hundred times what they cost in a node's own stiffness: what is continuous hardly feels
  // them, and all eigenvalues of jumps and multipliers are near (1 +- sqrt 5) / 2. More would save
  // iterations, but the error that round-off leaves grows with the square root.
  constexpr double weight = 100;
  const NodeClasses& classes = task.classes;
  const auto nodes = static_cast<int>(classes.class_of.size());
  int ties = nodes;
  for (int c = 0; c < classes.count(); ++c) {
    first_tie_.push_back(ties);
    ties += static_cast<int>(classes.of(c).size()) - 1;
  }
  std::vector<Index> local(static_cast<std::size_t>(ties), -1);
  for (int row = 0; row < rows_.local_rows(); ++row)
    local[static_cast<std::size_t>(rows_.global_of_local()[static_cast<std::size_t>(row)])] = row;
  std::vector<int> class_rows(static_cast<std::size_t>(classes.count()), -1);
  for (int row = 0; row < level.rows.local_rows(); ++row) {
    const int c = level.rows.global_of_local()[static_cast<std::size_t>(row)];
    class_rows[static_cast<std::size_t>(c)] = row;
    const auto members = classes.of(c);
    if (members.size() < 2) continue;
    TiedClass& tied = tied_.emplace_back();
    for (const int node : members) tied.nodes.push_back(local[static_cast<std::size_t>(node)]);
    tied.first_tie = local[static_cast<std::size_t>(first_tie_[static_cast<std::size_t>(c)])];
    tied.free = task.frames[static_cast<std::size_t>(c)].free;
    tied.jump_stiffness = weight * diagonal[static_cast<std::size_t>(row)].trace() /
                          (3.0 * static_cast<double>(members.size()));
  }
  for (int node = 0; node < nodes; ++node) {
    if (local[static_cast<std::size_t>(node)] < 0) continue;
    const auto c = static_cast<std::size_t>(classes.class_of[static_cast<std::size_t>(node)]);
    nodes_.push_back({node, class_rows[c], &task.frames[c]});
  }
}

// Sums over processes the forces that each has at its nodes.
VectorXd SaddlePoint::along_axes(const Eigen::Matrix3Xd& forces) const {
  VectorXd result = VectorXd::Zero(3 * static_cast<Index>(rows_.local_rows()));
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const SupportFrame& f = *nodes_[i].frame;
    result.segment(3 * static_cast<Index>(i), f.free) =
        f.axes.leftCols(f.free).transpose() * forces.col(nodes_[i].node);
  }
  rows_.sum(result);
  return result;
}

VectorXd SaddlePoint::product(const VectorXd& z) const {
  Eigen::Matrix3Xd u = Eigen::Matrix3Xd::Zero(3, static_cast<Index>(task_->classes.class_of.size()));
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const SupportFrame& f = *nodes_[i].frame;
    u.col(nodes_[i].node) = f.axes.leftCols(f.free) * z.segment(3 * static_cast<Index>(i), f.free);
  }
  VectorXd result = along_axes(stiffness_.apply(u));
  for (const TiedClass& tied : tied_) {
    const double g = tied.jump_stiffness;
    const Eigen::Vector3d mean = mean_of(tied.nodes, z);
    const Index first = 3 * tied.nodes[0];
    for (std::size_t i = 0; i < tied.nodes.size(); ++i) {
      const Index row = 3 * tied.nodes[i];
      result.segment(row, tied.free) += g * (z.segment(row, tied.free) - mean.head(tied.free));
      if (i == 0) continue;
      const Index tie = 3 * (tied.first_tie + static_cast<Index>(i) - 1);
      result.segment(tie, tied.free) = z.segment(first, tied.free) - z.segment(row, tied.free);
      result.segment(first, tied.free) += z.segment(tie, tied.free);
      result.segment(row, tied.free) -= z.segment(tie, tied.free);
    }
  }
  return result;
}

VectorXd SaddlePoint::preconditioned(const VectorXd& r) const {
  VectorXd sum = VectorXd::Zero(3 * static_cast<Index>(level_->rows.local_rows()));
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    sum.segment<3>(3 * static_cast<Index>(nodes_[i].class_row)) += r.segment<3>(3 * static_cast<Index>(i));
  const VectorXd continuous = multigrid_->apply(sum);
  VectorXd result = VectorXd::Zero(r.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    result.segment<3>(3 * static_cast<Index>(i)) =
        continuous.segment<3>(3 * static_cast<Index>(nodes_[i].class_row));
  for (const TiedClass& tied : tied_) {
    const Eigen::Vector3d mean = mean_of(tied.nodes, r);
    for (const Index node : tied.nodes)
      result.segment<3>(3 * node) += (r.segment<3>(3 * node) - mean) / tied.jump_stiffness;
    add_tie_inverse(tied, r, result);
  }
  return result;
}

// out += g (B B^T)^-1 in on the ties of one class: (I + 1 1^T)^-1 = I - 1 1^T / nodes.
void SaddlePoint::add_tie_inverse(const TiedClass& tied, const VectorXd& in, VectorXd& out) const {
  const auto count = static_cast<Index>(tied.nodes.size()) - 1;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (Index i = 0; i < count; ++i) mean += in.segment<3>(3 * (tied.first_tie + i));
  mean /= static_cast<double>(count + 1);
  for (Index i = 0; i < count; ++i)
    out.segment<3>(3 * (tied.first_tie + i)) +=
        tied.jump_stiffness * (in.segment<3>(3 * (tied.first_tie + i)) - mean);
}

VectorXd SaddlePoint::load() const {
  VectorXd result = VectorXd::Zero(3 * static_cast<Index>(rows_.local_rows()));
  Eigen::Matrix3Xd prescribed = Eigen::Matrix3Xd::Zero(3, task_->load.cols());
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const auto& [node, row, frame] = nodes_[i];
    prescribed.col(node) = frame->prescribed;
    // Every process has the loads of all nodes.
    result.segment(3 * static_cast<Index>(i), frame->free) =
        frame->axes.leftCols(frame->free).transpose() * task_->load.col(node);
  }
  return result - along_axes(stiffness_.apply(prescribed));
}

Eigen::Matrix3Xd SaddlePoint::displacement(const VectorXd& z) const {
  const VectorXd whole = rows_.whole(z);
  Eigen::Matrix3Xd u(3, static_cast<Index>(task_->classes.class_of.size()));
  for (Index node = 0; node < u.cols(); ++node) {
    const SupportFrame& f =
        task_->frames[static_cast<std::size_t>(task_->classes.class_of[static_cast<std::size_t>(node)])];
    u.col(node) = f.prescribed + f.axes.leftCols(f.free) * whole.segment(3 * node, f.free);
  }
  return u;
}

VectorXd SaddlePoint::multipliers(const VectorXd& z) const {
  VectorXd forces = z;
  VectorXd jumps = VectorXd::Zero(z.size());
  for (const TiedClass& tied : tied_) {
    for (std::size_t i = 1; i < tied.nodes.size(); ++i)
      jumps.segment<3>(3 * (tied.first_tie + static_cast<Index>(i) - 1)) =
          z.segment<3>(3 * tied.nodes[0]) - z.segment<3>(3 * tied.nodes[i]);
    add_tie_inverse(tied, jumps, forces);
  }
  const VectorXd whole = rows_.whole(forces);
  VectorXd result(static_cast<Index>(task_->multipliers.size()));
  for (std::size_t r = 0; r < task_->multipliers.size(); ++r) {
    const MultiplierRow& row = task_->multipliers[r];
    const auto members = task_->classes.of(row.node_class);
    const Index place = std::find(members.begin(), members.end(), row.second) - members.begin();
    const Index tie = first_tie_[static_cast<std::size_t>(row.node_class)] + place - 1;
    result[static_cast<Index>(r)] = whole[3 * tie + row.axis];
  }
  return result;
}

}  // namespace isopatch::iga
