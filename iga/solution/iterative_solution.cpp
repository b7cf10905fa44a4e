#include "iga/solution/iterative_solution.hpp"

#include "geometry/base/stopwatch.hpp"
#include "iga/assembly/assembly.hpp"
#include "iga/assembly/surface_stiffness.hpp"
#include "iga/multigrid/elasticity_multigrid.hpp"
#include "iga/multigrid/level_operator.hpp"
#include "iga/solution/level_vectors.hpp"
#include "solvers/block_product.hpp"
#include "solvers/load_sequence.hpp"
#include "solvers/operator_system.hpp"

namespace isopatch::iga {
namespace {

solvers::SymmetricBlockMatrix assembled(const Level& level, const CoupledProblem& coupled,
                                        const Progress& progress) {
  const RowNumbering numbering{level.row_of_node, level.rows.local_rows()};
  solvers::SymmetricBlockMatrix matrix = assemble_stiffness(
      level.spaces, level.parts, coupled.problem->materials, numbering, coupled.points, progress);
  surface_stiffness(level.spaces, level.parts, coupled.surfaces()).add_to(matrix, numbering);
  apply_supports(matrix, level.free, level.rows);
  return matrix;
}

}  // namespace

std::vector<DiscreteSolution> solve_eliminated(const CoupledProblem& coupled,
                                               const solvers::SolverOptions& options,
                                               const Progress& progress) {
  const bool is_assembled = options.form == solvers::Operator::assembled;
  Stopwatch watch;
  const Level level =
      finest_level(coupled.spaces, coupled.global, coupled.frames, coupled.distribution, coupled.processes);
  const LevelOperator stiffness(level, coupled.problem->materials, coupled.points, coupled.surfaces());
  solvers::OperatorSystem system;
  system.rows = level.rows;
  solvers::SymmetricBlockMatrix matrix;
  if (is_assembled) {
    matrix = assembled(level, coupled, progress);
    system.product = [&](const Eigen::VectorXd& x) {
      Eigen::VectorXd y = multiply(matrix, x);
      level.rows.sum(y);
      return y;
    };
  } else {
    system.product = {[&](const Eigen::VectorXd& x) { return stiffness.apply(x); },
                      [&](const Eigen::MatrixXd& x) { return stiffness.apply_each(x); }};
  }
  system.costs.assembly_seconds = watch.lap();
  const ElasticityMultigrid multigrid(*coupled.problem, level, coupled.frames, coupled.distribution,
                                      coupled.processes,
                                      is_assembled ? system.product : solvers::VectorsOperator(),
                                      {options.multigrid, coupled.points}, progress);
  system.preconditioner = {[&](const Eigen::VectorXd& r) { return multigrid.apply(r); },
                           [&](const Eigen::MatrixXd& r) { return multigrid.apply_each(r); }};
  system.costs.setup_seconds = watch.lap();
  system.costs.form = options.form;
  system.costs.levels = multigrid.levels();
  system.costs.bytes = multigrid.bytes();
  if (is_assembled) {
    system.costs.matrix_nonzeros = matrix.nonzeros();
    system.costs.bytes += matrix.bytes();
  }
  std::vector<Eigen::VectorXd> prescribed, loads;
  for (const RightSide& side : coupled.right_sides) {
    prescribed.push_back(prescribed_rows(level, side.prescribed));
    loads.push_back(free_load(level, stiffness, side.load, prescribed.back()));
  }
  solvers::LoadSequence sequence(system, solvers::KrylovMethod::cg);
  std::vector<solvers::LinearSolution> solved = sequence.solve_all(loads, options, progress);
  std::vector<DiscreteSolution> result;
  for (std::size_t i = 0; i < solved.size(); ++i) {
    const Eigen::VectorXd of_rows = prescribed[i] + level.free.to_space(std::move(solved[i].x));
    result.push_back({whole_at_nodes(level, level.rows.whole(of_rows)), {}, std::move(solved[i].report)});
  }
  return result;
}

}  // namespace isopatch::iga
