#include "app/problem/attachment.hpp"

#include "app/problem/face_name.hpp"
#include "geometry/attach.hpp"

namespace isopatch::app {
namespace {

std::vector<geometry::PatchFace> faces_of(const geometry::PatchSet& set, const AttachmentInput& input) {
  std::vector<geometry::PatchFace> result;
  for (const std::string& text : input.faces) {
    const auto faces = faces_named(text, static_cast<int>(set.patches.size()), set.boundaries, input.place);
    result.insert(result.end(), faces.begin(), faces.end());
  }
  return result;
}

}  // namespace

geometry::PatchSet attached(geometry::PatchSet set, const std::vector<AttachmentInput>& attachments) {
  for (const AttachmentInput& input : attachments) {
    const auto faces = faces_of(set, input);
    try {
      set = geometry::attached(std::move(set), faces, input.map, input.name);
    } catch (const Error& error) {
      throw error_at(input.place, error.what(), error.code());
    }
  }
  return set;
}

}  // namespace isopatch::app
