#include <gtest/gtest.h>

#include <fmt/format.h>
#include <unistd.h>
#include <cstring>
#include <filesystem>

#include "geometry/base/atomic_file.hpp"

#include "geometry/base/tests/expect_error.hpp"
#include "geometry/io/coordinate_grain.hpp"
#include "geometry/io/read_obj.hpp"
#include "geometry/io/read_ply.hpp"
#include "geometry/io/read_stl.hpp"
#include "geometry/io/read_triangles.hpp"

namespace isopatch::geometry {
namespace {

const std::string one_facet =
    "  facet normal 0 0 1\n    outer loop\n      vertex 0 0 0\n      vertex 1.5 0 0\n      vertex 0 2.25 0\n "
    "   endloop\n  endfacet\n";
const std::string text_stl = "solid a part\n" + one_facet + "endsolid a part\n";

Eigen::Matrix3d corners(const TriangleMesh& mesh, Eigen::Index t) {
  Eigen::Matrix3d result;
  for (int i = 0; i < 3; ++i) result.col(i) = mesh.vertices.col(mesh.triangles(i, t));
  return result;
}

Eigen::Matrix3d wanted() {
  Eigen::Matrix3d result;
  result << 0, 1.5, 0, 0, 0, 2.25, 0, 0, 0;
  return result;
}

TEST(Stl, TextIsReadWhateverItsLetters) {
  std::string capitals = text_stl;
  for (char& c : capitals) c = static_cast<char>(std::toupper(c));
  for (const std::string& text : {text_stl, capitals, "\n  " + text_stl,
                                  "solid\n" + one_facet + one_facet + "endsolid\nsolid b\nendsolid"}) {
    const TriangleMesh mesh = read_stl(text, "a.stl");
    ASSERT_GE(mesh.triangles.cols(), 1);
    EXPECT_EQ(corners(mesh, 0), wanted());
  }
}

TEST(Stl, BinaryIsKnownByItsLengthEvenIfItBeginsWithSolid) {
  std::string binary = to_stl(read_stl(text_stl, "a.stl"));
  EXPECT_EQ(binary.size(), 80 + 4 + 50u);
  EXPECT_EQ(corners(read_stl(binary, "b.stl"), 0), wanted());
  binary.replace(0, 5, "solid");
  EXPECT_EQ(corners(read_stl(binary, "b.stl"), 0), wanted());
  // What some programs append is theirs.
  EXPECT_EQ(corners(read_stl(to_stl(read_stl(text_stl, "a.stl")) + "more", "b.stl"), 0), wanted());
}

TEST(Stl, RoundTripKeepsNumbersOf32Bits) {
  TriangleMesh mesh = read_stl(text_stl, "a.stl");
  mesh.vertices.array() += 1.0 / 3;
  const TriangleMesh back = read_stl(to_stl(mesh), "b.stl");
  EXPECT_EQ(back.vertices, mesh.vertices.cast<float>().cast<double>());
  // A step of numbers of 32 bits at 2.58 is 2.4e-7.
  EXPECT_NEAR(back.grain, 3.1e-7, 1e-8);
}

TEST(Stl, BrokenFilesAreRefused) {
  EXPECT_ERROR(read_stl("", "a.stl"), ErrorCode::bad_format, "cut off");
  EXPECT_ERROR(read_stl(text_stl.substr(0, 60), "a.stl"), ErrorCode::bad_format, "a.stl:");
  EXPECT_ERROR(read_stl("solid\nfacet normal 0 0 1\nouter loop\nvertex 0 x 0", "a.stl"),
               ErrorCode::bad_format, "a.stl:4: ");
  EXPECT_ERROR(read_stl("solid\nfacet normal 0 0 1\nvertex", "a.stl"), ErrorCode::bad_format, "'outer'");
  const std::string binary = to_stl(read_stl(text_stl, "a.stl"));
  EXPECT_ERROR(read_stl(binary.substr(0, 120), "b.stl"), ErrorCode::bad_format, "cut off");
  std::string infinite = binary;
  const float value = INFINITY;
  std::memcpy(infinite.data() + 100, &value, 4);
  EXPECT_ERROR(read_stl(infinite, "b.stl"), ErrorCode::bad_format, "triangle 0 is not finite");
}

TEST(CoordinateGrain, IsTheLastDigitOfTheLargestCoordinate) {
  const auto step = [](std::initializer_list<std::pair<const char*, double>> words) {
    CoordinateGrain grain;
    for (const auto& [word, value] : words) grain.add(word, value);
    return grain.step();
  };
  EXPECT_NEAR(step({{"123.456", 123.456}, {"0.000789012", 0.000789012}}), 1e-3, 1e-9);  // six digits
  EXPECT_NEAR(step({{"0.5", 0.5}, {"123.456789", 123.456789}}), 1e-6, 1e-12);           // six decimals
  EXPECT_NEAR(step({{"3.832020e+001", 38.3202}}), 1e-5, 1e-11);
  EXPECT_LT(step({{"22.4999999999998", 22.4999999999998}}), 1e-12);
}

TEST(Obj, PolygonsAreDividedAndCountedFromEitherEnd) {
  const std::string text =
      "# a comment\nmtllib x.mtl\no part\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvn 0 0 1\nvt 0 0\ns off\nf "
      "1/1/1 2//1 3/1 4\nf -4 -3 \\\n -2\n";
  const TriangleMesh mesh = read_obj(text, "a.obj");
  ASSERT_EQ(mesh.triangles.cols(), 3);
  EXPECT_NEAR(area(mesh), 1.5, 1e-15);
  EXPECT_EQ(mesh.triangles.col(2), Eigen::Vector3i(0, 1, 2));
}

TEST(Obj, BrokenFilesAreRefused) {
  const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
  EXPECT_ERROR(read_obj(square + "f 1 2", "a.obj"), ErrorCode::bad_format, "a.obj:4: a face of fewer");
  EXPECT_ERROR(read_obj(square + "f 1 2 4\n", "a.obj"), ErrorCode::bad_format,
               "a.obj:4: there is no vertex 4");
  EXPECT_ERROR(read_obj(square + "f 1 2 0\n", "a.obj"), ErrorCode::bad_format, "no vertex");
  EXPECT_ERROR(read_obj(square + "f 1 2 -4\n", "a.obj"), ErrorCode::bad_format, "beyond the first");
  EXPECT_ERROR(read_obj("v 0 0\n", "a.obj"), ErrorCode::bad_format, "a.obj:");
}

const std::string ply_head =
    "comment by hand\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty uchar "
    "red\n"
    "element face 1\nproperty list uchar int vertex_indices\nend_header\n";

template <class Number>
void put(std::string& text, Number number, bool swapped) {
  std::string bytes(sizeof number, '\0');
  std::memcpy(bytes.data(), &number, sizeof number);
  if (swapped) std::reverse(bytes.begin(), bytes.end());
  text += bytes;
}

std::string binary_ply(bool big) {
  std::string text = fmt::format("ply\nformat binary_{}_endian 1.0\n", big ? "big" : "little") + ply_head;
  for (int i = 0; i < 3; ++i) {
    for (int d = 0; d < 3; ++d) put(text, static_cast<float>(wanted()(d, i)), big);
    text += '\7';
  }
  text += '\3';
  for (int i = 0; i < 3; ++i) put(text, i, big);
  return text;
}

TEST(Ply, TextAndBothByteOrdersAreTheSame) {
  const std::string text =
      "ply\nformat ascii 1.0\n" + ply_head + "0 0 0 255\n1.5 0 0 1\n0 2.25 0 1\n3 0 1 2\n";
  for (const std::string& file : {text, binary_ply(false), binary_ply(true)})
    EXPECT_EQ(corners(read_ply(file, "a.ply"), 0), wanted());
}

/// Bytes of a number of one of the format's types; each of them holds -1 or the largest of unsigned ones.
std::string bytes_of(const std::string& type, double value, bool big) {
  std::string text;
  if (type == "char") put(text, static_cast<std::int8_t>(value), big);
  if (type == "uchar") put(text, static_cast<std::uint8_t>(value), big);
  if (type == "int16") put(text, static_cast<std::int16_t>(value), big);
  if (type == "ushort") put(text, static_cast<std::uint16_t>(value), big);
  if (type == "int") put(text, static_cast<std::int32_t>(value), big);
  if (type == "uint32") put(text, static_cast<std::uint32_t>(value), big);
  if (type == "float32") put(text, static_cast<float>(value), big);
  if (type == "double") put(text, value, big);
  return text;
}

TEST(Ply, NumbersOfEveryTypeAreRead) {
  const std::vector<std::pair<const char*, double>> types = {
      {"char", -127},  {"uchar", 254},         {"int16", -32767},  {"ushort", 65534},
      {"int", -70000}, {"uint32", 4294967295}, {"float32", -0.25}, {"double", 1. / 3}};
  for (const bool big : {false, true})
    for (const auto& [type, value] : types) {
      const bool signless = value > 200;
      std::string text = fmt::format(
          "ply\nformat binary_{}_endian 1.0\nelement vertex 3\nproperty {} x\nproperty char y\nproperty "
          "char z\nelement face 1\nproperty list {} {} vertex_index\nend_header\n",
          big ? "big" : "little", type, type, signless ? type : "uint32");
      for (const double x : {0.0, 1.0, value})
        text += bytes_of(type, x, big) + bytes_of("char", x == 1 ? 1 : 0, big) + bytes_of("char", -2, big);
      text += bytes_of(type, 3, big);
      for (const double corner : {0, 1, 2}) text += bytes_of(signless ? type : "uint32", corner, big);
      const TriangleMesh mesh = read_ply(text, "a.ply");
      EXPECT_EQ(mesh.vertices(0, 2), value) << type << big;
      EXPECT_EQ(mesh.vertices.row(2), Eigen::RowVector3d(-2, -2, -2)) << type << big;
      EXPECT_EQ(mesh.triangles.col(0), Eigen::Vector3i(0, 1, 2)) << type << big;
    }
}

TEST(Ply, BrokenFilesAreRefused) {
  EXPECT_ERROR(read_ply("ply\nformat ascii 1.0\n", "a.ply"), ErrorCode::bad_format, "end_header");
  EXPECT_ERROR(read_ply("ply\nformat other 1.0\n" + ply_head, "a.ply"), ErrorCode::bad_format, "no format");
  EXPECT_ERROR(read_ply("ply\nformat ascii 1.0\nelement vertex 1\nproperty short4 x\nend_header\n", "a.ply"),
               ErrorCode::bad_format, "no type");
  const std::string binary = binary_ply(false);
  EXPECT_ERROR(read_ply(binary.substr(0, binary.size() - 2), "a.ply"), ErrorCode::bad_format, "cut off");
  const std::string text = "ply\nformat ascii 1.0\n" + ply_head + "0 0 0 255\n1.5 0 0 1\n0 2.25 0 1\n";
  EXPECT_ERROR(read_ply(text + "3 0 1 3\n", "a.ply"), ErrorCode::bad_format, "no vertex 3");
  EXPECT_ERROR(read_ply(text + "2 0 1\n", "a.ply"), ErrorCode::bad_format, "fewer than three");
  EXPECT_ERROR(read_ply(text + "3 0 -1 2\n", "a.ply"), ErrorCode::bad_format, "face 0 has a corner -1");
  EXPECT_ERROR(read_ply(text + "-3 0 1 2\n", "a.ply"), ErrorCode::bad_format,
               "a list of -3 numbers in face 0");
  EXPECT_ERROR(read_ply(text + "1e9 0 1 2\n", "a.ply"), ErrorCode::bad_format,
               "a list of 1000000000 numbers");
  EXPECT_ERROR(read_ply("ply\nformat ascii 1.0\nproperty int x\nend_header\n", "a.ply"),
               ErrorCode::bad_format, "a property before the first element");
  EXPECT_ERROR(read_ply("ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\nproperty int y\n"
                        "end_header\n1 2\n",
                        "a.ply"),
               ErrorCode::bad_format, "vertices have no z");
}

TEST(TriangleFiles, AreReadByTheirEnding) {
  const std::string folder = testing::TempDir() + fmt::format("isopatch_triangles_{}", ::getpid());
  std::filesystem::create_directory(folder);
  const std::vector<std::pair<const char*, std::string>> files = {
      {"a.stl", text_stl},
      {"a.OBJ", "v 0 0 0\nv 1.5 0 0\nv 0 2.25 0\nf 1 2 3\n"},
      {"a.ply", binary_ply(true)},
      {"a.off", "OFF\n3 1 3\n0 0 0\n1.5 0 0\n0 2.25 0\n3 0 1 2\n"}};
  for (const auto& [name, text] : files) {
    const std::filesystem::path path = std::filesystem::path(folder) / name;
    write_file(path, text);
    EXPECT_EQ(corners(read_triangles(path).mesh, 0), wanted()) << name;
  }
  // An L of six corners is four triangles, behind a triangle; numbers are as exact as written.
  const std::filesystem::path concave = std::filesystem::path(folder) / "l.off";
  write_file(concave, "OFF\n6 2 6\n0 0 0\n2 0 0\n2 1 0\n1 1 0\n1 2 0\n0 2 0\n3 0 1 2\n6 0 1 2 3 4 5\n");
  const TriangleMesh mesh = read_triangles(concave).mesh;
  ASSERT_EQ(mesh.triangles.cols(), 5);
  EXPECT_EQ(mesh.triangles.col(0), Eigen::Vector3i(0, 1, 2));
  EXPECT_NEAR(area(mesh), 1 + 3, 1e-14);
  EXPECT_LT(mesh.grain, 1e-15);
  std::filesystem::remove_all(folder);
}

TEST(TriangleFiles, AreKnownByTheirEnding) {
  EXPECT_TRUE(is_triangle_file("a/b.STL"));
  EXPECT_TRUE(is_triangle_file("b.ply"));
  EXPECT_FALSE(is_triangle_file("b.off"));
  EXPECT_ERROR(read_triangles("b.step"), ErrorCode::unsupported, ".stl");
  EXPECT_ERROR(read_triangles("absent.stl"), ErrorCode::io, "absent.stl");
}

TEST(CoordinateGrain, OfRoundNumbersIsRoundOff) {
  CoordinateGrain round;
  for (const auto& [word, value] : {std::pair("0", 0.0), std::pair("1", 1.0), std::pair("20.5", 20.5)})
    round.add(word, value);
  EXPECT_LT(round.step(), 1e-14);
  round.add("3.14159", 3.14159);
  EXPECT_NEAR(round.step(), 1e-4, 1e-12);  // of six digits of 20.5
}

}  // namespace
}  // namespace isopatch::geometry
