#include "iga/solution/mortar_iteration.hpp"

#include <Eigen/SparseCholesky>
#include <array>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/base/stopwatch.hpp"
#include "iga/multigrid/elasticity_multigrid.hpp"
#include "iga/multigrid/level_operator.hpp"
#include "iga/solution/level_vectors.hpp"
#include "iga/solution/mortar_projection.hpp"
#include "solvers/load_sequence.hpp"
#include "solvers/operator_system.hpp"

namespace isopatch::iga {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// How much more multipliers are worth than Nitsche's penalty says; fewest iterations, measured on a plate and
// on T-joints, between 0.1 and 0.5.
constexpr double share_of_penalty = 0.25;

VectorXd joined(const VectorXd& x, const VectorXd& y) {
  VectorXd z(x.size() + y.size());
  z << x, y;
  return z;
}

// What both ways share. Parts refer to each other, so it stays where it is.
struct MortarSystem {
  MortarSystem(const CoupledProblem& of, const solvers::MultigridOptions& smoothing, const Progress& progress)
      : coupled(of),
        level(finest_level(of.spaces, of.global, of.frames, of.distribution, of.processes)),
        stiffness(level, of.problem->materials, of.points, of.surfaces()),
        multigrid(*of.problem, level, of.frames, of.distribution, of.processes, {}, {smoothing, of.points},
                  progress),
        frames(level.free.frames(level.rows.local_rows())) {
    for (const SupportFrame& frame : frames) frame_of_row.push_back(&frame);
    b = mortar_matrix(of.mortar, {level.row_of_node, level.rows.local_rows()}, frame_of_row);
  }
  MortarSystem(const MortarSystem&) = delete;

  // Forces on the unknowns, and what B x must be.
  struct Sides {
    VectorXd prescribed, load, jump;
  };
  Sides sides(const RightSide& side) const {
    Sides result;
    result.prescribed = prescribed_rows(level, side.prescribed);
    result.load = free_load(level, stiffness, side.load, result.prescribed);
    result.jump =
        mortar_right_side(coupled.mortar, {level.row_of_node, level.rows.local_rows()}, result.prescribed);
    return result;
  }
  DiscreteSolution solution(const Sides& sides, const VectorXd& x, VectorXd multipliers,
                            solvers::SolveReport report) const {
    const VectorXd of_rows = sides.prescribed + level.free.to_space(x);
    return {whole_at_nodes(level, of_rows), {}, std::move(report), std::move(multipliers)};
  }

  const CoupledProblem& coupled;
  Level level;
  LevelOperator stiffness;
  ElasticityMultigrid multigrid;
  std::vector<SupportFrame> frames;
  std::vector<const SupportFrame*> frame_of_row;
  solvers::ConstraintMatrix b;
};

std::vector<DiscreteSolution> by_minimal_residuals(const MortarSystem& mortar,
                                                   const solvers::SolverOptions& options,
                                                   const Stopwatch& watch, const Progress& progress) {
  const MortarConstraints& constraints = mortar.coupled.mortar;
  const Eigen::SimplicialLLT<Eigen::SparseMatrix<double>> compliance(constraints.compliance);
  if (compliance.info() != Eigen::Success)
    throw Error(ErrorCode::singular_system, "multipliers between faces that do not match are no basis");
  const Index displacements = mortar.b.cols(), multipliers = mortar.b.rows();
  // PETSc wants three unknowns a row, so some that are 0 may follow.
  const Index more = (3 - multipliers % 3) % 3;
  solvers::OperatorSystem system;
  system.rows = solvers::SharedRows(mortar.level.rows.local_rows());
  system.product = [&](const VectorXd& z) {
    const VectorXd x = z.head(displacements), y = z.segment(displacements, multipliers);
    return joined(mortar.stiffness.apply(x) + mortar.b.transpose() * y, joined(mortar.b * x, z.tail(more)));
  };
  system.preconditioner = [&](const VectorXd& r) {
    return joined(
        mortar.multigrid.apply(r.head(displacements)),
        joined(share_of_penalty * compliance.solve(r.segment(displacements, multipliers)), r.tail(more)));
  };
  system.costs = {.levels = mortar.multigrid.levels(),
                  .bytes = mortar.multigrid.bytes(),
                  .setup_seconds = watch.seconds()};
  solvers::LoadSequence sequence(system, solvers::KrylovMethod::minres);
  std::vector<DiscreteSolution> result;
  for (const RightSide& side : mortar.coupled.right_sides) {
    const MortarSystem::Sides sides = mortar.sides(side);
    solvers::LinearSolution solved =
        sequence.solve(joined(sides.load, joined(sides.jump, VectorXd::Zero(more))), options, progress);
    result.push_back(mortar.solution(sides, solved.x.head(displacements),
                                     solved.x.segment(displacements, multipliers), std::move(solved.report)));
  }
  return result;
}

std::vector<DiscreteSolution> by_conjugate_gradients(const MortarSystem& mortar,
                                                     const solvers::SolverOptions& options,
                                                     const Stopwatch& watch, const Progress& progress) {
  std::vector<std::array<int, 3>> sizes;
  for (const PatchSpace& space : mortar.level.spaces) sizes.push_back(space.sizes());
  const MortarProjection projection(mortar.coupled.mortar, mortar.b, sizes, mortar.level.first_node,
                                    mortar.level.row_of_node, mortar.frame_of_row);
  solvers::OperatorSystem system;
  system.rows = mortar.level.rows;
  system.product = [&](const VectorXd& x) {
    return projection.moved_to_masters(mortar.stiffness.apply(projection.project(x)));
  };
  system.preconditioner = [&](const VectorXd& r) {
    return projection.project(mortar.multigrid.apply(projection.moved_to_masters(r)));
  };
  system.costs = {.levels = mortar.multigrid.levels(),
                  .bytes = mortar.multigrid.bytes(),
                  .setup_seconds = watch.seconds()};
  std::vector<MortarSystem::Sides> sides;
  std::vector<VectorXd> particular, loads;
  for (const RightSide& side : mortar.coupled.right_sides) {
    sides.push_back(mortar.sides(side));
    particular.push_back(projection.particular(sides.back().jump));
    loads.push_back(
        projection.moved_to_masters(sides.back().load - mortar.stiffness.apply(particular.back())));
  }
  solvers::LoadSequence sequence(system, solvers::KrylovMethod::cg);
  std::vector<solvers::LinearSolution> solved = sequence.solve_all(loads, options, progress);
  std::vector<DiscreteSolution> result;
  for (std::size_t i = 0; i < solved.size(); ++i) {
    const VectorXd x = particular[i] + projection.project(solved[i].x);
    VectorXd multipliers = projection.multipliers(sides[i].load - mortar.stiffness.apply(x));
    result.push_back(mortar.solution(sides[i], x, std::move(multipliers), std::move(solved[i].report)));
  }
  return result;
}

}  // namespace

std::vector<DiscreteSolution> solve_with_mortar(const CoupledProblem& coupled,
                                                const solvers::SolverOptions& options,
                                                const Progress& progress) {
  const Stopwatch watch;
  const MortarSystem mortar(coupled, options.multigrid, progress);
  return options.method == solvers::Method::cg ? by_conjugate_gradients(mortar, options, watch, progress)
                                               : by_minimal_residuals(mortar, options, watch, progress);
}

}  // namespace isopatch::iga
