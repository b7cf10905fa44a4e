#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string>
#include <vector>

#include "app/base/warning.hpp"
#include "geometry/base/progress.hpp"
#include "geometry/jacobian_certificate.hpp"
#include "geometry/measures.hpp"
#include "geometry/multi_patch.hpp"

namespace isopatch::app {

/// What a patch is like. Lengths in m.
struct PatchReport {
  std::array<int, 3> degree{};
  std::array<int, 3> control_points{};
  std::array<int, 3> elements{};
  bool rational = false;
  bool was_left_handed = false;
  double volume = 0;  ///< m^3
  geometry::Quality quality;
  geometry::JacobianCertificate certificate;
};

struct BoundaryFaceReport {
  geometry::PatchFace face;
  std::string label;       ///< "3:north", in the input's naming
  double area = 0;         ///< of what no other patch covers, m^2
  Eigen::Vector3d centre;  ///< point at the middle parameter, m
  Eigen::Vector3d normal;  ///< outward, there
};

/// Two faces that share a part and do not match there.
struct NonMatchingReport {
  std::string first, second;  ///< "3:north", in the input's naming
  double area = 0;            ///< of what they share, m^2
  double area_error = 0;      ///< estimated, of its integration, m^2
  double gap = 0;             ///< largest distance found between them, m
};

/// A model seen as a whole: what `isopatch info` shows.
struct ModelReport {
  std::vector<PatchReport> patches;
  std::vector<BoundaryFaceReport> boundary_faces;
  std::vector<NonMatchingReport> non_matching;
  std::vector<std::vector<PatchId>> bodies;
  Eigen::AlignedBox3d box;   ///< of the part, m
  double volume = 0;         ///< m^3
  double boundary_area = 0;  ///< of what no other patch covers, m^2
  double largest_gap = 0;    ///< between the two sides of an interface, m
  std::int64_t control_points = 0;
  std::int64_t elements = 0;
  /// Whether no patch is folded anywhere.
  bool certified() const;
};

/// Adds the pairs that do not match, and takes what they share off the areas of boundary faces.
void add_non_matching(const geometry::MultiPatch& model, ModelReport& report);

/// @param model  in m
/// @cost  the certificate's, a few ms per simple patch
ModelReport report(const geometry::MultiPatch& model, const Progress& progress = {});

/// "11 patches, 12 interfaces, 42 boundary faces, one body".
std::string contents_text(const geometry::MultiPatch& model, const ModelReport& report);

/// One warning for every patch whose certificate was not accepted, naming patch, parameter and place as the
/// input does.
std::vector<Warning> certificate_warnings(const geometry::MultiPatch& model, const ModelReport& report);

}  // namespace isopatch::app
