#include "iga/solution/mortar_iteration.hpp"

#include <Eigen/SparseCholesky>
#include <array>
#include <optional>
#include <utility>

#include "geometry/base/error.hpp"
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
  // B^T y of all processes.
  VectorXd force_of(const VectorXd& y) const {
    VectorXd result = b.transpose() * y;
    level.rows.sum(result);
    return result;
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

// PETSc wants three unknowns a row, so some that are 0 may follow the multipliers.
Index filled_up(Index multipliers) {
  return 3 * ((multipliers + 2) / 3);
}

// The rows of displacements, then those of each process' multipliers.
solvers::SharedRows rows_of_both(const MortarSystem& mortar) {
  const CoupledProblem& coupled = mortar.coupled;
  if (coupled.processes.count() == 1) return solvers::SharedRows(mortar.level.rows.local_rows());
  std::vector<std::vector<int>> of_row = processes_of_rows({mortar.level.global_of, coupled.global.count()},
                                                           mortar.level.first_node, coupled.distribution);
  std::vector<Index> multipliers(static_cast<std::size_t>(coupled.processes.count()), 0);
  for (const int process : processes_of_mortar(coupled.mortar, coupled.distribution))
    ++multipliers[static_cast<std::size_t>(process)];
  for (int process = 0; process < coupled.processes.count(); ++process)
    of_row.insert(of_row.end(),
                  static_cast<std::size_t>(filled_up(multipliers[static_cast<std::size_t>(process)]) / 3),
                  {process});
  return solvers::SharedRows(of_row, coupled.processes);
}

// The inverse of what multipliers cost.
class ComplianceInverse {
 public:
  explicit ComplianceInverse(const Eigen::SparseMatrix<double>& compliance) {
    if (compliance.rows() == 0) return;
    factors_.emplace(compliance);
    if (factors_->info() != Eigen::Success)
      throw Error(ErrorCode::singular_system, "multipliers between faces that do not match are no basis");
  }
  VectorXd operator()(const VectorXd& y) const { return factors_ ? VectorXd(factors_->solve(y)) : y; }

 private:
  std::optional<Eigen::SimplicialLLT<Eigen::SparseMatrix<double>>> factors_;
};

std::vector<DiscreteSolution> by_minimal_residuals(const MortarSystem& mortar,
                                                   const solvers::SolverOptions& options,
                                                   const Stopwatch& watch, const Progress& progress) {
  const ComplianceInverse compliance(mortar.share.constraints.compliance);
  const Index displacements = mortar.b.cols(), multipliers = mortar.b.rows();
  const Index more = filled_up(multipliers) - multipliers;
  solvers::OperatorSystem system;
  system.rows = rows_of_both(mortar);
  system.product = [&](const VectorXd& z) {
    const VectorXd x = z.head(displacements), y = z.segment(displacements, multipliers);
    return joined(mortar.stiffness.apply(x) + mortar.force_of(y), joined(mortar.b * x, z.tail(more)));
  };
  system.preconditioner = [&](const VectorXd& r) {
    return joined(mortar.multigrid.apply(r.head(displacements)),
                  joined(share_of_penalty * compliance(r.segment(displacements, multipliers)), r.tail(more)));
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
  const MortarProjection projection(mortar.share.constraints, mortar.b, mortar.level.rows, sizes,
                                    mortar.level.first_node, mortar.level.row_of_node, mortar.frame_of_row);
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
    const VectorXd multipliers = projection.multipliers(sides[i].load - mortar.stiffness.apply(x));
    result.push_back(mortar.solution(sides[i], x, multipliers, std::move(solved[i].report)));
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
