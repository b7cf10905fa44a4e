#include "geometry/io/vtk_collection.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <pugixml.hpp>
#include <sstream>

#include "geometry/base/error.hpp"

namespace isopatch::geometry {

std::string to_vtm(const std::vector<VtkGroup>& groups) {
  pugi::xml_document document;
  pugi::xml_node file = document.append_child("VTKFile");
  file.append_attribute("type") = "vtkMultiBlockDataSet";
  file.append_attribute("version") = "1.0";
  file.append_attribute("byte_order") = "LittleEndian";
  pugi::xml_node collection = file.append_child("vtkMultiBlockDataSet");
  int group_index = 0;
  for (const VtkGroup& group : groups) {
    pugi::xml_node parent = collection.append_child("Block");
    parent.append_attribute("index") = group_index++;
    parent.append_attribute("name") = group.name.c_str();
    int index = 0;
    for (const VtkBlock& block : group.blocks) {
      if (block.file.empty() || std::filesystem::path(block.file).is_absolute())
        throw Error(ErrorCode::invalid_argument,
                    fmt::format("collection for VTK: block '{}' has the file '{}'; a relative path is needed",
                                block.name, block.file));
      pugi::xml_node leaf = parent.append_child("DataSet");
      leaf.append_attribute("index") = index++;
      leaf.append_attribute("name") = block.name.c_str();
      leaf.append_attribute("file") = block.file.c_str();
    }
  }
  std::ostringstream text;
  document.save(text, "  ");
  return text.str();
}

}  // namespace isopatch::geometry
