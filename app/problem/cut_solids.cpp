#include "app/problem/cut_solids.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "app/problem/reconstructed_solids.hpp"
#include "geometry/brep/recognise_carriers.hpp"
#include "geometry/brep/require_solid.hpp"
#include "segmentation/decomposition/blocks.hpp"
#include "segmentation/decomposition/prepare.hpp"
#include "segmentation/decomposition/prospect.hpp"
#include "segmentation/decomposition/without_blends.hpp"
#include "segmentation/decomposition/without_tips.hpp"

namespace isopatch::app {
namespace {

using segmentation::CuttingError;

std::string number_of(int number, const std::string& one, const std::string& several) {
  return fmt::format("{} {}", number, number == 1 ? one : several);
}

/// Without blends where that is asked for, and with flat drill tips.
CutBody changed_body(geometry::BrepFile solid, const segmentation::DecompositionOptions& options) {
  CutBody body{std::move(solid), {}};
  if (is_block(body.solid.brep)) return body;
  const segmentation::WithoutBlends removal = segmentation::without_blends(body.solid.brep, options);
  const segmentation::WithoutTips flattening = segmentation::without_tips(removal.brep);
  body.blends = text_of(removal);
  body.tips = text_of(flattening);
  body.solid.brep = flattening.brep;
  return body;
}

void cut(CutBody& body, const segmentation::DecompositionOptions& options, const Progress& progress) {
  if (is_block(body.solid.brep)) {
    body.blocks = {body.solid};
    return;
  }
  body.cutting = segmentation::decompose(body.solid.brep, body.solid.name, options, progress);
  body.blocks = segmentation::blocks(body.solid, *body.cutting);
}

CutBody cut_body(geometry::BrepFile solid, const segmentation::DecompositionOptions& options,
                 const Progress& progress) {
  CutBody body = changed_body(std::move(solid), options);
  cut(body, options, progress);
  return body;
}

/// With the reason where it cannot be cut.
CutBody try_to_cut_body(const geometry::BrepFile& solid, const segmentation::DecompositionOptions& options,
                        const Progress& progress) {
  CutBody body{solid, {}};
  try {
    body = changed_body(solid, options);
    cut(body, options, progress);
  } catch (const CuttingError& error) {
    body.failure = error;
  } catch (const geometry::SolidError& error) {
    body.failure = CuttingError(error.code(), error.what(), error.fault(), {});
  } catch (const Error& error) {
    if (error.code() == ErrorCode::internal) throw;
    body.failure = CuttingError(error.code(), error.what(), {}, {});
  }
  if (body.failure) body.cutting.reset();
  return body;
}

/// "face 1 and face 5", "face 1, face 2 and face 5".
std::string listed(const geometry::Brep& solid, const std::vector<FaceId>& faces) {
  std::string text;
  for (std::size_t i = 0; i < faces.size(); ++i)
    text += (i == 0 ? "" : i + 1 == faces.size() ? " and " : ", ") + describe(solid, faces[i]);
  return text;
}

bool is_triangle(const geometry::Brep& solid, FaceId face) {
  const auto& loops = solid.face(face).loops;
  return loops.size() == 1 && loops.front().size() == 3;
}

/// A warning for faces of the file that are no longer told apart; "" if there are none. Triangles are not
/// meant to be.
std::string made_one(const CutBody& body) {
  if (!body.cutting) return {};
  const geometry::Brep& solid = body.solid.brep;
  std::string text;
  for (const std::vector<FaceId>& group : segmentation::faces_made_one(solid, body.cutting->complex))
    if (!std::all_of(group.begin(), group.end(), [&](FaceId face) { return is_triangle(solid, face); }))
      text += (text.empty() ? "" : "; ") + listed(solid, group) +
              fmt::format(" are '{}'", describe(solid, group.front()));
  if (text.empty()) return {};
  return fmt::format(
      "solid '{}': neighbouring faces in one plane are one, all of which is held or loaded: {}. Different "
      "names or "
      "colours in the CAD program keep them apart",
      body.solid.name, text);
}

/// Says which body it is where there are several.
Progress of_body(const Progress& progress, std::size_t index, std::size_t count) {
  if (count < 2) return progress;
  return {[&progress, index, count](std::string_view phase, double share) {
    progress(fmt::format("body {} of {}: {}", index + 1, count, phase), share);
  }};
}

template <class Cut>
CutSolids each_cut(segmentation::ReadSolids read, const segmentation::DecompositionOptions& options,
                   const Progress& progress, Cut cut) {
  CutSolids result;
  result.warnings = std::move(read.warnings);
  for (std::size_t i = 0; i < read.solids.size(); ++i) {
    geometry::BrepFile& solid = read.solids[i];
    const geometry::RecognisedBrep found = geometry::recognise_carriers(solid.brep);
    solid.brep = found.brep;
    result.bodies.push_back(cut(solid, options, of_body(progress, i, read.solids.size())));
    result.bodies.back().recognised = found.text();
  }
  for (const CutBody& body : result.bodies)
    for (const std::string& change : {body.blends, body.tips})
      if (!change.empty()) result.warnings.push_back(fmt::format("solid '{}': {}", body.solid.name, change));
  for (const CutBody& body : result.bodies)
    if (std::string warning = made_one(body); !warning.empty()) result.warnings.push_back(std::move(warning));
  return result;
}

std::string report_text(const segmentation::DecompositionReport& report) {
  if (!report.seen_as.empty())
    return fmt::format(
        "{}; {}{} ({:.1f} s)", report.seen_as, number_of(report.hexahedra, "hexahedron", "hexahedra"),
        report.t_joints_kept ? ", which may meet in parts of sides (kept)" : "", report.seconds);
  std::string text =
      fmt::format("{} into {}, {} where sides meet in parts", number_of(report.cuts, "cut", "cuts"),
                  number_of(report.cells, "part", "parts"), number_of(report.t_joints, "place", "places"));
  if (report.t_joints_kept && report.t_joints > 0)
    text += " (kept)";
  else if (report.by_tetrahedra)
    text += "; every part divided into tetrahedra around a point, for want of a way with fewer hexahedra";
  else if (report.further_cuts > 0)
    text += fmt::format(", closed by {}", number_of(report.further_cuts, "further cut", "further cuts"));
  return text + fmt::format("; {} ({:.1f} s)", number_of(report.hexahedra, "hexahedron", "hexahedra"),
                            report.seconds);
}

}  // namespace

bool is_block(const geometry::Brep& solid) {
  return segmentation::is_hexahedron(solid) && segmentation::corners_open(solid);
}

std::vector<geometry::BrepFile> CutSolids::blocks() const {
  std::vector<geometry::BrepFile> result;
  for (const CutBody& body : bodies) result.insert(result.end(), body.blocks.begin(), body.blocks.end());
  return result;
}

std::vector<std::string> CutSolids::body_names() const {
  std::vector<std::string> result;
  for (const CutBody& body : bodies) result.insert(result.end(), body.blocks.size(), body.solid.name);
  return result;
}

CutSolids cut_solids(const BlocksInput& input, const Progress& progress) {
  return cut_solids(solids_of_files(input, progress).read, *input.decomposition, progress);
}

CutSolids cut_solids(segmentation::ReadSolids read, const segmentation::DecompositionOptions& options,
                     const Progress& progress) {
  return each_cut(std::move(read), options, progress, cut_body);
}

CutSolids try_to_cut_solids(const BlocksInput& input, const Progress& progress) {
  return each_cut(solids_of_files(input, progress).read, *input.decomposition, progress, try_to_cut_body);
}

segmentation::ReadBlocks put_together(const CutSolids& solids, const segmentation::AssemblyOptions& options) {
  std::vector<segmentation::ListedPair> pairs;
  std::vector<int> groups;
  for (const CutBody& body : solids.bodies) {
    const int first = static_cast<int>(groups.size());
    // Parts of one body are known to meet where they were cut apart, but for sides in parts of sides.
    const bool known = body.cutting && !body.cutting->report.t_joints_kept;
    groups.insert(groups.end(), body.blocks.size(), known ? first : -1);
    if (!known) continue;
    for (segmentation::ListedPair pair : segmentation::block_pairs(*body.cutting)) {
      pair.first_block += first;
      pair.second_block += first;
      pairs.push_back(pair);
    }
  }
  segmentation::ReadBlocks result{segmentation::hex_model(solids.blocks(), pairs, groups, options),
                                  solids.warnings};
  result.model.bodies = solids.body_names();
  return result;
}

std::string cutting_text(const CutSolids& solids) {
  std::string text;
  for (const CutBody& body : solids.bodies)
    text +=
        fmt::format("  {}: {}{}{}\n", body.solid.name, body.recognised, body.recognised.empty() ? "" : "; ",
                    body.cutting   ? report_text(body.cutting->report)
                    : body.failure ? "given up"
                                   : "a topological hexahedron as it is");
  return text;
}

}  // namespace isopatch::app
