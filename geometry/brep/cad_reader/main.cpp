// Reads one CAD file for another process, which lives on if this one does not.

#include "geometry/brep/internal/cad_file.hpp"
#include "geometry/brep/internal/guarded_cad_file.hpp"

int main(int count, char** arguments) {
  return isopatch::geometry::cad_reader_main(count, arguments);
}
