#include "app/pages/block_scene.hpp"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "app/pages/internal/matrix_json.hpp"

namespace isopatch::app {
namespace {

Json piece_json(const BlockPiece& piece) {
  Json edges = Json::array();
  for (const Eigen::Matrix3Xd& edge : piece.edges) edges.push_back(points_text(edge));
  return {{"name", piece.name},
          {"body", piece.body},
          {"file", piece.file},
          {"volume", piece.volume},
          {"remark", piece.remark},
          {"is_faulty", piece.is_faulty},
          {"faces", piece.faces},
          {"points", points_text(piece.points)},
          {"triangles", triangles_json(piece.triangles)},
          {"edges", edges}};
}

Json stage_json(const BlockStage& stage) {
  Json pieces = Json::array(), lines = Json::array();
  for (const BlockPiece& piece : stage.pieces) pieces.push_back(piece_json(piece));
  for (const BlockLine& line : stage.lines)
    lines.push_back({{"piece", line.piece}, {"points", points_text(line.points)}});
  return {{"name", stage.name},
          {"pieces", pieces},
          {"lines", lines},
          {"apart", stage.apart},
          {"shows_triangles", stage.shows_triangles}};
}

}  // namespace

std::string block_scene_json(const BlockScene& scene) {
  Eigen::AlignedBox3d box;
  Json stages = Json::array(), faces = Json::array(), places = Json::array();
  for (const BlockStage& stage : scene.stages) {
    stages.push_back(stage_json(stage));
    for (const BlockPiece& piece : stage.pieces) {
      for (const auto& point : piece.points.colwise()) box.extend(Eigen::Vector3d(point));
      for (const Eigen::Matrix3Xd& edge : piece.edges)
        for (const auto& point : edge.colwise()) box.extend(Eigen::Vector3d(point));
    }
  }
  for (const FaultFace& face : scene.faces)
    faces.push_back({{"name", face.name},
                     {"remark", face.remark},
                     {"points", points_text(face.points)},
                     {"triangles", triangles_json(face.triangles)}});
  for (const FaultPlace& place : scene.places)
    places.push_back({{"name", place.name}, {"point", to_json(place.point)}});
  const Json json = {{"length", {{"unit", scene.length.unit}, {"factor", scene.length.factor}}},
                     {"box", {{"min", to_json(box.min())}, {"max", to_json(box.max())}}},
                     {"lines_name", scene.lines_name},
                     {"stages", stages},
                     {"faces", faces},
                     {"places", places}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace isopatch::app
