#include "geometry/io/mfem_topology.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "geometry/base/error.hpp"

namespace isopatch::geometry {
namespace {

// The faces of a patch in MFEM's order, their vertices counter-clockwise seen from outside.
struct LocalFace {
  Side side;
  std::array<int, 4> vertices;
};
constexpr std::array<LocalFace, 6> local_faces = {{{Side::front, {3, 2, 1, 0}},
                                                   {Side::south, {0, 1, 5, 4}},
                                                   {Side::east, {1, 2, 6, 5}},
                                                   {Side::north, {2, 3, 7, 6}},
                                                   {Side::west, {3, 0, 4, 7}},
                                                   {Side::back, {4, 5, 6, 7}}}};

std::array<int, 4> sorted(std::array<int, 4> vertices) {
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

void require_distinct(const std::array<int, 8>& patch, std::size_t index) {
  std::array<int, 8> vertices = patch;
  std::sort(vertices.begin(), vertices.end());
  if (std::adjacent_find(vertices.begin(), vertices.end()) != vertices.end())
    throw Error(ErrorCode::unsupported,
                fmt::format("patch {} has a vertex twice; split a patch that meets itself", index));
}

bool opposite_in(const std::array<int, 4>& cycle, int a, int b) {
  const auto at = std::find(cycle.begin(), cycle.end(), a) - cycle.begin();
  return cycle[static_cast<std::size_t>((at + 2) % 4)] == b;
}

// Vertices of a face where its parameters are (0, 0), (1, 0), (0, 1) and (1, 1).
std::array<int, 4> corners(const MfemTopology& topology, const PatchFace& face) {
  const auto t = tangents(face.side);
  std::array<int, 4> result{};
  for (int corner = 0; corner < 4; ++corner) {
    std::array<int, 3> ends{};
    ends[static_cast<std::size_t>(direction(face.side))] = is_high(face.side) ? 1 : 0;
    ends[static_cast<std::size_t>(t[0])] = corner & 1;
    ends[static_cast<std::size_t>(t[1])] = corner >> 1;
    result[static_cast<std::size_t>(corner)] =
        mfem_corner(topology.patches[static_cast<std::size_t>(face.patch.value)], ends);
  }
  return result;
}

std::map<std::pair<int, int>, MfemEdge> edges_by_ends(const MfemTopology& topology,
                                                      std::size_t knot_vectors) {
  std::map<std::pair<int, int>, MfemEdge> result;
  for (const MfemEdge& edge : topology.edges) {
    if (static_cast<std::size_t>(edge.knot_vector) >= knot_vectors)
      throw Error(ErrorCode::bad_format, fmt::format("edge {} {} has knot vector {}, but there are {}",
                                                     edge.from, edge.to, edge.knot_vector, knot_vectors));
    if (edge.from == edge.to || !result.emplace(std::minmax(edge.from, edge.to), edge).second)
      throw Error(ErrorCode::bad_format,
                  fmt::format("edge {} {} is listed twice or has no length", edge.from, edge.to));
  }
  return result;
}

}  // namespace

int mfem_corner(const std::array<int, 8>& patch, const std::array<int, 3>& ends) {
  constexpr std::array<std::size_t, 4> layer = {0, 1, 3, 2};  // counter-clockwise, by ends[0] + 2 ends[1]
  return patch[layer[static_cast<std::size_t>(ends[0] + 2 * ends[1])] +
               static_cast<std::size_t>(4 * ends[2])];
}

std::pair<int, int> mfem_edge_ends(const std::array<int, 8>& patch, int direction, int corner) {
  const auto t = tangents(side_of(direction, false));
  std::array<int, 3> ends{};
  ends[static_cast<std::size_t>(t[0])] = corner & 1;
  ends[static_cast<std::size_t>(t[1])] = corner >> 1;
  const int low = mfem_corner(patch, ends);
  ends[static_cast<std::size_t>(direction)] = 1;
  return {low, mfem_corner(patch, ends)};
}

std::vector<MfemFace> mfem_faces(const std::vector<std::array<int, 8>>& patches) {
  std::vector<MfemFace> faces;
  std::map<std::array<int, 4>, std::size_t> known;
  for (std::size_t p = 0; p < patches.size(); ++p) {
    require_distinct(patches[p], p);
    for (const LocalFace& local : local_faces) {
      std::array<int, 4> vertices{};
      for (std::size_t v = 0; v < 4; ++v)
        vertices[v] = patches[p][static_cast<std::size_t>(local.vertices[v])];
      const auto [entry, is_new] = known.emplace(sorted(vertices), faces.size());
      if (is_new) faces.push_back({vertices, {}});
      MfemFace& face = faces[entry->second];
      if (face.patches.size() == 2)
        throw Error(ErrorCode::bad_format,
                    fmt::format("patch {} has a face that two other patches share", p));
      if (!opposite_in(face.vertices, vertices[0], vertices[2]))
        throw Error(
            ErrorCode::bad_format,
            fmt::format("patch {} joins the vertices of a face in another order than its neighbour", p));
      face.patches.push_back({PatchId(static_cast<int>(p)), local.side});
    }
  }
  return faces;
}

std::vector<StatedInterface> mfem_interfaces(const MfemTopology& topology) {
  std::vector<StatedInterface> result;
  for (const MfemFace& face : topology.faces) {
    if (face.patches.size() != 2) continue;
    const auto orientation =
        orientation_between(corners(topology, face.patches[0]), corners(topology, face.patches[1]));
    // `mfem_faces` has seen that both run through the vertices in one cycle.
    result.push_back({face.patches[0], face.patches[1], orientation.value()});
  }
  return result;
}

std::vector<Boundary> mfem_boundaries(const MfemTopology& topology, const std::string& source) {
  std::map<std::array<int, 4>, const MfemFace*> faces;
  for (const MfemFace& face : topology.faces) faces.emplace(sorted(face.vertices), &face);
  std::map<int, Boundary> found;
  for (const MfemBoundaryElement& element : topology.boundary) {
    const auto face = faces.find(sorted(element.vertices));
    if (face == faces.end())
      throw Error(ErrorCode::bad_format,
                  fmt::format("{}:{}: this boundary element is no face of a patch", source, element.line));
    if (face->second->patches.size() == 2)
      throw Error(ErrorCode::unsupported,
                  fmt::format("{}:{}: this boundary element lies between two patches; remove it", source,
                              element.line));
    Boundary& boundary = found[element.attribute];
    boundary.name = fmt::format("attribute {}", element.attribute);
    boundary.faces.push_back(face->second->patches.front());
  }
  std::vector<Boundary> result;
  for (auto& [attribute, boundary] : found) result.push_back(std::move(boundary));
  return result;
}

std::vector<NurbsVolume::KnotVectors> mfem_spaces(const MfemTopology& topology,
                                                  const std::vector<KnotVector>& knots) {
  const std::map<std::pair<int, int>, MfemEdge> edges = edges_by_ends(topology, knots.size());
  std::vector<KnotVector> turned;
  for (const KnotVector& k : knots) turned.push_back(reversed(k));
  std::set<std::pair<int, int>> used;
  std::vector<NurbsVolume::KnotVectors> result(topology.patches.size());
  for (std::size_t p = 0; p < result.size(); ++p)
    for (int d = 0; d < 3; ++d)
      for (int corner = 0; corner < 4; ++corner) {
        const auto [low, high] = mfem_edge_ends(topology.patches[p], d, corner);
        const auto found = edges.find(std::minmax(low, high));
        if (found == edges.end())
          throw Error(ErrorCode::bad_format,
                      fmt::format("patch {} has edge {} {}, which is not listed", p, low, high));
        used.insert(found->first);
        const MfemEdge& edge = found->second;
        const KnotVector& space =
            (edge.from == low ? knots : turned)[static_cast<std::size_t>(edge.knot_vector)];
        KnotVector& chosen = result[p][static_cast<std::size_t>(d)];
        if (corner == 0) chosen = space;
        if (!same_space(chosen, space, 1e-9))
          throw Error(ErrorCode::bad_format,
                      fmt::format("patch {}, direction {}: its edges have different knot vectors", p, d));
      }
  if (used.size() != edges.size()) throw Error(ErrorCode::bad_format, "an edge belongs to no patch");
  return result;
}

std::vector<MfemDividedFace> mfem_divided_faces(const std::vector<MfemHangingVertex>& hanging,
                                                const MfemTopology& topology,
                                                const std::vector<KnotVector>& knots) {
  if (hanging.empty()) return {};
  const std::map<std::pair<int, int>, MfemEdge> edges = edges_by_ends(topology, knots.size());
  const auto elements = [&](int from, int to) {
    const auto edge = edges.find(std::minmax(from, to));
    if (edge == edges.end())
      throw Error(ErrorCode::bad_format,
                  fmt::format("the edge {} {} of a divided face is not listed", from, to));
    return knots[static_cast<std::size_t>(edge->second.knot_vector)].element_count();
  };
  std::map<std::array<int, 4>, std::map<std::array<int, 2>, int>> by_face;
  for (const MfemHangingVertex& vertex : hanging) {
    for (const int v : {vertex.vertex, vertex.face[0], vertex.face[1], vertex.face[2], vertex.face[3]})
      if (v >= topology.vertex_count)
        throw Error(ErrorCode::bad_format,
                    fmt::format("{} vertices, but vertex {} is named", topology.vertex_count, v));
    if (!by_face[vertex.face].emplace(vertex.element, vertex.vertex).second)
      throw Error(ErrorCode::bad_format, fmt::format("vertex {} lies where another one does", vertex.vertex));
  }
  std::vector<MfemDividedFace> result;
  for (auto& [corners, places] : by_face) {
    MfemDividedFace face{corners, {}, {}};
    const int m = elements(corners[0], corners[1]), n = elements(corners[1], corners[2]);
    std::array<std::set<int>, 2> lines = {{{0, m}, {0, n}}};
    for (const auto& [place, vertex] : places) {
      if (place[0] > m || place[1] > n)
        throw Error(ErrorCode::bad_format, fmt::format("vertex {} lies behind the last knot span", vertex));
      for (const std::size_t d : {0U, 1U}) lines[d].insert(place[d]);
    }
    for (const std::size_t d : {0U, 1U}) face.lines[d].assign(lines[d].begin(), lines[d].end());
    places[{0, 0}] = corners[0];
    places[{m, 0}] = corners[1];
    places[{m, n}] = corners[2];
    places[{0, n}] = corners[3];
    for (const int j : face.lines[1])
      for (const int i : face.lines[0]) {
        const auto place = places.find({i, j});
        if (place == places.end())
          throw Error(ErrorCode::unsupported,
                      fmt::format("the face {} {} {} {} is divided by vertices that are no grid: none is at "
                                  "knot spans {} and {}",
                                  corners[0], corners[1], corners[2], corners[3], i, j));
        face.vertices.push_back(place->second);
      }
    result.push_back(std::move(face));
  }
  return result;
}

}  // namespace isopatch::geometry
