#include "iga/estimate/error_estimate.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "geometry/base/error.hpp"
#include "iga/assembly/interface_thermal_load.hpp"
#include "iga/assembly/support_stiffness.hpp"
#include "iga/distribution/shared_interfaces.hpp"
#include "iga/estimate/element_errors.hpp"
#include "iga/estimate/raised_problem.hpp"
#include "iga/multigrid/fast_diagonalization.hpp"
#include "iga/multigrid/level_operator.hpp"
#include "iga/post/internal_forces.hpp"
#include "iga/problem/loads.hpp"
#include "iga/problem/thermal_load.hpp"
#include "iga/solution/solver_bytes.hpp"
#include "iga/solution/solver_choice.hpp"

namespace isopatch::iga {
namespace {

// Two iterations in a row that add less than this share of the energy found before are the last ones. One
// alone may be followed by larger ones where interfaces do not match, which the smoother does not know of.
constexpr double least_gain = 0.03;
constexpr int most_small_gains = 2;
constexpr int most_corrections = 12;
// Measured on patches of degree 2 to 4, with what the operator and the smoother keep.
constexpr double bytes_per_raised_node = 550;

void require_room(const Discretization& raised, const ElasticityOptions& options) {
  const double bytes = bytes_per_raised_node * raised.node_count();
  const double available = available_bytes(options.solver, options.processes);
  if (bytes <= available) return;
  throw Error(ErrorCode::out_of_memory,
              fmt::format("an estimate of the error takes about {}, and there are {}", gigabytes(bytes),
                          gigabytes(std::max(0.0, available))));
}

Level raised_level(const Discretization& d, const ElasticityProblem& raised,
                   const std::vector<PatchSpace>& spaces, const ElasticityOptions& options) {
  const GlobalNodes global = global_nodes(d);
  return finest_level(spaces, global, support_frames(raised, global),
                      distribute(d.model, spaces, global, options.processes.count()), options.processes);
}

// The values of nodes at the local rows: all nodes of a row have the same.
Eigen::VectorXd rows_of(const Level& level, const Eigen::Matrix3Xd& of_nodes) {
  Eigen::VectorXd result(3 * static_cast<Eigen::Index>(level.rows.local_rows()));
  for (Eigen::Index node = 0; node < of_nodes.cols(); ++node)
    if (const int row = level.row_of_node[static_cast<std::size_t>(node)]; row >= 0)
      result.segment<3>(3 * static_cast<Eigen::Index>(row)) = of_nodes.col(node);
  return result;
}

// What a solution leaves of the loads, and its energy.
struct Residual {
  Eigen::VectorXd force;  // on the free unknowns, N
  double energy = 0;      // J
};

// Those of displacements, a column each. A fold is seen by the process whose elements have it, and must be
// known to all before they talk again.
Eigen::MatrixXd forces_of(const Level& level, const LevelOperator& stiffness, const Eigen::MatrixXd& u,
                          const solvers::Processes& processes) {
  Eigen::MatrixXd forces = Eigen::MatrixXd::Zero(u.rows(), u.cols());
  std::string failure;
  try {
    forces = stiffness.forces_each(u);
  } catch (const Error& error) {
    if (processes.count() == 1 || error.code() != ErrorCode::fold_over) throw;
    failure = error.what();
  }
  if (processes.sum(failure.empty() ? 0.0 : 1.0) > 0)
    throw Error(ErrorCode::fold_over, failure.empty() ? "a patch of another process is folded" : failure);
  for (Eigen::Index i = 0; i < u.cols(); ++i) {
    Eigen::VectorXd sum = forces.col(i);
    level.rows.sum(sum);
    forces.col(i) = sum;
  }
  return forces;
}

// The raised functions are held everywhere: at points, those of the solution or others, they would bulge
// between them, which the part does not.
SurfaceTerms raised_terms(const ElasticityProblem& problem) {
  SurfaceTerms terms = surface_terms(problem);
  terms.springs = held_everywhere(std::move(terms.springs));
  return terms;
}

// The displacement that a residual causes, on the free unknowns, and its energy.
struct Correction {
  Eigen::VectorXd displacement;
  double energy = 0;  // J
  int iterations = 0;
};

// Of a displacement on the free unknowns, J.
using EnergyOf = std::function<double(const Eigen::VectorXd&)>;

// Conjugate gradients of one residual, whose energy grows from iteration to iteration towards that of the
// solution. What is not counted of it says nothing of when to end.
class CorrectionSearch {
 public:
  explicit CorrectionSearch(Eigen::VectorXd residual)
      : residual_(std::move(residual)), found_{Eigen::VectorXd::Zero(residual_.size()), 0, 0} {}

  bool goes_on() const { return goes_on_; }
  const Eigen::VectorXd& direction() const { return direction_; }

  // The next direction.
  void turn(const Level& level, const FastDiagonalization& smoother) {
    const Eigen::VectorXd smoothed = smoother.apply(residual_);
    const double square = level.rows.dot(residual_, smoothed);
    direction_ =
        direction_.size() == 0 ? smoothed : Eigen::VectorXd(smoothed + square / square_ * direction_);
    square_ = square;
    goes_on_ = square > 0;
  }

  // @param forces  those of the direction
  void advance(const Level& level, const Eigen::VectorXd& forces, const EnergyOf& uncounted) {
    const double curvature = level.rows.dot(direction_, forces);
    goes_on_ = curvature > 0;  // or a motion without energy
    if (!goes_on_) return;
    const double length = square_ / curvature;
    found_.displacement += length * direction_;
    residual_ -= length * forces;
    whole_ += 0.5 * length * square_;
    const double before = std::exchange(found_.energy, whole_ - uncounted(found_.displacement));
    ++found_.iterations;
    small_gains_ = std::abs(found_.energy - before) > least_gain * found_.energy ? 0 : small_gains_ + 1;
    goes_on_ = small_gains_ < most_small_gains && found_.iterations < most_corrections;
  }

  Correction found() && { return std::move(found_); }

 private:
  Eigen::VectorXd residual_, direction_;
  double square_ = 0, whole_ = 0;
  int small_gains_ = 0;
  Correction found_;
  bool goes_on_ = true;
};

// The searches of several residuals, whose products are computed together.
std::vector<Correction> corrections_of(std::vector<Eigen::VectorXd> residuals, const Level& level,
                                       const LevelOperator& stiffness, const FastDiagonalization& smoother,
                                       const EnergyOf& uncounted, const Progress& progress) {
  std::vector<CorrectionSearch> searches;
  for (Eigen::VectorXd& residual : residuals) searches.emplace_back(std::move(residual));
  for (int iteration = 0; iteration < most_corrections; ++iteration) {
    progress("estimating the error", static_cast<double>(iteration) / most_corrections);
    std::vector<CorrectionSearch*> left;
    for (CorrectionSearch& search : searches) {
      if (search.goes_on()) search.turn(level, smoother);
      if (search.goes_on()) left.push_back(&search);
    }
    if (left.empty()) break;
    Eigen::MatrixXd directions(left.front()->direction().size(), static_cast<Eigen::Index>(left.size()));
    for (std::size_t i = 0; i < left.size(); ++i)
      directions.col(static_cast<Eigen::Index>(i)) = left[i]->direction();
    const Eigen::MatrixXd forces = stiffness.apply_each(directions);
    for (std::size_t i = 0; i < left.size(); ++i)
      left[i]->advance(level, forces.col(static_cast<Eigen::Index>(i)), uncounted);
  }
  std::vector<Correction> result;
  for (CorrectionSearch& search : searches) result.push_back(std::move(search).found());
  return result;
}

// Stress of the error at some places; the process that acts for a patch knows it.
std::vector<Eigen::Matrix3d> stresses_at(const std::vector<PatchPlace>& places,
                                         const ElasticityProblem& raised, const Level& level,
                                         const Eigen::Matrix3Xd& error, const solvers::Processes& processes) {
  std::vector<Eigen::Matrix3d> result;
  for (const PatchPlace& place : places) {
    const auto p = static_cast<std::size_t>(place.patch);
    Eigen::VectorXd stress = Eigen::VectorXd::Zero(9);
    if (level.is_primary[p]) {
      const geometry::NurbsVolume& patch = raised.discretization.patches[p];
      const ElasticField field{
          {patch}, {error.middleCols(level.first_node[p], patch.size())}, {raised.materials[p]}};
      const Eigen::Matrix3d here = evaluate(field, 0, place.parameter).stress;
      stress = Eigen::Map<const Eigen::VectorXd>(here.data(), 9);
    }
    if (processes.count() > 1) processes.sum(stress);
    result.emplace_back(Eigen::Map<const Eigen::Matrix3d>(stress.data()));
  }
  return result;
}

}  // namespace

struct ErrorEstimator::State {
  State(const ElasticityProblem& given, ElasticityProblem with_raised_degree,
        const ElasticityOptions& with_options)
      : problem(given),
        raised(std::move(with_raised_degree)),
        options(with_options),
        spaces(isoparametric_spaces(raised.discretization)),
        level(raised_level(raised.discretization, raised, spaces, options)),
        stiffness(level, raised.materials, 0, raised_terms(problem)),
        springs(support_stiffness(spaces, level.parts, without_holds(springs_of(problem)))),
        holds(support_stiffness(spaces, level.parts, held_everywhere(holds_among(springs_of(problem))))),
        has_holds(!holds_among(springs_of(problem)).empty()),
        smoother(raised.discretization.model, level, raised.materials, stiffness.diagonal(),
                 stiffness.surfaces(), held_everywhere(holds_among(springs_of(problem)))) {}

  // What each solution leaves of its loads.
  std::vector<Residual> residuals(const std::vector<SolutionToEstimate>& solutions) const {
    Eigen::MatrixXd u(3 * static_cast<Eigen::Index>(level.rows.local_rows()),
                      static_cast<Eigen::Index>(solutions.size()));
    for (std::size_t i = 0; i < solutions.size(); ++i)
      u.col(static_cast<Eigen::Index>(i)) =
          rows_of(level, in_raised_space(problem, raised, solutions[i].solution.displacement));
    const Eigen::MatrixXd forces = forces_of(level, stiffness, u, options.processes);
    std::vector<Residual> result;
    for (std::size_t i = 0; i < solutions.size(); ++i) {
      const auto k = static_cast<Eigen::Index>(i);
      result.push_back({level.free.to_free(sum_of_nodes(level, solutions[i].loads) - forces.col(k)),
                        0.5 * level.rows.dot(u.col(k), forces.col(k)) - uncounted(u.col(k))});
    }
    return result;
  }

  bool has_mortar() const {
    return options.non_matching == NonMatchingCoupling::mortar &&
           !problem.discretization.model.non_matching().empty();
  }
  // What the equations count of a displacement and the part does not have: what holds do not give way, they
  // stop at their points in the solution, and jumps cost nothing where the solution has mortar multipliers.
  double uncounted(const Eigen::VectorXd& u) const {
    if (!has_holds && !has_mortar()) return 0;
    const Eigen::Matrix3Xd of_nodes = at_nodes(level, u);
    Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, of_nodes.cols()), counted = forces;
    if (has_mortar()) {
      stiffness.surfaces().add_forces(of_nodes, forces);
      springs.add_forces(of_nodes, counted);
    } else {
      holds.add_forces(of_nodes, forces);
    }
    return options.processes.sum(0.5 * of_nodes.cwiseProduct(forces - counted).sum());
  }

  const ElasticityProblem& problem;
  ElasticityProblem raised;  // its loads say nothing
  ElasticityOptions options;
  std::vector<PatchSpace> spaces;
  Level level;
  LevelOperator stiffness;
  NodeBlocks springs, holds;  // of what the stiffness has beside the elements'
  bool has_holds;             // on any process
  FastDiagonalization smoother;
};

ErrorEstimator::ErrorEstimator(const ElasticityProblem& problem, const ElasticityOptions& options,
                               const Progress& progress) {
  ElasticityProblem raised = with_degree_raised(problem, options.quadrature_points);
  require_room(raised.discretization, options);
  progress("estimating the error", 0);
  state_ = std::make_unique<State>(problem, std::move(raised), options);
}

ErrorEstimator::~ErrorEstimator() = default;
ErrorEstimator::ErrorEstimator(ErrorEstimator&&) noexcept = default;

// The load vector in the raised space, thermal loads included; every process has all of it.
Eigen::Matrix3Xd ErrorEstimator::loads(const ElasticityProblem& problem) const {
  const ElasticityProblem& raised = state_->raised;
  const solvers::Processes& processes = state_->options.processes;
  Eigen::Matrix3Xd result = load_vector({raised.discretization,
                                         problem.materials,
                                         {},
                                         problem.surface_loads,
                                         problem.volume_loads,
                                         {},
                                         problem.point_loads});
  const std::vector<ThermalStrain> strains = thermal_strains(problem.temperatures, problem.materials);
  if (strains.empty()) return result;
  Eigen::Matrix3Xd thermal =
      thermal_forces(raised.discretization, problem.materials, strains, state_->level.parts);
  thermal += interface_thermal_load(state_->spaces, state_->level.parts, surface_terms(problem), strains);
  if (processes.count() > 1) processes.sum(Eigen::Map<Eigen::VectorXd>(thermal.data(), thermal.size()));
  return result + thermal;
}

ErrorEstimate ErrorEstimator::estimate(const Eigen::Matrix3Xd& loads, const ElasticField& solution,
                                       const std::vector<PatchPlace>& places,
                                       const Progress& progress) const {
  return std::move(estimates({{loads, solution, places}}, progress).front());
}

std::vector<ErrorEstimate> ErrorEstimator::estimates(const std::vector<SolutionToEstimate>& solutions,
                                                     const Progress& progress) const {
  const State& s = *state_;
  std::vector<double> energies;
  std::vector<Eigen::VectorXd> residuals;
  for (Residual& residual : s.residuals(solutions)) {
    energies.push_back(residual.energy);
    residuals.push_back(std::move(residual.force));
  }
  const std::vector<Correction> corrections = corrections_of(
      std::move(residuals), s.level, s.stiffness, s.smoother,
      [&s](const Eigen::VectorXd& e) { return s.uncounted(s.level.free.to_space(e)); }, progress);
  std::vector<Eigen::Matrix3Xd> errors;
  for (const Correction& correction : corrections)
    errors.push_back(at_nodes(s.level, s.level.free.to_space(correction.displacement)));
  std::vector<std::vector<ElementErrors>> elements =
      element_errors(s.raised.discretization, s.raised.materials, errors, s.level.parts, s.options.processes);
  std::vector<ErrorEstimate> results;
  for (std::size_t i = 0; i < solutions.size(); ++i) {
    const Correction& correction = corrections[i];
    ErrorEstimate& result = results.emplace_back();
    result.iterations = correction.iterations;
    result.elements = std::move(elements[i]);
    result.energy = correction.energy;
    const double whole = energies[i] + result.energy;
    result.relative = whole > 0 ? std::sqrt(result.energy / whole) : 0;
    result.stress_at = stresses_at(solutions[i].places, s.raised, s.level, errors[i], s.options.processes);
  }
  return results;
}

ErrorEstimate estimate_error(const ElasticityProblem& problem, const ElasticField& solution,
                             const std::vector<PatchPlace>& places, const ElasticityOptions& options,
                             const Progress& progress) {
  const ErrorEstimator estimator(problem, options, progress);
  return estimator.estimate(estimator.loads(problem), solution, places, progress);
}

}  // namespace isopatch::iga
