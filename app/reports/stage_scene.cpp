#include "app/reports/stage_scene.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "app/base/engineering_units.hpp"
#include "app/problem/block_file.hpp"
#include "app/problem/patch_file.hpp"
#include "app/problem/solid_file.hpp"
#include "app/reports/block_pieces.hpp"
#include "app/reports/internal/block_page.hpp"
#include "app/results/internal/stages_json.hpp"
#include "geometry/base/atomic_file.hpp"
#include "geometry/base/content_hash.hpp"
#include "geometry/mesh/mend.hpp"
#include "geometry/mesh/weld.hpp"
#include "segmentation/reconstruction/reconstruction.hpp"

namespace isopatch::app {
namespace {

std::vector<std::string> face_names(const std::vector<geometry::BrepFile>& solids, const std::string& name) {
  std::vector<std::string> names;
  for (const geometry::BrepFile& solid : solids)
    if (solid.name == name)
      for (const geometry::BrepFace& face : solid.brep.faces()) names.push_back(face.name);
  return names;
}

void add_solid_stages(const FoundSolids& found, BlockScene& scene) {
  BlockStage triangles{.name = "triangles", .apart = 0, .shows_triangles = true};
  for (const SolidTriangles& made : found.triangles)
    if (made.mesh.triangles.cols() <= most_drawn_triangles)
      for (BlockPiece& piece : region_pieces(made, face_names(found.read.solids, made.solid)))
        triangles.pieces.push_back(std::move(piece));
  BlockStage solid{.name = found.read.solids.size() == 1 ? "solid" : "solids", .apart = 0};
  for (const geometry::BrepFile& body : found.read.solids)
    for (BlockPiece& piece : face_pieces(body.brep, body.name)) solid.pieces.push_back(std::move(piece));
  for (BlockStage* stage : {&triangles, &solid})
    if (!stage->pieces.empty()) scene.stages.push_back(std::move(*stage));
}

void add_block_stage(const segmentation::ReadBlocks& blocks, BlockScene& scene) {
  BlockStage stage{.name = "hexahedra"};
  for (std::size_t b = 0; b < blocks.model.solids.size(); ++b)
    stage.pieces.push_back(
        piece_of(blocks.model.solids[b].brep, blocks.model.solids[b].name, blocks.model.bodies[b]));
  scene.stages.push_back(std::move(stage));
}

void add_patch_stage(const segmentation::Parameterization& made, BlockScene& scene) {
  BlockStage stage{.name = "patches"};
  for (std::size_t p = 0; p < made.patches.patches.size(); ++p) {
    stage.pieces.push_back(patch_piece(made.patches.patches[p], made.report.patches[p].name));
    stage.pieces.back().volume = made.report.patches[p].volume;
  }
  scene.stages.push_back(std::move(stage));
}

bool is_as_it_was(const StageReport& stage) {
  try {
    return !stage.file.empty() && content_hash(read_file(stage.file)) == stage.content;
  } catch (const Error&) {
    return false;
  }
}

/// Diagonal of the box of all that is drawn, m.
double size_of(const BlockScene& scene) {
  Eigen::AlignedBox3d box;
  for (const BlockStage& stage : scene.stages)
    for (const BlockPiece& piece : stage.pieces)
      for (const auto& point : piece.points.colwise()) box.extend(Eigen::Vector3d(point));
  return box.isEmpty() ? 1 : box.diagonal().norm();
}

std::string page_of(BlockScene scene, const Json& summary, const std::string& title,
                    const std::string& study) {
  const double size = size_of(scene);
  return block_page_html("stages", std::move(scene), size, summary, title, study);
}

/// Edges of one triangle or of more than two.
std::vector<Eigen::Matrix3Xd> loose_edges(const geometry::TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> uses;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t)
    for (int c = 0; c < 3; ++c)
      ++uses[std::minmax(int{mesh.triangles(c, t)}, int{mesh.triangles((c + 1) % 3, t)})];
  std::vector<Eigen::Matrix3Xd> lines;
  for (const auto& [edge, count] : uses) {
    if (count == 2) continue;
    Eigen::Matrix3Xd line(3, 2);
    line << mesh.vertices.col(edge.first), mesh.vertices.col(edge.second);
    lines.push_back(std::move(line));
  }
  return lines;
}

/// All triangles as one piece, with the edges that keep them from bounding a solid.
BlockStage loose_stage(const geometry::TriangleMesh& read, const std::string& name) {
  const geometry::TriangleMesh mesh = geometry::weld(read, read.grain).mesh;
  BlockStage stage{.name = "triangles", .apart = 0, .shows_triangles = true};
  BlockPiece piece{.name = name, .body = name};
  piece.points = mesh.vertices;
  piece.triangles = mesh.triangles;
  piece.remark = fmt::format("{} triangles", with_separators(std::int64_t{mesh.triangles.cols()}));
  constexpr std::size_t most_lines = 2000;
  for (Eigen::Matrix3Xd& line : loose_edges(mesh))
    if (stage.lines.size() < most_lines) stage.lines.push_back({0, std::move(line)});
  stage.pieces.push_back(std::move(piece));
  return stage;
}

/// Triangles by the surfaces that were found; those without one are faulty.
BlockStage region_stage(const geometry::TriangleMesh& read, const BlocksInput& input,
                        const std::string& name) {
  const geometry::TriangleMesh mesh = geometry::mended(read, read.grain).mesh;
  const segmentation::Regions regions = segmentation::find_regions(mesh, input.reconstruction);
  std::vector<std::string> names;
  for (const segmentation::Region& region : regions.regions)
    names.push_back(region.carrier ? fmt::format("{} {}", geometry::name(region.carrier->kind), names.size())
                                   : fmt::format("no surface {}", names.size()));
  BlockStage stage{.name = "triangles", .apart = 0, .shows_triangles = true};
  stage.pieces = region_pieces({name, mesh, regions.of_triangle}, names);
  for (BlockPiece& piece : stage.pieces) piece.is_faulty = piece.name.starts_with("no surface");
  return stage;
}

}  // namespace

std::optional<BlockScene> stage_scene(const std::vector<StageReport>& stages) {
  BlockScene scene;
  scene.lines_name = "lines";
  for (const StageReport& stage : stages) {
    if (!is_as_it_was(stage)) continue;
    if (stage.stage == Stage::solid) add_solid_stages(read_solid_file(stage.file), scene);
    if (stage.stage == Stage::hexahedra) add_block_stage(read_block_file(stage.file), scene);
    if (stage.stage == Stage::patches) add_patch_stage(read_patch_file(stage.file), scene);
  }
  if (scene.stages.empty()) return std::nullopt;
  scene.length = model_length_unit(size_of(scene));
  return scene;
}

std::string stages_html(const std::vector<StageReport>& stages, const std::string& title,
                        const std::string& study) {
  return page_of(stage_scene(stages).value_or(BlockScene{}), {{"stages", stages_json(stages)}}, title, study);
}

std::optional<std::string> triangles_fault_html(const BlocksInput& input, const Error& error,
                                                const std::string& title, const std::string& study) {
  const std::filesystem::path& file = input.files.files.front();
  try {
    const geometry::TriangleMesh mesh = triangles_in_metres(file, input.files.length_unit);
    if (mesh.triangles.cols() > most_drawn_triangles) return std::nullopt;
    BlockScene scene;
    scene.lines_name = "edges of one triangle, or of more than two";
    try {
      scene.stages.push_back(region_stage(mesh, input, file.stem().string()));
    } catch (const Error&) {
      scene.stages.push_back(loose_stage(mesh, file.stem().string()));
    }
    return page_of(std::move(scene), {{"error", error.what()}, {"stages", Json::array()}}, title, study);
  } catch (const Error&) {
    return std::nullopt;
  }
}

}  // namespace isopatch::app
