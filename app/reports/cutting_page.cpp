#include "app/reports/cutting_page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "app/problem/internal/body_json.hpp"
#include "app/reports/block_pieces.hpp"
#include "app/reports/internal/block_page.hpp"
#include "geometry/brep/cell_solids.hpp"
#include "geometry/brep/require_solid.hpp"
#include "segmentation/decomposition/unfinished_parts.hpp"

namespace isopatch::app {
namespace {

using geometry::Brep;
using segmentation::CuttingError;
using segmentation::UnfinishedPart;

void add_piece(BlockStage& stage, BlockPiece piece, const std::vector<Eigen::Matrix3Xd>& lines) {
  for (const Eigen::Matrix3Xd& line : lines)
    stage.lines.push_back({static_cast<int>(stage.pieces.size()), line});
  stage.pieces.push_back(std::move(piece));
}

/// The parts of a body after the cuts, with T-joints.
void add_parts(const CutBody& body, BlockStage& stage) {
  const segmentation::Decomposition& cutting = *body.cutting;
  const std::vector<Brep> parts = geometry::cell_solids(body.solid.brep, cutting.parts);
  const segmentation::CellShapes shapes(body.solid.brep, cutting.parts);
  std::vector<std::vector<Eigen::Matrix3Xd>> lines(parts.size());
  for (const segmentation::PartedSide& side : cutting.t_joints)
    for (const EdgeId edge : side.inside)
      lines[static_cast<std::size_t>(side.cell.value)].push_back(segmentation::polyline(shapes, edge));
  for (std::size_t p = 0; p < parts.size(); ++p)
    add_piece(stage, piece_of(parts[p], fmt::format("part {} of {}", p, body.solid.name), body.solid.name),
              lines[p]);
}

void add_unfinished(const CuttingError& error, const std::string& body, BlockStage& stage) {
  for (std::size_t p = 0; p < error.parts().size(); ++p) {
    const UnfinishedPart& part = error.parts()[p];
    BlockPiece piece = piece_of(part.solid, fmt::format("part {} of {}", p, body), body);
    piece.is_faulty = !part.finished;
    add_piece(stage, std::move(piece), part.lines);
  }
}

/// A body that was given up; whole if no cut was tried on it.
void add_unfinished(const CutBody& body, BlockStage& stage) {
  if (!body.failure->parts().empty()) {
    add_unfinished(*body.failure, body.solid.name, stage);
    return;
  }
  BlockPiece piece = piece_of(body.solid.brep, body.solid.name, body.solid.name);
  piece.is_faulty = true;
  std::vector<Eigen::Matrix3Xd> lines;
  for (const auto& edge : body.failure->fault().edges) lines.push_back(edge.points);
  add_piece(stage, std::move(piece), lines);
}

/// The faces and places that an error names.
void mark_faults(const CutBody& body, BlockScene& scene) {
  const geometry::SolidFault& fault = body.failure->fault();
  if (const auto mesh = fault.faces.empty() ? std::nullopt : triangulated(body.solid.brep))
    for (const geometry::SolidFault::Face& face : fault.faces) {
      const geometry::FaceTriangles& drawn = mesh->faces[static_cast<std::size_t>(face.number)];
      scene.faces.push_back({fmt::format("{}: face {}", body.solid.name, face.number), face.remark, true,
                             drawn.points, drawn.triangles});
    }
  for (const auto& point : fault.points) scene.places.push_back({point.name, point.point});
}

Json body_with_volumes(const CutBody& body) {
  double volume = 0;
  for (const geometry::BrepFile& block : body.blocks) volume += block.brep.volume();
  Json json = body_json(body);
  json["volume"] = std::abs(body.solid.brep.volume());
  json["block_volume"] = volume;
  return json;
}

}  // namespace

std::string block_file_name(std::size_t block) {
  return fmt::format("block_{}.step", block);
}

std::string cutting_html(const CutSolids& solids, const std::string& title,
                         const std::vector<std::string>& t_joints) {
  BlockScene scene;
  BlockStage parts{"parts after the cuts", {}, {}}, blocks{"blocks", {}, {}};
  Json bodies = Json::array();
  std::size_t file = 0;
  double size = 0;
  bool cut = false, failed = false, kept = false;
  for (const CutBody& body : solids.bodies) {
    bodies.push_back(body_with_volumes(body));
    size = std::max(size, body.solid.brep.size());
    if (body.failure) {
      failed = true;
      for (BlockStage* stage : {&parts, &blocks}) add_unfinished(body, *stage);
      mark_faults(body, scene);
      continue;
    }
    const bool known = body.cutting && !body.cutting->report.seen_as.empty();
    if (body.cutting && !known) {
      add_parts(body, parts);
      cut = true;
      kept |= body.cutting->report.t_joints_kept;
    }
    for (const geometry::BrepFile& block : body.blocks) {
      BlockPiece piece = piece_of(block.brep, block.name, body.solid.name);
      if (!body.cutting || known) parts.pieces.push_back(piece);
      piece.file = block_file_name(file++);
      blocks.pieces.push_back(std::move(piece));
    }
  }
  scene.lines_name = failed ? "T-joints, edges in the way"
                     : kept ? "T-joints, kept"
                            : "T-joints before removal";
  if (cut) scene.stages.push_back(std::move(parts));
  scene.stages.push_back(std::move(blocks));
  return block_page_html("blocks", std::move(scene), size, {{"bodies", bodies}, {"t_joints", t_joints}},
                         title, "");
}

std::string cutting_fault_html(const CuttingError& error, const std::string& title, const std::string& study,
                               std::vector<BlockStage> before) {
  BlockScene scene;
  scene.stages = std::move(before);
  scene.lines_name = "in the way";
  BlockStage stage{"parts", {}, {}};
  double volume = 0, size = 0;
  for (const UnfinishedPart& part : error.parts()) {
    volume += part.solid.volume();
    size = std::max(size, part.solid.size());
  }
  add_unfinished(error, "the solid", stage);
  scene.stages.push_back(std::move(stage));
  const Json body = {{"name", "solid"}, {"volume", volume}, {"error", error.what()}};
  return block_page_html("blocks", std::move(scene), size, {{"bodies", Json::array({body})}}, title, study);
}

}  // namespace isopatch::app
