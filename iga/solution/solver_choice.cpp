#include "iga/solution/solver_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/base/error.hpp"
#include "iga/solution/solver_bytes.hpp"
#include "solvers/memory.hpp"

namespace isopatch::iga {
namespace {

using solvers::Method;
using solvers::Operator;
using solvers::Preconditioner;

// Operations of the factorization, per unknown and in all, up to which it takes less time than iterations
// with a multigrid or not much more; measured (solvers/README.md, "Factors or iterations").
constexpr double most_flops_per_unknown = 1e6;
constexpr double few_flops = 2e10;
// Iterations grow where a material hardly changes its volume: ten times as many at nu = 0.499.
constexpr double more_if_incompressible = 10;
// Matrices with fewer bytes per unknown (degree 1) multiply faster than their product is computed anew.
constexpr double cheap_matrix_bytes = 600;

[[noreturn]] void refuse(const std::string& message) {
  throw Error(ErrorCode::invalid_argument, message);
}

bool is_iterative(Method method) {
  return method == Method::cg || method == Method::minres;
}

/// Two digits or more, and no power of ten: "0.82", "203".
std::string about(double value) {
  return value < 100 ? fmt::format("{:.2g}", value) : fmt::format("{:.0f}", value);
}

/// "4,200 unknowns", or "1.4 million unknowns" from 100,000 on.
std::string about_unknowns(double count) {
  if (!(count >= 100)) return "not even 100 unknowns";
  if (count >= 1e5) return fmt::format("about {} million unknowns", about(1e-6 * count));
  const double digit = std::pow(10, std::floor(std::log10(count)) - 1);
  return fmt::format("about {:.0f} unknowns", digit * std::floor(count / digit));
}

void check_coupling(Method method, const SizeForecast& size) {
  const bool tied = size.has_multipliers();
  if (method == Method::cholmod && size.has_mortar)
    refuse(
        "method 'cholmod' cannot treat the multipliers of non_matching = \"mortar\"; use 'auto', 'mumps', "
        "'umfpack', 'cg' or 'minres', or non_matching = \"nitsche\"");
  if (size.coupling == Coupling::lagrange && (method == Method::cholmod || method == Method::cg))
    refuse(
        fmt::format("method '{}' cannot treat the multipliers of coupling 'lagrange'; use 'auto', 'minres', "
                    "'mumps' or 'umfpack', or coupling 'elimination'",
                    solvers::name(method)));
  if (!tied && method == Method::minres)
    refuse(
        "method 'minres' is for coupling 'lagrange' and for non_matching = \"mortar\"; use 'auto' or 'cg' "
        "without "
        "multipliers");
}

void check_processes(const solvers::SolverOptions& options, int processes) {
  if (processes == 1) return;
  if (options.method == Method::cholmod || options.method == Method::umfpack)
    refuse(
        fmt::format("method '{}' works on one process, and there are {}; use 'auto' or 'mumps', or start one "
                    "process with more threads",
                    solvers::name(options.method), processes));
  if (options.method == Method::cg && options.preconditioner == Preconditioner::block_jacobi)
    refuse(fmt::format(
        "preconditioner 'block_jacobi' works on one process, and there are {}; use 'multigrid'", processes));
}

void check_parts(const solvers::SolverOptions& options, const SizeForecast& size) {
  const bool tied = size.has_multipliers();
  const bool direct = options.method != Method::automatic && !is_iterative(options.method);
  const bool jacobi = options.preconditioner == Preconditioner::block_jacobi;
  if (direct && options.form == Operator::matrix_free)
    refuse(fmt::format(
        "method '{}' factorizes a matrix, and operator 'matrix_free' makes none; use 'auto', 'cg' or "
        "'minres'",
        solvers::name(options.method)));
  if (direct && jacobi)
    refuse(fmt::format("preconditioner 'block_jacobi' is for method 'cg'; method '{}' needs none",
                       solvers::name(options.method)));
  if (jacobi && options.form == Operator::matrix_free)
    refuse(
        "preconditioner 'block_jacobi' inverts blocks of a matrix, and operator 'matrix_free' makes none; "
        "use "
        "preconditioner 'multigrid' or operator 'assembled'");
  if (tied && options.method != Method::mumps && options.method != Method::umfpack) {
    const bool iterates = options.method == Method::minres || options.method == Method::cg;
    if (jacobi && iterates)
      refuse(
          fmt::format("preconditioner 'block_jacobi' cannot treat multipliers; use preconditioner "
                      "'multigrid' with method '{}'",
                      solvers::name(options.method)));
    if (options.form == Operator::assembled && iterates)
      refuse(
          fmt::format("method '{}' iterates without a matrix where there are multipliers; leave operator = "
                      "\"auto\"",
                      solvers::name(options.method)));
  }
}

SolverPlan direct_plan(const SizeForecast& size, Method method, std::string reason = "") {
  return {method, Preconditioner::multigrid, Operator::assembled, direct_bytes(size, method),
          std::move(reason)};
}

Method direct_method(const SizeForecast& size) {
  return size.has_multipliers() || size.processes > 1 ? Method::mumps : Method::cholmod;
}

// Iterations in the form that the options ask for, or else in the faster one that fits.
SolverPlan iterative_plan(const SizeForecast& size, const solvers::SolverOptions& options, double available) {
  SolverPlan plan;
  plan.method = options.method != Method::automatic   ? options.method
                : size.coupling == Coupling::lagrange ? Method::minres
                                                      : Method::cg;
  plan.preconditioner = options.preconditioner;
  if (options.preconditioner == Preconditioner::block_jacobi) {
    plan.reason = "iterations with block Jacobi";
    plan.predicted_bytes = jacobi_bytes(size);
    return plan;
  }
  plan.reason = "iterations with a multigrid";
  const double with_matrix = multigrid_bytes(size, Operator::assembled);
  plan.form = options.form;
  if (size.has_mortar) plan.reason += " among the displacements that satisfy the mortar constraints";
  if (plan.method == Method::minres || size.has_mortar) {
    plan.form = Operator::matrix_free;
  } else if (options.form == Operator::automatic) {
    const bool cheap = size.matrix_bytes <= cheap_matrix_bytes * static_cast<double>(size.unknowns);
    plan.form = cheap && with_matrix <= available ? Operator::assembled : Operator::matrix_free;
    if (!cheap)
      plan.reason += "; without a matrix, whose product would be slower at this degree";
    else if (with_matrix > available)
      plan.reason += fmt::format("; without a matrix, which would take {}", gigabytes(size.matrix_bytes));
  }
  plan.predicted_bytes = multigrid_bytes(size, plan.form);
  return plan;
}

// Very thin parts make the matrix with multipliers useless in double precision, as they do the factor of the
// one without; iterations on that one still work.
SolverPlan without_multipliers(const SizeForecast& size) {
  return {
      Method::cg, Preconditioner::multigrid, Operator::matrix_free,
      multigrid_bytes(size, Operator::matrix_free),
      "iterations on the displacements that satisfy all ties, with a multigrid; multipliers are the forces "
      "that these leave"};
}

// Flops as "3.2 Gflop".
std::string flops_text(double flops) {
  return flops < 1e9 ? fmt::format("{:.3g} Mflop", 1e-6 * flops) : fmt::format("{:.3g} Gflop", 1e-9 * flops);
}

std::vector<SolverPlan> automatic_plans(const SizeForecast& size, const solvers::SolverOptions& options,
                                        double available) {
  const bool tied = size.has_multipliers();
  const bool jacobi = options.preconditioner == Preconditioner::block_jacobi;
  const double unknowns = std::max(1.0, static_cast<double>(size.unknowns));
  const double per_unknown = size.factor.flops / unknowns;
  // Every right side costs its iterations, and next to nothing where there are factors.
  const bool is_cheap = size.factor.flops <= std::max(few_flops, most_flops_per_unknown * unknowns) *
                                                 size.right_sides *
                                                 (size.is_nearly_incompressible ? more_if_incompressible : 1);
  std::vector<SolverPlan> direct, iterative;
  if (options.form != Operator::matrix_free) direct.push_back(direct_plan(size, direct_method(size)));
  const bool can_iterate =
      tied ? !jacobi && options.form != Operator::assembled : !jacobi || size.processes == 1;
  if (can_iterate) iterative.push_back(iterative_plan(size, options, available));
  if (direct.empty() && iterative.empty()) refuse("operator 'matrix_free' and these options leave no method");
  const std::string factor = fmt::format("factors take about {}, {} an unknown",
                                         flops_text(size.factor.flops), flops_text(per_unknown));
  const std::string little = size.right_sides == 1
                                 ? ", which is little"
                                 : fmt::format(", which is little for {} load cases", size.right_sides);
  for (SolverPlan& plan : direct) plan.reason = is_cheap ? factor + little : factor;
  for (SolverPlan& plan : iterative) {
    const bool fits = direct.empty() || direct.front().predicted_bytes <= available;
    plan.reason = (!fits ? fmt::format("factors would take about {} of the {} available: ",
                                       gigabytes(direct.front().predicted_bytes), gigabytes(available))
                   : is_cheap || direct.empty() ? ""
                                                : factor + ": ") +
                  plan.reason;
  }
  std::vector<SolverPlan> plans = is_cheap ? direct : iterative;
  const std::vector<SolverPlan>& rest = is_cheap ? iterative : direct;
  plans.insert(plans.end(), rest.begin(), rest.end());
  // What MUMPS fails on for reasons of its own, LU may do, at twice the cost.
  if (tied && size.processes == 1 && options.form != Operator::matrix_free)
    plans.push_back(direct_plan(size, Method::umfpack, "LU, which pivots more freely"));
  if (tied && can_iterate && !size.has_mortar) plans.push_back(without_multipliers(size));
  return plans;
}

SolverPlan named_plan(const SizeForecast& size, const solvers::SolverOptions& options, double available) {
  SolverPlan plan = is_iterative(options.method) ? iterative_plan(size, options, available)
                                                 : direct_plan(size, options.method);
  plan.reason = "asked for by name" + (plan.reason.empty() ? "" : ": " + plan.reason);
  return plan;
}

std::string described(const SolverPlan& plan) {
  if (!is_iterative(plan)) return fmt::format("method '{}'", solvers::name(plan.method));
  return fmt::format("method '{}' {}", solvers::name(plan.method),
                     plan.form == Operator::assembled ? "and a matrix" : "without a matrix");
}

std::string advice(const SizeForecast& size, const solvers::SolverOptions& options, const SolverPlan& plan) {
  const char* const less =
      size.processes > 1 ? "or use more computers" : "or use more processes on more computers";
  if (options.method != Method::automatic && !is_iterative(options.method))
    return fmt::format("let method = \"auto\" choose, refine less, {}", less);
  if (is_iterative(plan) && plan.form == Operator::assembled &&
      plan.preconditioner == Preconditioner::multigrid)
    return fmt::format("leave operator = \"auto\", refine less, {}", less);
  return fmt::format("refine less, {}", less);
}

[[noreturn]] void refuse_memory(const SizeForecast& size, const solvers::SolverOptions& options,
                                const SolverPlan& plan, double before, double available) {
  const double needed = plan.predicted_bytes + before;
  // Factors grow with the power 4/3, all else in proportion.
  const double fitting =
      static_cast<double>(size.unknowns) *
      std::pow(std::max(0.0, available - fixed_bytes(plan.method)) / (needed - fixed_bytes(plan.method)),
               is_iterative(plan) ? 1.0 : 0.75);
  throw Error(
      ErrorCode::out_of_memory,
      fmt::format("{} unknowns with {} would take about {}, and {} are available; {} "
                  "would fit: {}, or raise [solver] memory_limit if you know better",
                  size.unknowns < 1'000'000 ? fmt::format("{}", size.unknowns)
                                            : about(1e-6 * static_cast<double>(size.unknowns)) + " million",
                  described(plan), gigabytes(needed), gigabytes(std::max(0.0, available)),
                  about_unknowns(fitting), advice(size, options, plan)));
}

std::vector<SolverPlan> plans_that_fit(const SizeForecast& size, const solvers::SolverOptions& options,
                                       double before, double available) {
  check_coupling(options.method, size);
  check_processes(options, size.processes);
  check_parts(options, size);
  const double left = available - before;
  const std::vector<SolverPlan> all = options.method == Method::automatic
                                          ? automatic_plans(size, options, left)
                                          : std::vector{named_plan(size, options, left)};
  std::vector<SolverPlan> fitting;
  for (const SolverPlan& plan : all)
    if (plan.predicted_bytes <= left) fitting.push_back(plan);
  if (fitting.empty())
    refuse_memory(size, options,
                  *std::min_element(all.begin(), all.end(),
                                    [](const SolverPlan& a, const SolverPlan& b) {
                                      return a.predicted_bytes < b.predicted_bytes;
                                    }),
                  before, available);
  return fitting;
}

}  // namespace

bool is_iterative(const SolverPlan& plan) {
  return is_iterative(plan.method);
}

double available_bytes(const solvers::SolverOptions& options, const solvers::Processes& processes) {
  const std::int64_t found = solvers::available_memory();
  // What other processes on the same computer will take is theirs.
  const double here = options.memory_limit > 0
                          ? options.memory_limit - static_cast<double>(solvers::resident_memory())
                      : found > 0 ? static_cast<double>(found) / processes.on_this_computer()
                                  : 1e300;
  return -processes.largest(-here);
}

std::vector<SolverPlan> solver_plans(const SizeForecast& size, const solvers::SolverOptions& options,
                                     double available) {
  return plans_that_fit(size, options, 0, available);
}

void require_memory(const geometry::MultiPatch& model, const DirectionKnots& knots,
                    const std::vector<Material>& materials, Coupling coupling,
                    NonMatchingCoupling non_matching, const solvers::SolverOptions& options,
                    const solvers::Processes& processes) {
  const SizeForecast size = forecast_size(model, knots, materials, coupling, processes.count(), non_matching);
  plans_that_fit(size, options, size.geometry_bytes + size.nodal_bytes, available_bytes(options, processes));
}

}  // namespace isopatch::iga
