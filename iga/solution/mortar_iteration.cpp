#include "iga/solution/mortar_iteration.hpp"

#include <utility>

#include "geometry/base/stopwatch.hpp"
#include "iga/multigrid/elasticity_multigrid.hpp"
#include "iga/multigrid/level_operator.hpp"
#include "iga/solution/level_vectors.hpp"
#include "iga/solution/mortar_projection.hpp"
#include "iga/solution/mortar_share.hpp"
#include "solvers/load_sequence.hpp"
#include "solvers/operator_system.hpp"

namespace isopatch::iga {
namespace {

using Eigen::VectorXd;

// Parts refer to each other, so it stays where it is.
struct MortarSystem {
  MortarSystem(const CoupledProblem& of, const solvers::MultigridOptions& smoothing, const Progress& progress)
      : coupled(of),
        level(finest_level(of.spaces, of.global, of.frames, of.distribution, of.processes)),
        stiffness(level, of.problem->materials, of.points, of.surfaces()),
        multigrid(*of.problem, level, of.frames, of.distribution, of.processes, {},
                  {.smoothing = smoothing, .points = of.points, .mortar = of.mortar.ties}, progress),
        frames(level.free.frames(level.rows.local_rows())),
        share(mortar_share(of.mortar, level.parts)) {
    for (const SupportFrame& frame : frames) frame_of_row.push_back(&frame);
    b = mortar_matrix(share.constraints, {level.row_of_node, level.rows.local_rows()}, frame_of_row);
  }
  MortarSystem(const MortarSystem&) = delete;

  // Forces on the unknowns, and what this process' B x must be.
  struct Sides {
    VectorXd prescribed, load, jump;
  };
  Sides sides(const RightSide& side) const {
    Sides result;
    result.prescribed = prescribed_rows(level, side.prescribed);
    result.load = free_load(level, stiffness, side.load, result.prescribed);
    result.jump =
        mortar_right_side(share.constraints, {level.row_of_node, level.rows.local_rows()}, result.prescribed);
    return result;
  }
  // @param multipliers  of this process
  DiscreteSolution solution(const Sides& sides, const VectorXd& x, const VectorXd& multipliers,
                            solvers::SolveReport report) const {
    const VectorXd of_rows = sides.prescribed + level.free.to_space(x);
    return {whole_at_nodes(level, level.rows.whole(of_rows)),
            {},
            std::move(report),
            whole_mortar(share, multipliers, coupled.mortar.rows(), coupled.processes)};
  }

  const CoupledProblem& coupled;
  Level level;
  LevelOperator stiffness;
  ElasticityMultigrid multigrid;
  std::vector<SupportFrame> frames;
  std::vector<const SupportFrame*> frame_of_row;
  MortarShare share;
  solvers::ConstraintMatrix b;  // of the share
};

}  // namespace

std::vector<DiscreteSolution> solve_with_mortar(const CoupledProblem& coupled,
                                                const solvers::SolverOptions& options,
                                                const Progress& progress) {
  const Stopwatch watch;
  const MortarSystem mortar(coupled, options.multigrid, progress);
  const MortarProjection projection(
      mortar.b, mortar.level.rows,
      interface_matrix(mortar.coupled.discretization().model, mortar.level, mortar.coupled.problem->materials,
                       mortar.stiffness.surfaces(), mortar.stiffness.diagonal()));
  solvers::OperatorSystem system;
  system.rows = mortar.level.rows;
  system.product = [&](const VectorXd& x) {
    return projection.reduce(mortar.stiffness.apply(projection.project(x)));
  };
  system.preconditioner = [&](const VectorXd& r) {
    return projection.project(mortar.multigrid.apply(projection.reduce(r)));
  };
  system.costs = {.levels = mortar.multigrid.levels(),
                  .bytes = mortar.multigrid.bytes(),
                  .setup_seconds = watch.seconds()};
  std::vector<MortarSystem::Sides> sides;
  std::vector<VectorXd> particular, loads;
  for (const RightSide& side : mortar.coupled.right_sides) {
    sides.push_back(mortar.sides(side));
    particular.push_back(projection.particular(sides.back().jump));
    loads.push_back(projection.reduce(sides.back().load - mortar.stiffness.apply(particular.back())));
  }
  solvers::LoadSequence sequence(system, options.method == solvers::Method::cg
                                             ? solvers::KrylovMethod::cg
                                             : solvers::KrylovMethod::minres);
  std::vector<solvers::LinearSolution> solved = sequence.solve_all(loads, options, progress);
  std::vector<DiscreteSolution> result;
  for (std::size_t i = 0; i < solved.size(); ++i) {
    const VectorXd x = particular[i] + projection.project(solved[i].x);
    const VectorXd multipliers = projection.multipliers(sides[i].load - mortar.stiffness.apply(x));
    result.push_back(mortar.solution(sides[i], x, multipliers, std::move(solved[i].report)));
  }
  return result;
}

}  // namespace isopatch::iga
