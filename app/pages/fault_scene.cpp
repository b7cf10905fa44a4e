#include "app/pages/fault_scene.hpp"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "app/pages/internal/matrix_json.hpp"

namespace isopatch::app {
std::string fault_scene_json(const FaultScene& scene) {
  Eigen::AlignedBox3d box;
  const auto widen = [&](const Eigen::Matrix3Xd& points) {
    for (const auto& point : points.colwise()) box.extend(Eigen::Vector3d(point));
  };
  Json faces = Json::array(), lines = Json::array(), places = Json::array();
  for (const FaultFace& face : scene.faces) {
    widen(face.points);
    faces.push_back({{"name", face.name},
                     {"remark", face.remark},
                     {"is_faulty", face.is_faulty},
                     {"points", points_text(face.points)},
                     {"triangles", triangles_json(face.triangles)}});
  }
  for (const FaultLine& line : scene.lines) {
    widen(line.points);
    lines.push_back(
        {{"name", line.name}, {"is_faulty", line.is_faulty}, {"points", points_text(line.points)}});
  }
  for (const FaultPlace& place : scene.places) {
    widen(place.point);
    places.push_back({{"name", place.name}, {"point", to_json(place.point)}});
  }
  const Json json = {{"length", {{"unit", scene.length.unit}, {"factor", scene.length.factor}}},
                     {"box", {{"min", to_json(box.min())}, {"max", to_json(box.max())}}},
                     {"faces", faces},
                     {"lines", lines},
                     {"places", places}};
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

}  // namespace isopatch::app
