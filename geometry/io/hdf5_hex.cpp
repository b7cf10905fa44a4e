#include "geometry/io/hdf5_hex.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "geometry/base/error.hpp"
#include "geometry/io/internal/number_list.hpp"

namespace isopatch::geometry {
namespace {

NumberList list_at(const Hdf5Reader& file, const std::string& path) {
  return {file.integers(path), path};
}

void add(NumberList& list, BlockSide side) {
  list.add(side.block.value, side.side);
}

BlockSide next_side(NumberList& list) {
  const BlockId block(list.next());
  return {block, static_cast<Side>(list.next())};
}

NumberList edge_list(const HexTopology& topology) {
  NumberList list;
  for (const HexEdge& edge : topology.edges) {
    list.add(edge.vertices[0].value, edge.vertices[1].value, edge.sheet.value, edge.against_sheet,
             edge.uses.size());
    for (const HexEdgeUse& use : edge.uses) list.add(use.edge.block.value, use.edge.edge, use.reversed);
  }
  return list;
}

std::vector<HexEdge> edges_of(NumberList list) {
  std::vector<HexEdge> edges;
  while (!list.at_end()) {
    HexEdge edge;
    for (HexVertexId& vertex : edge.vertices) vertex = HexVertexId(list.next());
    edge.sheet = SheetId(list.next());
    edge.against_sheet = list.next_flag();
    const std::size_t uses = list.next_count();
    for (std::size_t i = 0; i < uses; ++i) {
      const BlockId block(list.next());
      const BlockEdge at{block, list.next()};
      edge.uses.push_back({at, list.next_flag()});
    }
    edges.push_back(std::move(edge));
  }
  return edges;
}

NumberList face_list(const HexTopology& topology) {
  NumberList list;
  for (const HexFace& face : topology.faces) {
    list.add(face.uses.size());
    for (const HexFaceUse& use : face.uses) {
      add(list, use.side);
      list.add(use.orientation.swapped, use.orientation.flip_first, use.orientation.flip_second);
    }
  }
  return list;
}

std::vector<HexFace> faces_of(NumberList list, const Eigen::VectorXd& gaps, const std::string& path) {
  std::vector<HexFace> faces;
  while (!list.at_end()) {
    HexFace face;
    const std::size_t uses = list.next_count();
    for (std::size_t i = 0; i < uses; ++i) {
      HexFaceUse use{next_side(list), {}};
      for (bool* flag : {&use.orientation.swapped, &use.orientation.flip_first, &use.orientation.flip_second})
        *flag = list.next_flag();
      face.uses.push_back(use);
    }
    faces.push_back(std::move(face));
  }
  if (gaps.size() != static_cast<Eigen::Index>(faces.size()))
    throw Error(ErrorCode::invalid_argument,
                fmt::format("'{}' has {} numbers for {} faces", path, gaps.size(), faces.size()));
  for (std::size_t f = 0; f < faces.size(); ++f) faces[f].gap = gaps[static_cast<Eigen::Index>(f)];
  return faces;
}

NumberList block_list(const HexTopology& topology) {
  NumberList list;
  for (const HexBlock& block : topology.blocks) {
    for (const HexVertexId id : block.vertices) list.add(id.value);
    for (const HexEdgeId id : block.edges) list.add(id.value);
    for (const HexFaceId id : block.faces) list.add(id.value);
  }
  return list;
}

std::vector<HexBlock> blocks_of(NumberList list) {
  std::vector<HexBlock> blocks;
  while (!list.at_end()) {
    HexBlock block;
    for (HexVertexId& id : block.vertices) id = HexVertexId(list.next());
    for (HexEdgeId& id : block.edges) id = HexEdgeId(list.next());
    for (HexFaceId& id : block.faces) id = HexFaceId(list.next());
    blocks.push_back(block);
  }
  return blocks;
}

/// Numbers with a fraction, one after the other.
struct Shares {
  std::vector<double> values;
  std::string path = {};
  std::size_t read = 0;

  double next() {
    if (read == values.size())
      throw Error(ErrorCode::invalid_argument, fmt::format("'{}' has too few numbers", path));
    return values[read++];
  }
  void add(const SideRectangle& rectangle) {
    values.insert(values.end(), rectangle.low.begin(), rectangle.low.end());
    values.insert(values.end(), rectangle.high.begin(), rectangle.high.end());
  }
  SideRectangle next_rectangle() {
    SideRectangle result;
    for (double& x : result.low) x = next();
    for (double& x : result.high) x = next();
    return result;
  }
};

Shares shares_at(const Hdf5Reader& file, const std::string& path) {
  const Eigen::VectorXd values = file.vector(path);
  return {{values.begin(), values.end()}, path};
}

void write_t_joints(Hdf5Writer& file, const std::string& group, const HexTopology& topology) {
  NumberList joints, splits;
  Shares outlines, shares;
  for (const TJoint& joint : topology.t_joints) {
    add(joints, joint.whole);
    joints.add(joint.parts.size());
    for (const SidePart& part : joint.parts) {
      add(joints, part.side);
      joints.add(part.outline.size(), part.piece.has_value(), part.rectangle.has_value());
      for (const auto& point : part.outline)
        outlines.values.insert(outlines.values.end(), point.begin(), point.end());
      if (part.piece) outlines.add(*part.piece);
      if (part.rectangle) outlines.add(*part.rectangle);
    }
  }
  for (const SplitEdge& split : topology.split_edges) {
    splits.add(split.edge.value, split.at.size());
    for (const EdgeSplit& at : split.at) {
      splits.add(at.vertex.value);
      shares.values.push_back(at.share);
    }
  }
  file.write(group + "/t_joints", joints.numbers());
  file.write(group + "/t_joint_outlines", outlines.values);
  file.write(group + "/split_edges", splits.numbers());
  file.write(group + "/split_shares", shares.values);
}

SidePart next_part(NumberList& joints, Shares& outlines) {
  SidePart part{next_side(joints)};
  // Its points are in the other list; without those `outlines` says so.
  const int points = std::max(0, joints.next());
  part.outline.resize(std::min(static_cast<std::size_t>(points), outlines.values.size()));
  const bool has_piece = joints.next_flag(), has_rectangle = joints.next_flag();
  for (auto& point : part.outline)
    for (double& x : point) x = outlines.next();
  if (has_piece) part.piece = outlines.next_rectangle();
  if (has_rectangle) part.rectangle = outlines.next_rectangle();
  return part;
}

void read_t_joints(const Hdf5Reader& file, const std::string& group, HexTopology& topology) {
  NumberList joints = list_at(file, group + "/t_joints"), splits = list_at(file, group + "/split_edges");
  Shares outlines = shares_at(file, group + "/t_joint_outlines"),
         shares = shares_at(file, group + "/split_shares");
  while (!joints.at_end()) {
    TJoint joint{next_side(joints), {}};
    const std::size_t parts = joints.next_count();
    for (std::size_t i = 0; i < parts; ++i) joint.parts.push_back(next_part(joints, outlines));
    topology.t_joints.push_back(std::move(joint));
  }
  while (!splits.at_end()) {
    SplitEdge split{HexEdgeId(splits.next()), {}};
    const std::size_t count = splits.next_count();
    for (std::size_t i = 0; i < count; ++i) {
      const HexVertexId vertex(splits.next());
      split.at.push_back({vertex, shares.next()});
    }
    topology.split_edges.push_back(std::move(split));
  }
}

}  // namespace

void write_hex_topology(Hdf5Writer& file, const std::string& group, const HexTopology& topology) {
  std::vector<double> gaps;
  for (const HexFace& face : topology.faces) gaps.push_back(face.gap);
  NumberList sheets;
  for (const Sheet& sheet : topology.sheets) sheets.add(sheet.symmetric);
  file.write(group + "/vertex_count", static_cast<std::int64_t>(topology.vertex_count));
  file.write(group + "/blocks", block_list(topology).numbers());
  file.write(group + "/edges", edge_list(topology).numbers());
  file.write(group + "/faces", face_list(topology).numbers());
  file.write(group + "/face_gaps", gaps);
  file.write(group + "/sheets", sheets.numbers());
  write_t_joints(file, group, topology);
}

HexTopology read_hex_topology(const Hdf5Reader& file, const std::string& group) {
  HexTopology topology;
  topology.vertex_count = NumberList({file.integer(group + "/vertex_count")}, group).next();
  topology.blocks = blocks_of(list_at(file, group + "/blocks"));
  topology.edges = edges_of(list_at(file, group + "/edges"));
  const std::string gaps = group + "/face_gaps";
  topology.faces = faces_of(list_at(file, group + "/faces"), file.vector(gaps), gaps);
  NumberList sheets = list_at(file, group + "/sheets");
  while (!sheets.at_end()) topology.sheets.push_back({sheets.next_flag()});
  read_t_joints(file, group, topology);
  validate(topology);
  return topology;
}

void write_block_faces(Hdf5Writer& file, const std::string& group, const BlockFaces& faces) {
  NumberList list;
  std::string texts;
  for (const auto& block : faces)
    for (const BlockFace& face : block) {
      list.add(face.solid, face.face.value, face.name.size(), face.colour.size());
      texts += face.name + face.colour;
    }
  file.write(group + "/faces", list.numbers());
  file.write(group + "/texts", texts);
}

BlockFaces read_block_faces(const Hdf5Reader& file, const std::string& group) {
  NumberList list = list_at(file, group + "/faces");
  const std::string texts = file.text(group + "/texts");
  std::size_t at = 0;
  const auto next_text = [&] {
    const int length = list.next();
    if (length < 0 || static_cast<std::size_t>(length) > texts.size() - at)
      throw Error(ErrorCode::invalid_argument, fmt::format("'{}/texts' is too short", group));
    at += static_cast<std::size_t>(length);
    return texts.substr(at - static_cast<std::size_t>(length), static_cast<std::size_t>(length));
  };
  BlockFaces faces;
  while (!list.at_end())
    for (BlockFace& face : faces.emplace_back()) {
      face.solid = list.next();
      face.face = FaceId(list.next());
      face.name = next_text();
      face.colour = next_text();
    }
  return faces;
}

}  // namespace isopatch::geometry
