#include "segmentation/parameterization/read_blocks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <sstream>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/error.hpp"
#include "geometry/base/nearest_name.hpp"
#include "geometry/brep/read_brep.hpp"
#include "geometry/brep/solid_error.hpp"
#include "segmentation/parameterization/brep_solid.hpp"

namespace isopatch::segmentation {
namespace {

std::string small_ending(const std::filesystem::path& path) {
  std::string text = path.extension().string();
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::vector<geometry::BrepFile> solids_of(const std::filesystem::path& path, double length_unit) {
  try {
    return geometry::read_breps(path, block_reading(path, length_unit));
  } catch (const geometry::SolidError& error) {
    throw geometry::SolidError(error.code(), error.what(), of_solid(error.fault(), block_name(path, 0)));
  }
}

int block_named(const std::string& name, const std::vector<Hexahedron>& blocks, const std::string& where) {
  std::vector<std::string> names;
  for (const Hexahedron& block : blocks) names.push_back(block.name);
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw Error(ErrorCode::invalid_argument,
                fmt::format("{}no block is called '{}'{}; there are {}", where, name,
                            did_you_mean(name, names), fmt::join(names, ", ")));
  return static_cast<int>(found - names.begin());
}

}  // namespace

// STEP and IGES say their unit themselves; a plain 1 is no contradiction.
geometry::ReadBrepOptions block_reading(const std::filesystem::path& path, double length_unit) {
  const std::string end = small_ending(path);
  const bool says = end == ".step" || end == ".stp" || end == ".iges" || end == ".igs";
  geometry::ReadBrepOptions options;
  if (!says || length_unit != 1) options.length_unit = length_unit;
  return options;
}

std::vector<ListedPair> parse_pairs(const std::string& text, const std::string& source,
                                    const std::vector<Hexahedron>& blocks) {
  std::vector<ListedPair> result;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (line.find_first_not_of(" \t\r") == std::string::npos) continue;
    const std::string where = fmt::format("{}:{}: ", source, number);
    std::istringstream words(line);
    std::string first, second, rest;
    ListedPair pair;
    if (!(words >> first >> pair.first_face >> second >> pair.second_face) || words >> rest)
      throw Error(
          ErrorCode::bad_format,
          where + "expected 'block face block face', faces by their numbers from 0, got '" + line + "'");
    pair.first_block = block_named(first, blocks, where);
    pair.second_block = block_named(second, blocks, where);
    result.push_back(pair);
  }
  return result;
}

std::string block_name(const std::filesystem::path& path, int solid) {
  const std::string stem = path.stem().string();
  return solid == 0 ? stem : fmt::format("{}#{}", stem, solid);
}

HexComplex read_blocks(const BlockFiles& files) {
  if (files.files.empty()) throw Error(ErrorCode::invalid_argument, "no file of a block is given");
  std::vector<Hexahedron> blocks;
  for (const std::filesystem::path& path : files.files) {
    int count = 0;
    for (const geometry::BrepFile& solid : solids_of(path, files.length_unit))
      blocks.push_back(
          hexahedron(hex_solid(solid.brep, block_name(path, count++), solid.largest_correction)));
  }
  if (!files.pairs) return hex_complex(std::move(blocks), files.complex);
  const auto pairs = parse_pairs(read_file(*files.pairs), files.pairs->string(), blocks);
  return hex_complex(std::move(blocks), pairs, files.complex);
}

}  // namespace isopatch::segmentation
