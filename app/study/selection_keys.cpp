#include "app/study/selection_keys.hpp"

#include <fmt/format.h>

#include <charconv>

namespace isopatch::app {
namespace {

namespace dim = dimensions;

/// A number, a range "0-8", or a name.
void read_patches(const ConfigValue& value, PatchSelection& selection) {
  constexpr int most = 1000000;
  if (!std::holds_alternative<std::string>(value.value)) {
    const int index = read_integer(value, "patches", 0, most);
    selection.ranges.emplace_back(index, index);
    return;
  }
  const std::string text = read_text(value, "patches");
  int first = 0;
  int last = 0;
  const char* end = text.data() + text.size();
  const auto [dash, problem] = std::from_chars(text.data(), end, first);
  if (problem == std::errc{} && dash != end && *dash == '-') {
    const auto [stop, second] = std::from_chars(dash + 1, end, last);
    if (second == std::errc{} && stop == end && first >= 0 && first <= last) {
      selection.ranges.emplace_back(first, last);
      return;
    }
  }
  if (text.find_first_not_of("0123456789- ") == text.npos)
    throw error_at(value.place,
                   fmt::format("patches: expected \"all\", numbers from 0, ranges such as \"0-8\" or "
                               "names of bodies, got \"{}\"",
                               text));
  selection.names.push_back(text);
}

/// Where something must lie.
/// @param what  "Faces" or "Edges"
Keys<FaceConditions> place_keys(const std::string& what) {
  using C = FaceConditions;
  return {
      table_key<C, PlaneCondition>("plane", &C::plane, plane_keys, what + " that lie in a plane."),
      table_key<C, CylinderCondition>("cylinder", &C::cylinder, cylinder_keys,
                                      what + " that lie on a cylinder."),
      table_key<C, SphereCondition>("sphere", &C::sphere, sphere_keys, what + " that lie on a sphere."),
      table_key<C, BoxCondition>("box", &C::box, box_keys,
                                 what + " that lie inside a box with edges along the axes."),
  };
}

Key<FaceConditions> tolerance_key() {
  return quantity_key<FaceConditions>("tolerance", &FaceConditions::tolerance, dim::length, positive,
                                      "How far points may lie from the plane, cylinder, sphere or box.")
      .with_default("1e-4 of the model's size");
}

}  // namespace

std::vector<std::string> read_face_names(const ConfigValue& value) {
  if (std::holds_alternative<std::string>(value.value)) return {read_text(value, "faces")};
  std::vector<std::string> faces;
  for (const ConfigValue& item : read_array(value, "faces")) faces.push_back(read_text(item, "faces"));
  if (faces.empty()) throw error_at(value.place, "faces is empty: name at least one face or boundary");
  return faces;
}

std::vector<Eigen::Vector3d> read_places(const ConfigValue& value, const std::string& what) {
  std::vector<Eigen::Vector3d> result;
  for (const ConfigValue& item : read_array(value, what))
    result.push_back(read_vector(item, what, dim::length));
  if (result.empty())
    throw error_at(value.place, fmt::format("{} is empty: give at least one, as [[0, 0, 0]]", what));
  return result;
}

PatchSelection read_patch_selection(const ConfigValue& value) {
  PatchSelection selection{{}, {}, value.place};
  if (const auto* text = std::get_if<std::string>(&value.value); text && *text == "all") return selection;
  if (const auto* items = std::get_if<std::vector<ConfigValue>>(&value.value)) {
    for (const ConfigValue& item : *items) read_patches(item, selection);
    if (items->empty())
      throw error_at(value.place, "patches is empty: name at least one patch, or write \"all\"");
  } else {
    read_patches(value, selection);
  }
  return selection;
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
  static const Keys<C> keys = [] {
    Keys<C> result = place_keys("Faces");
    result.push_back(custom_key<C>(
        "normal", "3 numbers, or \"x\", \"-x\", \"y\", ...", "Faces whose outward normal points this way.",
        [](C& target, const ConfigValue& value) { target.normal = read_direction(value, "normal"); }));
    result.push_back(quantity_key<C>("angle", &C::angle, {0, 3.15, false, true},
                                     "How far a normal may turn away from `normal`.")
                         .with_default("\"5 deg\""));
    result.push_back(tolerance_key());
    return result;
  }();
  return keys;
}

const Keys<FaceConditions>& part_keys() {
  using C = FaceConditions;
  static const Keys<C> keys = {
      table_key<C, PlaneCondition>("plane", &C::plane, plane_keys,
                                   "What lies on the side of the plane to which its normal points."),
      table_key<C, CylinderCondition>("cylinder", &C::cylinder, cylinder_keys,
                                      "What lies within the cylinder."),
      table_key<C, SphereCondition>("sphere", &C::sphere, sphere_keys, "What lies within the sphere."),
      table_key<C, BoxCondition>("box", &C::box, box_keys, "What lies in the box."),
  };
  return keys;
}

FaceConditions read_part(const ConfigValue& value) {
  const ConfigTable& table = read_subtable(value, "part");
  if (table.entries.empty())
    throw error_at(value.place, "part is empty: give it a plane, cylinder, sphere or box");
  return read_table<FaceConditions>(table, value.place, "part", part_keys());
}

const Keys<FaceConditions>& edges_keys() {
  static const Keys<FaceConditions> keys = [] {
    Keys<FaceConditions> result = place_keys("Edges");
    result.push_back(tolerance_key());
    return result;
  }();
  return keys;
}

}  // namespace isopatch::app
