#include "segmentation/parameterization/assemble_model.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "geometry/base/error.hpp"
#include "geometry/brep/solid_error.hpp"
#include "geometry/hex/assemble_topology.hpp"
#include "segmentation/parameterization/internal/cube_sides.hpp"
#include "segmentation/parameterization/internal/face_contact.hpp"
#include "segmentation/parameterization/internal/find_t_joints.hpp"
#include "segmentation/parameterization/internal/hex_complex.hpp"
#include "segmentation/parameterization/internal/refused_faces.hpp"

namespace isopatch::segmentation {
namespace {

using geometry::SideMatch;
using geometry::SolidError;
using geometry::SolidFault;

using BlockMaps = std::vector<std::array<FaceMap, 6>>;

const FaceMap& map_of(const BlockMaps& maps, BlockSide side) {
  return maps[static_cast<std::size_t>(side.block.value)][static_cast<std::size_t>(side.side)];
}

/// The solids as hexahedra, not yet put together.
HexModel loose_blocks(std::vector<geometry::BrepFile> solids) {
  if (solids.empty()) throw Error(ErrorCode::invalid_argument, "a complex needs at least one hexahedron");
  HexModel model;
  for (std::size_t b = 0; b < solids.size(); ++b) {
    const geometry::Brep& brep = solids[b].brep;
    const std::array<FaceId, 6> sides = cube_sides(solids[b]);
    model.bodies.push_back(solids[b].name);
    auto& faces = model.faces.emplace_back();
    for (std::size_t side = 0; side < 6; ++side) {
      const auto& colour = brep.face(sides[side]).colour;
      faces[side] = {static_cast<int>(b), sides[side], face_name(brep, sides[side]),
                     colour ? geometry::hex_text(*colour) : ""};
    }
  }
  model.solids = std::move(solids);
  return model;
}

BlockSide side_of_face(const HexModel& model, int block, int face, std::size_t pair) {
  if (block < 0 || static_cast<std::size_t>(block) >= model.solids.size())
    throw Error(ErrorCode::invalid_argument,
                fmt::format("pair {} names block {}; there are {}", pair, block, model.solids.size()));
  for (const Side side : geometry::all_sides)
    if (const BlockSide here{BlockId(block), side}; model.face(here).face == FaceId(face)) return here;
  throw Error(ErrorCode::invalid_argument,
              fmt::format("pair {}: block '{}' has no face {}; a hexahedron's faces are numbered 0 to 5",
                          pair, model.name(BlockId(block)), face));
}

SolidFault fault_of(const HexModel& model, const std::vector<BlockSide>& sides, const std::string& remark,
                    std::vector<SolidFault::Point> points = {}) {
  SolidFault fault{.points = std::move(points)};
  for (const BlockSide side : sides)
    fault.faces.push_back({model.face(side).face.value, model.name(side.block), remark});
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
    FaceWithBox candidate{{BlockId(static_cast<int>(f / 6)), geometry::all_sides[f % 6]}, {}};
    const Eigen::Matrix3Xd grid = map_of(maps, candidate.side).grid(at, at);
    for (const auto& point : grid.colwise()) candidate.box.extend(Eigen::Vector3d(point));
    const Eigen::Vector3d wider = Eigen::Vector3d::Constant(margin);
    candidate.box = {candidate.box.min() - wider, candidate.box.max() + wider};
    result.push_back(candidate);
  }
  return result;
}

}  // namespace

void validate(const AssemblyOptions& options) {
  if (!(options.same_point > 0 && options.same_point < 0.05))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("same_point is {}; its range is (0, 0.05)", options.same_point));
}

HexModel hex_model(std::vector<geometry::BrepFile> solids, const std::vector<ListedPair>& pairs,
                   const AssemblyOptions& options) {
  validate(options);
  HexModel model = loose_blocks(std::move(solids));
  const std::vector<Hexahedron> blocks = hexahedra(model);
  const double size = size_of(blocks);
  const BlockMaps maps = face_maps(blocks);
  geometry::HexContacts contacts;
  std::map<BlockSide, std::size_t> pair_of;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const BlockSide first = side_of_face(model, pairs[i].first_block, pairs[i].first_face, i);
    const BlockSide second = side_of_face(model, pairs[i].second_block, pairs[i].second_face, i);
    for (const BlockSide side : {first, second})
      if (const auto [found, fresh] = pair_of.try_emplace(side, i); !fresh)
        throw SolidError(
            ErrorCode::invalid_argument,
            fmt::format("face {} is in pair {} and in pair {}", label_of(model, side), found->second, i),
            fault_of(model, {side}, fmt::format("in pairs {} and {}", found->second, i)));
    const FaceContact found = contact(map_of(maps, first), map_of(maps, second));
    if (found.distance > options.same_point * size)
      throw SolidError(
          ErrorCode::not_conforming,
          fmt::format("pair {}: faces {} and {} do not meet: they are {:.3g} apart at ({:.6g}, {:.6g}, "
                      "{:.6g}), {:.2g} of the model's size; correct the list, or raise same_point",
                      i, label_of(model, first), label_of(model, second), found.distance, found.place[0],
                      found.place[1], found.place[2], found.distance / size),
          fault_of(model, {first, second}, fmt::format("in pair {}", i),
                   {{fmt::format("{:.3g} apart", found.distance), found.place}}));
    contacts.sides.push_back({first, second, found.orientation, found.distance});
  }
  model.topology = geometry::assembled_topology(static_cast<int>(model.solids.size()), contacts);
  return model;
}

HexModel hex_model(std::vector<geometry::BrepFile> solids, const AssemblyOptions& options) {
  validate(options);
  HexModel model = loose_blocks(std::move(solids));
  const std::vector<Hexahedron> blocks = hexahedra(model);
  const double reach = options.same_point * size_of(blocks);
  const BlockMaps maps = face_maps(blocks);
  const std::vector<FaceWithBox> all = candidates(maps, reach);
  geometry::HexContacts contacts;
  std::vector<SideInSide> parts;
  std::map<BlockSide, BlockSide> partner;
  for (std::size_t i = 0; i < all.size(); ++i)
    for (std::size_t j = i + 1; j < all.size(); ++j) {
      const BlockSide first = all[i].side, second = all[j].side;
      if (first.block == second.block || !all[i].box.intersects(all[j].box)) continue;
      const FaceMap &one = map_of(maps, first), &two = map_of(maps, second);
      const FaceContact found = contact(one, two);
      if (found.distance <= reach) {
        for (const auto& [a, b] : {std::pair{first, second}, std::pair{second, first}})
          if (const auto [other, fresh] = partner.try_emplace(a, b); !fresh)
            throw SolidError(
                ErrorCode::not_conforming,
                fmt::format("face {} meets both {} and {}; a face lies between two blocks at most",
                            label_of(model, a), label_of(model, other->second), label_of(model, b)),
                fault_of(model, {a, other->second, b}, ""));
        contacts.sides.push_back({first, second, found.orientation, found.distance});
      } else if (auto part = lies_in(one, two, reach)) {
        parts.push_back({first, second, std::move(*part)});
      } else if (auto other_part = lies_in(two, one, reach)) {
        parts.push_back({second, first, std::move(*other_part)});
      }
    }
  model.topology = with_t_joints(static_cast<int>(model.solids.size()), std::move(contacts), parts);
  return model;
}

}  // namespace isopatch::segmentation
