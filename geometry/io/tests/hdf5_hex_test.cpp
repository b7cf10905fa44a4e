#include "geometry/io/hdf5_hex.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/error.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/hex/assemble_topology.hpp"

namespace isopatch::geometry {
namespace {

class Hdf5Hex : public testing::Test {
 protected:
  Hdf5Hex() : path_(std::filesystem::temp_directory_path() / fmt::format("isopatch_hex_{}.h5", ::getpid())) {}
  ~Hdf5Hex() override { std::filesystem::remove(path_); }

  Hdf5Reader stored(const Hdf5Writer& writer) const {
    write_file(path_, writer.image());
    return Hdf5Reader(path_);
  }
  std::filesystem::path path_;
};

/// A ring that closes with half a turn, and a T-joint at it.
HexTopology sample_complex() {
  HexContacts contacts;
  for (int b = 0; b < 4; ++b)
    contacts.sides.push_back({{BlockId(b), Side::east},
                              {BlockId((b + 1) % 4), Side::west},
                              {.flip_first = b == 3, .flip_second = b == 3},
                              1.0 / (3 + b)});
  HexTopology topology = assembled_topology(5, contacts);
  const BlockSide whole{BlockId(1), Side::north};
  topology.t_joints = {
      {whole,
       {{{BlockId(4), Side::south},
         {},
         {{0, 0}, {1.0 / 3, 0}, {1.0 / 3, 1}, {0, 1}},
         SideRectangle{{0, 0}, {1.0 / 3, 1}}},
        {{BlockId(3), Side::north}, SideRectangle{{0.5, 0}, {1, 1}}, {{0.9, 0.1}, {1, 0.2}, {0.8, 0.3}}}}}};
  // An outline of more points than the list of joints has numbers behind it.
  for (int i = 0; i < 16; ++i)
    topology.t_joints[0].parts[1].outline.push_back({0.5 + 0.4 * (i > 8), 0.03 * (16 - i)});
  topology.split_edges = {{HexEdgeId(7), {{HexVertexId(19), 0.1}, {HexVertexId(2), 0.7}}}};
  return topology;
}

TEST_F(Hdf5Hex, AComplexComesBackEqual) {
  const HexTopology topology = sample_complex();
  validate(topology);
  Hdf5Writer writer;
  write_hex_topology(writer, "/complex", topology);
  EXPECT_EQ(read_hex_topology(stored(writer), "/complex"), topology);
  EXPECT_NE(topology, HexTopology{});
}

TEST_F(Hdf5Hex, AnEmptyComplexComesBackEqual) {
  Hdf5Writer writer;
  write_hex_topology(writer, "/complex", {});
  EXPECT_EQ(read_hex_topology(stored(writer), "/complex"), HexTopology{});
}

TEST_F(Hdf5Hex, FacesOfSolidsComeBackEqual) {
  BlockFaces faces(2);
  for (std::size_t b = 0; b < 2; ++b)
    for (int side = 0; side < 6; ++side)
      faces[b][static_cast<std::size_t>(side)] = {static_cast<int>(b), FaceId(5 - side),
                                                  fmt::format("f{}", side)};
  faces[1][2].name = "B\xC3\xBChne:\n2";
  faces[1][2].colour = "#00ff7f";
  faces[0][0].name = "";
  Hdf5Writer writer;
  write_block_faces(writer, "/faces", faces);
  EXPECT_EQ(read_block_faces(stored(writer), "/faces"), faces);
}

TEST_F(Hdf5Hex, NumbersThatAreNoComplexAreRefused) {
  HexTopology broken = sample_complex();
  broken.blocks[2].edges[3] = HexEdgeId(5000);
  Hdf5Writer writer;
  write_hex_topology(writer, "/complex", broken);
  EXPECT_ERROR(read_hex_topology(stored(writer), "/complex"), ErrorCode::invalid_argument,
               "contradicts itself");
}

TEST_F(Hdf5Hex, ListsThatDoNotBelongTogetherAreRefused) {
  // The sample with one list that lacks its last number.
  const auto read_without_last_of = [&](const std::string& shorter) {
    Hdf5Writer sound;
    write_hex_topology(sound, "/complex", sample_complex());
    const Hdf5Reader file = stored(sound);
    Hdf5Writer writer;
    writer.write("/complex/vertex_count", file.integer("/complex/vertex_count"));
    for (const char* name : {"blocks", "edges", "faces", "sheets", "t_joints", "split_edges"}) {
      std::vector<std::int64_t> numbers = file.integers(std::string("/complex/") + name);
      if (name == shorter) numbers.pop_back();
      writer.write(std::string("/complex/") + name, numbers);
    }
    for (const char* name : {"face_gaps", "t_joint_outlines", "split_shares"}) {
      const Eigen::VectorXd values = file.vector(std::string("/complex/") + name);
      writer.write(std::string("/complex/") + name,
                   Eigen::VectorXd(values.head(values.size() - (name == shorter ? 1 : 0))));
    }
    return read_hex_topology(stored(writer), "/complex");
  };
  EXPECT_EQ(read_without_last_of("nothing"), sample_complex());
  for (const char* name : {"blocks", "edges", "faces", "t_joints", "split_edges"})
    EXPECT_ERROR(read_without_last_of(name), ErrorCode::invalid_argument,
                 fmt::format("'/complex/{}' ends within a record", name));
  EXPECT_ERROR(read_without_last_of("sheets"), ErrorCode::invalid_argument, "sheet is");
  EXPECT_ERROR(read_without_last_of("face_gaps"), ErrorCode::invalid_argument, "numbers for 26 faces");
  for (const char* name : {"t_joint_outlines", "split_shares"})
    EXPECT_ERROR(read_without_last_of(name), ErrorCode::invalid_argument,
                 fmt::format("'/complex/{}' has too few numbers", name));
}

TEST_F(Hdf5Hex, ListsThatEndWithinARecordAreRefused) {
  Hdf5Writer shorter;
  shorter.write("/faces/faces", std::vector<std::int64_t>{0, 1, 5});
  shorter.write("/faces/texts", "abc");
  EXPECT_ERROR(read_block_faces(stored(shorter), "/faces"), ErrorCode::invalid_argument, "too short");
}

}  // namespace
}  // namespace isopatch::geometry
