#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>
#include <vector>

#include "iga/output/result_file.hpp"

namespace isopatch::app {

/// `count` places between two points, evenly spread, both ends included. m
std::vector<Eigen::Vector3d> line_places(const Eigen::Vector3d& from, const Eigen::Vector3d& to, int count);

/// A place X,Y,Z a line, in m or with units, as `parse_point` takes it; empty lines and those that begin with
/// "#" or with a letter (a heading) are left out.
/// @throws Error io, invalid_argument  naming file and line
std::vector<Eigen::Vector3d> read_places(const std::filesystem::path& path);

/// A heading and a row for each place, and for each material that meets there: number of the place, x, y, z,
/// distance from the first place, patch, material, displacement, stress, von Mises stress; SI units. A place
/// that is more than 1e-4 of the model's size away from the part has a row without values.
std::string places_csv(const iga::StoredResult& result, const std::vector<Eigen::Vector3d>& places);

}  // namespace isopatch::app
