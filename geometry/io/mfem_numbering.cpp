#include "geometry/io/mfem_numbering.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "geometry/base/error.hpp"

namespace isopatch::geometry {
namespace {

std::array<int, 4> ascending(std::array<int, 4> vertices) {
  std::sort(vertices.begin(), vertices.end());
  return vertices;
}

[[noreturn]] void refuse(const char* what, const std::array<int, 4>& corners) {
  throw Error(ErrorCode::unsupported, fmt::format("the face {} {} {} {} is divided by faces {}", corners[0],
                                                  corners[1], corners[2], corners[3], what));
}

}  // namespace

MfemNumbering::MfemNumbering(const MfemTopology& topology, std::vector<std::array<int, 3>> sizes,
                             const std::vector<int>& edges)
    : topology_(topology), sizes_(std::move(sizes)), size_(topology.vertex_count) {
  for (const MfemDividedFace& divided : topology.divided)
    divided_faces_[ascending(divided.corners)] = &divided;
  find_divided_edges();
  for (std::size_t e = 0; e < edges.size(); ++e) {
    const auto ends = std::minmax(topology.edges[e].from, topology.edges[e].to);
    if (divided_.contains(ends)) continue;
    edges_[ends] = {size_, edges[e] - 2};
    size_ += edges[e] - 2;
  }
  for (const MfemFace& face : topology.faces) {
    if (divided_faces_.contains(ascending(face.vertices))) continue;
    const PatchFace& first = face.patches.front();
    const auto& size = sizes_[static_cast<std::size_t>(first.patch.value)];
    // The frame's first direction is that of its first edge.
    std::array<int, 2> inside{};
    const auto [a, b] = tangents(first.side);
    for (const int d : {a, b})
      for (int corner = 0; corner < 4; ++corner) {
        const auto [low, high] =
            mfem_edge_ends(topology.patches[static_cast<std::size_t>(first.patch.value)], d, corner);
        for (const std::size_t k : {0U, 1U})
          if (std::minmax(low, high) == std::minmax(face.vertices[k], face.vertices[k + 1]))
            inside[k] = size[static_cast<std::size_t>(d)] - 2;
      }
    faces_[ascending(face.vertices)] = {face.vertices, size_, inside};
    size_ += std::int64_t{inside[0]} * inside[1];
  }
  for (const auto& [a, b, c] : sizes_) {
    first_of_patch_.push_back(size_);
    size_ += std::int64_t{a - 2} * (b - 2) * (c - 2);
  }
}

/// Sides of the grids of divided faces.
void MfemNumbering::find_divided_edges() {
  for (const MfemDividedFace& face : topology_.divided) {
    const std::size_t m = face.lines[0].size(), n = face.lines[1].size();
    std::array<std::vector<int>, 4> sides;
    for (std::size_t i = 0; i < m; ++i) {
      sides[0].push_back(face.at(i, 0));
      sides[1].push_back(face.at(i, n - 1));
    }
    for (std::size_t j = 0; j < n; ++j) {
      sides[2].push_back(face.at(0, j));
      sides[3].push_back(face.at(m - 1, j));
    }
    for (std::vector<int>& side : sides) {
      if (side.size() < 3) continue;
      if (side.front() > side.back()) std::reverse(side.begin(), side.end());
      divided_[{side.front(), side.back()}] = side;
    }
  }
}

MfemNumbering::Numbers MfemNumbering::edge(int from, int to) const {
  const auto ends = std::minmax(from, to);
  Numbers result;
  if (const auto divided = divided_.find(ends); divided != divided_.end()) {
    const std::vector<int>& along = divided->second;
    for (std::size_t i = 0; i + 1 < along.size(); ++i) {
      if (i > 0) result.push_back(along[i]);
      const Numbers piece = edge(along[i], along[i + 1]);
      result.insert(result.end(), piece.begin(), piece.end());
    }
  } else {
    const auto known = edges_.find(ends);
    if (known == edges_.end())
      throw Error(ErrorCode::unsupported,
                  fmt::format("the edge {} {} of a divided face is no edge of a patch", from, to));
    for (int i = 0; i < known->second.inside; ++i) result.push_back(known->second.first + i);
  }
  if (from > to) std::reverse(result.begin(), result.end());
  return result;
}

MfemNumbering::Numbers MfemNumbering::face(const FaceCorners& corners) const {
  const auto divided = divided_faces_.find(ascending(corners));
  if (divided != divided_faces_.end()) return divided_face(*divided->second, corners);
  const auto known = faces_.find(ascending(corners));
  if (known == faces_.end())
    throw Error(ErrorCode::unsupported,
                fmt::format("a divided face meets no face of a patch with the vertices {}, {}, {} and {}",
                            corners[0], corners[1], corners[2], corners[3]));
  const OfFace& here = known->second;
  const auto at = std::find(here.vertices.begin(), here.vertices.end(), corners[0]) - here.vertices.begin();
  const auto vertex = [&](std::ptrdiff_t i) { return here.vertices[static_cast<std::size_t>(i % 4)]; };
  // In the frame: where (0, 0) is, and whether its first direction is ours.
  const bool high_first = at == 1 || at == 2, high_second = at == 2 || at == 3;
  const bool straight = (vertex(at + 1) == corners[1]) == (at % 2 == 0);
  const std::array<int, 2> n = straight ? here.inside : std::array{here.inside[1], here.inside[0]};
  Numbers result;
  for (int j = 0; j < n[1]; ++j)
    for (int i = 0; i < n[0]; ++i) {
      std::array<int, 2> frame = straight ? std::array{i, j} : std::array{j, i};
      if (high_first) frame[0] = here.inside[0] - 1 - frame[0];
      if (high_second) frame[1] = here.inside[1] - 1 - frame[1];
      result.push_back(here.first + frame[0] + std::int64_t{here.inside[0]} * frame[1]);
    }
  return result;
}

/// The faces that divide it, side by side, with the edges and vertices between them.
MfemNumbering::Numbers MfemNumbering::divided_face(const MfemDividedFace& divided,
                                                   const FaceCorners& corners) const {
  const std::size_t m = divided.lines[0].size(), n = divided.lines[1].size();
  // Rows of numbers in the divided face's own directions.
  std::vector<Numbers> rows;
  for (std::size_t j = 0; j + 1 < n; ++j) {
    if (j > 0) {
      Numbers& row = rows.emplace_back();
      for (std::size_t i = 0; i + 1 < m; ++i) {
        if (i > 0) row.push_back(divided.at(i, j));
        const Numbers piece = edge(divided.at(i, j), divided.at(i + 1, j));
        row.insert(row.end(), piece.begin(), piece.end());
      }
    }
    const std::size_t height = edge(divided.at(0, j), divided.at(0, j + 1)).size();
    std::vector<Numbers> band(height);
    for (std::size_t i = 0; i + 1 < m; ++i) {
      const Numbers up = edge(divided.at(i, j), divided.at(i, j + 1));
      const Numbers cell =
          face({divided.at(i, j), divided.at(i + 1, j), divided.at(i, j + 1), divided.at(i + 1, j + 1)});
      const std::size_t width = edge(divided.at(i, j), divided.at(i + 1, j)).size();
      if (up.size() != height || cell.size() != width * height)
        refuse("of other numbers of coefficients", divided.corners);
      for (std::size_t k = 0; k < height; ++k) {
        if (i > 0) band[k].push_back(up[k]);
        band[k].insert(band[k].end(), cell.begin() + static_cast<std::ptrdiff_t>(k * width),
                       cell.begin() + static_cast<std::ptrdiff_t>((k + 1) * width));
      }
    }
    std::move(band.begin(), band.end(), std::back_inserter(rows));
  }
  const std::size_t width = rows.empty() ? 0 : rows.front().size();
  if (std::any_of(rows.begin(), rows.end(), [&](const Numbers& row) { return row.size() != width; }))
    refuse("of other numbers of coefficients", divided.corners);
  const auto at =
      std::find(divided.corners.begin(), divided.corners.end(), corners[0]) - divided.corners.begin();
  const bool high_first = at == 1 || at == 2, high_second = at == 2 || at == 3;
  const bool straight =
      (divided.corners[static_cast<std::size_t>((at + 1) % 4)] == corners[1]) == (at % 2 == 0);
  const std::size_t first = straight ? width : rows.size(), second = straight ? rows.size() : width;
  Numbers result;
  for (std::size_t j = 0; j < second; ++j)
    for (std::size_t i = 0; i < first; ++i) {
      std::size_t column = straight ? i : j, row = straight ? j : i;
      if (high_first) column = width - 1 - column;
      if (high_second) row = rows.size() - 1 - row;
      result.push_back(rows[row][column]);
    }
  return result;
}

std::int64_t MfemNumbering::number(const Frames& frames, std::size_t patch,
                                   const std::array<int, 3>& at) const {
  const std::array<int, 3>& n = sizes_[patch];
  std::array<int, 3> ends{};
  int inside = 0;
  int inner = 0;  // the last direction in which the coefficient lies inside
  int outer = 0;  // and the last in which it lies on a side
  for (int d = 0; d < 3; ++d) {
    const auto k = static_cast<std::size_t>(d);
    ends[k] = at[k] == n[k] - 1;
    const bool is_inside = at[k] > 0 && at[k] < n[k] - 1;
    inside += is_inside;
    (is_inside ? inner : outer) = d;
  }
  if (inside == 0) return mfem_corner(topology_.patches[patch], ends);
  if (inside == 3)
    return first_of_patch_[patch] + at[0] - 1 +
           std::int64_t{n[0] - 2} * (at[1] - 1 + std::int64_t{n[1] - 2} * (at[2] - 1));
  const int across = inside == 1 ? inner : outer;
  const auto t = tangents(side_of(across, false));
  const auto a = static_cast<std::size_t>(t[0]);
  const auto b = static_cast<std::size_t>(t[1]);
  if (inside == 1)
    return frames.edges[static_cast<std::size_t>(4 * across + ends[a] + 2 * ends[b])]
                       [static_cast<std::size_t>(at[static_cast<std::size_t>(across)] - 1)];
  return frames.faces[static_cast<std::size_t>(side_of(across, ends[static_cast<std::size_t>(across)] == 1))]
                     [static_cast<std::size_t>(at[a] - 1 + (n[a] - 2) * (at[b] - 1))];
}

std::vector<std::int64_t> MfemNumbering::patch(std::size_t index) const {
  const std::array<int, 8>& vertices = topology_.patches[index];
  const std::array<int, 3>& n = sizes_[index];
  const auto require = [&](const Numbers& numbers, int count) {
    if (numbers.size() != static_cast<std::size_t>(count))
      throw Error(
          ErrorCode::bad_format,
          fmt::format("patch {} has a side with other numbers of coefficients than what divides it", index));
  };
  Frames frames;
  for (const Side side : all_sides) {
    const auto t = tangents(side);
    std::array<int, 3> ends{};
    ends[static_cast<std::size_t>(direction(side))] = is_high(side) ? 1 : 0;
    FaceCorners corners{};
    for (int corner = 0; corner < 4; ++corner) {
      ends[static_cast<std::size_t>(t[0])] = corner % 2;
      ends[static_cast<std::size_t>(t[1])] = corner / 2;
      corners[static_cast<std::size_t>(corner)] = mfem_corner(vertices, ends);
    }
    Numbers& numbers = frames.faces[static_cast<std::size_t>(side)];
    numbers = face(corners);
    require(numbers, (n[static_cast<std::size_t>(t[0])] - 2) * (n[static_cast<std::size_t>(t[1])] - 2));
  }
  for (int d = 0; d < 3; ++d)
    for (int c = 0; c < 4; ++c) {
      const auto [low, high] = mfem_edge_ends(vertices, d, c);
      Numbers& numbers = frames.edges[static_cast<std::size_t>(4 * d + c)];
      numbers = edge(low, high);
      require(numbers, n[static_cast<std::size_t>(d)] - 2);
    }
  std::vector<std::int64_t> result;
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) result.push_back(number(frames, index, {i, j, k}));
  return result;
}

}  // namespace isopatch::geometry
