#include "iga/output/result_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/base/error.hpp"
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
                         file.contains(group + "/expansion") ? file.number(group + "/expansion") : 0.0});
  }
  for (const std::int64_t number : numbers) of_patches.push_back(materials[static_cast<std::size_t>(number)]);
}

// Files of runs without an estimate, or from before there was one, have none.
constexpr const char* errors_group = "/patches/errors";

void write_errors(Hdf5Writer& file, const std::vector<ElementErrors>& errors) {
  if (errors.empty()) return;
  geometry::PackedNumbers energy, stress;
  for (const ElementErrors& of_patch : errors) {
    energy.add(of_patch.energy);
    stress.add(of_patch.stress);
  }
  energy.write(file, std::string(errors_group) + "/energy", 1);
  stress.write(file, std::string(errors_group) + "/stress", 1);
}

void read_errors(const Hdf5Reader& file, ElasticField& field) {
  if (!file.contains(errors_group)) return;
  geometry::UnpackedNumbers energy(file, std::string(errors_group) + "/energy", 1);
  geometry::UnpackedNumbers stress(file, std::string(errors_group) + "/stress", 1);
  for (const NurbsVolume& patch : field.patches) {
    const Eigen::Index count = Eigen::Index{patch.knots(0).element_count()} * patch.knots(1).element_count() *
                               patch.knots(2).element_count();
    field.errors.push_back({energy.take(count).transpose(), stress.take(count).transpose()});
  }
  energy.require_end();
  stress.require_end();
}

void write_field(Hdf5Writer& file, const ElasticField& field) {
  geometry::write_volumes(file, "/patches", field.patches);
  geometry::PackedNumbers displacement;
  for (const Eigen::Matrix3Xd& of_patch : field.displacement) displacement.add(of_patch);
  displacement.write(file, "/patches/displacement", 3);
  write_materials(file, field.materials);
  write_errors(file, field.errors);
  if (field.thermal.empty()) return;
  Eigen::MatrixXd strains(4, static_cast<Eigen::Index>(field.thermal.size()));
  for (std::size_t p = 0; p < field.thermal.size(); ++p)
    strains.col(static_cast<Eigen::Index>(p)) << field.thermal[p].at_origin, field.thermal[p].gradient;
  file.write("/patches/thermal_strain", strains);
}

void read_field(const Hdf5Reader& file, ElasticField& field) {
  field.patches = geometry::read_volumes(file, "/patches");
  geometry::UnpackedNumbers displacement(file, "/patches/displacement", 3);
  for (const NurbsVolume& patch : field.patches)
    field.displacement.emplace_back(displacement.take(patch.size()));
  displacement.require_end();
  read_materials(file, field.materials);
  read_errors(file, field);
  if (field.materials.size() != field.patches.size())
    throw Error(ErrorCode::invalid_argument, fmt::format("/patches/material has {} numbers for {} patches",
                                                         field.materials.size(), field.patches.size()));
  if (!file.contains("/patches/thermal_strain")) return;
  const Eigen::MatrixXd strains = file.matrix("/patches/thermal_strain", 4);
  for (Eigen::Index p = 0; p < strains.cols(); ++p)
    field.thermal.push_back({strains(0, p), strains.col(p).tail<3>()});
  if (field.thermal.size() != field.patches.size())
    throw Error(ErrorCode::invalid_argument,
                fmt::format("/patches/thermal_strain has {} columns for {} patches", field.thermal.size(),
                            field.patches.size()));
}

}  // namespace

void write_hdf5(const ElasticField& field, const std::vector<Multiplier>& multipliers,
                const geometry::PatchConnections& connections, const std::string& study,
                const std::string& summary, const geometry::ByteSink& sink) {
  Hdf5Writer file;
  file.write("/format", format_name);
  file.write("/version", format_version);
  file.write("/study", study);
  file.write("/summary", summary);
  geometry::write_connections(file, "/model", connections);
  write_field(file, field);
  std::vector<std::int64_t> nodes;
  nodes.reserve(2 * multipliers.size());
  Eigen::Matrix3Xd forces(3, static_cast<Eigen::Index>(multipliers.size()));
  for (std::size_t i = 0; i < multipliers.size(); ++i) {
    nodes.push_back(multipliers[i].first_node);
    nodes.push_back(multipliers[i].second_node);
    forces.col(static_cast<Eigen::Index>(i)) = multipliers[i].force;
  }
  file.write("/multipliers/nodes", nodes);
  file.write("/multipliers/forces", forces);
  sink(file.view());
}

std::string to_hdf5(const StoredResult& result) {
  std::string bytes;
  write_hdf5(result.field, result.multipliers, result.connections, result.study, result.summary,
             [&](std::string_view all) { bytes = all; });
  return bytes;
}

geometry::MultiPatch model_of(const StoredResult& result) {
  return geometry::connected(result.field.patches, result.connections);
}

StoredResult read_result(const std::filesystem::path& path) {
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
  try {
    result.connections = geometry::read_connections(file, "/model");
    read_field(file, result.field);
    geometry::validate(result.connections, result.field.patches.size());
  } catch (const Error& error) {
    if (error.code() != ErrorCode::invalid_argument) throw;
    throw Error(ErrorCode::bad_format, path.string() + ": " + error.what());
  }
  result.study = file.text("/study");
  result.summary = file.text("/summary");
  const std::vector<std::int64_t> nodes = file.integers("/multipliers/nodes");
  const Eigen::MatrixXd forces = file.matrix("/multipliers/forces", 3);
  if (static_cast<Eigen::Index>(nodes.size()) != 2 * forces.cols())
    throw Error(ErrorCode::bad_format,
                path.string() + ": /multipliers/nodes and /multipliers/forces differ in length");
  for (Eigen::Index i = 0; i < forces.cols(); ++i)
    result.multipliers.push_back({static_cast<int>(nodes[static_cast<std::size_t>(2 * i)]),
                                  static_cast<int>(nodes[static_cast<std::size_t>(2 * i + 1)]),
                                  forces.col(i)});
  return result;
}

}  // namespace isopatch::iga
