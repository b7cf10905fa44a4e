#pragma once

#include <filesystem>
#include <variant>
#include <vector>

#include "app/study/attachment_input.hpp"
#include "app/study/blocks_input.hpp"
#include "app/study/config_value.hpp"
#include "app/study/generated_input.hpp"
#include "geometry/base/tolerance.hpp"

namespace isopatch::app {

/// A file of patches: G+Smo XML, GoTools .g2 or MFEM NURBS mesh.
struct PatchFile {
  std::filesystem::path path;  ///< resolved against the study's folder
  double length_unit = 1;      ///< m per model unit; above 0
  bool operator==(const PatchFile&) const = default;
};

/// Where the patches come from. What more there may be, as a mesh, is one more alternative.
using ModelSource = std::variant<PatchFile, BlocksInput, GeneratedInput>;

struct ModelInput {
  ModelSource source;
  std::vector<AttachmentInput> attachments = {};
  Tolerance tolerance = {};
  Place place = {};
  bool operator==(const ModelInput&) const = default;
};

}  // namespace isopatch::app
