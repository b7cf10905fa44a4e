#include "verification/parts/internal/stl_file.hpp"

#include <BRepBndLib.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <Bnd_Box.hxx>
#include <StlAPI_Writer.hxx>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace isopatch::parts {
namespace {

constexpr double chord = 1e-3;  // of the size
constexpr double turn = 12 * std::numbers::pi / 180;

}  // namespace

void write_stl(const Part& part, const std::string& path) {
  Bnd_Box box;
  BRepBndLib::AddOptimal(part.solid, box, false, false);
  BRepMesh_IncrementalMesh(part.solid, chord * std::sqrt(box.SquareExtent()), false, turn);
  StlAPI_Writer writer;
  writer.ASCIIMode() = false;
  if (!writer.Write(part.solid, path.c_str())) throw std::runtime_error("cannot write " + path);
}

}  // namespace isopatch::parts
