#include "geometry/io/hdf5_writer.hpp"

#include <fmt/format.h>

#include <atomic>
#include <string>

#include "geometry/base/error.hpp"
#include "geometry/io/internal/hdf5_handle.hpp"

namespace isopatch::geometry {
namespace {

constexpr std::size_t growth = 1 << 24;

Hdf5Handle file_in_memory() {
  const Hdf5Silence silence;
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  if (!access || H5Pset_fapl_core(access, growth, 0) < 0)
    throw Error(ErrorCode::internal, "HDF5: no core driver");
  static std::atomic<int> files = 0;  // of one name, one at a time could be open
  const std::string name = fmt::format("isopatch in memory {}", files++);
  Hdf5Handle file(H5Fcreate(name.c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, access), H5Fclose);
  if (!file) throw Error(ErrorCode::internal, "HDF5: cannot create a file in memory");
  return file;
}

}  // namespace

struct Hdf5Writer::State {
  Hdf5Handle file = file_in_memory();

  static bool mark(hid_t dataset, std::uint64_t checksum) {
    const Hdf5Handle one(H5Screate(H5S_SCALAR), H5Sclose);
    const Hdf5Handle attribute(
        H5Acreate2(dataset, checksum_name, H5T_NATIVE_UINT64, one, H5P_DEFAULT, H5P_DEFAULT), H5Aclose);
    return attribute && H5Awrite(attribute, H5T_NATIVE_UINT64, &checksum) >= 0;
  }

  void write(const std::string& path, hid_t type, const std::vector<hsize_t>& shape, const void* data) {
    const Hdf5Silence silence;
    if (path.size() < 2 || path[0] != '/' || path.back() == '/')
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("HDF5: '{}' is no path of a dataset such as /group/name", path));
    const Hdf5Handle links(H5Pcreate(H5P_LINK_CREATE), H5Pclose);
    const Hdf5Handle space(shape.empty()
                               ? H5Screate(H5S_SCALAR)
                               : H5Screate_simple(static_cast<int>(shape.size()), shape.data(), nullptr),
                           H5Sclose);
    if (!links || !space || H5Pset_create_intermediate_group(links, 1) < 0)
      throw Error(ErrorCode::internal, fmt::format("HDF5: cannot describe dataset '{}'", path));
    // Without the time of writing: equal contents are equal bytes.
    const Hdf5Handle creation(H5Pcreate(H5P_DATASET_CREATE), H5Pclose);
    H5Pset_obj_track_times(creation, false);
    const Hdf5Handle dataset(H5Dcreate2(file, path.c_str(), type, space, links, creation, H5P_DEFAULT),
                             H5Dclose);
    if (!dataset)
      throw Error(
          ErrorCode::invalid_argument,
          fmt::format("HDF5: cannot create dataset '{}'; is the name taken, or one on its way a dataset?",
                      path));
    std::size_t bytes = H5Tget_size(type);
    for (const hsize_t extent : shape) bytes *= extent;
    if (H5Dwrite(dataset, type, H5S_ALL, H5S_ALL, H5P_DEFAULT, data) < 0 ||
        !mark(dataset, dataset_checksum(shape, data, bytes)))
      throw Error(ErrorCode::out_of_memory, fmt::format("HDF5: cannot write dataset '{}'", path));
  }
};

Hdf5Writer::Hdf5Writer() : state_(std::make_unique<State>()) {}
Hdf5Writer::~Hdf5Writer() = default;
Hdf5Writer::Hdf5Writer(Hdf5Writer&&) noexcept = default;
Hdf5Writer& Hdf5Writer::operator=(Hdf5Writer&&) noexcept = default;

void Hdf5Writer::write(const std::string& path, const Eigen::MatrixXd& values) {
  // Column-major in memory is row-major of the transpose in the file.
  state_->write(path, H5T_NATIVE_DOUBLE,
                {static_cast<hsize_t>(values.cols()), static_cast<hsize_t>(values.rows())}, values.data());
}

void Hdf5Writer::write(const std::string& path, const Eigen::Matrix3Xd& values) {
  state_->write(path, H5T_NATIVE_DOUBLE, {static_cast<hsize_t>(values.cols()), 3}, values.data());
}

void Hdf5Writer::write(const std::string& path, const Eigen::VectorXd& values) {
  state_->write(path, H5T_NATIVE_DOUBLE, {static_cast<hsize_t>(values.size())}, values.data());
}

void Hdf5Writer::write(const std::string& path, const std::vector<double>& values) {
  state_->write(path, H5T_NATIVE_DOUBLE, {values.size()}, values.data());
}

void Hdf5Writer::write(const std::string& path, const std::vector<std::int64_t>& values) {
  state_->write(path, H5T_NATIVE_INT64, {values.size()}, values.data());
}

void Hdf5Writer::write(const std::string& path, std::int64_t value) {
  state_->write(path, H5T_NATIVE_INT64, {}, &value);
}

void Hdf5Writer::write(const std::string& path, double value) {
  state_->write(path, H5T_NATIVE_DOUBLE, {}, &value);
}

void Hdf5Writer::write(const std::string& path, const std::string& text) {
  const Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  // One byte more than the text, so that it ends in a zero and may be empty.
  if (H5Tset_size(type, text.size() + 1) < 0 || H5Tset_cset(type, H5T_CSET_UTF8) < 0)
    throw Error(ErrorCode::internal, "HDF5: cannot describe a text");
  state_->write(path, type, {}, text.c_str());
}

std::string_view Hdf5Writer::view() const {
  const Hdf5Silence silence;
  const ssize_t size =
      H5Fflush(state_->file, H5F_SCOPE_GLOBAL) < 0 ? -1 : H5Fget_file_image(state_->file, nullptr, 0);
  // The handle of the core driver is the address of the memory that it keeps the file in.
  void** memory = nullptr;
  if (size < 0 || H5Fget_vfd_handle(state_->file, H5P_DEFAULT, reinterpret_cast<void**>(&memory)) < 0)
    throw Error(ErrorCode::internal, "HDF5: the file in memory cannot be read");
  return {static_cast<const char*>(*memory), static_cast<std::size_t>(size)};
}

}  // namespace isopatch::geometry
