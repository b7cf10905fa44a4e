#include "segmentation/parameterization/read_blocks.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/error.hpp"
#include "geometry/base/nearest_name.hpp"
#include "geometry/brep/brep_graph.hpp"
#include "geometry/brep/contradictions.hpp"
#include "geometry/brep/read_brep.hpp"
#include "geometry/brep/solid_error.hpp"
#include "geometry/topology/graph_connectivity.hpp"
#include "segmentation/parameterization/assemble_model.hpp"

namespace isopatch::segmentation {
namespace {

// With the name of the block in its faces, and the file's in front of the message if it lacks it.
template <class Work>
auto named(const std::filesystem::path& path, const std::string& block, Work work) {
  try {
    return work();
  } catch (const geometry::SolidError& error) {
    const std::string message = error.what();
    const bool has_file = message.find(path.string()) != message.npos;
    throw geometry::SolidError(error.code(), has_file ? message : path.string() + ": " + message,
                               of_solid(error.fault(), block));
  }
}

geometry::BrepSet bodies_of(const std::filesystem::path& path, const geometry::ReadBrepOptions& options) {
  geometry::BrepSet set =
      named(path, path.stem().string(), [&] { return geometry::read_breps(path, options); });
  for (const geometry::BrepFile& body : set.bodies)
    named(path, body.name, [&] { geometry::require_sound(body.brep); });
  return set;
}

int block_named(const std::string& name, const std::vector<std::string>& names, const std::string& where) {
  const auto found = std::find(names.begin(), names.end(), name);
  if (found == names.end())
    throw Error(ErrorCode::invalid_argument,
                fmt::format("{}no block is called '{}'{}; there are {}", where, name,
                            did_you_mean(name, names), fmt::join(names, ", ")));
  return static_cast<int>(found - names.begin());
}

}  // namespace

geometry::ReadBrepOptions block_reading(const BlockFiles& files) {
  geometry::ReadBrepOptions options;
  options.length_unit = files.length_unit;
  options.allow_partial = files.allow_partial;
  options.limits = files.limits;
  return options;
}

std::string BlockNames::add(const std::string& body) {
  const int before = count_[body]++;
  return before == 0 ? body : add(fmt::format("{}#{}", body, before));
}

std::vector<ListedPair> parse_pairs(const std::string& text, const std::string& source,
                                    const std::vector<std::string>& blocks) {
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

bool is_hexahedron(const geometry::Brep& solid) {
  const geometry::EdgeGraph graph = edge_graph(solid);
  return is_cube(graph, connectivity(graph, topology(graph, boundary(graph))));
}

ReadSolids read_solids(const BlockFiles& files, const Progress& progress) {
  if (files.files.empty()) throw Error(ErrorCode::invalid_argument, "no file of a block is given");
  geometry::ReadBrepOptions options = block_reading(files);
  options.progress = progress;
  ReadSolids result;
  BlockNames names;
  for (const std::filesystem::path& path : files.files) {
    geometry::BrepSet set = bodies_of(path, options);
    for (const std::string& warning : set.warnings)
      result.warnings.push_back(fmt::format("{}: {}", path.string(), warning));
    for (geometry::BrepFile& body : set.bodies) {
      body.name = names.add(body.name);
      result.solids.push_back(std::move(body));
    }
  }
  return result;
}

ReadBlocks read_blocks(const BlockFiles& files, const Progress& progress) {
  ReadSolids read = read_solids(files, progress);
  if (!files.pairs) return {hex_model(std::move(read.solids), files.assembly), std::move(read.warnings)};
  std::vector<std::string> called;
  for (const geometry::BrepFile& solid : read.solids) called.push_back(solid.name);
  const auto pairs = parse_pairs(read_file(*files.pairs), files.pairs->string(), called);
  return {hex_model(std::move(read.solids), pairs, files.assembly), std::move(read.warnings)};
}

}  // namespace isopatch::segmentation
