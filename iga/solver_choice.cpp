#include "iga/solver_choice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/base/error.hpp"
#include "iga/stiffness_pattern.hpp"
#include "solvers/memory.hpp"

namespace isopatch::iga {
namespace {

using solvers::Method;
using solvers::Operator;

// Measured: what a run holds per unknown with the multigrid, of which matrix-free products are the least
// part.
constexpr double multigrid_bytes = 700;
// Above this a multigrid beats factors (solvers/README.md, "Factors or iterations").
constexpr std::int64_t most_factorized_unknowns = 30'000;
// The same for a material that hardly changes its volume, on which iterations grow.
constexpr std::int64_t most_factorized_if_incompressible = 100'000;
constexpr double nearly_incompressible = 0.45;  // Poisson's ratio
// Matrices with fewer bytes per unknown (degree 1) multiply faster than their product is computed anew.
constexpr double cheap_matrix_bytes = 600;

struct Prediction {
  std::int64_t unknowns = 0;
  double matrix = 0;     // bytes, of this process
  double factor = 0;     // bytes of a direct method
  double iterative = 0;  // bytes of the multigrid and its vectors
};

// Entries of the factor of an n-row matrix with `width` entries per row: nested dissection of a body whose
// separators hold about (rows per width)^(2/3) widths each.
double factor_bytes(double rows, double width, bool saddle) {
  // 344 million entries for 73,167 rows of a cube with 1,029 entries each; plates and frames need less.
  constexpr double entries_of_cube = 344e6;
  const double growth = std::pow(rows / 73167.0, 4.0 / 3.0) * std::pow(width / 1029.0, 2.0 / 3.0);
  return (saddle ? 18.0 : 12.5) * entries_of_cube * growth;
}

Prediction predict(const SolutionTask& task) {
  const Discretization& d = task.problem.discretization;
  const std::vector<PatchSpace> spaces = isoparametric_spaces(d);
  const RowNumbering classes{task.classes.class_of, task.classes.count()};
  const LocalRows local = local_rows(classes, d.first_node, task.distribution, task.processes);
  const StiffnessSize size =
      stiffness_size(spaces, parts_of(task.distribution, spaces, task.processes.rank()), local.numbering);
  Prediction result;
  const double rows = 3.0 * task.classes.count();
  result.unknowns = static_cast<std::int64_t>(rows);
  result.matrix = static_cast<double>(size.bytes);
  const double local_share = local.numbering.rows / std::max(1.0, static_cast<double>(task.classes.count()));
  const double width =
      18.0 * static_cast<double>(size.blocks) / std::max(1.0, 3.0 * local.numbering.rows) - 3;
  result.factor =
      factor_bytes(rows, width, task.coupling == Coupling::lagrange) / task.processes.count() + result.matrix;
  result.iterative = multigrid_bytes * rows * local_share;
  if (task.coupling == Coupling::lagrange)
    result.iterative += 500.0 * static_cast<double>(task.classes.class_of.size());
  for (double* bytes : {&result.matrix, &result.factor, &result.iterative})
    *bytes = task.processes.largest(*bytes);
  return result;
}

double gigabytes(double bytes) {
  return bytes / 1e9;
}

bool is_nearly_incompressible(const std::vector<Material>& materials) {
  return std::any_of(materials.begin(), materials.end(),
                     [](const Material& material) { return poisson(material) > nearly_incompressible; });
}

double bytes_of(const SolverChoice& choice, const Prediction& prediction) {
  switch (choice.method) {
    case Method::cg:
    case Method::minres:
      return prediction.iterative + (choice.form == Operator::assembled ? prediction.matrix : 0);
    default:
      return prediction.matrix + prediction.factor;
  }
}

SolverChoice automatic(const SolutionTask& task, const Prediction& prediction, double available) {
  const bool tied = task.coupling == Coupling::lagrange;
  const Method direct = tied || task.processes.count() > 1 ? Method::mumps : Method::cholmod;
  const std::int64_t most = is_nearly_incompressible(task.problem.materials)
                                ? most_factorized_if_incompressible
                                : most_factorized_unknowns;
  const bool small = prediction.unknowns <= most;
  const bool fits = prediction.matrix + prediction.factor <= available;
  if (small && fits) return {direct, Operator::assembled, {}, 0};  // `solvers::solve` says why
  return {
      tied ? Method::minres : Method::cg, Operator::automatic,
      small ? fmt::format("factors would take about {:.1f} GB of the {:.1f} GB available: iterations with a "
                          "multigrid",
                          gigabytes(prediction.factor), gigabytes(available))
            : fmt::format("more than {} unknowns: iterations with a multigrid", most),
      0};
}

Operator chosen_form(const SolutionTask& task, const solvers::SolverOptions& options,
                     const Prediction& prediction, double available, std::string& reason) {
  if (task.coupling == Coupling::lagrange) return Operator::matrix_free;
  if (options.form != Operator::automatic) return options.form;
  const bool fits = prediction.iterative + prediction.matrix <= available;
  if (!fits) {
    reason += fmt::format("; without a matrix, which would take {:.1f} GB", gigabytes(prediction.matrix));
    return Operator::matrix_free;
  }
  if (prediction.matrix / static_cast<double>(prediction.unknowns) <= cheap_matrix_bytes)
    return Operator::assembled;
  reason += "; without a matrix, whose product would be slower at this degree";
  return Operator::matrix_free;
}

[[noreturn]] void refuse(const SolverChoice& choice, const Prediction& prediction, double needed,
                         double available) {
  const bool direct = choice.method != Method::cg && choice.method != Method::minres;
  // Factors grow with the power 4/3, all else in proportion.
  const double fitting =
      static_cast<double>(prediction.unknowns) * std::pow(available / needed, direct ? 0.75 : 1.0);
  throw Error(
      ErrorCode::out_of_memory,
      fmt::format("{:.3g} million unknowns with method '{}'{} would take about {:.1f} GB, and {:.1f} GB are "
                  "available; about {:.2g} million unknowns would fit: {}, or raise [solver] memory_limit if "
                  "you know better",
                  1e-6 * static_cast<double>(prediction.unknowns), solvers::name(choice.method),
                  direct                               ? ""
                  : choice.form == Operator::assembled ? " and a matrix"
                                                       : " without a matrix",
                  gigabytes(needed), gigabytes(available), 1e-6 * fitting,
                  direct ? "let method = \"auto\" choose, refine less, or use more processes"
                  : choice.form == Operator::assembled
                      ? "leave operator = \"auto\", refine less, or use more "
                        "processes on more computers"
                      : "refine less, or use more computers"));
}

void check_coupling(const SolutionTask& task, Method method) {
  const bool tied = task.coupling == Coupling::lagrange;
  if (tied && method == Method::cg)
    throw Error(
        ErrorCode::invalid_argument,
        "method 'cg' cannot treat the multipliers of coupling 'lagrange'; use 'auto', 'minres', 'mumps' or "
        "'umfpack', or coupling 'elimination'");
  if (!tied && method == Method::minres)
    throw Error(ErrorCode::invalid_argument,
                "method 'minres' is for coupling 'lagrange'; use 'auto' or 'cg' with coupling 'elimination'");
}

}  // namespace

SolverChoice choose_solver(const SolutionTask& task, const solvers::SolverOptions& options) {
  check_coupling(task, options.method);
  const Prediction prediction = predict(task);
  const std::int64_t found = solvers::available_memory();
  // What other processes on the same computer will take is theirs.
  const double here = options.memory_limit > 0 ? options.memory_limit
                      : found > 0 ? static_cast<double>(found) / task.processes.on_this_computer()
                                  : 1e300;
  const double available = -task.processes.largest(-here);  // all processes must choose alike
  SolverChoice choice{options.method, Operator::assembled, "asked for by name", 0};
  if (options.method == Method::automatic) choice = automatic(task, prediction, available);
  const bool iterative = choice.method == Method::cg || choice.method == Method::minres;
  if (iterative && options.preconditioner == solvers::Preconditioner::multigrid)
    choice.form = chosen_form(task, options, prediction, available, choice.reason);
  const double needed = bytes_of(choice, prediction);
  choice.predicted_bytes = static_cast<std::int64_t>(needed);
  // Factors are estimated for a cube, the worst of bodies: by name they may be tried up to twice what there
  // is.
  const bool direct = !iterative;
  if (needed > (direct ? 2 : 1) * available) refuse(choice, prediction, needed, available);
  return choice;
}

}  // namespace isopatch::iga
