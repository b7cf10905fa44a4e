// Writes STEP and STL files of the parts that the segmentation is measured on, and parts.json, which says
// what they are.

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <Standard_Failure.hxx>
#include <algorithm>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "verification/parts/internal/drawings.hpp"
#include "verification/parts/internal/step_file.hpp"
#include "verification/parts/internal/stl_file.hpp"

namespace {

using isopatch::parts::Drawing;
using isopatch::parts::drawings;
using isopatch::parts::Part;
using nlohmann::ordered_json;

ordered_json description(const Drawing& drawing, const Part& part) {
  ordered_json result = {{"name", drawing.name}, {"set", drawing.set}, {"what", drawing.what}};
  result["file"] = drawing.name + ".step";
  if (part.others.empty()) result["triangles"] = drawing.name + ".stl";
  for (const auto& face : part.faces) result["faces"].push_back(face.name);
  result["held"] = part.faces[0].name;
  result["loaded"] = part.faces[1].name;
  result["volume_in_mm3"] = part.volume ? ordered_json(*part.volume) : ordered_json(nullptr);
  result["hexahedra_at_most"] = drawing.hexahedra ? ordered_json(*drawing.hexahedra) : ordered_json(nullptr);
  return result;
}

ordered_json written(const Drawing& drawing, const std::string& folder) {
  try {
    const Part part = drawing.draw();
    write_step(part, drawing.name, folder + "/" + drawing.name + ".step");
    if (part.others.empty()) write_stl(part, folder + "/" + drawing.name + ".stl");
    return description(drawing, part);
  } catch (const Standard_Failure& failure) {
    throw std::runtime_error(drawing.name + ": " + failure.GetMessageString());
  } catch (const std::exception& error) {
    throw std::runtime_error(drawing.name + ": " + error.what());
  }
}

std::vector<Drawing> chosen(const std::vector<std::string>& names) {
  if (names.empty()) return drawings();
  std::vector<Drawing> result;
  for (const std::string& name : names) {
    const auto found = std::find_if(drawings().begin(), drawings().end(),
                                    [&](const Drawing& one) { return one.name == name; });
    if (found == drawings().end()) throw std::runtime_error("no part is called " + name);
    result.push_back(*found);
  }
  return result;
}

void write_parts(const std::string& folder, const std::vector<std::string>& names) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  ordered_json parts = ordered_json::array();
  for (const Drawing& drawing : chosen(names)) parts.push_back(written(drawing, folder));
  if (names.empty()) std::ofstream(folder + "/parts.json") << parts.dump(1) << "\n";
}

}  // namespace

int main(int count, char** arguments) {
  const std::vector<std::string> words(arguments + 1, arguments + count);
  if (words.empty() || words[0] == "--help") {
    std::cerr << "usage: isopatch-parts FOLDER [NAME...]   writes parts, default all of them and parts.json\n"
                 "       isopatch-parts --list             says what there is\n";
    return words.empty() ? 2 : 0;
  }
  try {
    if (words[0] == "--list")
      for (const Drawing& drawing : drawings())
        std::cout << drawing.set << "  " << drawing.name << ": " << drawing.what << "\n";
    else
      write_parts(words[0], {words.begin() + 1, words.end()});
  } catch (const std::exception& error) {
    std::cerr << "isopatch-parts: " << error.what() << "\n";
    return 1;
  }
  return 0;
}
