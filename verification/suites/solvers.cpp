// Every way to solve gives the same solution, iterations do not grow with the problem, and what cannot be
// solved is said to be so.

#include "geometry/base/larger.hpp"
#include "solvers/solve.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "geometry/base/error.hpp"
#include "verification/suites/linear_field.hpp"
#include "verification/suites/program_run.hpp"
#include "verification/suites/solved_study.hpp"

namespace isopatch::verification {
namespace {

using Settings = std::vector<std::string>;

Settings joined(Settings a, const Settings& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

// ------------------------------------------------------------ the same answer

struct Way {
  std::string name;
  Settings settings;
  bool iterates = false;
};

const std::vector<Way> ways_to_eliminate = {
    {"mumps", {"solver.method='mumps'"}},
    {"umfpack", {"solver.method='umfpack'"}},
    {"cg with block Jacobi", {"solver.method='cg'", "solver.preconditioner='block_jacobi'"}, true},
    {"cg with multigrid, stored matrix", {"solver.method='cg'", "solver.operator='assembled'"}, true},
    {"cg with multigrid, matrix-free", {"solver.method='cg'", "solver.operator='matrix_free'"}, true},
};
const std::vector<Way> ways_with_multipliers = {
    {"mumps with multipliers", {"coupling.method='lagrange'", "solver.method='mumps'"}},
    {"umfpack with multipliers", {"coupling.method='lagrange'", "solver.method='umfpack'"}},
    {"minres with multipliers, matrix-free",
     {"coupling.method='lagrange'", "solver.method='minres'", "solver.tolerance=3e-11"},
     true},
};

// Direct methods refine in extended precision. An iteration's error in energy is about what it was asked for,
// and a coefficient's may be larger by the ratio of the two norms, which stays below 10 here. Minimal
// residuals end where round-off stops them, at 1.5e-11 on the link.
const Tolerance of_direct_methods = round_off(1e3, "another factorization");
const Tolerance of_asked_accuracy = {
    1e-10, "iterations to 1e-12, minimal residuals to 3e-11, and up to 10 times that in another norm"};

void expect_same_answer(const std::string& of, const std::string& file, const Settings& settings) {
  const Settings all = joined(settings, {"solver.tolerance=1e-12"});
  const SolvedStudy cholmod = solved(file, joined(all, {"solver.method='cholmod'"}));
  std::vector<Way> ways = ways_to_eliminate;
  ways.insert(ways.end(), ways_with_multipliers.begin(), ways_with_multipliers.end());
  for (const Way& way : ways) {
    const SolvedStudy other = solved(file, joined(all, way.settings));
    const auto claim = [&](const std::string& what, const char* unit, double reference, double value) {
      expect(Claim{fmt::format("{}, {}, {}", what, of, way.name), unit, ReferenceKind::other_method,
                   "cholmod, elimination", reference, value,
                   way.iterates ? of_asked_accuracy : of_direct_methods, other.named});
    };
    claim("energy", "J", cholmod.run.solution.results.internal_energy,
          other.run.solution.results.internal_energy);
    claim("difference of the displacement anywhere", "", 0,
          coefficient_difference(cholmod.run.solution.field, other.run.solution.field));
  }
}

TEST(Solvers, GiveTheSameAnswer) {
  expect_same_answer("link", "examples/link/study.toml", {});
  expect_same_answer("thick cylinder", "examples/thick_cylinder/study.toml",
                     {"discretization.degree=3", "discretization.refine=1"});
}

// ----------------------------------------------------------------- iterations

struct Point {
  std::string name;
  Settings settings;
};

// How many iterations each method took when this was written (the table of solvers/README.md).
struct Usual {
  int cg = 0;
  int minres = 0;
};

// Iterations to a relative error of 1e-8 at each point: at most twice what is usual, and the most no more
// than 1.5 times the fewest.
void expect_steady_iterations(const std::string& over, const std::string& file,
                              const std::vector<Point>& points, const Way& way, int usual) {
  int fewest = 1000000;
  int most = 0;
  ClaimStudy worst;
  for (const Point& point : points) {
    const SolvedStudy s =
        solved(file, joined(joined(way.settings, {"solver.tolerance=1e-8"}), point.settings));
    const int iterations = s.run.solution.solver.iterations;
    expect(Claim{
        fmt::format("iterations of {}, {}, {} unknowns", way.name, point.name, s.run.solution.size.dofs_free),
        "", ReferenceKind::other_method, "twice what is usual", 2. * usual, static_cast<double>(iterations),
        0, s.named, Comparison::at_most, 1.});
    fewest = smaller(fewest, iterations);
    if (iterations > most) worst = s.named;
    most = larger(most, iterations);
  }
  expect(Claim{fmt::format("most over fewest iterations of {} over {}", way.name, over), "",
               ReferenceKind::exact, "nearly independent of them", 1.5, static_cast<double>(most) / fewest, 0,
               worst, Comparison::at_most, 1.});
}

void expect_steady_iterations(const std::string& over, const std::string& file,
                              const std::vector<Point>& points, const Usual& usual) {
  expect_steady_iterations(over, file, points, {"cg", {"solver.method='cg'"}}, usual.cg);
  expect_steady_iterations(
      over, file, points, {"minres", {"coupling.method='lagrange'", "solver.method='minres'"}}, usual.minres);
}

constexpr Usual of_the_box{7, 16};
constexpr Usual of_the_link{11, 24};

const std::string link_study = "examples/link/study.toml";
const std::string box = "verification/performance/box.toml";

// From the first problem that has two levels; a multigrid of one level is a direct method.
TEST(Solvers, IterateSteadilyOverRefinements) {
  std::vector<Point> points;
  for (const int elements : {4, 8, 12})
    points.push_back(
        {fmt::format("box of 8 patches, p = 2, {} elements a patch", elements * elements * elements),
         {"discretization.degree=2", "model.patches=[2,2,2]",
          fmt::format("discretization.elements_per_direction=[{0},{0},{0}]", elements)}});
  expect_steady_iterations("refinements of a box", box, points, of_the_box);
  points.clear();
  for (const int refine : {1, 2})
    points.push_back(
        {fmt::format("link, p = 3, refine = {}", refine), {fmt::format("discretization.refine={}", refine)}});
  expect_steady_iterations("refinements of the link", link_study, points, of_the_link);
}

TEST(Solvers, IterateSteadilyOverDegrees) {
  std::vector<Point> points;
  for (const int degree : {3, 4, 5})
    points.push_back({fmt::format("link, p = {}, refine = 1", degree),
                      {fmt::format("discretization.degree={}", degree), "discretization.refine=1"}});
  expect_steady_iterations("degrees", link_study, points, of_the_link);
}

TEST(FullSolvers, IterateSteadilyOnLargerProblems) {
  std::vector<Point> points;
  for (const int refine : {2, 3, 4})
    points.push_back({fmt::format("link, p = 2, refine = {}", refine),
                      {"discretization.degree=2", fmt::format("discretization.refine={}", refine)}});
  expect_steady_iterations("refinements of the link, p = 2", link_study, points, of_the_link);
  points.clear();
  for (const int degree : {2, 3, 4, 5})
    points.push_back({fmt::format("link, p = {}, refine = 2", degree),
                      {fmt::format("discretization.degree={}", degree), "discretization.refine=2"}});
  expect_steady_iterations("degrees, refine = 2", link_study, points, of_the_link);
}

TEST(Solvers, IterateSteadilyOverPatches) {
  std::vector<Point> points;
  for (const int n : {2, 3, 4})
    points.push_back({fmt::format("box of {} patches, p = 2", n * n * n),
                      {"discretization.degree=2", fmt::format("model.patches=[{0},{0},{0}]", n),
                       "discretization.elements_per_direction=[4,4,4]"}});
  expect_steady_iterations("patches", box, points, of_the_box);
}

// ------------------------------------------------------------------- failures

// A call that must end with an error of a certain cause, and say certain words.
template <class Call>
void expect_error(const std::string& what, ErrorCode code, const std::string& words, const Call& call,
                  const ClaimStudy& study = {}) {
  std::string found = "no error";
  bool says = false;
  try {
    call();
  } catch (const Error& error) {
    found = name(error.code());
    says = std::string(error.what()).find(words) != std::string::npos;
    if (!says) found += fmt::format(": {}", error.what());
  }
  const bool holds = found == name(code) && says;
  expect(Claim{fmt::format("{} is refused: {}", what, holds ? name(code) : found), "", ReferenceKind::exact,
               fmt::format("{}, \"{}\"", name(code), words), 1, holds ? 1.0 : 0.0, 0, study});
}

void expect_study_error(const std::string& what, ErrorCode code, const std::string& words,
                        const ClaimStudy& study) {
  expect_error(
      what, code, words, [&] { solved(study.file, study.overrides); }, study);
}

TEST(Solvers, RefuseWhatCannotBeSolved) {
  expect_study_error("a body that can move", ErrorCode::free_body, "rigid motions",
                     {"examples/thick_cylinder/study.toml", {"support.0.faces=['start', 'bottom']"}});
  expect_study_error("an iteration that would take longer, cg", ErrorCode::not_converged,
                     "after 3 iterations", {link_study, {"solver.method='cg'", "solver.max_iterations=3"}});
  expect_study_error(
      "an iteration that would take longer, block Jacobi", ErrorCode::not_converged, "after 3 iterations",
      {link_study,
       {"solver.method='cg'", "solver.preconditioner='block_jacobi'", "solver.max_iterations=3"}});
  expect_study_error(
      "an iteration that would take longer, minres", ErrorCode::not_converged, "after 3 iterations",
      {link_study, {"coupling.method='lagrange'", "solver.method='minres'", "solver.max_iterations=3"}});
  expect_study_error("a factor that does not fit", ErrorCode::out_of_memory, "memory",
                     {link_study, {"solver.method='cholmod'", "solver.memory_limit=1000000"}});
  expect_study_error("cholmod with multipliers", ErrorCode::invalid_argument, "cholmod",
                     {link_study, {"coupling.method='lagrange'", "solver.method='cholmod'"}});
}

TEST(Solvers, RefuseSupportsThatContradict) {
  const app::BuiltProblem built =
      app::build_problem(app::read_study(std::filesystem::path(ISOPATCH_SOURCE_DIR) / link_study));
  iga::ElasticityProblem problem = built.problem;
  problem.supports.push_back(problem.supports.front());
  problem.supports.back().name = "the same bore, moved";
  std::get<iga::PrescribedDisplacement>(problem.supports.back().condition).value = {1e-3, 0.0, 0.0};
  expect_error("one face held in two places", ErrorCode::conflict, "the same bore, moved",
               [&] { iga::solve_elasticity(problem); });
}

// Three masses on two springs, held nowhere. Round-off leaves their last pivot at 1e-16, and not at 0.
solvers::LinearSystem loose_springs() {
  solvers::LinearSystem system;
  system.stiffness.row_start = {0, 2, 4, 5};
  system.stiffness.columns = {0, 1, 1, 2, 2};
  for (const double value : {0.1, -0.1, 0.8, -0.7, 0.7})
    for (int i = 0; i < 9; ++i) system.stiffness.values.push_back(i % 4 == 0 ? value : 0.0);
  system.load = Eigen::VectorXd::Ones(9);
  return system;
}

TEST(Solvers, RefuseSingularSystems) {
  for (const auto method : {solvers::Method::cholmod, solvers::Method::mumps, solvers::Method::umfpack})
    expect_error(fmt::format("a singular matrix, {}", name(method)), ErrorCode::singular_system, "",
                 [&] { solvers::solve(loose_springs(), {.method = method}); });
}

TEST(Solvers, RefuseATolerancePastRoundOff) {
  expect_study_error(
      "what doubles cannot reach, minres to 1e-14", ErrorCode::not_converged, "instead of 1.000e-14",
      {link_study, {"coupling.method='lagrange'", "solver.method='minres'", "solver.tolerance=1e-14"}});
}

}  // namespace
}  // namespace isopatch::verification
