#include "iga/solution/mortar_iteration.hpp"

#include <Eigen/SparseCholesky>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/base/stopwatch.hpp"
#include "iga/multigrid/elasticity_multigrid.hpp"
#include "iga/multigrid/level_operator.hpp"
#include "iga/solution/level_vectors.hpp"
#include "solvers/load_sequence.hpp"
#include "solvers/operator_system.hpp"

namespace isopatch::iga {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

VectorXd joined(const VectorXd& x, const VectorXd& y) {
  VectorXd z(x.size() + y.size());
  z << x, y;
  return z;
}

}  // namespace

std::vector<DiscreteSolution> solve_with_mortar(const CoupledProblem& coupled,
                                                const solvers::SolverOptions& options,
                                                const Progress& progress) {
  Stopwatch watch;
  const MortarConstraints& mortar = coupled.mortar;
  const Level level =
      finest_level(coupled.spaces, coupled.global, coupled.frames, coupled.distribution, coupled.processes);
  const LevelOperator stiffness(level, coupled.problem->materials, coupled.points, coupled.surfaces());
  const ElasticityMultigrid multigrid(*coupled.problem, level, coupled.frames, coupled.distribution,
                                      coupled.processes, {}, {options.multigrid, coupled.points}, progress);
  const RowNumbering numbering{level.row_of_node, level.rows.local_rows()};
  const std::vector<SupportFrame> frames = level.free.frames(numbering.rows);
  std::vector<const SupportFrame*> frame_of_row;
  for (const SupportFrame& frame : frames) frame_of_row.push_back(&frame);
  const solvers::ConstraintMatrix b = mortar_matrix(mortar, numbering, frame_of_row);
  const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> compliance(mortar.compliance);
  if (compliance.info() != Eigen::Success)
    throw Error(ErrorCode::singular_system, "multipliers between faces that do not match are no basis");
  const Index displacements = b.cols(), multipliers = b.rows();
  solvers::OperatorSystem system;
  system.rows = solvers::SharedRows(numbering.rows + mortar.functions());
  system.product = [&](const VectorXd& z) {
    const VectorXd x = z.head(displacements), y = z.tail(multipliers);
    return joined(stiffness.apply(x) + b.transpose() * y, b * x);
  };
  system.preconditioner = [&](const VectorXd& r) {
    return joined(multigrid.apply(r.head(displacements)), compliance.solve(r.tail(multipliers)));
  };
  system.costs = {.levels = multigrid.levels(), .bytes = multigrid.bytes(), .setup_seconds = watch.lap()};
  solvers::LoadSequence sequence(system, solvers::KrylovMethod::minres);
  std::vector<DiscreteSolution> result;
  for (const RightSide& side : coupled.right_sides) {
    const VectorXd prescribed = prescribed_rows(level, side.prescribed);
    const VectorXd load = joined(free_load(level, stiffness, side.load, prescribed),
                                 mortar_right_side(mortar, numbering, prescribed));
    solvers::LinearSolution solved = sequence.solve(load, options, progress);
    const VectorXd of_rows = prescribed + level.free.to_space(solved.x.head(displacements));
    DiscreteSolution& solution = result.emplace_back(
        DiscreteSolution{whole_at_nodes(level, of_rows), {}, std::move(solved.report), {}});
    solution.mortar = solved.x.tail(multipliers);
  }
  return result;
}

}  // namespace isopatch::iga
