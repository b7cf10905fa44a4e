#include "app/study_keys.hpp"

#include <fmt/format.h>

#include <charconv>

#include "app/standard_materials.hpp"

namespace isopatch::app {
namespace {

namespace dim = dimensions;

template <class S>
Key<S> value_key(const std::string& name, const std::string& type, std::optional<ConfigValue> S::*member,
                 std::string meaning) {
  return custom_key<S>(name, type, std::move(meaning),
                       [=](S& target, const ConfigValue& value) { target.*member = value; });
}

template <class S>
Key<S> optional_text_key(const std::string& name, std::optional<std::string> S::*member,
                         std::string meaning) {
  return custom_key<S>(name, "string", std::move(meaning),
                       [=](S& target, const ConfigValue& value) { target.*member = read_text(value, name); });
}

std::vector<std::string> read_faces(const ConfigValue& value) {
  if (std::holds_alternative<std::string>(value.value)) return {read_text(value, "faces")};
  std::vector<std::string> faces;
  for (const ConfigValue& item : read_array(value, "faces")) faces.push_back(read_text(item, "faces"));
  if (faces.empty()) throw error_at(value.place, "faces is empty: name at least one face or boundary");
  return faces;
}

template <class S>
Key<S> faces_key() {
  return custom_key<S>(
      "faces", "array of strings",
      "Faces as \"patch:side\" with the side west, east, south, north, front or back, or names of "
      "boundaries. `isopatch info` lists both.",
      [](S& target, const ConfigValue& value) { target.faces = read_faces(value); });
}

template <class S>
Key<S> where_key() {
  return table_key<S, FaceConditions>(
      "where", &S::where, where_keys,
      "Faces chosen by geometry; together with `faces`, those that fulfil both.");
}

std::pair<int, int> read_range(const ConfigValue& value) {
  constexpr int most = 1000000;
  if (!std::holds_alternative<std::string>(value.value)) {
    const int index = read_integer(value, "patches", 0, most);
    return {index, index};
  }
  const std::string text = read_text(value, "patches");
  int first = 0;
  int last = 0;
  const char* end = text.data() + text.size();
  const auto [dash, problem] = std::from_chars(text.data(), end, first);
  if (problem == std::errc{} && dash != end && *dash == '-') {
    const auto [stop, second] = std::from_chars(dash + 1, end, last);
    if (second == std::errc{} && stop == end && first >= 0 && first <= last) return {first, last};
  }
  throw error_at(
      value.place,
      fmt::format("patches: expected \"all\", numbers from 0 or ranges such as \"0-8\", got \"{}\"", text));
}

PatchSelection read_patches(const ConfigValue& value) {
  PatchSelection selection{{}, value.place};
  if (const auto* text = std::get_if<std::string>(&value.value); text && *text == "all") return selection;
  if (const auto* items = std::get_if<std::vector<ConfigValue>>(&value.value)) {
    for (const ConfigValue& item : *items) selection.ranges.push_back(read_range(item));
    if (items->empty())
      throw error_at(value.place, "patches is empty: name at least one patch, or write \"all\"");
  } else {
    selection.ranges.push_back(read_range(value));
  }
  return selection;
}

template <class S>
Key<S> patches_key(std::string meaning) {
  return custom_key<S>("patches", "\"all\", integer, or array of integers and ranges \"0-8\"",
                       std::move(meaning),
                       [](S& target, const ConfigValue& value) { target.patches = read_patches(value); })
      .with_default("\"all\"");
}

std::array<std::optional<double>, 3> read_displacement(const ConfigValue& value) {
  const auto& items = read_array(value, "displacement");
  if (items.size() != 3)
    throw error_at(value.place, fmt::format("displacement: expected 3 components, got {}", items.size()));
  std::array<std::optional<double>, 3> result;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto* text = std::get_if<std::string>(&items[i].value);
    if (text && *text == "free") continue;
    result[i] = read_quantity(items[i], "displacement", dim::length);
  }
  return result;
}

Eigen::Matrix3d read_gradient(const ConfigValue& value) {
  const auto& rows = read_array(value, "displacement_gradient");
  if (rows.size() != 3) throw error_at(value.place, "displacement_gradient: expected 3 rows of 3 numbers");
  Eigen::Matrix3d result;
  for (int i = 0; i < 3; ++i)
    result.row(i) =
        read_vector(rows[static_cast<std::size_t>(i)], "displacement_gradient", dim::none).transpose();
  return result;
}

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

Key<DiscretizationKeys> per_direction_key(const std::string& name,
                                          std::array<int, 3> iga::DiscretizationOptions::*member, int least,
                                          int most, const std::string& fallback, std::string meaning) {
  Key<DiscretizationKeys> key =
      custom_key<DiscretizationKeys>(name, "integer, or array of 3", std::move(meaning),
                                     [=](DiscretizationKeys& target, const ConfigValue& value) {
                                       target.options.*member = read_per_direction(value, name, least, most);
                                     });
  key.text.range = fmt::format("from {} to {}", least, most);
  key.text.fallback = fallback;
  return key;
}

Key<DiscretizationKeys> option_key(const std::string& name, int iga::DiscretizationOptions::*member,
                                   int least, int most, const std::string& fallback, std::string meaning) {
  Key<DiscretizationKeys> key = custom_key<DiscretizationKeys>(
      name, "integer", std::move(meaning), [=](DiscretizationKeys& target, const ConfigValue& value) {
        target.options.*member = read_integer(value, name, least, most);
      });
  key.text.range = fmt::format("from {} to {}", least, most);
  key.text.fallback = fallback;
  return key;
}

double read_poisson(const ConfigValue& value) {
  const double poisson = read_quantity(value, "poisson", dim::none);
  if (poisson > -1 && poisson < 0.5) return poisson;
  const char* advice =
      poisson == 0.5 ? ". An incompressible material has no displacement formulation; 0.499 comes close" : "";
  throw error_at(value.place,
                 fmt::format("poisson is {}; it must be above -1 and below 0.5{}", poisson, advice));
}

std::string material_names() {
  std::string result;
  for (const StandardMaterial& material : standard_materials())
    result += fmt::format("{}{} (E {:g} GPa, nu {:g}, {:g} kg/m^3)", result.empty() ? "" : ", ",
                          material.name, material.young / 1e9, material.poisson, material.density);
  return result;
}

}  // namespace

const Keys<StudyKeys>& study_keys() {
  static const Keys<StudyKeys> keys = {
      text_key<StudyKeys>("title", &StudyKeys::title, "Name of the study, for reports."),
      value_key<StudyKeys>("model", "table", &StudyKeys::model, "Where the patches come from.").required(),
      value_key<StudyKeys>("discretization", "table", &StudyKeys::discretization, "The solution space."),
      value_key<StudyKeys>("material", "array of tables", &StudyKeys::material,
                           "Materials; every patch needs exactly one.")
          .required(),
      value_key<StudyKeys>("support", "array of tables", &StudyKeys::support, "What holds the part.")
          .required(),
      value_key<StudyKeys>("load", "array of tables", &StudyKeys::load, "What acts on the part."),
      value_key<StudyKeys>("coupling", "table", &StudyKeys::coupling, "How the patches are held together."),
      value_key<StudyKeys>("solver", "table", &StudyKeys::solver, "How the equations are solved."),
      value_key<StudyKeys>("probe", "array of tables", &StudyKeys::probe, "Places whose values are wanted."),
      value_key<StudyKeys>("output", "table", &StudyKeys::output, "What is written, and where."),
  };
  return keys;
}

const Keys<ModelKeys>& model_keys() {
  static const Keys<ModelKeys> keys = {
      optional_text_key<ModelKeys>(
          "file", &ModelKeys::file,
          "A file of patches: G+Smo XML (.xml), GoTools (.g2) or MFEM NURBS mesh (.mesh). Relative "
          "paths count from the study's folder; ${NAME} and ${NAME:-default} are environment "
          "variables. Either this or `generate`."),
      optional_text_key<ModelKeys>(
          "generate", &ModelKeys::generate,
          "Name of a generated model, whose dimensions are further keys of [model]; see below."),
      custom_key<ModelKeys>(
          "length_unit", "length (m), with or without a number",
          "What one unit of the file's (or the generated model's) coordinates measures: \"mm\", "
          "\"225 mm\", 0.0254. All other lengths of the study are in m or have a unit.",
          [](ModelKeys& target, const ConfigValue& value) { target.length_unit = read_length_unit(value); })
          .with_default("\"m\""),
      quantity_key<ModelKeys>(
          "same_point", &ModelKeys::same_point, dim::none, {0, 1e-2, false, false},
          "Points closer than this share of the model's size are one point: faces that agree so well "
          "are interfaces."),
      quantity_key<ModelKeys>(
          "near_miss", &ModelKeys::near_miss, dim::none, {0, 0.1, false, false},
          "Faces that agree only to this share of the model's size are refused as a gap."),
      quantity_key<ModelKeys>(
          "same_knot", &ModelKeys::same_knot, dim::none, {0, 1e-3, false, false},
          "Knots of two neighbours closer than this share of the knot range are one knot."),
  };
  return keys;
}

const Keys<DiscretizationKeys>& discretization_keys() {
  using Options = iga::DiscretizationOptions;
  static const Keys<DiscretizationKeys> keys = {
      per_direction_key(
          "degree", &Options::degree, 1, 10, "the geometry's",
          "Degree of the splines, raised where the geometry's is lower and never lowered; the continuity "
          "of the geometry stays."),
      option_key("refine", &Options::refine, 0, 10, "0", "How often every knot span is halved."),
      per_direction_key("elements_per_direction", &Options::elements_per_direction, 1, 10000,
                        "as the geometry has",
                        "Least number of elements along each direction of each patch."),
      custom_key<DiscretizationKeys>(
          "max_size", type_name(dim::length), "Largest length of an element's edge.",
          [](DiscretizationKeys& target, const ConfigValue& value) {
            target.options.max_size = read_quantity(value, "max_size", dim::length, positive);
          })
          .with_default("no limit"),
      option_key("continuity", &Options::continuity, 0, 9, "as smooth as degree and geometry allow",
                 "Highest continuity C^k across the knots inside a patch."),
      integer_key<DiscretizationKeys>("points", &DiscretizationKeys::points, 0, 20,
                                      "Gauss points per element and direction; 0 means degree + 1."),
  };
  return keys;
}

const Keys<LameKeys>& lame_keys() {
  static const Keys<LameKeys> keys = {
      quantity_key<LameKeys>("lambda", &LameKeys::lambda, dim::pressure, any_number, "First Lame parameter.")
          .required(),
      quantity_key<LameKeys>("mu", &LameKeys::mu, dim::pressure, positive, "Shear modulus.").required(),
  };
  return keys;
}

const Keys<MaterialKeys>& material_keys() {
  static const Keys<MaterialKeys> keys = {
      patches_key<MaterialKeys>("The patches made of it."),
      optional_text_key<MaterialKeys>("name", &MaterialKeys::name,
                                      "Without elastic constants, a material of the table: " +
                                          material_names() + "; with them, a name for reports."),
      quantity_key<MaterialKeys>("young", &MaterialKeys::young, dim::pressure, positive,
                                 "Young's modulus; with `poisson`."),
      custom_key<MaterialKeys>(
          "poisson", "number, above -1 and below 0.5", "Poisson's ratio; with `young`.",
          [](MaterialKeys& target, const ConfigValue& value) { target.poisson = read_poisson(value); }),
      table_key<MaterialKeys, LameKeys>("lame", &MaterialKeys::lame, lame_keys,
                                        "Lame parameters, in place of young and poisson."),
      quantity_key<MaterialKeys>("density", &MaterialKeys::density, dim::density, positive,
                                 "Mass per volume; needed by gravity unless the table has it."),
  };
  return keys;
}

const Keys<PlaneCondition>& plane_keys() {
  static const Keys<PlaneCondition> keys = {
      vector_key<PlaneCondition>("point", &PlaneCondition::point, dim::length, "A point of the plane.")
          .with_default("[0, 0, 0]"),
      direction_key<PlaneCondition>("normal", &PlaneCondition::normal,
                                    "The plane's normal, of any length and sign.")
          .required(),
  };
  return keys;
}

const Keys<CylinderCondition>& cylinder_keys() {
  static const Keys<CylinderCondition> keys = {
      vector_key<CylinderCondition>("point", &CylinderCondition::point, dim::length, "A point of the axis.")
          .with_default("[0, 0, 0]"),
      direction_key<CylinderCondition>("axis", &CylinderCondition::axis, "Direction of the axis.")
          .with_default("\"z\""),
      quantity_key<CylinderCondition>("radius", &CylinderCondition::radius, dim::length, positive, "Radius.")
          .required(),
  };
  return keys;
}

const Keys<SphereCondition>& sphere_keys() {
  static const Keys<SphereCondition> keys = {
      vector_key<SphereCondition>("centre", &SphereCondition::centre, dim::length, "The centre.")
          .with_default("[0, 0, 0]"),
      quantity_key<SphereCondition>("radius", &SphereCondition::radius, dim::length, positive, "Radius.")
          .required(),
  };
  return keys;
}

const Keys<BoxCondition>& box_keys() {
  static const Keys<BoxCondition> keys = {
      vector_key<BoxCondition>("min", &BoxCondition::min, dim::length, "Corner with the lowest coordinates.")
          .required(),
      vector_key<BoxCondition>("max", &BoxCondition::max, dim::length, "Corner with the highest coordinates.")
          .required(),
  };
  return keys;
}

const Keys<FaceConditions>& where_keys() {
  using C = FaceConditions;
  static const Keys<C> keys = {
      table_key<C, PlaneCondition>("plane", &C::plane, plane_keys, "Faces that lie in a plane."),
      table_key<C, CylinderCondition>("cylinder", &C::cylinder, cylinder_keys,
                                      "Faces that lie on a cylinder."),
      table_key<C, SphereCondition>("sphere", &C::sphere, sphere_keys, "Faces that lie on a sphere."),
      table_key<C, BoxCondition>("box", &C::box, box_keys,
                                 "Faces that lie inside a box with edges along the axes."),
      custom_key<C>(
          "normal", "3 numbers, or \"x\", \"-x\", \"y\", ...", "Faces whose outward normal points this way.",
          [](C& target, const ConfigValue& value) { target.normal = read_direction(value, "normal"); }),
      quantity_key<C>("angle", &C::angle, dim::angle, {0, 3.1415926535897936, false, true},
                      "How far a normal may turn away from `normal`.")
          .with_default("\"5 deg\""),
      quantity_key<C>("tolerance", &C::tolerance, dim::length, positive,
                      "How far points may lie from the plane, cylinder, sphere or box.")
          .with_default("1e-4 of the model's size"),
  };
  return keys;
}

const Keys<SupportKeys>& support_keys() {
  using S = SupportKeys;
  static const Keys<S> keys = {
      text_key<S>("name", &S::name, "For messages and for the reactions in summary.json.")
          .with_default("\"support 1\", ..."),
      faces_key<S>(),
      where_key<S>(),
      custom_key<S>(
          "displacement", "3 of length (m) or \"free\"",
          "Prescribed displacement; \"free\" leaves a component free.",
          [](S& target, const ConfigValue& value) { target.displacement = read_displacement(value); }),
      custom_key<S>(
          "displacement_gradient", "3 x 3 numbers",
          "Adds a linear part: u = displacement + displacement_gradient * x, with x in m.",
          [](S& target, const ConfigValue& value) { target.displacement_gradient = read_gradient(value); }),
      flag_key<S>("symmetry", &S::symmetry,
                  "A plane of symmetry of any orientation: no displacement along its normal."),
      flag_key<S>("roller", &S::roller,
                  "A frictionless guide on a plane face: the same condition by its other name."),
      quantity_key<S>("normal_displacement", &S::normal_displacement, dim::length, any_number,
                      "With roller: moves the faces along their outward normal.")
          .with_default("0"),
  };
  return keys;
}

const Keys<LoadKeys>& load_keys() {
  using L = LoadKeys;
  static const Keys<L> keys = {
      text_key<L>("name", &L::name, "For messages and reports.").with_default("\"load 1\", ..."),
      faces_key<L>(),
      where_key<L>(),
      vector_key<L>("traction", &L::traction, dim::pressure, "Force per area of the faces."),
      quantity_key<L>("pressure", &L::pressure, dim::pressure, any_number,
                      "Pushes against the faces where positive."),
      vector_key<L>("force", &L::force, dim::force,
                    "Total force, spread evenly over the area of all faces of this load."),
      patches_key<L>("The patches that body_force or gravity acts in."),
      vector_key<L>("body_force", &L::body_force, dim::force_per_volume, "Force per volume."),
      vector_key<L>("gravity", &L::gravity, dim::acceleration,
                    "Acceleration of gravity; the materials need a density."),
  };
  return keys;
}

const Keys<iga::ElasticityOptions>& coupling_keys() {
  static const std::vector<std::string> names = {"elimination", "lagrange"};
  static const Keys<iga::ElasticityOptions> keys = {
      custom_key<iga::ElasticityOptions>("method", "\"elimination\" or \"lagrange\"",
                                         "Coincident control points share their unknowns, or multipliers tie "
                                         "them. `isopatch compare` runs both.",
                                         [](iga::ElasticityOptions& target, const ConfigValue& value) {
                                           target.coupling = read_choice(value, "method", names) == 0
                                                                 ? iga::Coupling::elimination
                                                                 : iga::Coupling::lagrange;
                                         })
          .with_default("\"elimination\""),
  };
  return keys;
}

const Keys<solvers::SolverOptions>& solver_keys() {
  using O = solvers::SolverOptions;
  using M = solvers::Method;
  static const std::vector<std::pair<std::string, M>> methods = {
      {"auto", M::automatic}, {"direct", M::automatic}, {"cholmod", M::cholmod},
      {"mumps", M::mumps},    {"umfpack", M::umfpack},  {"cg", M::cg}};
  static const Keys<O> keys = {
      custom_key<O>(
          "method", "\"auto\", \"direct\", \"cholmod\", \"mumps\", \"umfpack\" or \"cg\"",
          "auto and direct take CHOLMOD for elimination and MUMPS for lagrange; cholmod and cg cannot treat "
          "multipliers.",
          [](O& target, const ConfigValue& value) {
            std::vector<std::string> names;
            for (const auto& method : methods) names.push_back(method.first);
            target.method = methods[read_choice(value, "method", names)].second;
          })
          .with_default("\"auto\""),
      quantity_key<O>("tolerance", &O::tolerance, dim::none, {1e-14, 1e-2}, "Relative residual to reach."),
      integer_key<O>("max_iterations", &O::max_iterations, 1, 10000000,
                     "Most iterations of an iterative method."),
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

const Keys<OutputKeys>& output_keys() {
  using O = OutputKeys;
  static const Keys<O> keys = {
      text_key<O>("directory", &O::directory,
                  "Folder of the results, made where absent; relative paths count from the study's folder. "
                  "The option "
                  "--output DIR replaces it."),
      flag_key<O>("fields", &O::fields,
                  "Whether fields are written for ParaView: results.vtm and fields/*.vtu."),
      flag_key<O>("hdf5", &O::hdf5,
                  "Whether results.h5 is written, for `isopatch probe`, `fields` and `info`."),
  };
  return keys;
}

}  // namespace isopatch::app
