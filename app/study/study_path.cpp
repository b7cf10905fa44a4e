#include "app/study/study_path.hpp"

#include <fmt/format.h>

#include <cstdlib>

#include "geometry/base/error.hpp"

namespace isopatch::app {

std::string expand_variables(const std::string& text) {
  std::string result;
  std::size_t position = 0;
  for (;;) {
    const std::size_t begin = text.find("${", position);
    result += text.substr(position, begin - position);
    if (begin == std::string::npos) return result;
    const std::size_t end = text.find('}', begin);
    if (end == std::string::npos)
      throw Error(ErrorCode::invalid_argument, fmt::format("'${{' without '}}' in \"{}\"", text));
    const std::string inside = text.substr(begin + 2, end - begin - 2);
    const std::size_t fallback = inside.find(":-");
    const std::string name = inside.substr(0, fallback);
    const char* value = std::getenv(name.c_str());
    if (value && *value) {
      result += value;
    } else if (fallback != std::string::npos) {
      result += inside.substr(fallback + 2);
    } else {
      throw Error(ErrorCode::invalid_argument,
                  fmt::format("the environment variable {} is not set; set it, or write ${{{}:-default}}",
                              name, name));
    }
    position = end + 1;
  }
}

std::filesystem::path study_path(const std::string& path, const Place& place, const std::string& source) {
  try {
    const std::filesystem::path expanded = expand_variables(path);
    if (expanded.empty()) throw Error(ErrorCode::invalid_argument, "the path is empty");
    return expanded.is_absolute() ? expanded : std::filesystem::path(source).parent_path() / expanded;
  } catch (const Error& error) {
    throw error_at(place, error.what());
  }
}

}  // namespace isopatch::app
