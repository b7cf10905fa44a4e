#include "geometry/brep/internal/file_format.hpp"

#include <algorithm>
#include <cctype>

namespace isopatch::geometry {

std::string file_ending(const std::filesystem::path& path) {
  std::string text = path.extension().string();
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::optional<BrepFormat> module_format(const std::string& ending) {
  if (ending == ".step" || ending == ".stp" || ending == ".p21") return BrepFormat::step;
  if (ending == ".iges" || ending == ".igs") return BrepFormat::iges;
  if (ending == ".brep" || ending == ".brp") return BrepFormat::brep;
  return std::nullopt;
}

}  // namespace isopatch::geometry
