#include "iga/multigrid/elasticity_multigrid.hpp"

#include <algorithm>
#include <deque>
#include <numeric>

#include "iga/assembly/assembly.hpp"
#include "iga/coupling/supported_system.hpp"
#include "iga/multigrid/fast_diagonalization.hpp"
#include "iga/multigrid/level_operator.hpp"
#include "iga/multigrid/level_transfer.hpp"
#include "iga/multigrid/smoothing_points.hpp"
#include "solvers/cholmod_solver.hpp"

namespace isopatch::iga {
namespace {

// Every process has all of every patch.
Distribution everywhere(const Distribution& distribution, std::size_t patches) {
  std::vector<PatchShare> all;
  for (std::size_t p = 0; p < patches; ++p) all.push_back({static_cast<int>(p), 0, 1});
  return Distribution(distribution.size(), all);
}

bool has_one_element_of_degree(const Level& level, int highest) {
  for (const PatchSpace& space : level.spaces)
    for (const geometry::KnotVector& knots : space.knots)
      if (knots.element_count() > 1 || knots.degree() > highest) return false;
  return true;
}

// The same functions with the Gauss points that smoothing needs.
std::vector<PatchSpace> with_fewest_points(std::vector<PatchSpace> spaces) {
  for (PatchSpace& space : spaces) space.points = smoothing_points(space);
  return spaces;
}

// The coarsest level's matrix, the same on every process, which has all rows there.
solvers::VectorsOperator coarse_inverse(const Level& level, const std::vector<Material>& materials,
                                        const SurfaceTerms& surfaces, int points) {
  const RowNumbering numbering{level.global_of, level.rows.global_rows()};
  solvers::SymmetricBlockMatrix stiffness =
      assemble_stiffness(level.spaces, whole_patches(level.spaces), materials, numbering, points);
  surface_stiffness(level.spaces, whole_patches(level.spaces), surfaces).add_to(stiffness, numbering);
  apply_supports(stiffness, level.free, solvers::SharedRows(stiffness.block_rows()));
  return solvers::cholmod_inverse(std::move(stiffness));
}

}  // namespace

// Levels, operators and transfers refer to each other, so they stay where they are.
struct ElasticityMultigrid::State {
  std::deque<std::vector<PatchSpace>> smoothed_spaces;  // of the levels
  std::deque<Level> coarser;
  std::deque<LevelOperator> operators;
  std::deque<FastDiagonalization> smoothers;
  std::deque<LevelTransfer> transfers;
  std::unique_ptr<solvers::Multigrid> multigrid;
};

ElasticityMultigrid::ElasticityMultigrid(const ElasticityProblem& problem, const Level& finest,
                                         const std::vector<SupportFrame>& frames,
                                         const Distribution& distribution,
                                         const solvers::Processes& processes,
                                         const solvers::VectorsOperator& product,
                                         const ElasticityMultigridOptions& options, const Progress& progress)
    : state_(std::make_unique<State>()) {
  const geometry::MultiPatch& model = problem.discretization.model;
  progress("multigrid", 0);
  const auto is_small = [&](const Level& level) {
    // Degree 1 hardly bends: single elements of degree 2 are worth larger factors.
    const int most =
        has_one_element_of_degree(level, 2) ? options.coarsest_curved_dofs : options.coarsest_dofs;
    return 3 * level.rows.global_rows() <= most;
  };
  std::vector<const Level*> levels = {&finest};
  // A level that is spread over processes cannot be the coarsest.
  while (!is_small(*levels.back()) || (levels.size() == 1 && finest.rows.is_distributed())) {
    std::optional<Level> next = coarser_level(model, *levels.back(), finest, frames, distribution, processes);
    if (!next) break;
    levels.push_back(&state_->coarser.emplace_back(std::move(*next)));
  }
  // The coarsest level is factorized by every process, so each needs all of it.
  if (levels.size() > 1) {
    levels.pop_back();
    state_->coarser.pop_back();
    levels.push_back(&state_->coarser.emplace_back(*coarser_level(
        model, *levels.back(), finest, frames, everywhere(distribution, finest.spaces.size()), processes)));
  }
  // On coarser levels holds are integrated: seen from there the points of the finest level are everywhere,
  // and points of their own would let coarse functions do what the finest level forbids.
  SurfaceTerms of_finest = surface_terms(problem);
  if (!options.mortar.faces.empty()) {
    of_finest.interfaces.clear();
    of_finest.mortar = options.mortar;
  }
  SurfaceTerms of_coarser = of_finest;
  of_coarser.springs = held_everywhere(std::move(of_coarser.springs));
  const Springs holds = holds_among(of_finest.springs), coarser_holds = held_everywhere(holds);
  std::vector<solvers::MultigridLevel> described;
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const Level& level = *levels[l];
    solvers::MultigridLevel& made = described.emplace_back();
    made.rows = level.rows;
    if (l > 0) {
      const LevelTransfer& transfer = state_->transfers.emplace_back(level, *levels[l - 1]);
      made.to_finer = [&transfer](const Eigen::VectorXd& x) { return transfer.to_finer(x); };
      made.from_finer = [&transfer](const Eigen::VectorXd& f) { return transfer.from_finer(f); };
    }
    if (l + 1 == levels.size()) break;
    const bool own = l > 0 || !product;
    if (own) state_->smoothed_spaces.push_back(with_fewest_points(level.spaces));
    const LevelOperator& stiffness =
        state_->operators.emplace_back(level, own ? state_->smoothed_spaces.back() : level.spaces,
                                       problem.materials, options.points, l == 0 ? of_finest : of_coarser);
    const FastDiagonalization& smoother =
        state_->smoothers.emplace_back(model, level, problem.materials, stiffness.diagonal(),
                                       stiffness.surfaces(), l == 0 ? holds : coarser_holds);
    made.product = l == 0 && product
                       ? product
                       : solvers::VectorsOperator(
                             [&stiffness](const Eigen::VectorXd& x) { return stiffness.apply(x); },
                             [&stiffness](const Eigen::MatrixXd& x) { return stiffness.apply_each(x); });
    made.smoother = [&smoother](const Eigen::VectorXd& r) { return smoother.apply(r); };
    progress("multigrid", static_cast<double>(l + 1) / static_cast<double>(levels.size()));
  }
  state_->multigrid = std::make_unique<solvers::Multigrid>(
      std::move(described),
      coarse_inverse(*levels.back(), problem.materials, levels.size() == 1 ? of_finest : of_coarser,
                     options.points),
      options.smoothing);
}

ElasticityMultigrid::~ElasticityMultigrid() = default;
ElasticityMultigrid::ElasticityMultigrid(ElasticityMultigrid&&) noexcept = default;

Eigen::VectorXd ElasticityMultigrid::apply(const Eigen::VectorXd& residual) const {
  return state_->multigrid->apply(residual);
}

Eigen::MatrixXd ElasticityMultigrid::apply_each(const Eigen::MatrixXd& residuals) const {
  return state_->multigrid->apply_each(residuals);
}

int ElasticityMultigrid::levels() const {
  return state_->multigrid->levels();
}

std::int64_t ElasticityMultigrid::bytes() const {
  std::int64_t total = 0;
  for (const FastDiagonalization& smoother : state_->smoothers) total += smoother.bytes();
  for (const Level& level : state_->coarser)
    total += static_cast<std::int64_t>(4 * (level.row_of_node.size() + level.global_of.size()));
  return total;
}

}  // namespace isopatch::iga
