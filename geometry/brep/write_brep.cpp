#include "geometry/brep/write_brep.hpp"

#include <fmt/format.h>

#include <unistd.h>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/error.hpp"
#include "geometry/brep/internal/file_format.hpp"
#include "geometry/brep/module.hpp"

namespace isopatch::geometry {
namespace {

namespace fs = std::filesystem;

/// A folder for files of the library, which cannot write into memory; removed at the end.
class ScratchFolder {
 public:
  ScratchFolder()
      : path_(fs::temp_directory_path() / fmt::format("isopatch-solid-{}-{}", ::getpid(), ++count)) {
    fs::create_directories(path_);
  }
  ~ScratchFolder() {
    std::error_code none;
    fs::remove_all(path_, none);
  }
  ScratchFolder(const ScratchFolder&) = delete;
  ScratchFolder& operator=(const ScratchFolder&) = delete;
  const fs::path& path() const { return path_; }

 private:
  static inline int count = 0;
  fs::path path_;
};

}  // namespace

void write_brep(const fs::path& path, const Brep& brep, const WriteBrepOptions& options) {
  const auto format = module_format(file_ending(path));
  if (!format)
    throw Error(ErrorCode::unsupported,
                fmt::format("{}: solids are written as .step, .stp, .iges, .igs and .brep", path.string()));
  if (options.unit != "mm" && options.unit != "m" && options.unit != "in")
    throw Error(ErrorCode::invalid_argument,
                fmt::format("unit is '{}'; mm, m and in are supported", options.unit));
  const ScratchFolder scratch;
  const fs::path written = scratch.path() / path.filename();
  brep_module().write(written, *format, brep.kernel(), options.unit);
  write_file(path, read_file(written));
}

}  // namespace isopatch::geometry
