#include "iga/output/result_file.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <sstream>

#include "geometry/base/error.hpp"
#include "geometry/base/nearest_name.hpp"
#include "geometry/io/hdf5_connections.hpp"
#include "geometry/io/hdf5_nurbs.hpp"
#include "geometry/io/packed_numbers.hpp"

namespace isopatch::iga {
namespace {

using geometry::Hdf5Reader;
using geometry::Hdf5Writer;
using geometry::NurbsVolume;

constexpr const char* format_name = "isopatch result";
constexpr std::int64_t format_version = 3;

std::string material_group(std::size_t material) {
  return fmt::format("/materials/{:05}", material);
}

/// Each once, and which one every patch has.
void write_materials(Hdf5Writer& file, const std::vector<Material>& of_patches) {
  std::vector<Material> materials;
  std::vector<std::int64_t> numbers;
  for (const Material& material : of_patches) {
    const auto found = std::find_if(materials.begin(), materials.end(),
                                    [&](const Material& other) { return material == other; });
    numbers.push_back(found - materials.begin());
    if (found == materials.end()) materials.push_back(material);
  }
  for (std::size_t m = 0; m < materials.size(); ++m) {
    const std::string group = material_group(m);
    file.write(group + "/name", materials[m].name);
    file.write(group + "/lambda", materials[m].lambda);
    file.write(group + "/mu", materials[m].mu);
    file.write(group + "/density", materials[m].density);
    file.write(group + "/expansion", materials[m].expansion);
    if (materials[m].yield > 0) file.write(group + "/yield", materials[m].yield);
  }
  file.write("/patches/material", numbers);
}

void read_materials(const Hdf5Reader& file, std::vector<Material>& of_patches) {
  const std::vector<std::int64_t> numbers = file.integers("/patches/material");
  std::vector<Material> materials;
  const auto most = numbers.empty() ? -1 : *std::max_element(numbers.begin(), numbers.end());
  if (most >= static_cast<std::int64_t>(numbers.size()) ||
      std::any_of(numbers.begin(), numbers.end(), [](std::int64_t number) { return number < 0; }))
    throw Error(ErrorCode::invalid_argument, "/patches/material has numbers that no material has");
  for (std::int64_t m = 0; m <= most; ++m) {
    const std::string group = material_group(static_cast<std::size_t>(m));
    materials.push_back({file.number(group + "/lambda"), file.number(group + "/mu"),
                         file.number(group + "/density"), file.text(group + "/name"),
                         file.contains(group + "/expansion") ? file.number(group + "/expansion") : 0.0,
                         file.contains(group + "/yield") ? file.number(group + "/yield") : 0.0});
  }
  for (const std::int64_t number : numbers) of_patches.push_back(materials[static_cast<std::size_t>(number)]);
}

// Files of runs without an estimate, or from before there was one, have none.
void write_errors(Hdf5Writer& file, const std::string& group, const std::vector<ElementErrors>& errors) {
  if (errors.empty()) return;
  geometry::PackedNumbers energy, stress;
  for (const ElementErrors& of_patch : errors) {
    energy.add(of_patch.energy);
    stress.add(of_patch.stress);
  }
  energy.write(file, group + "/energy", 1);
  stress.write(file, group + "/stress", 1);
}

void read_errors(const Hdf5Reader& file, const std::string& group, ElasticField& field) {
  if (!file.contains(group)) return;
  geometry::UnpackedNumbers energy(file, group + "/energy", 1);
  geometry::UnpackedNumbers stress(file, group + "/stress", 1);
  for (const NurbsVolume& patch : field.patches) {
    const Eigen::Index count = Eigen::Index{patch.knots(0).element_count()} * patch.knots(1).element_count() *
                               patch.knots(2).element_count();
    field.errors.push_back({energy.take(count).transpose(), stress.take(count).transpose()});
  }
  energy.require_end();
  stress.require_end();
}

void write_thermal(Hdf5Writer& file, const std::string& path, const std::vector<ThermalStrain>& thermal) {
  if (thermal.empty()) return;
  Eigen::MatrixXd strains(4, static_cast<Eigen::Index>(thermal.size()));
  for (std::size_t p = 0; p < thermal.size(); ++p)
    strains.col(static_cast<Eigen::Index>(p)) << thermal[p].at_origin, thermal[p].gradient;
  file.write(path, strains);
}

void write_displacement(Hdf5Writer& file, const std::string& path, const ElasticField& field) {
  geometry::PackedNumbers displacement;
  for (const Eigen::Matrix3Xd& of_patch : field.displacement) displacement.add(of_patch);
  displacement.write(file, path, 3);
}

Eigen::Matrix3Xd forces_of(const std::vector<Multiplier>& multipliers) {
  Eigen::Matrix3Xd forces(3, static_cast<Eigen::Index>(multipliers.size()));
  for (std::size_t i = 0; i < multipliers.size(); ++i)
    forces.col(static_cast<Eigen::Index>(i)) = multipliers[i].force;
  return forces;
}

// Where a case has its datasets: the first where files without cases have theirs.
struct CasePaths {
  explicit CasePaths(std::size_t index)
      : displacement(index == 0 ? "/patches/displacement" : fmt::format("/cases/{:05}/displacement", index)),
        forces(index == 0 ? "/multipliers/forces" : fmt::format("/cases/{:05}/forces", index)),
        errors(index == 0 ? "/patches/errors" : fmt::format("/cases/{:05}/errors", index)),
        thermal_strain(index == 0 ? "/patches/thermal_strain"
                                  : fmt::format("/cases/{:05}/thermal_strain", index)) {}
  std::string displacement, forces, errors, thermal_strain;
};

std::vector<std::string> case_names_of(const Hdf5Reader& file) {
  std::vector<std::string> names;
  if (!file.contains("/cases/names")) return names;
  std::istringstream lines(file.text("/cases/names"));
  for (std::string line; std::getline(lines, line);) names.push_back(line);
  return names;
}

std::size_t index_of_case(const std::vector<std::string>& names, const std::string& name,
                          const std::filesystem::path& path) {
  if (name.empty()) return 0;
  const auto found = std::find(names.begin(), names.end(), name);
  if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
  throw Error(ErrorCode::invalid_argument,
              names.empty() ? fmt::format("{} has no load cases, so none named '{}'", path.string(), name)
                            : fmt::format("{} has no load case '{}'{}; it has {}", path.string(), name,
                                          did_you_mean(name, names), fmt::join(names, ", ")));
}

void read_field(const Hdf5Reader& file, const CasePaths& paths, ElasticField& field) {
  field.patches = geometry::read_volumes(file, "/patches");
  geometry::UnpackedNumbers displacement(file, paths.displacement, 3);
  for (const NurbsVolume& patch : field.patches)
    field.displacement.emplace_back(displacement.take(patch.size()));
  displacement.require_end();
  read_materials(file, field.materials);
  read_errors(file, paths.errors, field);
  if (field.materials.size() != field.patches.size())
    throw Error(ErrorCode::invalid_argument, fmt::format("/patches/material has {} numbers for {} patches",
                                                         field.materials.size(), field.patches.size()));
  if (!file.contains(paths.thermal_strain)) return;
  const Eigen::MatrixXd strains = file.matrix(paths.thermal_strain, 4);
  for (Eigen::Index p = 0; p < strains.cols(); ++p)
    field.thermal.push_back({strains(0, p), strains.col(p).tail<3>()});
  if (field.thermal.size() != field.patches.size())
    throw Error(ErrorCode::invalid_argument,
                fmt::format("{} has {} columns for {} patches", paths.thermal_strain, field.thermal.size(),
                            field.patches.size()));
}

}  // namespace

void write_hdf5(const std::vector<CaseToStore>& cases, const geometry::PatchConnections& connections,
                const std::string& study, const std::string& summary, const geometry::ByteSink& sink) {
  const CaseToStore& first = cases.front();
  Hdf5Writer file;
  file.write("/format", format_name);
  file.write("/version", format_version);
  file.write("/study", study);
  file.write("/summary", summary);
  geometry::write_connections(file, "/model", connections);
  geometry::write_volumes(file, "/patches", first.field.patches);
  write_materials(file, first.field.materials);
  std::vector<std::int64_t> nodes;
  nodes.reserve(2 * first.multipliers.size());
  for (const Multiplier& multiplier : first.multipliers) {
    nodes.push_back(multiplier.first_node);
    nodes.push_back(multiplier.second_node);
  }
  file.write("/multipliers/nodes", nodes);
  std::string names;
  for (std::size_t i = 0; i < cases.size(); ++i) {
    const CasePaths paths(i);
    write_displacement(file, paths.displacement, cases[i].field);
    write_errors(file, paths.errors, cases[i].field.errors);
    write_thermal(file, paths.thermal_strain, cases[i].field.thermal);
    file.write(paths.forces, forces_of(cases[i].multipliers));
    names += cases[i].name + "\n";
  }
  if (!first.name.empty()) file.write("/cases/names", names);
  sink(file.view());
}

std::string to_hdf5(const StoredResult& result) {
  std::string bytes;
  write_hdf5({{result.case_name, result.field, result.multipliers}}, result.connections, result.study,
             result.summary, [&](std::string_view all) { bytes = all; });
  return bytes;
}

geometry::MultiPatch model_of(const StoredResult& result) {
  return geometry::connected(result.field.patches, result.connections);
}

StoredResult read_result(const std::filesystem::path& path, const std::string& case_name) {
  const Hdf5Reader file(path);
  if (!file.contains("/format") || file.text("/format") != format_name)
    throw Error(ErrorCode::bad_format, path.string() + ": an HDF5 file, but not a result of isopatch");
  if (const std::int64_t version = file.integer("/version"); version != format_version)
    throw Error(
        ErrorCode::unsupported,
        fmt::format("{}: results in format {}, this program reads format {}; run the study again, or use "
                    "the version of isopatch that wrote them",
                    path.string(), version, format_version));
  StoredResult result;
  result.case_names = case_names_of(file);
  const std::size_t index = index_of_case(result.case_names, case_name, path);
  const CasePaths paths(index);
  if (!result.case_names.empty()) result.case_name = result.case_names[index];
  try {
    result.connections = geometry::read_connections(file, "/model");
    read_field(file, paths, result.field);
    geometry::validate(result.connections, result.field.patches.size());
  } catch (const Error& error) {
    if (error.code() != ErrorCode::invalid_argument) throw;
    throw Error(ErrorCode::bad_format, path.string() + ": " + error.what());
  }
  result.study = file.text("/study");
  result.summary = file.text("/summary");
  const std::vector<std::int64_t> nodes = file.integers("/multipliers/nodes");
  const Eigen::MatrixXd forces = file.matrix(paths.forces, 3);
  if (static_cast<Eigen::Index>(nodes.size()) != 2 * forces.cols())
    throw Error(ErrorCode::bad_format,
                path.string() + ": /multipliers/nodes and " + paths.forces + " differ in length");
  for (Eigen::Index i = 0; i < forces.cols(); ++i)
    result.multipliers.push_back({static_cast<int>(nodes[static_cast<std::size_t>(2 * i)]),
                                  static_cast<int>(nodes[static_cast<std::size_t>(2 * i + 1)]),
                                  forces.col(i)});
  return result;
}

}  // namespace isopatch::iga
