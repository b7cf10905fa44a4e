#include "app/pages/fault_scene.hpp"

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "app/pages/internal/base64.hpp"
#include "app/pages/internal/point_json.hpp"

namespace isopatch::app {
namespace {

std::string block(const Eigen::Matrix3Xd& points) {
  std::vector<float> numbers;
  for (Eigen::Index i = 0; i < points.size(); ++i) numbers.push_back(static_cast<float>(points.data()[i]));
  return to_base64(numbers);
}

Json indices(const Eigen::Matrix3Xi& triangles) {
  Json result = Json::array();
  for (Eigen::Index i = 0; i < triangles.size(); ++i) result.push_back(triangles.data()[i]);
  return result;
}

}  // namespace

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
                     {"points", block(face.points)},
                     {"triangles", indices(face.triangles)}});
  }
  for (const FaultLine& line : scene.lines) {
    widen(line.points);
    lines.push_back({{"name", line.name}, {"is_faulty", line.is_faulty}, {"points", block(line.points)}});
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
