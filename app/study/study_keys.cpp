#include "app/study/study_keys.hpp"

#include <fmt/format.h>

#include <array>
#include <string>
#include <variant>
#include <vector>

#include "app/study/selection_keys.hpp"

namespace isopatch::app {
namespace {

namespace dim = dimensions;

/// An integer for all directions, or three.
std::array<int, 3> read_per_direction(const ConfigValue& value, const std::string& what, int least,
                                      int most) {
  if (!std::holds_alternative<std::vector<ConfigValue>>(value.value)) {
    const int all = read_integer(value, what, least, most);
    return {all, all, all};
  }
  const auto& items = read_array(value, what);
  if (items.size() != 3)
    throw error_at(value.place, fmt::format("{}: expected one number or 3, got {}", what, items.size()));
  std::array<int, 3> result{};
  for (std::size_t i = 0; i < 3; ++i) result[i] = read_integer(items[i], what, least, most);
  return result;
}

/// A key of a member of one of S's members.
template <class S, class Options>
Key<S> per_direction_key(const std::string& name, Options S::*options, std::array<int, 3> Options::*member,
                         int least, int most, const std::string& fallback, std::string meaning) {
  Key<S> key = custom_key<S>(name, "integer, or array of 3", std::move(meaning),
                             [=](S& target, const ConfigValue& value) {
                               target.*options.*member = read_per_direction(value, name, least, most);
                             });
  key.text.range = fmt::format("from {} to {}", least, most);
  key.text.fallback = fallback;
  return key;
}

template <class S, class Options>
Key<S> option_key(const std::string& name, Options S::*options, int Options::*member, int least, int most,
                  const std::string& fallback, std::string meaning) {
  Key<S> key = custom_key<S>(name, "integer", std::move(meaning), [=](S& target, const ConfigValue& value) {
    target.*options.*member = read_integer(value, name, least, most);
  });
  key.text.range = fmt::format("from {} to {}", least, most);
  key.text.fallback = fallback;
  return key;
}

}  // namespace

const Keys<StudyKeys>& study_keys() {
  static const Keys<StudyKeys> keys = {
      text_key<StudyKeys>("title", &StudyKeys::title, "Name of the study, for reports."),
      value_key<StudyKeys>("model", "table", &StudyKeys::model, "Where the patches come from.").required(),
      value_key<StudyKeys>("parameterization", "table", &StudyKeys::parameterization,
                           "How solids become patches, where the model is made of solids."),
      value_key<StudyKeys>(
          "segmentation", "table", &StudyKeys::segmentation,
          "How solids are cut into topological hexahedra, where the model is a file of solids."),
      value_key<StudyKeys>("reconstruction", "table", &StudyKeys::reconstruction,
                           "How triangles become a solid, where the model is a file of triangles."),
      value_key<StudyKeys>("discretization", "table", &StudyKeys::discretization, "The solution space."),
      value_key<StudyKeys>("material", "array of tables", &StudyKeys::material,
                           "Materials; every patch needs exactly one.")
          .required(),
      value_key<StudyKeys>("support", "array of tables", &StudyKeys::support, "What holds the part.")
          .required(),
      value_key<StudyKeys>("load", "array of tables", &StudyKeys::load, "What acts on the part."),
      value_key<StudyKeys>("combination", "array of tables", &StudyKeys::combination,
                           "Sums of load cases with factors."),
      value_key<StudyKeys>("coupling", "table", &StudyKeys::coupling, "How the patches are held together."),
      value_key<StudyKeys>("solver", "table", &StudyKeys::solver, "How the equations are solved."),
      value_key<StudyKeys>("probe", "array of tables", &StudyKeys::probe, "Places whose values are wanted."),
      value_key<StudyKeys>("section", "array of tables", &StudyKeys::section,
                           "Cuts through the part whose forces and moments are wanted."),
      value_key<StudyKeys>("accuracy", "table", &StudyKeys::accuracy,
                           "How accurate `isopatch run` shall be: it refines where errors come from."),
      value_key<StudyKeys>("modes", "table", &StudyKeys::modes, "What `isopatch modes` looks for."),
      value_key<StudyKeys>("output", "table", &StudyKeys::output, "What is written, and where."),
  };
  return keys;
}

const Keys<DiscretizationKeys>& discretization_keys() {
  using Options = iga::DiscretizationOptions;
  constexpr auto options = &DiscretizationKeys::options;
  static const Keys<DiscretizationKeys> keys = {
      per_direction_key(
          "degree", options, &Options::degree, 1, 10, "2",
          "Degree of the splines, raised where the geometry's is lower and never lowered; the continuity "
          "of the geometry stays. 1 keeps the geometry's everywhere; elements of degree 1 hardly bend."),
      option_key("refine", options, &Options::refine, 0, 10, "0",
                 "How often every element is halved, after all that the other keys ask for."),
      per_direction_key(
          "elements_per_direction", options, &Options::elements_per_direction, 1, 10000,
          "as the geometry has",
          "Least number of elements along each direction of each patch, before refine halves them. Patches "
          "made of a solid, of triangles or of hexahedra have 2 where neither this, refine, max_size, "
          "[[discretization.patch]] nor [accuracy] says how fine."),
      custom_key<DiscretizationKeys>(
          "max_size", type_name(dim::length), "Largest length of an element's edge, before refine halves it.",
          [](DiscretizationKeys& target, const ConfigValue& value) {
            target.options.max_size = read_quantity(value, "max_size", dim::length, positive);
          })
          .with_default("no limit"),
      option_key("continuity", options, &Options::continuity, 0, 9, "as smooth as degree and geometry allow",
                 "Highest continuity C^k across the knots inside a patch."),
      integer_key<DiscretizationKeys>(
          "points", &DiscretizationKeys::points, 0, 20,
          "Gauss points per element and direction; 0 means degree + 1, and more in "
          "directions in which the map of a patch is so curved that it needs them."),
      value_key<DiscretizationKeys>("patch", "array of tables", &DiscretizationKeys::patch,
                                    "What some patches have beyond all others; see below."),
  };
  return keys;
}

const Keys<PatchDiscretizationKeys>& patch_discretization_keys() {
  using P = PatchDiscretizationKeys;
  using Options = iga::PatchRefinement;
  constexpr auto options = &P::refinement;
  static const Keys<P> keys = {
      custom_key<P>("patches", "patches, as in [[material]]",
                    "Which ones: indices, ranges or names of bodies.",
                    [](P& target, const ConfigValue& value) { target.patches = read_patch_selection(value); })
          .with_default("all, with `part`"),
      custom_key<P>("part", "table, as in [[load]]",
                    "Only patches that reach into this plane's side, cylinder, sphere or box.",
                    [](P& target, const ConfigValue& value) { target.reach.part = read_part(value); }),
      per_direction_key("degree", options, &Options::degree, 1, 10, "that of [discretization]",
                        "Degree of the splines, if it is higher than that of [discretization]."),
      option_key("refine", options, &Options::refine, 0, 10, "0",
                 "How often every element of these patches is halved, after `discretization.refine`."),
      per_direction_key("elements_per_direction", options, &Options::elements_per_direction, 1, 10000,
                        "that of [discretization]", "Least number of elements before they are halved."),
      custom_key<P>("max_size", type_name(dim::length),
                    "Largest length of an element's edge before it is halved.",
                    [](P& target, const ConfigValue& value) {
                      target.refinement.max_size = read_quantity(value, "max_size", dim::length, positive);
                    })
          .with_default("that of [discretization]"),
  };
  return keys;
}

const Keys<CouplingKeys>& coupling_keys() {
  static const Choices<iga::Coupling> methods = {{"elimination", iga::Coupling::elimination},
                                                 {"lagrange", iga::Coupling::lagrange}};
  using NonMatching = iga::NonMatchingCoupling;
  static const Choices<std::optional<NonMatching>> non_matching = {
      {"refuse", std::nullopt}, {"nitsche", NonMatching::nitsche}, {"mortar", NonMatching::mortar}};
  static const Choices<iga::MortarSide> mortar_sides = {{"auto", iga::MortarSide::automatic},
                                                        {"other", iga::MortarSide::other}};
  static const Keys<CouplingKeys> keys = {
      choice_key(
          "method", &CouplingKeys::method, methods,
          "Coincident control points share their unknowns, or multipliers tie them. `isopatch compare` "
          "runs both."),
      choice_key(
          "non_matching", &CouplingKeys::non_matching, non_matching,
          "Faces that lie on one another with other elements, parameters or outlines (T-joints) are an "
          "error, or are coupled: by Nitsche's method, which leaves the system positive definite, or by "
          "mortar multipliers, for which one side must be covered all over. Natural modes always take "
          "Nitsche's method."),
      choice_key("mortar_side", &CouplingKeys::mortar_side, mortar_sides,
                 "Which side has the mortar multipliers: the softer, of equal ones that with more functions, "
                 "or the other one, where both can."),
  };
  return keys;
}

const Keys<solvers::SolverOptions>& solver_keys() {
  using O = solvers::SolverOptions;
  using M = solvers::Method;
  static const Choices<M> methods = {{"auto", M::automatic},  {"direct", M::automatic},
                                     {"cholmod", M::cholmod}, {"mumps", M::mumps},
                                     {"umfpack", M::umfpack}, {"cg", M::cg},
                                     {"minres", M::minres}};
  static const Choices<solvers::Preconditioner> preconditioners = {
      {"multigrid", solvers::Preconditioner::multigrid},
      {"block_jacobi", solvers::Preconditioner::block_jacobi}};
  static const Choices<solvers::Operator> operators = {{"auto", solvers::Operator::automatic},
                                                       {"assembled", solvers::Operator::assembled},
                                                       {"matrix_free", solvers::Operator::matrix_free}};
  static const Keys<O> keys = {
      choice_key(
          "method", &O::method, methods,
          "auto factorizes where that costs little (CHOLMOD for elimination, MUMPS for lagrange or several "
          "processes) and iterates where factors would cost more or not fit (cg for elimination, minres for "
          "lagrange); if the one fails it tries the other, and for lagrange also cg with all ties "
          "eliminated; the summary says why. direct is another word for auto."),
      quantity_key<O>(
          "tolerance", &O::tolerance, dim::none, {1e-14, 1e-2},
          "Relative residual to reach; with a multigrid the relative error in its norm, about that in "
          "energy."),
      integer_key<O>("max_iterations", &O::max_iterations, 1, 10000000,
                     "Most iterations of an iterative method."),
      choice_key(
          "preconditioner", &O::preconditioner, preconditioners,
          "Of cg and minres. A multigrid needs some ten iterations more or less whatever the size and the "
          "degree; block_jacobi, for cg on one process, needs many more and is there for comparison."),
      choice_key("operator", &O::form, operators,
                 "Whether cg with a multigrid stores the matrix or computes its product anew each time. auto "
                 "stores it where it fits and multiplies faster, which it does for degree 1 alone."),
      custom_key<O>("smoothing_degree", "integer",
                    "Degree of the multigrid's Chebyshev smoother, 1 .. 20. With a higher one iterations are "
                    "fewer and each takes longer; the time is least near 4.",
                    [](O& target, const ConfigValue& value) {
                      const auto degree = static_cast<int>(read_integer(value, "smoothing_degree", 1, 20));
                      target.multigrid.smoothing_degree = degree;
                      // A polynomial damps a range in proportion to the square of its degree.
                      target.multigrid.smoothing_range = 2.5 * degree * degree;
                    })
          .with_default("4"),
      quantity_key<O>("memory_limit", &O::memory_limit, dim::data, {0, 1e15},
                      "What the run may take, of each process; 0 means what the machine, a control group or "
                      "a batch job has to "
                      "spare. Runs that are expected to take more are refused before the model is refined."),
  };
  return keys;
}

const Keys<ProbeKeys>& probe_keys() {
  using P = ProbeKeys;
  static const Keys<P> keys = {
      text_key<P>("name", &P::name, "For summary.json.").with_default("\"probe 1\", ..."),
      vector_key<P>("point", &P::point, dim::length, "A place; either this or patch and parameter."),
      custom_key<P>("patch", "integer", "The patch, from 0.",
                    [](P& target, const ConfigValue& value) {
                      target.patch = read_integer(value, "patch", 0, 1000000);
                    }),
      vector_key<P>("parameter", &P::parameter, dim::none,
                    "Parameter in the patch's knot ranges, as the file gives them."),
  };
  return keys;
}

const Keys<OutputInput>& output_keys() {
  using O = OutputInput;
  static const Choices<FieldPrecision> precisions = {{"auto", FieldPrecision::automatic},
                                                     {"full", FieldPrecision::full},
                                                     {"single", FieldPrecision::single}};
  static const Keys<O> keys = {
      custom_key<O>(
          "directory", "string",
          "Folder of the results, made where absent; relative paths count from the study's folder. "
          "The option --output DIR replaces it.",
          [](O& target, const ConfigValue& value) { target.directory = read_text(value, "directory"); })
          .with_default("\"results\""),
      flag_key<O>(
          "fields", &O::fields,
          "Whether fields are written for ParaView: results.vtm (straight hexahedra, for all filters), "
          "results_boundaries.vtm and results_exact.vtm, with their parts in fields/."),
      custom_key<O>(
          "pieces", "integer, from 1 to 32",
          "Straight hexahedra of results.vtm per element and direction, at least; more where a line "
          "would turn by more than 9 degrees in one. Where this is not given, layers of them are halved "
          "until "
          "von Mises stress between nodes is within 1 % of the largest.",
          [](O& target, const ConfigValue& value) {
            target.field_options.pieces = static_cast<int>(read_integer(value, "pieces", 1, 32));
          })
          .with_default("4; 2 above 100,000 elements, 1 above 1,000,000"),
      custom_key<O>(
          "exact", "true or false",
          "Whether results_exact.vtm is written: the smooth surface, as rational Bezier cells.",
          [](O& target, const ConfigValue& value) { target.field_options.exact = read_flag(value, "exact"); })
          .with_default("true"),
      custom_key<O>(
          "precision", quoted_list(names(precisions)),
          "Of the numbers of results_exact.vtm: 8 bytes each, or 4 with a relative error of 6e-8. auto takes "
          "single where full would need more than 1 GB. results.h5 always has all digits.",
          [](O& target, const ConfigValue& value) {
            target.field_options.precision = read_choice(value, "precision", precisions);
          })
          .with_default("\"auto\""),
      flag_key<O>("hdf5", &O::hdf5,
                  "Whether results.h5 is written, for `isopatch report`, `probe`, `fields` and `info`."),
      flag_key<O>("report", &O::report,
                  "Whether report.html is written: pictures and figures on one page for any browser."),
      flag_key<O>(
          "stages", &O::stages,
          "Whether the solid, its hexahedra and its patches are kept in the folder `stages`: a further run "
          "takes those that files, keys or the program have not changed since. One of each kind is kept."),
      flag_key<O>(
          "error_estimate", &O::error_estimate,
          "Whether the error of the discretization is estimated: in energy, in every element, and of "
          "the stress at probes and where it is largest. Takes a fifth of a run or less, and some 1 kB "
          "of memory for each unknown."),
      vector_key<O>("moments_about", &O::moments_about, dim::length,
                    "The point about which moments of reactions are given besides those about the origin.")
          .with_default("[0, 0, 0]"),
  };
  return keys;
}

}  // namespace isopatch::app
