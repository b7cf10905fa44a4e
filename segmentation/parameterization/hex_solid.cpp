#include "segmentation/parameterization/hex_solid.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "geometry/brep/solid_error.hpp"
#include "segmentation/parameterization/outline.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::SolidError;
using geometry::SolidFault;
using VertexPair = std::pair<int, int>;

VertexPair ordered(int a, int b) {
  return {std::min(a, b), std::max(a, b)};
}

std::string of(const HexSolid& solid, const SolidFace& face) {
  return fmt::format("solid '{}', {}", solid.name, face_in_words(face.name));
}

std::string place(const Eigen::Vector3d& p) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g})", p[0], p[1], p[2]);
}

double size_of(const HexSolid& solid) {
  Eigen::AlignedBox3d box;
  for (const auto& vertex : solid.vertices) box.extend(vertex);
  return box.diagonal().norm();
}

/// The faces at every edge.
using EdgeFaces = std::map<VertexPair, std::vector<std::size_t>>;

EdgeFaces edge_faces(const HexSolid& solid) {
  EdgeFaces result;
  for (std::size_t f = 0; f < solid.faces.size(); ++f) {
    const auto& corners = solid.faces[f].corners;
    for (std::size_t k = 0; k < corners.size(); ++k)
      result[ordered(corners[k], corners[(k + 1) % corners.size()])].push_back(f);
  }
  return result;
}

int number_of(const HexSolid& solid, const SolidFace& face) {
  return static_cast<int>(&face - solid.faces.data());
}

SolidFault face_fault(const HexSolid& solid, const SolidFace& face, const std::string& remark,
                      const std::vector<int>& vertices) {
  SolidFault fault;
  fault.faces.push_back({number_of(solid, face), solid.name, remark});
  for (const int v : std::set<int>(vertices.begin(), vertices.end()))
    if (v >= 0 && static_cast<std::size_t>(v) < solid.vertices.size())
      fault.points.push_back({fmt::format("vertex {}", v), solid.vertices[static_cast<std::size_t>(v)]});
  return fault;
}

/// An edge and its faces.
SolidFault edge_fault(const HexSolid& solid, const VertexPair& edge, const std::vector<std::size_t>& faces) {
  SolidFault fault;
  for (const std::size_t f : faces) fault.faces.push_back({static_cast<int>(f), solid.name});
  const SolidFace& face = solid.faces[faces.front()];
  for (std::size_t k = 0; k < face.corners.size(); ++k) {
    if (ordered(face.corners[k], face.corners[(k + 1) % face.corners.size()]) != edge) continue;
    constexpr int pieces = 24;
    Eigen::Matrix3Xd points(3, pieces + 1);
    for (int i = 0; i <= pieces; ++i) points.col(i) = face.surface(face.curves[k](double(i) / pieces));
    fault.edges.push_back({fmt::format("edge between vertices {} and {}", edge.first, edge.second), points});
    break;
  }
  return fault;
}

/// What to do about a face with too few corners or too many.
std::string advice_for_corners(std::size_t count) {
  if (count > 4) return "Cut the solid through the face, or remove a vertex that only divides an edge";
  if (count == 3)
    return "Cut the solid from the face's middle to its three edges: that makes three faces with four edges";
  return "Cut the solid so that each piece has four edges there; a round face through its middle, twice";
}

SolidError wrong_corner_count(const HexSolid& solid, const SolidFace& face) {
  const std::size_t count = face.corners.size();
  return {ErrorCode::unsupported,
          fmt::format("{} has {} corner{} (vert{} {}); each face of a hexahedron has four. {}",
                      of(solid, face), count, count == 1 ? "" : "s", count == 1 ? "ex" : "ices",
                      fmt::join(face.corners, ", "), advice_for_corners(count)),
          face_fault(solid, face, fmt::format("{} corners", count), face.corners)};
}

void check_faces(const HexSolid& solid) {
  for (const SolidFace& face : solid.faces) {
    if (face.corners.size() != 4) throw wrong_corner_count(solid, face);
    if (face.curves.size() != 4 || !face.surface)
      throw Error(ErrorCode::invalid_argument, of(solid, face) + " lacks a curve or its surface");
    for (const int corner : face.corners)
      if (corner < 0 || static_cast<std::size_t>(corner) >= solid.vertices.size())
        throw Error(ErrorCode::invalid_argument,
                    fmt::format("{} names vertex {}, which does not exist", of(solid, face), corner));
    if (std::set<int>(face.corners.begin(), face.corners.end()).size() != 4)
      throw SolidError(
          ErrorCode::unsupported,
          fmt::format("{} comes back to a vertex on its way around: {}. Each face of a hexahedron has four "
                      "different corners; cut the solid through that vertex",
                      of(solid, face), fmt::join(face.corners, ", ")),
          face_fault(solid, face, "visits a vertex twice", face.corners));
  }
}

void check_shell(const HexSolid& solid, const EdgeFaces& edges) {
  for (const auto& [edge, faces] : edges) {
    if (faces.size() == 2) continue;
    std::vector<std::string> names;
    for (const std::size_t f : faces) names.push_back(face_in_words(solid.faces[f].name));
    const std::string where =
        fmt::format("solid '{}', edge between vertices {} {} and {} {}: ", solid.name, edge.first,
                    place(solid.vertices[static_cast<std::size_t>(edge.first)]), edge.second,
                    place(solid.vertices[static_cast<std::size_t>(edge.second)]));
    throw SolidError(
        ErrorCode::not_conforming,
        where + (faces.size() == 1 ? fmt::format("the shell is open, only {} ends here", names[0])
                                   : fmt::format("{} faces meet here ({}); an edge has two", faces.size(),
                                                 fmt::join(names, ", "))),
        edge_fault(solid, edge, faces));
  }
}

void check_geometry(const HexSolid& solid) {
  const double size = size_of(solid);
  for (const SolidFace& face : solid.faces) {
    for (std::size_t k = 0; k < 4; ++k) {
      const int from = face.corners[k];
      const int to = face.corners[(k + 1) % 4];
      double length = 0;
      Eigen::Vector3d last = face.surface(face.curves[k](0));
      for (int i = 1; i <= 16; ++i) {
        const Eigen::Vector3d next = face.surface(face.curves[k](i / 16.0));
        length += (next - last).norm();
        last = next;
      }
      if (!(length > 1e-9 * size))
        throw SolidError(
            ErrorCode::invalid_argument,
            fmt::format("{}: the edge between vertices {} and {} at {} has no length; merge the two",
                        of(solid, face), from, to, place(last)),
            face_fault(solid, face, "an edge without length", {from, to}));
    }
    const std::optional<Eigen::Vector2d> crossing = self_intersection(face.curves);
    if (crossing) {
      SolidFault fault = face_fault(solid, face, "outline crosses itself", {});
      fault.points.push_back({"crossing", face.surface(*crossing)});
      throw SolidError(ErrorCode::invalid_argument,
                       fmt::format("{}: its outline crosses itself at {}", of(solid, face),
                                   place(face.surface(*crossing))),
                       std::move(fault));
    }
  }
}

std::string not_a_cube(const HexSolid& solid, const EdgeFaces& edges, const std::string& why) {
  std::set<int> used;
  for (const auto& entry : edges) used.insert({entry.first.first, entry.first.second});
  return fmt::format(
      "solid '{}' is no topological hexahedron: {}. It has {} vertices, {} edges and {} faces; a cube has 8, "
      "12 and "
      "6, connected as a cube's",
      solid.name, why, used.size(), edges.size(), solid.faces.size());
}

/// The vertex at each corner of the cube: grown from vertex 0 and its three neighbours.
std::array<int, 8> label_corners(const HexSolid& solid, const EdgeFaces& edges) {
  const auto fail = [&](const std::string& why, SolidFault fault = {}) {
    return SolidError(ErrorCode::unsupported, not_a_cube(solid, edges, why), std::move(fault));
  };
  std::map<int, std::set<int>> neighbours;
  for (const auto& entry : edges) {
    neighbours[entry.first.first].insert(entry.first.second);
    neighbours[entry.first.second].insert(entry.first.first);
  }
  if (neighbours.size() != 8 || edges.size() != 12 || solid.faces.size() != 6) throw fail("wrong counts");
  for (const auto& [vertex, near] : neighbours)
    if (near.size() != 3)
      throw fail(
          fmt::format("{} edges meet at vertex {}", near.size(), vertex),
          {.points = {{fmt::format("vertex {}", vertex), solid.vertices[static_cast<std::size_t>(vertex)]}}});
  const int origin = neighbours.begin()->first;
  const std::vector<int> axes(neighbours[origin].begin(), neighbours[origin].end());
  // The fourth corner of the face through the origin and two of its neighbours.
  const auto across = [&](int a, int b) {
    for (const SolidFace& face : solid.faces) {
      const std::set<int> in(face.corners.begin(), face.corners.end());
      if (!in.contains(origin) || !in.contains(a) || !in.contains(b)) continue;
      for (const int corner : face.corners)
        if (corner != origin && corner != a && corner != b) return corner;
    }
    throw fail(fmt::format("no face has the vertices {}, {} and {}", a, origin, b));
  };
  std::array<int, 8> at{origin, axes[0], axes[1], across(axes[0], axes[1]), axes[2], 0, 0, -1};
  at[5] = across(axes[0], axes[2]);
  at[6] = across(axes[1], axes[2]);
  const std::set<int> seven(at.begin(), at.end() - 1);
  for (const auto& entry : neighbours)
    if (!seven.contains(entry.first)) at[7] = entry.first;
  if (seven.size() != 7) throw fail("its faces share vertices that a cube's do not");
  return at;
}

template <class Curve>
Curve turned_curve(const Curve& curve) {
  return [curve](double t) { return curve(1 - t); };
}

DomainCurve turned_around(const DomainCurve& curve) {
  return turned_curve(curve);
}

SolidEdge turned_around(const SolidEdge& edge) {
  SolidEdge result;
  if (edge.curve) result.curve = turned_curve(edge.curve);
  if (edge.knots) result.knots = reversed(*edge.knots);
  return result;
}

/// The face whose corners are those of a side, turned into the side's frame.
QuadFace face_on(const HexSolid& solid, const EdgeFaces& edges, const std::array<int, 8>& at, Side side) {
  const auto vertex = [&](int s, int t) { return at[static_cast<std::size_t>(side_corner(side, s, t))]; };
  const std::set<int> wanted{vertex(0, 0), vertex(1, 0), vertex(0, 1), vertex(1, 1)};
  for (std::size_t f = 0; f < solid.faces.size(); ++f) {
    const SolidFace& face = solid.faces[f];
    if (std::set<int>(face.corners.begin(), face.corners.end()) != wanted) continue;
    QuadFace quad{face.name,   static_cast<int>(f), {}, face.surface, face.colour, {},
                  face.spline, face.is_affine};
    const auto put_side = [&](std::size_t side_number, int from, int to) {
      for (std::size_t k = 0; k < 4; ++k) {
        const std::pair walked{face.corners[k], face.corners[(k + 1) % 4]};
        if (walked != std::pair{from, to} && walked != std::pair{to, from}) continue;
        const bool turned = walked.first == to;
        quad.sides[side_number] = turned ? turned_around(face.curves[k]) : face.curves[k];
        if (!face.edges.empty())
          quad.edges[side_number] = turned ? turned_around(face.edges[k]) : face.edges[k];
        return;
      }
      throw Error(ErrorCode::unsupported, not_a_cube(solid, edges,
                                                     fmt::format("{} has no edge between vertices {} and {}",
                                                                 face_in_words(face.name), from, to)));
    };
    put_side(0, vertex(0, 0), vertex(1, 0));
    put_side(1, vertex(0, 1), vertex(1, 1));
    put_side(2, vertex(0, 0), vertex(0, 1));
    put_side(3, vertex(1, 0), vertex(1, 1));
    return quad;
  }
  throw Error(ErrorCode::unsupported,
              not_a_cube(solid, edges, fmt::format("no face has the vertices {}", fmt::join(wanted, " "))));
}

Hexahedron assembled(const HexSolid& solid, const EdgeFaces& edges, const std::array<int, 8>& at) {
  Hexahedron result;
  result.name = solid.name;
  result.edge_uncertainty = solid.edge_uncertainty;
  for (std::size_t c = 0; c < 8; ++c) result.corners[c] = solid.vertices[static_cast<std::size_t>(at[c])];
  for (const Side side : geometry::all_sides)
    result.faces[static_cast<std::size_t>(side)] = face_on(solid, edges, at, side);
  return result;
}

/// Whether s, t and the outward normal of a side are right-handed on a right-handed cube.
bool faces_outward(Side side) {
  return geometry::is_high(side) != (geometry::direction(side) == 1);
}

/// Volume inside the faces' grids of n x n cells, by the divergence theorem.
double grid_volume(const Hexahedron& block, int n) {
  double sum = 0;
  for (const Side side : geometry::all_sides) {
    const QuadFace& face = block.face(side);
    Eigen::Matrix3Xd points(3, (n + 1) * (n + 1));
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i <= n; ++i)
        points.col(i + (n + 1) * j) =
            face.surface(coons_point(face.sides, double(i) / n, double(j) / n)) - block.corners[0];
    const double sign = faces_outward(side) ? 1 : -1;
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) {
        const int at = i + (n + 1) * j;
        const Eigen::Vector3d a = points.col(at), b = points.col(at + 1), c = points.col(at + n + 2),
                              d = points.col(at + n + 1);
        sum += sign * (a.dot(b.cross(c)) + a.dot(c.cross(d))) / 6;
      }
  }
  return sum;
}

/// The volume, well enough to tell its sign: grids are halved until two agree to a tenth.
double volume_of(const HexSolid& solid, const Hexahedron& block) {
  constexpr int coarsest = 12, finest = 384;
  double before = grid_volume(block, coarsest);
  for (int n = 2 * coarsest; n <= finest; n *= 2) {
    const double now = grid_volume(block, n);
    if (std::abs(now - before) <= 0.1 * std::abs(now)) return now;
    before = now;
  }
  const double size = size_of(solid);
  if (std::abs(before) <= 1e-9 * size * size * size) return 0;
  throw Error(
      ErrorCode::invalid_argument,
      fmt::format("solid '{}': inside and outside cannot be told apart, its faces wind too much for a "
                  "grid of {} x {} points each; cut it into shorter pieces",
                  solid.name, finest, finest));
}

/// How many of the loops run around the cube's sides as those of a right-handed cube, less the others.
int right_handed_loops(const HexSolid& solid, const Hexahedron& block, const std::array<int, 8>& at) {
  int sum = 0;
  for (const Side side : geometry::all_sides) {
    const auto& loop = solid.faces[static_cast<std::size_t>(block.face(side).number)].corners;
    const auto vertex = [&](int s, int t) { return at[static_cast<std::size_t>(side_corner(side, s, t))]; };
    const auto start =
        static_cast<std::size_t>(std::find(loop.begin(), loop.end(), vertex(0, 0)) - loop.begin());
    const bool runs_along_first = loop[(start + 1) % 4] == vertex(1, 0);
    sum += runs_along_first == faces_outward(side) ? 1 : -1;
  }
  return sum;
}

bool is_right_handed(const HexSolid& solid, const Hexahedron& block, const std::array<int, 8>& at) {
  const double size = size_of(solid);
  const auto has_volume = [&](double volume) { return std::abs(volume) > 1e-12 * size * size * size; };
  const auto refuse = [&] {
    throw Error(ErrorCode::invalid_argument, fmt::format("solid '{}' has no volume", solid.name));
  };
  const int loops = solid.has_outward_loops ? right_handed_loops(solid, block, at) : 0;
  if (std::abs(loops) == 6) {
    // Of faces that wind, a coarse grid may by chance enclose nothing.
    if (!has_volume(grid_volume(block, 12)) && !has_volume(volume_of(solid, block))) refuse();
    return loops > 0;
  }
  const double volume = volume_of(solid, block);
  if (!has_volume(volume)) refuse();
  return volume > 0;
}

}  // namespace

std::string face_in_words(const std::string& name) {
  const std::string prefix = "face ";
  const bool numbered = name.starts_with(prefix) && name.size() > prefix.size() &&
                        name.find_first_not_of("0123456789", prefix.size()) == std::string::npos;
  return numbered ? name : "face '" + name + "'";
}

Hexahedron hexahedron(const HexSolid& solid) {
  check_faces(solid);
  const EdgeFaces edges = edge_faces(solid);
  check_shell(solid, edges);
  std::array<int, 8> at = label_corners(solid, edges);
  check_geometry(solid);
  const Hexahedron first = assembled(solid, edges, at);
  if (is_right_handed(solid, first, at)) return first;
  std::swap(at[1], at[2]);
  std::swap(at[5], at[6]);
  return assembled(solid, edges, at);
}

}  // namespace isopatch::segmentation
