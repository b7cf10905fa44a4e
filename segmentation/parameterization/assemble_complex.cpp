#include "segmentation/parameterization/assemble_complex.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <queue>

#include "geometry/brep/solid_error.hpp"
#include "segmentation/parameterization/edge_pace.hpp"
#include "segmentation/parameterization/edge_samples.hpp"
#include "segmentation/parameterization/face_contact.hpp"
#include "segmentation/parameterization/outline.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::SolidError;
using geometry::SolidFault;

/// Two sides that are one face.
struct Match {
  BlockSide first, second;
  FaceContact contact;
};

/// Sets of items that are one, each item with a flag that says whether it is turned around against its root.
class SignedSets {
 public:
  explicit SignedSets(std::size_t count) : parent_(count), flipped_(count, false) {
    for (std::size_t i = 0; i < count; ++i) parent_[i] = static_cast<int>(i);
  }
  std::pair<int, bool> root(int i) const {
    bool flipped = false;
    while (parent_[static_cast<std::size_t>(i)] != i) {
      flipped ^= flipped_[static_cast<std::size_t>(i)];
      i = parent_[static_cast<std::size_t>(i)];
    }
    return {i, flipped};
  }
  void join(int a, int b, bool flipped) {
    const auto [ra, fa] = root(a);
    const auto [rb, fb] = root(b);
    if (ra == rb) return;
    const int low = std::min(ra, rb), high = std::max(ra, rb);
    parent_[static_cast<std::size_t>(high)] = low;
    flipped_[static_cast<std::size_t>(high)] = fa ^ fb ^ flipped;
  }

 private:
  std::vector<int> parent_;
  std::vector<bool> flipped_;
};

double size_of(const std::vector<Hexahedron>& blocks) {
  Eigen::AlignedBox3d box;
  for (const Hexahedron& block : blocks) {
    for (const auto& corner : block.corners) box.extend(corner);
    for (const QuadFace& face : block.faces) box.extend(face.surface(coons_point(face.sides, 0.5, 0.5)));
  }
  return box.diagonal().norm();
}

using BlockMaps = std::vector<std::array<FaceMap, 6>>;

BlockMaps face_maps(const std::vector<Hexahedron>& blocks) {
  BlockMaps result;
  for (const Hexahedron& block : blocks) {
    const auto map = [&](std::size_t side) {
      QuadFace named = block.faces[side];
      named.name = block.name + ":" + named.name;
      return face_map(named);
    };
    result.push_back({map(0), map(1), map(2), map(3), map(4), map(5)});
  }
  return result;
}

const FaceMap& map_of(const BlockMaps& maps, BlockSide side) {
  return maps[static_cast<std::size_t>(side.block)][static_cast<std::size_t>(side.side)];
}

/// Number of a corner or an edge among those of all blocks.
int corner_id(int block, int corner) {
  return 8 * block + corner;
}
int edge_id(int block, int edge) {
  return 12 * block + edge;
}

void join_corners(SignedSets& corners, const Match& match) {
  for (int s = 0; s < 2; ++s)
    for (int t = 0; t < 2; ++t) {
      const geometry::Parameter<2> other = match.contact.orientation(geometry::Parameter<2>(s, t));
      corners.join(corner_id(match.first.block, side_corner(match.first.side, s, t)),
                   corner_id(match.second.block, side_corner(match.second.side, static_cast<int>(other[0]),
                                                             static_cast<int>(other[1]))),
                   false);
    }
}

void join_edges(SignedSets& edges, const Match& match) {
  const FaceOrientation& o = match.contact.orientation;
  const auto own = side_edges(match.first.side);
  const auto others = side_edges(match.second.side);
  for (std::size_t k = 0; k < 4; ++k) {
    const bool along_first = k < 2;
    const bool high = k % 2 == 1;
    // Where this side of the square, and a direction along it, go on the other face.
    const bool lands_first = along_first != o.swapped;
    const bool turned = lands_first ? o.flip_first : o.flip_second;
    const bool end = high != (lands_first ? o.flip_second : o.flip_first);
    edges.join(edge_id(match.first.block, own[k]),
               edge_id(match.second.block, others[(lands_first ? 0u : 2u) + (end ? 1u : 0u)]), turned);
  }
}

void number_vertices(HexComplex& complex, const SignedSets& corners) {
  std::map<int, int> number;
  std::vector<int> uses;
  for (std::size_t b = 0; b < complex.blocks.size(); ++b)
    for (int c = 0; c < 8; ++c) {
      const int root = corners.root(corner_id(static_cast<int>(b), c)).first;
      const auto [found, fresh] = number.try_emplace(root, static_cast<int>(complex.vertices.size()));
      if (fresh) {
        complex.vertices.emplace_back(Eigen::Vector3d::Zero());
        uses.push_back(0);
      }
      const auto v = static_cast<std::size_t>(found->second);
      complex.vertices[v] += complex.blocks[b].corners[static_cast<std::size_t>(c)];
      ++uses[v];
      complex.block_vertices[b][static_cast<std::size_t>(c)] = found->second;
    }
  for (std::size_t v = 0; v < uses.size(); ++v) complex.vertices[v] /= uses[v];
}

void number_edges(HexComplex& complex, const SignedSets& edges) {
  std::map<int, int> number;
  for (std::size_t b = 0; b < complex.blocks.size(); ++b)
    for (int e = 0; e < 12; ++e) {
      const auto [root, flipped] = edges.root(edge_id(static_cast<int>(b), e));
      const auto [found, fresh] = number.try_emplace(root, static_cast<int>(complex.edges.size()));
      if (fresh) complex.edges.emplace_back();
      ComplexEdge& edge = complex.edges[static_cast<std::size_t>(found->second)];
      edge.uses.push_back({static_cast<int>(b), e, flipped});
      const auto ends = edge_corners(e);
      const auto& at = complex.block_vertices[b];
      edge.vertices = {at[static_cast<std::size_t>(ends[flipped ? 1 : 0])],
                       at[static_cast<std::size_t>(ends[flipped ? 0 : 1])]};
      complex.block_edges[b][static_cast<std::size_t>(e)] = found->second;
    }
}

void number_faces(HexComplex& complex, const std::vector<Match>& matches) {
  std::map<BlockSide, const Match*> second_of, first_of;
  for (const Match& match : matches) {
    first_of[match.first] = &match;
    second_of[match.second] = &match;
  }
  for (std::size_t b = 0; b < complex.blocks.size(); ++b)
    for (const Side side : geometry::all_sides) {
      const BlockSide here{static_cast<int>(b), side};
      if (second_of.contains(here)) continue;
      const int number = static_cast<int>(complex.faces.size());
      ComplexFace face{{{here, {}}}, 0};
      complex.block_faces[b][static_cast<std::size_t>(side)] = number;
      if (const auto found = first_of.find(here); found != first_of.end()) {
        const Match& match = *found->second;
        face.uses.push_back({match.second, match.contact.orientation});
        face.gap = match.contact.distance;
        complex.block_faces[static_cast<std::size_t>(match.second.block)]
                           [static_cast<std::size_t>(match.second.side)] = number;
      }
      complex.faces.push_back(std::move(face));
    }
}

// Whether a block runs through an edge against the complex' direction.
bool reversed_in(const HexComplex& complex, int block, int edge) {
  const auto& found = complex.edges[static_cast<std::size_t>(
      complex.block_edges[static_cast<std::size_t>(block)][static_cast<std::size_t>(edge)])];
  for (const EdgeUse& use : found.uses)
    if (use.block == block && use.edge == edge) return use.reversed;
  return false;
}

// The four parallel edges of each block's direction belong together; two ways around that disagree make a
// sheet symmetric.
void find_sheets(HexComplex& complex) {
  std::vector<bool> seen(complex.edges.size(), false);
  for (std::size_t start = 0; start < complex.edges.size(); ++start) {
    if (seen[start]) continue;
    const int sheet = static_cast<int>(complex.sheets.size());
    complex.sheets.emplace_back();
    complex.edges[start].sheet = sheet;
    seen[start] = true;
    std::queue<std::size_t> open;
    open.push(start);
    while (!open.empty()) {
      const ComplexEdge edge = complex.edges[open.front()];
      open.pop();
      for (const EdgeUse& use : edge.uses)
        for (int k = 0; k < 4; ++k) {
          const int parallel = 4 * edge_direction(use.edge) + k;
          const auto next = static_cast<std::size_t>(
              complex.block_edges[static_cast<std::size_t>(use.block)][static_cast<std::size_t>(parallel)]);
          const bool against =
              (edge.against_sheet != use.reversed) != reversed_in(complex, use.block, parallel);
          ComplexEdge& target = complex.edges[next];
          if (!seen[next]) {
            seen[next] = true;
            target.sheet = sheet;
            target.against_sheet = against;
            open.push(next);
          } else if (target.against_sheet != against) {
            complex.sheets[static_cast<std::size_t>(sheet)].symmetric = true;
          }
        }
    }
  }
}

HexComplex assembled(std::vector<Hexahedron> blocks, BlockMaps maps, const std::vector<Match>& matches,
                     double size) {
  HexComplex complex;
  complex.blocks = std::move(blocks);
  complex.maps = std::move(maps);
  complex.size = size;
  const std::size_t n = complex.blocks.size();
  complex.block_vertices.resize(n);
  complex.block_edges.resize(n);
  complex.block_faces.resize(n);
  SignedSets corners(8 * n), edges(12 * n);
  for (const Match& match : matches) {
    join_corners(corners, match);
    join_edges(edges, match);
  }
  number_vertices(complex, corners);
  number_edges(complex, edges);
  number_faces(complex, matches);
  find_sheets(complex);
  settle_paces(complex);
  settle_edges(complex);
  return complex;
}

BlockSide side_of_face(const std::vector<Hexahedron>& blocks, int block, int face, std::size_t pair) {
  if (block < 0 || static_cast<std::size_t>(block) >= blocks.size())
    throw Error(ErrorCode::invalid_argument,
                fmt::format("pair {} names block {}; there are {}", pair, block, blocks.size()));
  for (const Side side : geometry::all_sides)
    if (blocks[static_cast<std::size_t>(block)].face(side).number == face) return {block, side};
  throw Error(ErrorCode::invalid_argument,
              fmt::format("pair {}: block '{}' has no face {}; a hexahedron's faces are numbered 0 to 5",
                          pair, blocks[static_cast<std::size_t>(block)].name, face));
}

void check(const std::vector<Hexahedron>& blocks, const ComplexOptions& options) {
  validate(options);
  if (blocks.empty()) throw Error(ErrorCode::invalid_argument, "a complex needs at least one hexahedron");
}

SolidFault fault_of(const std::vector<Hexahedron>& blocks, const std::vector<BlockSide>& sides,
                    const std::string& remark, std::vector<SolidFault::Point> points = {}) {
  SolidFault fault{.points = std::move(points)};
  for (const BlockSide side : sides) {
    const Hexahedron& block = blocks[static_cast<std::size_t>(side.block)];
    fault.faces.push_back({block.face(side.side).number, block.name, remark});
  }
  return fault;
}

/// A face and the box around a coarse grid of it.
struct FaceWithBox {
  BlockSide side;
  Eigen::AlignedBox3d box;
};

std::vector<FaceWithBox> candidates(const BlockMaps& maps, double margin) {
  std::vector<FaceWithBox> result;
  std::vector<double> at;
  for (int i = 0; i <= 8; ++i) at.push_back(i / 8.0);
  for (std::size_t f = 0; f < 6 * maps.size(); ++f) {
    FaceWithBox candidate{{static_cast<int>(f / 6), Side(f % 6)}, {}};
    const Eigen::Matrix3Xd grid = map_of(maps, candidate.side).grid(at, at);
    for (const auto& point : grid.colwise()) candidate.box.extend(Eigen::Vector3d(point));
    const Eigen::Vector3d wider = Eigen::Vector3d::Constant(margin);
    candidate.box = {candidate.box.min() - wider, candidate.box.max() + wider};
    result.push_back(candidate);
  }
  return result;
}

// Whether a face lies in another: its corners and some inner points do.
bool lies_in(const FaceMap& part, const FaceMap& whole, double reach) {
  for (const double s : {0.5, 0.0, 1.0, 0.3})
    for (const double t : {0.5, 0.0, 1.0, 0.8})
      if (distance(whole, part.point(s, t), reach) > reach) return false;
  return true;
}

}  // namespace

void validate(const ComplexOptions& options) {
  if (!(options.same_point > 0 && options.same_point < 0.05))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("same_point is {}; its range is (0, 0.05)", options.same_point));
}

HexComplex hex_complex(std::vector<Hexahedron> blocks, const std::vector<ListedPair>& pairs,
                       const ComplexOptions& options) {
  check(blocks, options);
  const double size = size_of(blocks);
  BlockMaps maps = face_maps(blocks);
  std::vector<Match> matches;
  std::map<BlockSide, std::size_t> pair_of;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const BlockSide first = side_of_face(blocks, pairs[i].first_block, pairs[i].first_face, i);
    const BlockSide second = side_of_face(blocks, pairs[i].second_block, pairs[i].second_face, i);
    for (const BlockSide side : {first, second})
      if (const auto [found, fresh] = pair_of.try_emplace(side, i); !fresh)
        throw SolidError(
            ErrorCode::invalid_argument,
            fmt::format("face {} is in pair {} and in pair {}", label_of(blocks, side), found->second, i),
            fault_of(blocks, {side}, fmt::format("in pairs {} and {}", found->second, i)));
    const FaceContact found = contact(map_of(maps, first), map_of(maps, second));
    if (found.distance > options.same_point * size)
      throw SolidError(
          ErrorCode::not_conforming,
          fmt::format("pair {}: faces {} and {} do not meet: they are {:.3g} apart at ({:.6g}, {:.6g}, "
                      "{:.6g}), {:.2g} of the model's size; correct the list, or raise same_point",
                      i, label_of(blocks, first), label_of(blocks, second), found.distance, found.place[0],
                      found.place[1], found.place[2], found.distance / size),
          fault_of(blocks, {first, second}, fmt::format("in pair {}", i),
                   {{fmt::format("{:.3g} apart", found.distance), found.place}}));
    matches.push_back({first, second, found});
  }
  return assembled(std::move(blocks), std::move(maps), matches, size);
}

HexComplex hex_complex(std::vector<Hexahedron> blocks, const ComplexOptions& options) {
  check(blocks, options);
  const double size = size_of(blocks);
  const double reach = options.same_point * size;
  BlockMaps maps = face_maps(blocks);
  const std::vector<FaceWithBox> all = candidates(maps, reach);
  std::vector<Match> matches;
  std::vector<PartialContact> partial;
  std::map<BlockSide, BlockSide> partner;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      if (all[i].side.block == all[j].side.block || !all[i].box.intersects(all[j].box)) continue;
      const FaceMap& one = map_of(maps, all[i].side);
      const FaceMap& two = map_of(maps, all[j].side);
      const FaceContact found = contact(one, two);
      if (found.distance <= reach) {
        for (const auto& [a, b] : {std::pair{all[i].side, all[j].side}, std::pair{all[j].side, all[i].side}})
          if (const auto [other, fresh] = partner.try_emplace(a, b); !fresh)
            throw SolidError(
                ErrorCode::not_conforming,
                fmt::format("face {} meets both {} and {}; a face lies between two blocks at most",
                            label_of(blocks, a), label_of(blocks, other->second), label_of(blocks, b)),
                fault_of(blocks, {a, other->second, b}, ""));
        matches.push_back({all[i].side, all[j].side, found});
      } else if (lies_in(one, two, reach)) {
        partial.push_back({all[i].side, all[j].side});
      } else if (lies_in(two, one, reach)) {
        partial.push_back({all[j].side, all[i].side});
      }
    }
  HexComplex complex = assembled(std::move(blocks), std::move(maps), matches, size);
  complex.partial_contacts = std::move(partial);
  return complex;
}

}  // namespace isopatch::segmentation
