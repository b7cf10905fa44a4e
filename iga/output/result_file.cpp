#include "iga/output/result_file.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/base/error.hpp"
#include "geometry/io/hdf5_connections.hpp"

namespace isopatch::iga {
namespace {

using geometry::Hdf5Reader;
using geometry::Hdf5Writer;
using geometry::KnotVector;
using geometry::NurbsVolume;

constexpr const char* format_name = "isopatch result";
constexpr std::int64_t format_version = 3;

/// Numbers of all patches one after the other: files of many small datasets take long to write.
class Packed {
 public:
  template <class Matrix>
  void add(const Matrix& values) {
    numbers_.insert(numbers_.end(), values.data(), values.data() + values.size());
  }
  void write(Hdf5Writer& file, const std::string& path, Eigen::Index rows) const {
    if (rows == 1)
      file.write(path, numbers_);
    else
      file.write(path, Eigen::MatrixXd(Eigen::Map<const Eigen::MatrixXd>(
                           numbers_.data(), rows, static_cast<Eigen::Index>(numbers_.size()) / rows)));
  }

 private:
  std::vector<double> numbers_;
};

/// Takes numbers off one after the other. What is wrong with them is an invalid_argument, to which
/// `read_result` adds the file.
class Unpacked {
 public:
  Unpacked(Eigen::MatrixXd values, std::string path) : values_(std::move(values)), path_(std::move(path)) {}

  void require(Eigen::Index count) const {
    if (count > values_.cols() - taken_)
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("{} ends early: {} columns are too few", path_, values_.cols()));
  }
  Eigen::MatrixXd take(Eigen::Index count) {
    require(count);
    taken_ += count;
    return values_.middleCols(taken_ - count, count);
  }
  void require_end() const {
    if (taken_ != values_.cols())
      throw Error(ErrorCode::invalid_argument, fmt::format("{} has {} columns, of which {} belong to patches",
                                                           path_, values_.cols(), taken_));
  }

 private:
  Eigen::MatrixXd values_;
  std::string path_;
  Eigen::Index taken_ = 0;
};

bool same(const Material& a, const Material& b) {
  return a.lambda == b.lambda && a.mu == b.mu && a.density == b.density && a.name == b.name;
}

std::string material_group(std::size_t material) {
  return fmt::format("/materials/{:05}", material);
}

/// Each once, and which one every patch has.
void write_materials(Hdf5Writer& file, const std::vector<Material>& of_patches) {
  std::vector<Material> materials;
  std::vector<std::int64_t> numbers;
  for (const Material& material : of_patches) {
    const auto found = std::find_if(materials.begin(), materials.end(),
                                    [&](const Material& other) { return same(material, other); });
    numbers.push_back(found - materials.begin());
    if (found == materials.end()) materials.push_back(material);
  }
  for (std::size_t m = 0; m < materials.size(); ++m) {
    const std::string group = material_group(m);
    file.write(group + "/name", materials[m].name);
    file.write(group + "/lambda", materials[m].lambda);
    file.write(group + "/mu", materials[m].mu);
    file.write(group + "/density", materials[m].density);
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
                         file.number(group + "/density"), file.text(group + "/name")});
  }
  for (const std::int64_t number : numbers) of_patches.push_back(materials[static_cast<std::size_t>(number)]);
}

void write_patches(Hdf5Writer& file, const ElasticField& field) {
  std::vector<std::int64_t> degrees, knot_counts;
  Packed knots, weights;
  for (const NurbsVolume& patch : field.patches) {
    for (const KnotVector& along : patch.knots()) {
      degrees.push_back(along.degree());
      knot_counts.push_back(static_cast<std::int64_t>(along.knots().size()));
      knots.add(along.knots());
    }
    weights.add(patch.weights());
  }
  file.write("/patches/degrees", degrees);
  file.write("/patches/knot_counts", knot_counts);
  knots.write(file, "/patches/knots", 1);
  weights.write(file, "/patches/weights", 1);
  const auto write_points = [&](const std::string& path, const auto& of_patch) {
    Packed points;
    for (std::size_t p = 0; p < field.patches.size(); ++p) points.add(of_patch(p));
    points.write(file, path, 3);
  };
  write_points("/patches/control_points",
               [&](std::size_t p) -> decltype(auto) { return field.patches[p].control_points(); });
  write_points("/patches/displacement",
               [&](std::size_t p) -> const Eigen::Matrix3Xd& { return field.displacement[p]; });
  write_materials(file, field.materials);
}

void read_patches(const Hdf5Reader& file, std::size_t count, ElasticField& field) {
  const auto numbers = static_cast<std::int64_t>(3 * count);
  const std::vector<std::int64_t> degrees = file.integers("/patches/degrees", numbers);
  const std::vector<std::int64_t> knot_counts = file.integers("/patches/knot_counts", numbers);
  const auto packed = [&](const std::string& path, int rows) {
    return Unpacked(rows == 1 ? Eigen::MatrixXd(file.vector(path).transpose()) : file.matrix(path, rows),
                    path);
  };
  Unpacked all_knots = packed("/patches/knots", 1), weights = packed("/patches/weights", 1),
           points = packed("/patches/control_points", 3), displacement = packed("/patches/displacement", 3);
  for (std::size_t p = 0; p < count; ++p) {
    std::array<KnotVector, 3> knots;
    Eigen::Index size = 1;
    for (std::size_t d = 0; d < 3; ++d) {
      const Eigen::MatrixXd values = all_knots.take(std::max<std::int64_t>(knot_counts[3 * p + d], 0));
      knots[d] = KnotVector(
          static_cast<int>(std::clamp<std::int64_t>(degrees[3 * p + d], -1, KnotVector::max_degree + 1)),
          {values.data(), values.data() + values.size()});
      size *= knots[d].size();
      points.require(size);  // before the product can overflow
    }
    const Eigen::Matrix3Xd net = points.take(size);
    field.patches.emplace_back(knots, net, Eigen::VectorXd(weights.take(size).transpose()));
    field.displacement.emplace_back(displacement.take(size));
  }
  for (const Unpacked* each : {&all_knots, &weights, &points, &displacement}) each->require_end();
  read_materials(file, field.materials);
  if (field.materials.size() != count)
    throw Error(ErrorCode::invalid_argument, fmt::format("/patches/material has {} numbers for {} patches",
                                                         field.materials.size(), count));
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
  write_patches(file, field);
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
    read_patches(file, result.connections.reversed.size(), result.field);
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
