#include "app/study/load_keys.hpp"

#include <fmt/format.h>

#include <utility>
#include <variant>
#include <vector>

#include "app/study/case_keys.hpp"
#include "app/study/load_tables.hpp"
#include "app/study/selection_keys.hpp"

namespace isopatch::app {
namespace {

namespace dim = dimensions;

FaceSelection& loaded_faces(AppliedLoad& load, const ConfigValue& value) {
  if (FaceSelection* selection = faces_of(load)) return *selection;
  throw error_at(value.place,
                 fmt::format("[[load]]: {} acts in patches, not on faces; use patches", kind_name(load)));
}

PatchSelection& loaded_patches(AppliedLoad& load, const ConfigValue& value) {
  if (PatchSelection* selection = patches_of(load)) return *selection;
  throw error_at(value.place,
                 fmt::format("[[load]]: {} acts on faces, not in patches; use faces", kind_name(load)));
}

Force& force_of(AppliedLoad& load, const ConfigValue& value) {
  if (auto* force = std::get_if<Force>(&load.load)) return *force;
  throw error_at(value.place,
                 fmt::format("[[load]]: points and lines take a force, not {}", kind_name(load)));
}

// Where a load on faces, points or a line acts.
void require_places(const AppliedLoad& load, const FaceSelection& selection) {
  const bool has_faces = !selection.faces.empty() || selection.where || selection.part;
  const auto* force = std::get_if<Force>(&load.load);
  const bool has_points = force && !force->points.empty(), has_line = force && !force->line.empty();
  if (!has_faces && !has_points && !has_line)
    throw error_at(load.place, "[[load]] needs faces, where or part: which faces are loaded?");
  if (has_faces + has_points + has_line > 1)
    throw error_at(load.place, "[[load]] has more than one of faces, points and a line; write several loads");
  if (has_line && force->line.size() == 1)
    throw error_at(load.place, "[[load]] a line needs two points or more");
}

/// The vector of one kind of load.
template <class Load>
Key<AppliedLoad> load_vector_key(const std::string& name, const Dimension& dimension, std::string meaning) {
  return custom_key<AppliedLoad>(name, "3 of " + type_name(dimension), std::move(meaning),
                                 [=](AppliedLoad& target, const ConfigValue& value) {
                                   std::get<Load>(target.load).value = read_vector(value, name, dimension);
                                 });
}

/// The table of one kind of load.
template <class Load, class Table>
Key<AppliedLoad> load_table_key(const std::string& name, const Keys<Table>& keys, std::string meaning) {
  return custom_key<AppliedLoad>(name, "table, see below", std::move(meaning),
                                 [name, &keys](AppliedLoad& target, const ConfigValue& value) {
                                   std::get<Load>(target.load).value =
                                       read_table<Table>(read_subtable(value, name), value.place, name, keys);
                                 });
}

/// Loads of the kinds that some keys ask for, with nothing in them yet.
std::vector<AppliedLoad> empty_loads(const ConfigSection& input) {
  std::vector<AppliedLoad> result = {{.load = Traction{}},
                                     {.load = Pressure{}},
                                     {.load = Force{}},
                                     {.load = Bearing{}},
                                     {.load = Remote{}},
                                     {.load = Hydrostatic{}},
                                     {.load = BodyForce{.patches = {.place = input.place}}},
                                     {.load = Gravity{.patches = {.place = input.place}}},
                                     {.load = Acceleration{.patches = {.place = input.place}}},
                                     {.load = Rotating{.patches = {.place = input.place}}},
                                     {.load = Temperature{.patches = {.place = input.place}}}};
  std::erase_if(result, [&](const AppliedLoad& load) { return !input.table.find(kind_name(load)); });
  return result;
}

/// A load of any kind that the other keys may belong to, so that what is wrong with them is found.
AppliedLoad any_load(const ConfigSection& input) {
  if (input.table.find("patches")) return {.load = BodyForce{}};
  return {.load = Traction{}};
}

}  // namespace

const Keys<AppliedLoad>& load_keys() {
  using L = AppliedLoad;
  static const Keys<L> keys = {
      text_key<L>("name", &L::key, "For messages and reports.").with_default("\"load 1\", ..."),
      faces_key<L>(loaded_faces),
      where_key<L>(loaded_faces),
      part_key<L>(loaded_faces),
      load_vector_key<Traction>("traction", dim::pressure, "Force per area of the faces."),
      custom_key<L>("pressure", type_name(dim::pressure), "Pushes against the faces where positive.",
                    [](L& target, const ConfigValue& value) {
                      std::get<Pressure>(target.load).value = read_quantity(value, "pressure", dim::pressure);
                    }),
      load_vector_key<Force>("force", dim::force,
                             "Total force, spread evenly over the area of all faces of this load, over its "
                             "points or along its line."),
      custom_key<L>("points", "array of points, each 3 of length (m)",
                    "Places of the part that take equal shares of `force`, instead of faces. Displacements "
                    "and stresses there grow without limit as elements become small.",
                    [](L& target, const ConfigValue& value) {
                      force_of(target, value).points = read_places(value, "points");
                    }),
      custom_key<L>("line", "array of points, each 3 of length (m)",
                    "Straight lines from each of these points to the next, which must lie in the part; they "
                    "take `force`, spread evenly, instead of faces.",
                    [](L& target, const ConfigValue& value) {
                      force_of(target, value).line = read_places(value, "line");
                    }),
      load_vector_key<Bearing>("bearing", dim::force,
                               "Total force of a pin in a bore, or of a housing on a shaft, across its axis: "
                               "a pressure that falls "
                               "with the cosine from where the force points to nothing at a quarter turn."),
      load_table_key<Remote>("remote", remote_keys(),
                             "A force and a moment at a point that need not be on the part, carried to the "
                             "faces, which may deform."),
      load_table_key<Hydrostatic>("hydrostatic", hydrostatic_keys(), "The pressure of a liquid at rest."),
      patches_key<L>("The patches that body_force, gravity, acceleration, rotation or temperature acts in.",
                     loaded_patches),
      load_vector_key<BodyForce>("body_force", dim::force_per_volume, "Force per volume."),
      load_vector_key<Gravity>("gravity", dim::acceleration,
                               "Acceleration of gravity; the materials need a density."),
      load_vector_key<Acceleration>("acceleration", dim::acceleration,
                                    "Acceleration of the part, which its mass resists: the same as a gravity "
                                    "the other way; the materials need a density."),
      load_table_key<Rotating>("rotation", rotation_keys(),
                               "Steady rotation: centrifugal forces; the materials need a density."),
      load_table_key<Temperature>("temperature", temperature_keys(),
                                  "A change of temperature; the materials need an expansion. Stresses are "
                                  "those of the strain without the thermal one."),
      case_key<L>(
          "Load case that it belongs to, or several. Loads of one case act together; cases are solved "
          "with one set-up, and each has results of its own."),
  };
  return keys;
}

AppliedLoad read_load(const ConfigSection& input, std::size_t index) {
  constexpr const char* one_kind =
      "[[load]] needs exactly one of traction, pressure, force, bearing, remote, hydrostatic, body_force, "
      "gravity, acceleration, rotation, temperature";
  const std::vector<AppliedLoad> kinds = empty_loads(input);
  if (kinds.size() > 1) throw error_at(input.place, one_kind);
  AppliedLoad result = read_table<AppliedLoad>(input.table, input.place, "[[load]]", load_keys(),
                                               kinds.empty() ? any_load(input) : kinds.front());
  if (kinds.empty()) throw error_at(input.place, one_kind);
  result.place = input.place;
  if (FaceSelection* selection = faces_of(result)) {
    selection->place = input.place;
    require_places(result, *selection);
  }
  result.name = fmt::format("load {}{}", index + 1, result.key.empty() ? "" : " (" + result.key + ")");
  if (result.key.empty()) result.key = result.name;
  return result;
}

}  // namespace isopatch::app
