#pragma once

// For .cpp files of this folder only: third-party types stay out of the headers that others include.

#include <Eigen/Core>
#include <nlohmann/json.hpp>
#include <vector>

#include "app/base/warning.hpp"

namespace isopatch::app {

using Json = nlohmann::ordered_json;

inline Json to_json(const Eigen::Vector3d& vector) {
  return Json::array({vector[0], vector[1], vector[2]});
}

/// xx, yy, zz, xy, yz, zx.
inline Json symmetric_to_json(const Eigen::Matrix3d& tensor) {
  return Json::array({tensor(0, 0), tensor(1, 1), tensor(2, 2), tensor(0, 1), tensor(1, 2), tensor(2, 0)});
}

inline Json texts_json(const std::vector<Warning>& warnings) {
  Json result = Json::array();
  for (const Warning& warning : warnings) result.push_back(warning.text);
  return result;
}

/// What each warning is about: {"patch", "point"}, null where it is about the study as a whole.
inline Json places_json(const std::vector<Warning>& warnings) {
  Json result = Json::array();
  for (const Warning& warning : warnings) {
    Json place;
    if (warning.patch) place["patch"] = *warning.patch;
    if (warning.place) place["point"] = to_json(*warning.place);
    result.push_back(place);
  }
  return result;
}

/// The text of a file: two blanks a level, numbers with all their digits.
inline std::string file_text(const Json& json) {
  return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace isopatch::app
