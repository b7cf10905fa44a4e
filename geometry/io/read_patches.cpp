#include "geometry/io/read_patches.hpp"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/error.hpp"
#include "geometry/io/read_g2.hpp"
#include "geometry/io/read_gismo_xml.hpp"
#include "geometry/io/read_mfem_mesh.hpp"
#include "geometry/io/text_scanner.hpp"

namespace isopatch::geometry {
namespace {

constexpr const char* supported =
    "supported are G+Smo XML (<xml> with TensorBSpline3 and TensorNurbs3), GoTools .g2 (type 700) and "
    "MFEM NURBS meshes (MFEM NURBS mesh v1.0 and v1.1)";

// How files of other formats begin that a user may well try.
constexpr std::array<std::pair<std::string_view, std::string_view>, 13> known = {{
    {"MFEM mesh", "an MFEM mesh without NURBS"},
    {"MFEM NC", "an MFEM mesh without NURBS"},
    {"ISO-10303-21", "a STEP file: surfaces of solids, not volume patches"},
    {"solid", "an STL triangulation"},
    {"OFF", "an OFF triangulation"},
    {"$MeshFormat", "a Gmsh mesh"},
    {"*", "an input file of Abaqus or CalculiX: finite elements, not patches"},
    {"DBRep_DrawableShape", "an OpenCASCADE .brep file: surfaces of solids, not volume patches"},
    {"CASCADE Topology", "an OpenCASCADE .brep file: surfaces of solids, not volume patches"},
    {"\xFF\xFE", "a text in UTF-16; save it as UTF-8"},
    {"\xFE\xFF", "a text in UTF-16; save it as UTF-8"},
    {"# vtk DataFile", "a VTK file"},
    {"\x89HDF", "an HDF5 file, perhaps results of isopatch"},
}};

// The text after a byte order mark and white space.
std::string_view beginning(std::string_view text) {
  text = without_byte_order_mark(text);
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first == text.npos ? std::string_view{} : text.substr(first);
}

[[noreturn]] void refuse(std::string_view begin, const std::string& source) {
  for (const auto& [magic, what] : known)
    if (begin.starts_with(magic))
      throw Error(ErrorCode::unsupported, fmt::format("{}: this is {}; {}", source, what, supported));
  if (begin.empty())
    throw Error(ErrorCode::bad_format, fmt::format("{}: the file is empty; {}", source, supported));
  throw Error(ErrorCode::unsupported, fmt::format("{}: the format is unknown; {}", source, supported));
}

}  // namespace

PatchSet read_patches(std::string_view text, const std::string& source) {
  const std::string_view begin = beginning(text);
  if (begin.starts_with("<")) return read_gismo_xml(text, source);
  if (begin.starts_with("MFEM NURBS")) return read_mfem_mesh(text, source);
  if (!begin.empty() && begin[0] >= '0' && begin[0] <= '9') return read_g2(text, source);
  refuse(begin, source);
}

PatchSet read_patches(const std::filesystem::path& path) {
  return read_patches(read_file(path), path.string());
}

}  // namespace isopatch::geometry
