#include <algorithm>

#include "geometry/base/error.hpp"
#include "iga/elasticity_multigrid.hpp"
#include "iga/iterative_solution.hpp"
#include "iga/level_operator.hpp"
#include "solvers/operator_system.hpp"
#include "solvers/stopwatch.hpp"

namespace isopatch::iga {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// The saddle point's unknowns: three components of every node along its class's frame, then one block of
// three for every node but the first of each class, the forces that tie it to the first, along the same
// frame.
class Saddle {
 public:
  Saddle(const SolutionTask& task, const Level& level, const ElasticityMultigrid& multigrid,
         const std::vector<Eigen::Matrix3d>& diagonal)
      : classes_(task.classes),
        frames_(task.frames),
        multigrid_(multigrid),
        stiffness_(level.spaces, level.parts, task.problem.materials, task.points) {
    // Jumps cost some ten times what they cost in a node's own stiffness: enough to separate them from what
    // is continuous, and far from drowning the stiffness in round-off.
    constexpr double weight = 10;
    tie_of_class_.reserve(static_cast<std::size_t>(classes_.count()));
    int ties = 0;
    for (int c = 0; c < classes_.count(); ++c) {
      const auto members = static_cast<int>(classes_.of(c).size());
      tie_of_class_.push_back(ties);
      ties += members - 1;
      jump_stiffness_.push_back(weight * diagonal[static_cast<std::size_t>(c)].trace() / (3.0 * members));
    }
    nodes_ = static_cast<Index>(classes_.class_of.size());
    ties_ = ties;
  }

  int block_rows() const { return static_cast<int>(nodes_ + ties_); }

  VectorXd product(const VectorXd& z) const {
    Eigen::Matrix3Xd u(3, nodes_);
    for (Index node = 0; node < nodes_; ++node) {
      const Frame& f = frame(node);
      u.col(node) = f.axes.leftCols(f.free) * z.segment(3 * node, f.free);
    }
    const Eigen::Matrix3Xd forces = stiffness_.apply(u);
    VectorXd result = VectorXd::Zero(z.size());
    for (Index node = 0; node < nodes_; ++node) {
      const Frame& f = frame(node);
      result.segment(3 * node, f.free) = f.axes.leftCols(f.free).transpose() * forces.col(node);
    }
    for_each_tied_class([&](int c, std::span<const int> members, Index tie) {
      const int free = frames_[static_cast<std::size_t>(c)].free;
      const double g = jump_stiffness_[static_cast<std::size_t>(c)];
      const Eigen::Vector3d mean = mean_of(members, z);
      for (std::size_t i = 0; i < members.size(); ++i) {
        const Index row = 3 * static_cast<Index>(members[i]);
        result.segment(row, free) += g * (z.segment(row, free) - mean.head(free));
        if (i == 0) continue;
        const Index at = 3 * (nodes_ + tie + static_cast<Index>(i) - 1);
        const Index first = 3 * static_cast<Index>(members[0]);
        result.segment(at, free) = z.segment(first, free) - z.segment(row, free);
        result.segment(first, free) += z.segment(at, free);
        result.segment(row, free) -= z.segment(at, free);
      }
    });
    return result;
  }

  VectorXd preconditioned(const VectorXd& r) const {
    VectorXd sum = VectorXd::Zero(3 * static_cast<Index>(classes_.count()));
    for (Index node = 0; node < nodes_; ++node)
      sum.segment<3>(3 * static_cast<Index>(class_of(node))) += r.segment<3>(3 * node);
    const VectorXd continuous = multigrid_.apply(sum);
    VectorXd result = VectorXd::Zero(r.size());
    for (Index node = 0; node < nodes_; ++node)
      result.segment<3>(3 * node) = continuous.segment<3>(3 * static_cast<Index>(class_of(node)));
    for_each_tied_class([&](int c, std::span<const int> members, Index tie) {
      const double g = jump_stiffness_[static_cast<std::size_t>(c)];
      const Eigen::Vector3d mean = mean_of(members, r);
      for (const int node : members)
        result.segment<3>(3 * static_cast<Index>(node)) +=
            (r.segment<3>(3 * static_cast<Index>(node)) - mean) / g;
      add_tie_inverse(members.size(), g, tie, r, result);
    });
    return result;
  }

  VectorXd load(const Eigen::Matrix3Xd& of_nodes, const Eigen::Matrix3Xd& prescribed) const {
    const Eigen::Matrix3Xd forces =
        prescribed.isZero(0) ? of_nodes : Eigen::Matrix3Xd(of_nodes - stiffness_.apply(prescribed));
    VectorXd result = VectorXd::Zero(3 * static_cast<Index>(block_rows()));
    for (Index node = 0; node < nodes_; ++node) {
      const Frame& f = frame(node);
      result.segment(3 * node, f.free) = f.axes.leftCols(f.free).transpose() * forces.col(node);
    }
    return result;
  }

  Eigen::Matrix3Xd displacement(const VectorXd& z) const {
    Eigen::Matrix3Xd u(3, nodes_);
    for (Index node = 0; node < nodes_; ++node) {
      const Frame& f = frame(node);
      u.col(node) = f.prescribed + f.axes.leftCols(f.free) * z.segment(3 * node, f.free);
    }
    return u;
  }

  // The multipliers of the system without K's jump term, which takes its share of the force as long as jumps
  // are not quite closed.
  VectorXd multipliers(const std::vector<MultiplierRow>& rows, const VectorXd& z) const {
    VectorXd all = z;
    VectorXd jumps = VectorXd::Zero(z.size());
    for_each_tied_class([&](int c, std::span<const int> members, Index tie) {
      for (std::size_t i = 1; i < members.size(); ++i)
        jumps.segment<3>(3 * (nodes_ + tie + static_cast<Index>(i) - 1)) =
            z.segment<3>(3 * static_cast<Index>(members[0])) -
            z.segment<3>(3 * static_cast<Index>(members[i]));
      add_tie_inverse(members.size(), jump_stiffness_[static_cast<std::size_t>(c)], tie, jumps, all);
    });
    VectorXd result(static_cast<Index>(rows.size()));
    for (std::size_t r = 0; r < rows.size(); ++r) {
      const auto members = classes_.of(rows[r].node_class);
      const auto place = std::find(members.begin(), members.end(), rows[r].second) - members.begin();
      const Index tie = tie_of_class_[static_cast<std::size_t>(rows[r].node_class)] + place - 1;
      result[static_cast<Index>(r)] = all[3 * (nodes_ + tie) + rows[r].axis];
    }
    return result;
  }

 private:
  int class_of(Index node) const { return classes_.class_of[static_cast<std::size_t>(node)]; }
  const Frame& frame(Index node) const { return frames_[static_cast<std::size_t>(class_of(node))]; }

  template <class Visit>
  void for_each_tied_class(Visit visit) const {
    for (int c = 0; c < classes_.count(); ++c)
      if (const auto members = classes_.of(c); members.size() > 1)
        visit(c, members, static_cast<Index>(tie_of_class_[static_cast<std::size_t>(c)]));
  }

  static Eigen::Vector3d mean_of(std::span<const int> members, const VectorXd& z) {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (const int node : members) sum += z.segment<3>(3 * static_cast<Index>(node));
    return sum / static_cast<double>(members.size());
  }

  // out += g (B B^T)^-1 in on the ties of one class: (I + 1 1^T)^-1 = I - 1 1^T / members.
  void add_tie_inverse(std::size_t members, double g, Index tie, const VectorXd& in, VectorXd& out) const {
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    const auto count = static_cast<Index>(members) - 1;
    for (Index i = 0; i < count; ++i) sum += in.segment<3>(3 * (nodes_ + tie + i));
    for (Index i = 0; i < count; ++i)
      out.segment<3>(3 * (nodes_ + tie + i)) +=
          g * (in.segment<3>(3 * (nodes_ + tie + i)) - sum / static_cast<double>(members));
  }

  const NodeClasses& classes_;
  const std::vector<Frame>& frames_;
  const ElasticityMultigrid& multigrid_;
  StiffnessOperator stiffness_;
  std::vector<int> tie_of_class_;
  std::vector<double> jump_stiffness_;
  Index nodes_ = 0;
  Index ties_ = 0;
};

}  // namespace

NodalSolution solve_with_multipliers(const SolutionTask& task, const solvers::SolverOptions& options,
                                     const Progress& progress) {
  solvers::Stopwatch watch;
  const Level level =
      finest_level(task.problem.discretization, task.classes, task.frames, task.distribution, task.processes);
  if (level.rows.is_distributed())
    throw Error(ErrorCode::unsupported,
                "method 'minres' runs with one process so far; start it without mpiexec, or use 'mumps'");
  const LevelOperator stiffness(level, task.problem.materials, task.points);
  const ElasticityMultigrid multigrid(
      task.problem, level, task.frames, task.distribution, task.processes,
      [&](const VectorXd& x) { return stiffness.apply(x); }, {options.multigrid, task.points}, progress);
  const Saddle saddle(task, level, multigrid, stiffness.diagonal());
  Eigen::Matrix3Xd prescribed(3, static_cast<Index>(task.classes.class_of.size()));
  for (Index node = 0; node < prescribed.cols(); ++node)
    prescribed.col(node) =
        task.frames[static_cast<std::size_t>(task.classes.class_of[static_cast<std::size_t>(node)])]
            .prescribed;
  solvers::OperatorSystem system;
  system.rows = solvers::SharedRows(saddle.block_rows());
  system.load = saddle.load(task.load, prescribed);
  system.product = [&](const VectorXd& z) { return saddle.product(z); };
  system.preconditioner = [&](const VectorXd& r) { return saddle.preconditioned(r); };
  const double setup_seconds = watch.lap();
  solvers::LinearSolution solved = solve_with_minres(system, options, progress);
  NodalSolution result;
  result.report = std::move(solved.report);
  result.report.form = solvers::Operator::matrix_free;
  result.report.analysis_seconds = setup_seconds;
  result.report.levels = multigrid.levels();
  constexpr int vectors = 20;  // of PETSc, the multigrid's levels and operators
  result.report.memory_bytes = multigrid.bytes() + 8 * vectors * system.load.size();
  result.displacement = saddle.displacement(solved.x);
  result.multipliers = saddle.multipliers(task.multipliers, solved.x);
  return result;
}

}  // namespace isopatch::iga
