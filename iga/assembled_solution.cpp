#include <numeric>

#include "iga/assembly.hpp"
#include "iga/nodal_solution.hpp"
#include "iga/shared_multipliers.hpp"
#include "solvers/stopwatch.hpp"

namespace isopatch::iga {
namespace {

// The unknowns of one coupling: which block row each node has, and the frame of each row.
struct Unknowns {
  RowNumbering numbering;
  std::vector<const Frame*> frame_of_row;
};

Unknowns unknowns(const SolutionTask& task) {
  Unknowns result;
  const NodeClasses& classes = task.classes;
  if (task.coupling == Coupling::elimination) {
    result.numbering = {classes.class_of, classes.count()};
    for (const Frame& frame : task.frames) result.frame_of_row.push_back(&frame);
  } else {
    result.numbering.rows = static_cast<int>(classes.class_of.size());
    result.numbering.row_of_node.resize(classes.class_of.size());
    std::iota(result.numbering.row_of_node.begin(), result.numbering.row_of_node.end(), 0);
    for (const int c : classes.class_of)
      result.frame_of_row.push_back(&task.frames[static_cast<std::size_t>(c)]);
  }
  return result;
}

// The frames of this process' rows.
std::vector<const Frame*> frames_of(const solvers::SharedRows& rows, const std::vector<const Frame*>& whole) {
  std::vector<const Frame*> result;
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

NodalSolution solve_assembled(const SolutionTask& task, const solvers::SolverOptions& options,
                              const Progress& progress) {
  const Discretization& d = task.problem.discretization;
  solvers::Stopwatch watch;
  const Unknowns unknown = unknowns(task);
  const std::vector<PatchSpace> spaces = isoparametric_spaces(d);
  const std::vector<PatchPart> parts = parts_of(task.distribution, spaces, task.processes.rank());
  const LocalRows local = local_rows(unknown.numbering, d.first_node, task.distribution, task.processes);

  solvers::LinearSystem system;
  system.rows = local.rows;
  system.stiffness =
      assemble_stiffness(spaces, parts, task.problem.materials, local.numbering, task.points, progress);
  system.load = local.rows.part(load_of_rows(task.load, unknown.numbering));
  apply_supports(system, frames_of(local.rows, unknown.frame_of_row));
  const bool tied = task.coupling == Coupling::lagrange;
  if (tied) {
    SharedMultipliers multipliers =
        shared_multipliers(task.multipliers, local, d.first_node, task.distribution);
    system.constraints = std::move(multipliers.matrix);
    system.multiplier_rows = std::move(multipliers.rows);
  }
  const double assembly_seconds = watch.lap();

  solvers::LinearSolution linear = solvers::solve(system, options, progress);
  NodalSolution result;
  result.report = std::move(linear.report);
  result.report.assembly_seconds = assembly_seconds;
  if (tied) result.multipliers = system.multiplier_rows.whole(linear.multipliers);
  const Eigen::Matrix3Xd of_rows = displacement_of_rows(local.rows.whole(linear.x), unknown.frame_of_row);
  result.displacement.resize(3, d.node_count());
  for (Eigen::Index node = 0; node < result.displacement.cols(); ++node)
    result.displacement.col(node) =
        of_rows.col(unknown.numbering.row_of_node[static_cast<std::size_t>(node)]);
  return result;
}

}  // namespace isopatch::iga
