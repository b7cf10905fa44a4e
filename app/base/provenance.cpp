#include "app/base/provenance.hpp"

#include <sys/resource.h>

namespace isopatch::app {

std::string_view version() {
  return ISOPATCH_VERSION;
}

std::int64_t peak_memory_bytes() {
  rusage usage = {};
  ::getrusage(RUSAGE_SELF, &usage);
  return static_cast<std::int64_t>(usage.ru_maxrss) * 1024;
}

}  // namespace isopatch::app
