#include "segmentation/parameterization/assemble_model.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <optional>
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
  if (!(options.same_point >= 0 && options.same_point < 0.05))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("same_point is {}; its range is (0, 0.05), or 0 for one that suits the model",
                            options.same_point));
}

namespace {

// Shares of the size: how near points of blocks of any origin have to be, those of exact solids, and how well
// these agree.
constexpr double usual_reach = 1e-3;
constexpr double exact_reach = 1e-5;
constexpr double exact_agreement = 1e-6;

/// Blocks with the maps of their sides, while it is found how they meet.
class Assembly {
 public:
  Assembly(std::vector<geometry::BrepFile> solids, const AssemblyOptions& options)
      : model_(loose_blocks(std::move(solids))),
        blocks_(hexahedra(model_)),
        size_(size_of(blocks_)),
        reach_((options.same_point > 0 ? options.same_point : usual_reach) * size_),
        is_reach_given_(options.same_point > 0),
        maps_(face_maps(blocks_)) {}

  void add(const std::vector<ListedPair>& pairs) {
    std::map<BlockSide, std::size_t> pair_of;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      const BlockSide first = side_of_face(model_, pairs[i].first_block, pairs[i].first_face, i);
      const BlockSide second = side_of_face(model_, pairs[i].second_block, pairs[i].second_face, i);
      for (const BlockSide side : {first, second})
        if (const auto [found, fresh] = pair_of.try_emplace(side, i); !fresh)
          throw SolidError(
              ErrorCode::invalid_argument,
              fmt::format("face {} is in pair {} and in pair {}", label_of(model_, side), found->second, i),
              fault_of(model_, {side}, fmt::format("in pairs {} and {}", found->second, i)));
      add(first, second, i);
    }
  }

  /// Compares sides of blocks that are not of one group, and not in a pair already.
  void search(const std::vector<int>& groups) {
    const std::vector<FaceWithBox> all = candidates(maps_, reach_);
    const auto is_known = [&](BlockSide a, BlockSide b) {
      const int group = groups[static_cast<std::size_t>(a.block.value)];
      return a.block == b.block || (group >= 0 && group == groups[static_cast<std::size_t>(b.block.value)]);
    };
    std::vector<std::pair<BlockSide, BlockSide>> near;
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = i + 1; j < all.size(); ++j)
        if (!is_known(all[i].side, all[j].side) && all[i].box.intersects(all[j].box))
          near.emplace_back(all[i].side, all[j].side);
    if (!is_reach_given_) reach_ = suitable_reach(near);
    for (const auto& [first, second] : near) compare(first, second);
  }

  HexModel put_together() {
    model_.topology =
        with_t_joints(static_cast<int>(model_.solids.size()), std::move(contacts_), std::move(parts_));
    return std::move(model_);
  }

 private:
  void add(BlockSide first, BlockSide second, std::size_t pair) {
    const FaceContact found = contact(map_of(maps_, first), map_of(maps_, second));
    if (found.distance > reach_)
      throw SolidError(
          ErrorCode::not_conforming,
          fmt::format("pair {}: faces {} and {} do not meet: they are {:.3g} apart at ({:.6g}, {:.6g}, "
                      "{:.6g}), {:.2g} of the model's size; correct the list, or raise same_point",
                      pair, label_of(model_, first), label_of(model_, second), found.distance, found.place[0],
                      found.place[1], found.place[2], found.distance / size_),
          fault_of(model_, {first, second}, fmt::format("in pair {}", pair),
                   {{fmt::format("{:.3g} apart", found.distance), found.place}}));
    join(first, second, found);
  }

  void join(BlockSide first, BlockSide second, const FaceContact& found) {
    for (const auto& [a, b] : {std::pair{first, second}, std::pair{second, first}})
      if (const auto [other, fresh] = partner_.try_emplace(a, b); !fresh)
        throw SolidError(
            ErrorCode::not_conforming,
            fmt::format("face {} meets both {} and {}; a face lies between two blocks at most",
                        label_of(model_, a), label_of(model_, other->second), label_of(model_, b)),
            fault_of(model_, {a, other->second, b}, ""));
    contacts_.sides.push_back({first, second, found.orientation, found.distance});
  }

  // How far two sides are apart where they meet within the reach; nothing where they do not.
  std::optional<double> distance_where_they_meet(BlockSide first, BlockSide second) const {
    const FaceContact found = contact(map_of(maps_, first), map_of(maps_, second));
    if (found.distance <= reach_) return found.distance;
    const std::optional<SideInSide> part = part_of(first, second);
    return part ? std::optional(part->outline.distance) : std::nullopt;
  }

  double suitable_reach(const std::vector<std::pair<BlockSide, BlockSide>>& near) const {
    std::size_t meeting = 0, exact = 0;
    for (const auto& [first, second] : near) {
      const std::optional<double> distance = distance_where_they_meet(first, second);
      if (distance) ++meeting;
      if (distance && *distance <= exact_agreement * size_) ++exact;
    }
    return (2 * exact > meeting ? exact_reach : usual_reach) * size_;
  }

  // Whichever of the two is the part.
  std::optional<SideInSide> part_of(BlockSide first, BlockSide second) const {
    const FaceMap &one = map_of(maps_, first), &two = map_of(maps_, second);
    if (const auto outline = lies_in(one, two, reach_)) return SideInSide{first, second, *outline};
    if (const auto outline = lies_in(two, one, reach_)) return SideInSide{second, first, *outline};
    return std::nullopt;
  }

  void compare(BlockSide first, BlockSide second) {
    const FaceContact found = contact(map_of(maps_, first), map_of(maps_, second));
    if (found.distance <= reach_)
      join(first, second, found);
    else if (auto part = part_of(first, second))
      parts_.push_back(std::move(*part));
  }

  HexModel model_;
  std::vector<Hexahedron> blocks_;
  double size_, reach_;
  bool is_reach_given_;
  BlockMaps maps_;
  geometry::HexContacts contacts_;
  std::vector<SideInSide> parts_;
  std::map<BlockSide, BlockSide> partner_;
};

}  // namespace

HexModel hex_model(std::vector<geometry::BrepFile> solids, const std::vector<ListedPair>& pairs,
                   const AssemblyOptions& options) {
  validate(options);
  Assembly assembly(std::move(solids), options);
  assembly.add(pairs);
  return assembly.put_together();
}

HexModel hex_model(std::vector<geometry::BrepFile> solids, const std::vector<ListedPair>& pairs,
                   const std::vector<int>& groups, const AssemblyOptions& options) {
  validate(options);
  if (groups.size() != solids.size())
    throw Error(ErrorCode::invalid_argument,
                fmt::format("{} solids come with the groups of {}", solids.size(), groups.size()));
  Assembly assembly(std::move(solids), options);
  assembly.add(pairs);
  assembly.search(groups);
  return assembly.put_together();
}

HexModel hex_model(std::vector<geometry::BrepFile> solids, const AssemblyOptions& options) {
  const std::vector<int> groups(solids.size(), -1);
  return hex_model(std::move(solids), {}, groups, options);
}

}  // namespace isopatch::segmentation
