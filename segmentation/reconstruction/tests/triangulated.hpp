#pragma once

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "geometry/base/union_find.hpp"
#include "geometry/brep/brep.hpp"
#include "geometry/brep/recognise_carriers.hpp"
#include "geometry/io/read_stl.hpp"
#include "geometry/mesh/triangle_mesh.hpp"
#include "segmentation/reconstruction/internal/carrier_distance.hpp"
#include "segmentation/reconstruction/regions.hpp"

namespace isopatch::segmentation::test {

/// A solid as the triangles of an STL file, and the face that each belongs to.
struct Triangulated {
  geometry::TriangleMesh mesh;
  std::vector<int> face;
  int faces = 0;
};

/// Neighbouring faces on one carrier are one face: no program can tell them apart in a triangulation.
inline std::vector<int> faces_by_carrier(const geometry::Brep& brep) {
  UnionFind same(static_cast<int>(brep.faces().size()));
  const auto on_carrier = [&](FaceId face, const geometry::Carrier& carrier) {
    for (const auto& loop : brep.face(face).loops)
      for (const geometry::EdgeUse& use : loop)
        for (int i = 0; i <= 8; ++i) {
          const Eigen::Vector2d uv = brep.domain_point(face, use, i / 8.0);
          const CarrierDistance off = carrier_distance(carrier, brep.point(face, uv));
          if (!(std::abs(off.value) < 1e-6 * brep.size())) return false;
          if (!(std::abs(off.gradient.dot(brep.outward_normal(face, uv))) > 0.9999)) return false;
        }
    return true;
  };
  for (const geometry::BrepEdge& edge : brep.edges()) {
    if (edge.faces.size() != 2 || edge.faces[0] == edge.faces[1]) continue;
    const auto a = brep.carrier(edge.faces[0]), b = brep.carrier(edge.faces[1]);
    if (a && b && a->kind == b->kind && on_carrier(edge.faces[0], *b) && on_carrier(edge.faces[1], *a))
      same.unite(edge.faces[0].value, edge.faces[1].value);
  }
  std::vector<int> result;
  for (int f = 0; f < static_cast<int>(brep.faces().size()); ++f) result.push_back(same.find(f));
  return result;
}

inline Eigen::Matrix3d corners_of(const geometry::FaceTriangles& part, Eigen::Index triangle) {
  Eigen::Matrix3d result;
  for (int i = 0; i < 3; ++i) result.col(i) = part.points.col(part.triangles(i, triangle));
  return result;
}

/// @param chord, turn  as of geometry::TessellationOptions
inline Triangulated triangulated(const geometry::Brep& given, double chord, double degrees,
                                 bool rounded = true) {
  const geometry::Brep brep = geometry::recognise_carriers(given).brep;
  const geometry::Tessellation tessellation =
      geometry::tessellate(brep, {.chord = chord, .turn = Angle::degrees(degrees)});
  const std::vector<int> face = faces_by_carrier(brep);
  Triangulated result;
  Eigen::Index count = 0;
  for (const auto& part : tessellation.faces) count += part.triangles.cols();
  result.mesh.vertices.resize(3, 3 * count);
  result.mesh.triangles.resize(3, count);
  std::map<int, int> used;
  for (std::size_t f = 0; f < tessellation.faces.size(); ++f) {
    const auto& part = tessellation.faces[f];
    for (Eigen::Index t = 0; t < part.triangles.cols(); ++t) {
      const Eigen::Matrix3f corners = corners_of(part, t).cast<float>();
      if (rounded && (corners.col(0) == corners.col(1) || corners.col(1) == corners.col(2) ||
                      corners.col(2) == corners.col(0)))
        continue;
      const auto next = static_cast<Eigen::Index>(result.face.size());
      for (int i = 0; i < 3; ++i) {
        result.mesh.vertices.col(3 * next + i) = part.points.col(part.triangles(i, t));
        result.mesh.triangles(i, next) = static_cast<int>(3 * next) + i;
      }
      result.face.push_back(used.emplace(face[f], static_cast<int>(used.size())).first->second);
    }
  }
  const auto kept = static_cast<Eigen::Index>(result.face.size());
  result.mesh.vertices.conservativeResize(3, 3 * kept);
  result.mesh.triangles.conservativeResize(3, kept);
  result.faces = static_cast<int>(used.size());
  if (rounded) result.mesh = geometry::read_stl(geometry::to_stl(result.mesh), "made.stl");
  return result;
}

/// How many faces of the solid are regions: all but a hundredth of its area is in one region, which has as
/// little of others.
inline int faces_found(const Triangulated& truth, const geometry::TriangleMesh& mesh,
                       const Regions& regions) {
  std::map<std::pair<int, int>, double> shared;
  std::map<int, double> of_face, of_region;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const double area = geometry::area_vector(mesh, t).norm();
    const int face = truth.face[static_cast<std::size_t>(t)],
              region = regions.of_triangle[static_cast<std::size_t>(t)];
    shared[{face, region}] += area;
    of_face[face] += area;
    of_region[region] += area;
  }
  int found = 0;
  for (const auto& [pair, area] : shared)
    found += area > 0.99 * of_face[pair.first] && area > 0.99 * of_region[pair.second];
  return found;
}

/// Which faces were not found, and what they became; for people.
inline std::string missed(const geometry::Brep& given, const Triangulated& truth,
                          const geometry::TriangleMesh& mesh, const Regions& regions) {
  const geometry::Brep brep = geometry::recognise_carriers(given).brep;
  std::map<int, std::map<int, double>> parts;
  std::map<int, double> of_face;
  std::map<int, int> count;
  for (Eigen::Index t = 0; t < mesh.triangles.cols(); ++t) {
    const int face = truth.face[static_cast<std::size_t>(t)];
    parts[face][regions.of_triangle[static_cast<std::size_t>(t)]] += geometry::area_vector(mesh, t).norm();
    of_face[face] += geometry::area_vector(mesh, t).norm();
    ++count[face];
  }
  const std::vector<int> merged = faces_by_carrier(brep);
  std::map<int, int> used;
  std::map<int, std::string> kind;
  for (std::size_t f = 0; f < merged.size(); ++f) {
    const int n = used.emplace(merged[f], static_cast<int>(used.size())).first->second;
    kind[n] += std::string(geometry::name(brep.faces()[f].kind)) + " ";
    if (const auto c = brep.carrier(FaceId(static_cast<int>(f))))
      kind[n] += fmt::format("({:.4g} {:.4g} {:.4g}) ", c->radius, c->second_radius, c->half_angle.degrees());
  }
  std::string text;
  for (const auto& [face, pieces] : parts) {
    if (pieces.size() == 1 &&
        regions.regions[static_cast<std::size_t>(pieces.begin()->first)].area * 2 < 1.01 * of_face[face])
      continue;
    text += fmt::format("\n   face {}{} triangles:", kind[face], count[face]);
    for (const auto& [r, area] : pieces) {
      const Region& region = regions.regions[static_cast<std::size_t>(r)];
      text += fmt::format(" {}#{} {:.0f} % of {} t;",
                          region.carrier ? geometry::name(region.carrier->kind) : "freeform", r,
                          100 * area / of_face[face], region.triangles.size());
    }
  }
  return text;
}

}  // namespace isopatch::segmentation::test
