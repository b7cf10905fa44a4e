#include "geometry/io/mfem_numbering.hpp"

#include <algorithm>

namespace isopatch::geometry {

MfemNumbering::MfemNumbering(const MfemTopology& topology, std::vector<std::array<int, 3>> sizes,
                             const std::vector<int>& edges)
    : topology_(topology), sizes_(std::move(sizes)), size_(topology.vertex_count) {
  for (std::size_t e = 0; e < edges.size(); ++e) {
    first_of_edge_[std::minmax(topology.edges[e].from, topology.edges[e].to)] = size_;
    size_ += edges[e] - 2;
  }
  for (const MfemFace& face : topology.faces) {
    const auto& size = sizes_[static_cast<std::size_t>(face.patches.front().patch.value)];
    const auto [a, b] = tangents(face.patches.front().side);
    for (const PatchFace& of : face.patches) face_of_[of] = first_of_face_.size();
    first_of_face_.push_back(size_);
    size_ += std::int64_t{size[static_cast<std::size_t>(a)] - 2} * (size[static_cast<std::size_t>(b)] - 2);
  }
  for (const auto& [a, b, c] : sizes_) {
    first_of_patch_.push_back(size_);
    size_ += std::int64_t{a - 2} * (b - 2) * (c - 2);
  }
}

MfemNumbering::Strided MfemNumbering::edge(std::size_t patch, int direction, int corner) const {
  const auto [low, high] = mfem_edge_ends(topology_.patches[patch], direction, corner);
  const std::int64_t first = first_of_edge_.at(std::minmax(low, high));
  const std::int64_t inside = sizes_[patch][static_cast<std::size_t>(direction)] - 2;
  return low < high ? Strided{first, 1, 0} : Strided{first + inside - 1, -1, 0};
}

MfemNumbering::Strided MfemNumbering::face(std::size_t patch, Side side) const {
  const std::size_t index = face_of_.at({PatchId(static_cast<int>(patch)), side});
  const std::array<int, 4>& frame = topology_.faces[index].vertices;
  const auto t = tangents(side);
  // Where in this patch the frame begins, and whether its first axis is our first tangent.
  std::array<int, 3> ends{};
  ends[static_cast<std::size_t>(direction(side))] = is_high(side);
  std::array<bool, 2> from_high{};
  bool straight = true;
  for (int corner = 0; corner < 4; ++corner) {
    ends[static_cast<std::size_t>(t[0])] = corner % 2;
    ends[static_cast<std::size_t>(t[1])] = corner / 2;
    if (mfem_corner(topology_.patches[patch], ends) != frame[0]) continue;
    from_high = {corner % 2 == 1, corner / 2 == 1};
    ends[static_cast<std::size_t>(t[0])] = 1 - corner % 2;
    straight = mfem_corner(topology_.patches[patch], ends) == frame[1];
    break;
  }
  const std::int64_t along = sizes_[patch][static_cast<std::size_t>(t[0])] - 2;
  const std::int64_t across = sizes_[patch][static_cast<std::size_t>(t[1])] - 2;
  Strided result{first_of_face_[index], straight ? 1 : across, straight ? along : 1};
  if (from_high[0]) {
    result.first += (along - 1) * result.along;
    result.along = -result.along;
  }
  if (from_high[1]) {
    result.first += (across - 1) * result.across;
    result.across = -result.across;
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
  if (inside == 1) {
    const Strided& edge = frames.edges[static_cast<std::size_t>(4 * across + ends[a] + 2 * ends[b])];
    return edge.first + (at[static_cast<std::size_t>(across)] - 1) * edge.along;
  }
  const Strided& face =
      frames.faces[static_cast<std::size_t>(side_of(across, ends[static_cast<std::size_t>(across)] == 1))];
  return face.first + (at[a] - 1) * face.along + (at[b] - 1) * face.across;
}

std::vector<std::int64_t> MfemNumbering::patch(std::size_t index) const {
  Frames frames;
  for (const Side side : all_sides) frames.faces[static_cast<std::size_t>(side)] = face(index, side);
  for (int d = 0; d < 3; ++d)
    for (int c = 0; c < 4; ++c) frames.edges[static_cast<std::size_t>(4 * d + c)] = edge(index, d, c);
  const std::array<int, 3>& n = sizes_[index];
  std::vector<std::int64_t> result;
  for (int k = 0; k < n[2]; ++k)
    for (int j = 0; j < n[1]; ++j)
      for (int i = 0; i < n[0]; ++i) result.push_back(number(frames, index, {i, j, k}));
  return result;
}

}  // namespace isopatch::geometry
