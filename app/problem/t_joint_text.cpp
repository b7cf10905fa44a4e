#include "app/problem/t_joint_text.hpp"

#include <fmt/format.h>

#include "app/problem/overlapping_sides.hpp"

namespace isopatch::app {

std::vector<std::string> t_joint_texts(const segmentation::HexModel& model) {
  std::vector<std::string> texts;
  for (const geometry::TJoint& joint : model.topology.t_joints) {
    std::string parts;
    for (const geometry::SidePart& part : joint.parts)
      parts += (parts.empty() ? "" : ", ") + model.name(part.side.block);
    texts.push_back(fmt::format("{} of block '{}' meets {}", model.face(joint.whole).name,
                                model.name(joint.whole.block), parts));
  }
  for (const auto& [first, second] : overlapping_sides(model))
    texts.push_back(fmt::format("{} of block '{}' meets {} in part", model.face(first).name,
                                model.name(first.block), model.name(second.block)));
  return texts;
}

}  // namespace isopatch::app
