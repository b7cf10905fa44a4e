#pragma once

#include "app/study/study_keys.hpp"

namespace isopatch::app {

/// A string or an array of them.
std::vector<std::string> read_face_names(const ConfigValue& value);

/// "all", an index, "0-8", or an array of these.
PatchSelection read_patch_selection(const ConfigValue& value);

/// Keys that several sections share.
template <class S>
Key<S> faces_key() {
  return custom_key<S>(
      "faces", "array of strings",
      "Faces as \"patch:side\" with the side west, east, south, north, front or back, or names of "
      "boundaries. `isopatch info` lists both.",
      [](S& target, const ConfigValue& value) { target.faces = read_face_names(value); });
}

template <class S>
Key<S> where_key() {
  return table_key<S, FaceConditions>(
      "where", &S::where, where_keys,
      "Faces chosen by geometry; together with `faces`, those that fulfil both.");
}

template <class S>
Key<S> patches_key(std::string meaning) {
  return custom_key<S>(
             "patches", "\"all\", integer, name of a body, or array of these and ranges \"0-8\"",
             std::move(meaning),
             [](S& target, const ConfigValue& value) { target.patches = read_patch_selection(value); })
      .with_default("\"all\"");
}

}  // namespace isopatch::app
