#include "geometry/io/hdf5_reader.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/base/error.hpp"
#include "geometry/io/internal/hdf5_handle.hpp"

namespace isopatch::geometry {
namespace {

[[noreturn]] void fail(const std::string& file, const std::string& message,
                       ErrorCode code = ErrorCode::bad_format) {
  throw Error(code, fmt::format("{}: {}", file, message));
}

// Reads one byte through the system, for its reason if that fails.
void check_readable(const std::filesystem::path& path) {
  std::error_code reason;
  const auto size = std::filesystem::file_size(path, reason);
  if (reason) fail(path.string(), "cannot be read: " + reason.message(), ErrorCode::io);
  if (size == 0) fail(path.string(), "the file is empty");
}

}  // namespace

struct Hdf5Reader::State {
  std::string name;
  Hdf5Handle file;

  // Whether every part of the path exists; H5Lexists wants its parents to be there.
  bool contains(const std::string& path) const {
    const Hdf5Silence silence;
    for (std::size_t end = path.find('/', 1);; end = path.find('/', end + 1)) {
      const std::string part = path.substr(0, end);
      if (part != "/" && H5Lexists(file, part.c_str(), H5P_DEFAULT) <= 0) return false;
      if (end == path.npos) return H5Oexists_by_name(file, path.c_str(), H5P_DEFAULT) > 0;
    }
  }

  Hdf5Handle open(const std::string& path) const {
    if (!contains(path)) fail(name, fmt::format("there is no dataset '{}'", path));
    Hdf5Handle dataset(H5Dopen2(file, path.c_str(), H5P_DEFAULT), H5Dclose);
    if (!dataset) fail(name, fmt::format("'{}' is not a dataset, or it is damaged", path));
    return dataset;
  }

  std::vector<hsize_t> shape(hid_t dataset, const std::string& path) const {
    const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
    const int rank = space ? H5Sget_simple_extent_ndims(space) : -1;
    if (rank < 0) fail(name, fmt::format("the shape of dataset '{}' cannot be read", path));
    std::vector<hsize_t> result(static_cast<std::size_t>(rank));
    H5Sget_simple_extent_dims(space, result.data(), nullptr);
    hsize_t room = static_cast<hsize_t>(max_values);
    for (const hsize_t extent : result) {
      if (extent > room) fail(name, fmt::format("dataset '{}' has more than {} values", path, max_values));
      if (extent > 0) room /= extent;
    }
    return result;
  }

  void require_type(hid_t dataset, const std::string& path, H5T_class_t wanted, const char* what) const {
    const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
    if (!type || H5Tget_class(type) != wanted)
      fail(name, fmt::format("dataset '{}' does not hold {}", path, what));
  }

  void require_rank(const std::vector<hsize_t>& shape, std::size_t rank, const std::string& path) const {
    if (shape.size() != rank)
      fail(name, fmt::format("dataset '{}' has {} dimensions instead of {}", path, shape.size(), rank));
  }

  // A file that was cut off must not make us allocate: what is stored cannot exceed the file.
  void require_stored(hid_t dataset, const std::string& path, hsize_t bytes) const {
    if (bytes > 0 && H5Dget_storage_size(dataset) == 0)
      fail(name, fmt::format("dataset '{}' was never written", path));
    hsize_t size = 0;
    if (H5Fget_filesize(file, &size) < 0 || bytes > size)
      fail(name, fmt::format("dataset '{}' is larger than the file; the file may be cut off", path));
  }

  void read(hid_t dataset, const std::string& path, hid_t type, const std::vector<hsize_t>& shape,
            void* data) const {
    if (H5Dread(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0)
      fail(name, fmt::format("dataset '{}' cannot be read; the file may be cut off or damaged", path));
    std::size_t bytes = H5Tget_size(type);
    for (const hsize_t extent : shape) bytes *= extent;
    require_unchanged(dataset, path, dataset_checksum(shape, data, bytes));
  }

  // Files by other programs have no checksums, which is no fault of theirs.
  void require_unchanged(hid_t dataset, const std::string& path, std::uint64_t found) const {
    if (H5Aexists(dataset, checksum_name) <= 0) return;
    const Hdf5Handle attribute(H5Aopen(dataset, checksum_name, H5P_DEFAULT), H5Aclose);
    std::uint64_t written = 0;
    if (attribute && H5Aread(attribute, H5T_NATIVE_UINT64, &written) >= 0 && written == found) return;
    fail(name, fmt::format("dataset '{}' is not as it was written: the file has been changed or damaged; "
                           "copy it anew, or make it again",
                           path));
  }
};

Hdf5Reader::Hdf5Reader(const std::filesystem::path& path) : state_(std::make_unique<State>()) {
  const Hdf5Silence silence;
  state_->name = path.string();
  check_readable(path);
  if (H5Fis_hdf5(path.c_str()) <= 0) fail(state_->name, "not an HDF5 file");
  state_->file = Hdf5Handle(H5Fopen(path.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
  if (!state_->file) fail(state_->name, "the HDF5 file cannot be opened; it may be cut off or damaged");
}

Hdf5Reader::~Hdf5Reader() = default;
Hdf5Reader::Hdf5Reader(Hdf5Reader&&) noexcept = default;
Hdf5Reader& Hdf5Reader::operator=(Hdf5Reader&&) noexcept = default;

bool Hdf5Reader::contains(const std::string& path) const {
  return state_->contains(path);
}

std::vector<std::string> Hdf5Reader::names(const std::string& group) const {
  const Hdf5Silence silence;
  const Hdf5Handle handle(H5Gopen2(state_->file, group.c_str(), H5P_DEFAULT), H5Gclose);
  if (!handle) fail(state_->name, fmt::format("there is no group '{}'", group));
  std::vector<std::string> result;
  const auto collect = [](hid_t, const char* name, const H5L_info_t*, void* names) -> herr_t {
    static_cast<std::vector<std::string>*>(names)->emplace_back(name);
    return 0;
  };
  if (H5Literate(handle, H5_INDEX_NAME, H5_ITER_INC, nullptr, collect, &result) < 0)
    fail(state_->name, fmt::format("group '{}' cannot be read", group));
  std::sort(result.begin(), result.end());
  return result;
}

Eigen::MatrixXd Hdf5Reader::matrix(const std::string& path, int rows) const {
  const Hdf5Silence silence;
  const Hdf5Handle dataset = state_->open(path);
  state_->require_type(dataset, path, H5T_FLOAT, "real numbers");
  const std::vector<hsize_t> shape = state_->shape(dataset, path);
  state_->require_rank(shape, 2, path);
  if (rows >= 0 && shape[1] != static_cast<hsize_t>(rows))
    fail(state_->name, fmt::format("dataset '{}' has {} numbers a row instead of {}", path, shape[1], rows));
  state_->require_stored(dataset, path, shape[0] * shape[1] * sizeof(double));
  Eigen::MatrixXd result(static_cast<Eigen::Index>(shape[1]), static_cast<Eigen::Index>(shape[0]));
  state_->read(dataset, path, H5T_NATIVE_DOUBLE, shape, result.data());
  return result;
}

Eigen::VectorXd Hdf5Reader::vector(const std::string& path, std::int64_t size) const {
  const Hdf5Silence silence;
  const Hdf5Handle dataset = state_->open(path);
  state_->require_type(dataset, path, H5T_FLOAT, "real numbers");
  const std::vector<hsize_t> shape = state_->shape(dataset, path);
  state_->require_rank(shape, 1, path);
  if (size >= 0 && shape[0] != static_cast<hsize_t>(size))
    fail(state_->name, fmt::format("dataset '{}' has {} entries instead of {}", path, shape[0], size));
  state_->require_stored(dataset, path, shape[0] * sizeof(double));
  Eigen::VectorXd result(static_cast<Eigen::Index>(shape[0]));
  state_->read(dataset, path, H5T_NATIVE_DOUBLE, shape, result.data());
  return result;
}

std::vector<std::int64_t> Hdf5Reader::integers(const std::string& path, std::int64_t size) const {
  const Hdf5Silence silence;
  const Hdf5Handle dataset = state_->open(path);
  state_->require_type(dataset, path, H5T_INTEGER, "integers");
  const std::vector<hsize_t> shape = state_->shape(dataset, path);
  state_->require_rank(shape, 1, path);
  if (size >= 0 && shape[0] != static_cast<hsize_t>(size))
    fail(state_->name, fmt::format("dataset '{}' has {} entries instead of {}", path, shape[0], size));
  state_->require_stored(dataset, path, shape[0] * sizeof(std::int64_t));
  std::vector<std::int64_t> result(shape[0]);
  state_->read(dataset, path, H5T_NATIVE_INT64, shape, result.data());
  return result;
}

std::int64_t Hdf5Reader::integer(const std::string& path) const {
  const Hdf5Silence silence;
  const Hdf5Handle dataset = state_->open(path);
  state_->require_type(dataset, path, H5T_INTEGER, "an integer");
  state_->require_rank(state_->shape(dataset, path), 0, path);
  std::int64_t result = 0;
  state_->read(dataset, path, H5T_NATIVE_INT64, {}, &result);
  return result;
}

double Hdf5Reader::number(const std::string& path) const {
  const Hdf5Silence silence;
  const Hdf5Handle dataset = state_->open(path);
  state_->require_type(dataset, path, H5T_FLOAT, "a real number");
  state_->require_rank(state_->shape(dataset, path), 0, path);
  double result = 0;
  state_->read(dataset, path, H5T_NATIVE_DOUBLE, {}, &result);
  return result;
}

std::string Hdf5Reader::text(const std::string& path) const {
  const Hdf5Silence silence;
  const Hdf5Handle dataset = state_->open(path);
  state_->require_type(dataset, path, H5T_STRING, "a text");
  state_->require_rank(state_->shape(dataset, path), 0, path);
  const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
  if (H5Tis_variable_str(type) != 0)
    fail(state_->name, fmt::format("dataset '{}' holds a text of variable length", path));
  const std::size_t size = H5Tget_size(type);
  state_->require_stored(dataset, path, size);
  std::string result(size, '\0');
  state_->read(dataset, path, type, {}, result.data());
  result.resize(std::min(result.find('\0'), size));
  return result;
}

}  // namespace isopatch::geometry
