#include "iga/solution/saddle_point.hpp"

#include <algorithm>

#include "iga/assembly/surface_stiffness.hpp"

namespace isopatch::iga {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// Nodes in the order of all patches, then ties global node by global node.
solvers::SharedRows saddle_rows(const CoupledProblem& coupled, const Level& level) {
  const std::vector<int>& global_of = coupled.global.global_of;
  if (!level.rows.is_distributed())
    return solvers::SharedRows(static_cast<int>(2 * global_of.size()) - coupled.global.count());
  const auto of_global =
      processes_of_rows({global_of, coupled.global.count()}, level.first_node, coupled.distribution);
  std::vector<std::vector<int>> of_row;
  for (const int c : global_of) of_row.push_back(of_global[static_cast<std::size_t>(c)]);
  for (int c = 0; c < coupled.global.count(); ++c)
    of_row.insert(of_row.end(), coupled.global.nodes_of(c).size() - 1,
                  of_global[static_cast<std::size_t>(c)]);
  return solvers::SharedRows(of_row, coupled.processes);
}

}  // namespace

SaddlePoint::SaddlePoint(const CoupledProblem& coupled, const Level& level,
                         const ElasticityMultigrid& multigrid, const std::vector<Eigen::Matrix3d>& diagonal)
    : coupled_(&coupled),
      level_(&level),
      multigrid_(&multigrid),
      stiffness_(level.spaces, level.parts, coupled.problem->materials, coupled.points),
      surfaces_(surface_stiffness(level.spaces, level.parts, surface_terms(*coupled.problem))),
      rows_(saddle_rows(coupled, level)) {
  // Jumps cost a million times what they cost in a node's own stiffness: what is continuous does not feel
  // them, and all eigenvalues of jumps and multipliers are near (1 +- sqrt 5) / 2.
  constexpr double weight = 1e6;
  const GlobalNodes& global = coupled.global;
  const auto nodes = static_cast<int>(global.global_of.size());
  int ties = nodes;
  for (int c = 0; c < global.count(); ++c) {
    first_tie_.push_back(ties);
    ties += static_cast<int>(global.nodes_of(c).size()) - 1;
  }
  std::vector<Index> local(static_cast<std::size_t>(ties), -1);
  for (int row = 0; row < rows_.local_rows(); ++row)
    local[static_cast<std::size_t>(rows_.global_of_local()[static_cast<std::size_t>(row)])] = row;
  std::vector<int> row_of_global(static_cast<std::size_t>(global.count()), -1);
  for (int row = 0; row < level.rows.local_rows(); ++row) {
    const int c = level.rows.global_of_local()[static_cast<std::size_t>(row)];
    row_of_global[static_cast<std::size_t>(c)] = row;
    const auto members = global.nodes_of(c);
    if (members.size() < 2) continue;
    TiedNodes& tied = tied_.emplace_back();
    for (const int node : members) tied.nodes.push_back(local[static_cast<std::size_t>(node)]);
    tied.first_tie = local[static_cast<std::size_t>(first_tie_[static_cast<std::size_t>(c)])];
    tied.free = coupled.frames[static_cast<std::size_t>(c)].free;
    tied.jump_stiffness = weight * diagonal[static_cast<std::size_t>(row)].trace() /
                          (3.0 * static_cast<double>(members.size()));
  }
  for (int node = 0; node < nodes; ++node) {
    if (local[static_cast<std::size_t>(node)] < 0) continue;
    const auto c = static_cast<std::size_t>(global.global_of[static_cast<std::size_t>(node)]);
    nodes_.push_back(
        {node, row_of_global[c], global.nodes_of(static_cast<int>(c)).front() == node, &coupled.frames[c]});
  }
}

// The value of the first of tied nodes moves them all: the sum of their forces acts on it.
void SaddlePoint::move_all_by_first(VectorXd& forces) const {
  for (const TiedNodes& tied : tied_) forces.segment<3>(3 * tied.nodes[0]) += sum_of_jumps(tied, forces);
}

// What forces at the nodes do along the unknowns, summed over processes.
VectorXd SaddlePoint::on_unknowns(const Eigen::Matrix3Xd& forces) const {
  VectorXd result = VectorXd::Zero(3 * static_cast<Index>(rows_.local_rows()));
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const SupportFrame& f = *nodes_[i].frame;
    result.segment(3 * static_cast<Index>(i), f.free) =
        f.axes.leftCols(f.free).transpose() * forces.col(nodes_[i].node);
  }
  rows_.sum(result);
  move_all_by_first(result);
  return result;
}

// The values of nodes, in place of the jumps of tied ones.
VectorXd SaddlePoint::values_of(VectorXd z) const {
  for (const TiedNodes& tied : tied_)
    for (std::size_t i = 1; i < tied.nodes.size(); ++i)
      z.segment<3>(3 * tied.nodes[i]) += z.segment<3>(3 * tied.nodes[0]);
  return z;
}

Eigen::Matrix3Xd SaddlePoint::forces_of(const Eigen::Matrix3Xd& displacement) const {
  Eigen::Matrix3Xd forces = stiffness_.apply(displacement);
  surfaces_.add_forces(displacement, forces);
  return forces;
}

VectorXd SaddlePoint::product(const VectorXd& z) const {
  const VectorXd values = values_of(z);
  Eigen::Matrix3Xd u = Eigen::Matrix3Xd::Zero(3, static_cast<Index>(coupled_->global.global_of.size()));
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const SupportFrame& f = *nodes_[i].frame;
    u.col(nodes_[i].node) = f.axes.leftCols(f.free) * values.segment(3 * static_cast<Index>(i), f.free);
  }
  VectorXd result = on_unknowns(forces_of(u));
  for (const TiedNodes& tied : tied_) {
    const Eigen::Vector3d share = sum_of_jumps(tied, z) / static_cast<double>(tied.nodes.size());
    for (std::size_t i = 1; i < tied.nodes.size(); ++i) {
      const Index row = 3 * tied.nodes[i];
      const Index tie = 3 * (tied.first_tie + static_cast<Index>(i) - 1);
      result.segment(row, tied.free) +=
          tied.jump_stiffness * (z.segment(row, tied.free) - share.head(tied.free)) -
          z.segment(tie, tied.free);
      result.segment(tie, tied.free) = -z.segment(row, tied.free);
    }
  }
  return result;
}

VectorXd SaddlePoint::preconditioned(const VectorXd& r) const {
  VectorXd of_rows = VectorXd::Zero(3 * static_cast<Index>(level_->rows.local_rows()));
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i].is_first)
      of_rows.segment<3>(3 * static_cast<Index>(nodes_[i].row_of_global)) =
          r.segment<3>(3 * static_cast<Index>(i));
  const VectorXd continuous = multigrid_->apply(of_rows);
  VectorXd result = VectorXd::Zero(r.size());
  for (std::size_t i = 0; i < nodes_.size(); ++i)
    if (nodes_[i].is_first)
      result.segment<3>(3 * static_cast<Index>(i)) =
          continuous.segment<3>(3 * static_cast<Index>(nodes_[i].row_of_global));
  for (const TiedNodes& tied : tied_) {
    // The jumps' (I - 1 1^T / nodes)^-1 = I + 1 1^T.
    const Eigen::Vector3d sum = sum_of_jumps(tied, r);
    for (std::size_t i = 1; i < tied.nodes.size(); ++i)
      result.segment<3>(3 * tied.nodes[i]) = (r.segment<3>(3 * tied.nodes[i]) + sum) / tied.jump_stiffness;
    add_tie_inverse(tied, r, result);
  }
  return result;
}

// Of all tied nodes but the first, whose jump is none.
Eigen::Vector3d SaddlePoint::sum_of_jumps(const TiedNodes& tied, const VectorXd& z) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::size_t i = 1; i < tied.nodes.size(); ++i) sum += z.segment<3>(3 * tied.nodes[i]);
  return sum;
}

// out += g (B B^T)^-1 in on the ties of one global node: (I + 1 1^T)^-1 = I - 1 1^T / nodes.
void SaddlePoint::add_tie_inverse(const TiedNodes& tied, const VectorXd& in, VectorXd& out) const {
  const auto count = static_cast<Index>(tied.nodes.size()) - 1;
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (Index i = 0; i < count; ++i) mean += in.segment<3>(3 * (tied.first_tie + i));
  mean /= static_cast<double>(count + 1);
  for (Index i = 0; i < count; ++i)
    out.segment<3>(3 * (tied.first_tie + i)) +=
        tied.jump_stiffness * (in.segment<3>(3 * (tied.first_tie + i)) - mean);
}

VectorXd SaddlePoint::load(const RightSide& side) const {
  VectorXd result = VectorXd::Zero(3 * static_cast<Index>(rows_.local_rows()));
  Eigen::Matrix3Xd prescribed = Eigen::Matrix3Xd::Zero(3, side.load.cols());
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const auto& [node, row, is_first, frame] = nodes_[i];
    prescribed.col(node) = side.prescribed.col(coupled_->global.global_of[static_cast<std::size_t>(node)]);
    // Every process has the loads of all nodes.
    result.segment(3 * static_cast<Index>(i), frame->free) =
        frame->axes.leftCols(frame->free).transpose() * side.load.col(node);
  }
  move_all_by_first(result);
  return result - on_unknowns(forces_of(prescribed));
}

Eigen::Matrix3Xd SaddlePoint::displacement(const VectorXd& z, const RightSide& side) const {
  const VectorXd whole = rows_.whole(values_of(z));
  Eigen::Matrix3Xd u(3, static_cast<Index>(coupled_->global.global_of.size()));
  for (Index node = 0; node < u.cols(); ++node) {
    const SupportFrame& f = coupled_->frame_of(static_cast<int>(node));
    u.col(node) = side.prescribed.col(coupled_->global.global_of[static_cast<std::size_t>(node)]) +
                  f.axes.leftCols(f.free) * whole.segment(3 * node, f.free);
  }
  return u;
}

VectorXd SaddlePoint::multipliers(const VectorXd& z) const {
  VectorXd forces = z;
  VectorXd jumps = VectorXd::Zero(z.size());
  for (const TiedNodes& tied : tied_) {
    for (std::size_t i = 1; i < tied.nodes.size(); ++i)
      jumps.segment<3>(3 * (tied.first_tie + static_cast<Index>(i) - 1)) = -z.segment<3>(3 * tied.nodes[i]);
    add_tie_inverse(tied, jumps, forces);
  }
  const VectorXd whole = rows_.whole(forces);
  VectorXd result(static_cast<Index>(coupled_->multipliers.size()));
  for (std::size_t r = 0; r < coupled_->multipliers.size(); ++r) {
    const MultiplierRow& row = coupled_->multipliers[r];
    const auto members = coupled_->global.nodes_of(row.global_node);
    const Index place = std::find(members.begin(), members.end(), row.second) - members.begin();
    const Index tie = first_tie_[static_cast<std::size_t>(row.global_node)] + place - 1;
    result[static_cast<Index>(r)] = whole[3 * tie + row.axis];
  }
  return result;
}

}  // namespace isopatch::iga
