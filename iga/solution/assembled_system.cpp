#include "iga/solution/assembled_system.hpp"

#include <numeric>
#include <utility>

#include "geometry/base/stopwatch.hpp"
#include "iga/assembly/assembly.hpp"
#include "iga/assembly/surface_stiffness.hpp"
#include "iga/distribution/shared_multipliers.hpp"
#include "iga/solution/mortar_share.hpp"

namespace isopatch::iga {
namespace {

// Which block row each node has, and the frame of each row.
void number_rows(const CoupledProblem& coupled, AssembledSystem& result) {
  const GlobalNodes& global = coupled.global;
  if (coupled.coupling == Coupling::elimination) {
    result.numbering = {global.global_of, global.count()};
    for (const SupportFrame& frame : coupled.frames) result.frame_of_row.push_back(&frame);
  } else {
    result.numbering.rows = static_cast<int>(global.global_of.size());
    result.numbering.row_of_node.resize(global.global_of.size());
    std::iota(result.numbering.row_of_node.begin(), result.numbering.row_of_node.end(), 0);
    for (const int c : global.global_of)
      result.frame_of_row.push_back(&coupled.frames[static_cast<std::size_t>(c)]);
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

Eigen::VectorXd prescribed_of_rows(const Eigen::Matrix3Xd& of_globals, const CoupledProblem& coupled) {
  if (coupled.coupling == Coupling::elimination) return of_globals.reshaped();
  Eigen::Matrix3Xd result(3, static_cast<Eigen::Index>(coupled.global.global_of.size()));
  for (Eigen::Index node = 0; node < result.cols(); ++node)
    result.col(node) = of_globals.col(coupled.global.global_of[static_cast<std::size_t>(node)]);
  return result.reshaped();
}

// Both one below the other.
solvers::ConstraintMatrix stacked(const solvers::ConstraintMatrix& above,
                                  const solvers::ConstraintMatrix& below) {
  solvers::ConstraintMatrix result(above.rows() + below.rows(), below.cols());
  result.reserve(above.nonZeros() + below.nonZeros());
  if (above.rows() > 0) result.topRows(above.rows()) = above;
  result.bottomRows(below.rows()) = below;
  return result;
}

// The rows of faces that do not match, behind those of nodes that are one.
// @param local             the rows of this process
// @param processes_of_row  of all constraints; those of the ties so far
void add_mortar(const CoupledProblem& coupled, const LocalRows& local, AssembledSystem& assembled,
                std::vector<std::vector<int>>& processes_of_row) {
  solvers::LinearSystem& system = assembled.system;
  const MortarShare share = mortar_share(coupled.mortar, coupled.parts);
  const Eigen::Index ties = system.constraints.rows();
  system.constraints = stacked(
      system.constraints,
      mortar_matrix(share.constraints, local.numbering, frames_of(local.rows, assembled.frame_of_row)));
  for (const int process : processes_of_mortar(coupled.mortar, coupled.distribution))
    processes_of_row.push_back({process});
  for (std::size_t i = 0; i < assembled.loads.size(); ++i) {
    const Eigen::VectorXd jumps =
        mortar_right_side(share.constraints, local.numbering, local.rows.part(assembled.prescribed[i]));
    if (jumps.isZero(0)) continue;
    Eigen::VectorXd both = Eigen::VectorXd::Zero(assembled.loads[i].size() + ties + jumps.size());
    both.head(assembled.loads[i].size()) = assembled.loads[i];
    both.tail(jumps.size()) = jumps;
    assembled.loads[i] = std::move(both);
  }
  system.load = assembled.loads.front();
}

}  // namespace

AssembledSystem assembled_system(const CoupledProblem& coupled, const Progress& progress) {
  Stopwatch watch;
  AssembledSystem result;
  number_rows(coupled, result);
  const std::vector<int>& first_node = coupled.discretization().first_node;
  const LocalRows local = local_rows(result.numbering, first_node, coupled.distribution, coupled.processes);
  solvers::LinearSystem& system = result.system;
  system.rows = local.rows;
  system.stiffness = assemble_stiffness(coupled.spaces, coupled.parts, coupled.problem->materials,
                                        local.numbering, coupled.points, progress);
  surface_stiffness(coupled.spaces, coupled.parts, coupled.surfaces())
      .add_to(system.stiffness, local.numbering);
  std::vector<LoadOfRows> loads;
  for (const RightSide& side : coupled.right_sides) {
    result.prescribed.push_back(prescribed_of_rows(side.prescribed, coupled));
    loads.push_back({local.rows.part(load_of_rows(side.load, result.numbering)),
                     local.rows.part(result.prescribed.back())});
  }
  apply_supports(system.stiffness, system.rows, frames_of(local.rows, result.frame_of_row), loads);
  for (LoadOfRows& load : loads) result.loads.push_back(std::move(load.load));
  system.load = result.loads.front();
  std::vector<std::vector<int>> processes_of_row;  // of constraints
  if (coupled.coupling == Coupling::lagrange) {
    SharedMultipliers multipliers =
        shared_multipliers(coupled.multipliers, local, first_node, coupled.distribution);
    system.constraints = std::move(multipliers.matrix);
    processes_of_row = std::move(multipliers.processes_of_row);
  } else {
    system.constraints.resize(0, 3 * Eigen::Index{local.rows.local_rows()});
  }
  if (!coupled.mortar.empty()) add_mortar(coupled, local, result, processes_of_row);
  if (coupled.processes.count() > 1)
    system.multiplier_rows = solvers::SharedRows(processes_of_row, coupled.processes, 1);
  system.assembly_seconds = watch.lap();
  return result;
}

}  // namespace isopatch::iga
