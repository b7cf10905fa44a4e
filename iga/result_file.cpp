#include "iga/result_file.hpp"

#include <fmt/format.h>

#include "geometry/base/error.hpp"
#include "geometry/io/hdf5_connections.hpp"

namespace isopatch::iga {
namespace {

using geometry::Hdf5Reader;
using geometry::Hdf5Writer;
using geometry::KnotVector;
using geometry::NurbsVolume;

constexpr const char* format_name = "isopatch result";
constexpr std::int64_t format_version = 2;

std::string patch_group(std::size_t patch) {
  return fmt::format("/patches/{:05}", patch);
}

void write_patch(Hdf5Writer& file, const ElasticField& field, std::size_t p) {
  const std::string group = patch_group(p);
  const NurbsVolume& patch = field.patches[p];
  for (int d = 0; d < 3; ++d) {
    file.write(fmt::format("{}/degree_{}", group, d), std::int64_t{patch.degree(d)});
    file.write(fmt::format("{}/knots_{}", group, d), patch.knots(d).knots());
  }
  file.write(group + "/control_points", patch.control_points());
  file.write(group + "/weights", patch.weights());
  file.write(group + "/displacement", field.displacement[p]);
  const Material& material = field.materials[p];
  file.write(group + "/material/name", material.name);
  file.write(group + "/material/lambda", material.lambda);
  file.write(group + "/material/mu", material.mu);
  file.write(group + "/material/density", material.density);
}

void read_patch(const Hdf5Reader& file, const std::string& group, ElasticField& field) {
  std::array<KnotVector, 3> knots;
  for (int d = 0; d < 3; ++d) {
    const std::int64_t degree = file.integer(fmt::format("{}/degree_{}", group, d));
    const Eigen::VectorXd values = file.vector(fmt::format("{}/knots_{}", group, d));
    knots[static_cast<std::size_t>(d)] =
        KnotVector(static_cast<int>(std::min<std::int64_t>(degree, KnotVector::max_degree + 1)),
                   {values.begin(), values.end()});
  }
  field.patches.emplace_back(knots, file.matrix(group + "/control_points", 3),
                             file.vector(group + "/weights"));
  field.displacement.push_back(file.matrix(group + "/displacement", 3));
  if (field.displacement.back().cols() != field.patches.back().size())
    throw Error(ErrorCode::bad_format,
                fmt::format("{}/displacement has {} columns for {} control points", group,
                            field.displacement.back().cols(), field.patches.back().size()));
  field.materials.push_back({file.number(group + "/material/lambda"), file.number(group + "/material/mu"),
                             file.number(group + "/material/density"), file.text(group + "/material/name")});
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
  for (std::size_t p = 0; p < field.patches.size(); ++p) write_patch(file, field, p);
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
    for (std::size_t p = 0; p < result.connections.reversed.size(); ++p)
      read_patch(file, patch_group(p), result.field);
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
