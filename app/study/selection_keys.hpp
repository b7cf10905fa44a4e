#pragma once

#include <string>
#include <utility>
#include <vector>

#include "app/study/face_selection.hpp"
#include "app/study/keys.hpp"

namespace isopatch::app {

const Keys<FaceConditions>& where_keys();
const Keys<FaceConditions>& edges_keys();
const Keys<FaceConditions>& part_keys();
const Keys<PlaneCondition>& plane_keys();
const Keys<CylinderCondition>& cylinder_keys();
const Keys<SphereCondition>& sphere_keys();
const Keys<BoxCondition>& box_keys();

/// A string or an array of them.
std::vector<std::string> read_face_names(const ConfigValue& value);

/// "all", an index, "0-8", or an array of these.
PatchSelection read_patch_selection(const ConfigValue& value);

/// The keys that several sections share. `selection_of(target, value)` is the selection of `target` that the
/// key fills; it may throw if there is none.
template <class S, class Of>
Key<S> faces_key(Of selection_of) {
  return custom_key<S>(
      "faces", "array of strings",
      "Names of faces of solids, names of boundaries, colours \"#rrggbb\", or sides of patches "
      "as \"patch:side\" with the side west, east, south, north, front or back; `isopatch info` "
      "lists all. A name with two meanings is refused; \"face:NAME\", \"colour:#rrggbb\" and "
      "\"side:patch:side\" have one.",
      [=](S& target, const ConfigValue& value) {
        selection_of(target, value).faces = read_face_names(value);
      });
}

template <class S, class Of>
Key<S> where_key(Of selection_of) {
  return custom_key<S>(
      "where", "table, see below", "Faces chosen by geometry; together with `faces`, those that fulfil both.",
      [=](S& target, const ConfigValue& value) {
        selection_of(target, value).where =
            read_table<FaceConditions>(read_subtable(value, "where"), value.place, "where", where_keys());
      });
}

/// A table with at least one of a plane, cylinder, sphere and box.
FaceConditions read_part(const ConfigValue& value);

template <class S, class Of>
Key<S> part_key(Of selection_of) {
  return custom_key<S>(
      "part", "table, see below",
      "Only what lies in here of the faces; without `faces` and `where`, of all faces of the part.",
      [=](S& target, const ConfigValue& value) { selection_of(target, value).part = read_part(value); });
}

/// Places, at least one.
std::vector<Eigen::Vector3d> read_places(const ConfigValue& value, const std::string& what);

template <class S, class Of>
Key<S> patches_key(std::string meaning, Of selection_of) {
  return custom_key<S>("patches", "\"all\", integer, name of a body, or array of these and ranges \"0-8\"",
                       std::move(meaning),
                       [=](S& target, const ConfigValue& value) {
                         selection_of(target, value) = read_patch_selection(value);
                       })
      .with_default("\"all\"");
}

}  // namespace isopatch::app
