#include "iga/solution/assembled_system.hpp"

#include <numeric>

#include "iga/distribution/shared_multipliers.hpp"

namespace isopatch::iga {
namespace {

// Which block row each node has, and the frame of each row.
void number_rows(const SolutionTask& task, AssembledSystem& result) {
  const NodeClasses& classes = task.classes;
  if (task.coupling == Coupling::elimination) {
    result.numbering = {classes.class_of, classes.count()};
    for (const SupportFrame& frame : task.frames) result.frame_of_row.push_back(&frame);
  } else {
    result.numbering.rows = static_cast<int>(classes.class_of.size());
    result.numbering.row_of_node.resize(classes.class_of.size());
    std::iota(result.numbering.row_of_node.begin(), result.numbering.row_of_node.end(), 0);
    for (const int c : classes.class_of)
      result.frame_of_row.push_back(&task.frames[static_cast<std::size_t>(c)]);
  }
}

// The frames of this process' rows.
std::vector<const SupportFrame*> frames_of(const solvers::SharedRows& rows,
                                           const std::vector<const SupportFrame*>& whole) {
  std::vector<const SupportFrame*> result;
  for (const int row : rows.global_of_local()) result.push_back(whole[static_cast<std::size_t>(row)]);
  return result;
}

Eigen::VectorXd load_of_rows(const Eigen::Matrix3Xd& load, const RowNumbering& numbering) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(3 * static_cast<Eigen::Index>(numbering.rows));
  for (Eigen::Index node = 0; node < load.cols(); ++node)
    result.segment<3>(3 * static_cast<Eigen::Index>(numbering.row_of_node[static_cast<std::size_t>(node)])) +=
        load.col(node);
  return result;
}

}  // namespace

AssembledSystem assembled_system(const SolutionTask& task, const Progress& progress) {
  AssembledSystem result;
  number_rows(task, result);
  const Discretization& d = task.problem.discretization;
  const std::vector<PatchSpace> spaces = isoparametric_spaces(d);
  const std::vector<PatchPart> parts = parts_of(task.distribution, spaces, task.processes.rank());
  const LocalRows local = local_rows(result.numbering, d.first_node, task.distribution, task.processes);
  solvers::LinearSystem& system = result.system;
  system.rows = local.rows;
  system.stiffness =
      assemble_stiffness(spaces, parts, task.problem.materials, local.numbering, task.points, progress);
  system.load = local.rows.part(load_of_rows(task.load, result.numbering));
  apply_supports(system, frames_of(local.rows, result.frame_of_row));
  if (task.coupling == Coupling::lagrange) {
    SharedMultipliers multipliers =
        shared_multipliers(task.multipliers, local, d.first_node, task.distribution);
    system.constraints = std::move(multipliers.matrix);
    system.multiplier_rows = std::move(multipliers.rows);
  }
  return result;
}

}  // namespace isopatch::iga
