#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/problem/model_report.hpp"
#include "iga/problem/problem.hpp"

namespace isopatch::app {

/// Where a support or a load acts, so that its author can see what was caught: faces, or edges for supports
/// that hold these, or patches for the loads that act in them.
struct AppliedRegion {
  std::string name;                ///< for messages: "support 1 (left bore)"
  std::string kind;                ///< as the study's key says: "displacement", "pressure", "gravity", ...
  std::vector<std::string> faces;  ///< "0:back", in the input's naming
  double area = 0;                 ///< of these faces together, m^2
  std::vector<int> patches;
  double volume = 0;                                ///< of these patches together, m^3
  Eigen::Vector3d total = Eigen::Vector3d::Zero();  ///< force of a load, N
  std::vector<std::string> edges = {};              ///< "0:east+back", in the input's naming
  std::string key = {};                             ///< what results call it: "left bore", or "support 1"
  std::vector<std::string> given = {};              ///< names of its faces, as the study gives them
  int points = 0;                                   ///< places that a support holds or a load acts at
  double length = 0;     ///< of the lines that a support holds or a load acts along, m
  bool is_part = false;  ///< whether it is a part of its faces alone, whose area `area` is
};

AppliedRegion region_of(const std::string& name, std::string_view kind,
                        const std::vector<geometry::PatchFace>& faces, const ModelReport& report);
AppliedRegion region_of(const std::string& name, std::string_view kind, const std::vector<PatchId>& patches,
                        const ModelReport& report);

AppliedRegion region_of(const std::string& name, std::string_view kind,
                        const std::vector<iga::SupportedEdge>& edges, const geometry::MultiPatch& model);

/// "support 1 (left bore): displacement on bore_left (4 faces), 7.54 cm^2", or "on 4 faces" where the study
/// names none, or each by its patch and side.
std::string region_text(const AppliedRegion& region);

}  // namespace isopatch::app
