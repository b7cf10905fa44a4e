#include <gtest/gtest.h>
#include <unistd.h>

#include <array>
#include <functional>
#include <random>

#include "geometry/base/atomic_file.hpp"
#include "geometry/io/hdf5_reader.hpp"
#include "geometry/io/hdf5_writer.hpp"
#include "geometry/io/read_gismo_solid.hpp"
#include "geometry/io/read_obj.hpp"
#include "geometry/io/read_off.hpp"
#include "geometry/io/read_patches.hpp"
#include "geometry/io/read_ply.hpp"
#include "geometry/io/read_stl.hpp"
#include "geometry/io/tests/sample_patches.hpp"
#include "geometry/io/write_gismo_xml.hpp"

namespace isopatch::geometry {
namespace {

const std::string g2_seed =
    "700 1 0 0\n3 1\n2 2\n0 0 1 1\n3 3\n0 0 0 1 1 1\n2 2\n0 0 1 1\n"
    "0 0 0 1\n1 0 0 1\n0 .5 0 1\n.5 .5 0 .5\n0 1 0 1\n1 1 0 1\n0 0 1 1\n1 0 1 1\n0 .5 1 1\n.5 .5 1 .5\n0 1 1 "
    "1\n1 1 1 1\n";

const std::string mfem_head =
    "MFEM NURBS mesh v1.0\n# two\ndimension\n3\nelements\n2\n1 5 0 1 4 5 6 7 10 11\n2 5 1 2 3 4 7 8 9 10\n"
    "boundary\n2\n3 3 5 4 1 0\n-1 3 2 3 9 8\n";

const std::string mfem_seed =
    mfem_head +
    "edges\n20\n0 0 1\n0 5 4\n0 6 7\n0 11 10\n1 1 2\n1 4 3\n1 7 8\n1 10 9\n2 0 5\n2 1 4\n2 2 3\n2 6 11\n2 7 "
    "10\n"
    "2 8 9\n3 0 6\n3 1 7\n3 2 8\n3 3 9\n3 4 10\n3 5 11\nvertices\n12\nknotvectors\n4\n1 3 0 0 .5 1 1\n"
    "1 2 0 0 1 1\n1 2 0 0 1 1\n1 2 0 0 1 1\nweights\n1 1 1 1 1 1 1 1 1 1 1 1 1 1 1 1\n"
    "FiniteElementSpace\nFiniteElementCollection: NURBS1\nVDim: 3\nOrdering: 1\n"
    "0 0 0 4 0 0 8 0 0 8 1 0 4 1 0 0 1 0 0 0 1 4 0 1 8 0 1 8 1 1 4 1 1 0 1 1 2 0 0 2 1 0 2 0 1 2 1 1\n";

const std::string mfem_spacing_seed = replaced(replaced(mfem_seed, "v1.0", "v1.1"), "weights\n",
                                               "spacing\n2\n0 1 2 3 4 5 .1 .2 .3\n2 0 0 0\nweights\n");

const std::string mfem_patch_seed =
    mfem_head +
    "edges\n0\nvertices\n12\npatches\nknotvectors\n3\n1 2 0 0 1 1\n1 2 0 0 1 1\n1 2 0 0 1 1\ndimension\n3\n"
    "controlpoints_cartesian\n0 0 0 1\n1 0 0 1\n0 1 0 1\n1 1 0 1\n0 0 1 1\n1 0 1 1\n0 1 1 1\n1 1 1 1\n"
    "knotvectors\n3\n1 2 0 0 1 1\n1 2 0 0 1 1\n1 2 0 0 1 1\ndimension\n3\ncontrolpoints\n"
    "1 0 0 1\n2 0 0 1\n1 1 0 1\n2 1 0 1\n1 0 1 1\n2 0 1 1\n1 1 1 1\n2 1 1 1\n";

std::string xml_seed() {
  const NurbsVolume cube = cube_at(0, 0, 0);
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(8);
  weights[3] = 0.5;
  PatchSet set{{cube, NurbsVolume(cube.knots(), cube.control_points(), weights)}, {}, {}};
  set.boundaries.push_back({"a & b", {{PatchId(0), Side::back}}});
  return replaced(to_gismo_xml(set), "  <boundary",
                  "  <interfaces>0 2 1 1 0 1 2 1 1 1\n</interfaces><!-- x -->\n  <boundary");
}

const std::string base64_seed =
    "<xml><Geometry type=\"TensorBSpline3\"><Basis>"
    "<Basis><KnotVector degree=\"1\" format=\"B64Float32\">AAAAAAAAAAAAAIA/AACAPw==</KnotVector></Basis>"
    "<Basis><KnotVector degree=\"1\" format=\"b64int16\">AAAAAAEAAQA=</KnotVector></Basis>"
    "<Basis><KnotVector degree=\"1\">0 0 1 1</KnotVector></Basis></Basis>"
    "<coefs geoDim=\"3\" "
    "format=\"B64Int16\">AAAAAAAAAQAAAAAAAAABAAAAAQABAAAAAAAAAAEAAQAAAAEAAAABAAEAAQABAAEA</coefs>"
    "</Geometry></xml>";

const std::string off_seed =
    "OFF\n# a tetrahedron\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1e0\n3 0 2 1\n3 0 1 3 255 0 0\n3 1 2 3\n3 2 0 3\n";

const std::string gismo_solid_seed =
    "<xml><TrimSurface id=\"7\"><Geometry type=\"TensorBSpline2\"><Basis type=\"TensorBSplineBasis2\">"
    "<Basis index=\"0\"><KnotVector degree=\"1\">0 0 1 1</KnotVector></Basis>"
    "<Basis index=\"1\"><KnotVector degree=\"1\">0 0 1 1</KnotVector></Basis></Basis>"
    "<coefs geoDim=\"3\">0 0 0 2 0 0 0 2 0 2 2 1</coefs></Geometry><PlanarDomain><CurveLoop>"
    "<Geometry type=\"BSpline\"><Basis><KnotVector degree=\"1\">0 0 .5 .5 1 1</KnotVector></Basis>"
    "<coefs geoDim=\"2\">0 0 .25 0 .25 0 1 0</coefs></Geometry></CurveLoop></PlanarDomain></TrimSurface>"
    "<Solid><Vertex>0 0 0 1 0 0 0 1 0 0 0 -1/2</Vertex><Face>3 0 2 1 7\n3 0 1 3 -1\n3 1 2 3 7\n3 2 0 3 "
    "7</Face>"
    "<Volume>4 3 0 1 2\n2 1 0</Volume></Solid></xml>";

// Broken versions of a text: bytes changed, pieces cut out, repeated or moved, numbers replaced.
class Mutator {
 public:
  explicit Mutator(unsigned seed) : random_(seed) {}

  std::string operator()(std::string text) {
    for (int round = integer(1, 4); round > 0 && !text.empty(); --round) text = once(std::move(text));
    return text;
  }

 private:
  int integer(int low, int high) { return std::uniform_int_distribution(low, high)(random_); }
  std::size_t below(std::size_t end) {
    return std::uniform_int_distribution<std::size_t>(0, end - 1)(random_);
  }

  std::string once(std::string text) {
    const std::size_t at = below(text.size());
    const std::size_t length = 1 + below(std::min<std::size_t>(40, text.size() - at));
    switch (integer(0, 6)) {
      case 0:
        text[at] = static_cast<char>(integer(0, 255));
        return text;
      case 1:
        return text.erase(at, length);
      case 2:
        return text.insert(at, text.substr(at, length));
      case 3:
        return text.insert(below(text.size()), text.substr(at, length));
      case 4:
        return text.substr(0, at);
      default:
        return with_number(std::move(text), at);
    }
  }

  std::string with_number(std::string text, std::size_t at) {
    static const std::array<const char*, 22> numbers = {"1e999",       "-1",
                                                        "99999999999", "0",
                                                        "1",           "2",
                                                        "3",           "nan",
                                                        "-inf",        "1e-999",
                                                        "2147483647",  "-2147483648",
                                                        "100000000",   "99999999",
                                                        "20",          "21",
                                                        "0x10",        "1e308",
                                                        "4294967297",  "",
                                                        "12 12",       "18446744073709551616"};
    const std::size_t begin = text.find_first_of("0123456789", at);
    if (begin == text.npos) return text;
    const std::size_t end = std::min(text.find_first_not_of("0123456789.", begin), text.size());
    return text.replace(begin, end - begin, numbers[below(numbers.size())]);
  }

  std::mt19937 random_;
};

struct Tally {
  int read = 0;
  int refused = 0;
};

using Reader = std::function<bool(std::string_view, const std::string&)>;  // whether anything was in the text

bool patches(std::string_view text, const std::string& source) {
  return !read_patches(text, source).patches.empty();
}
bool polyhedron(std::string_view text, const std::string& source) {
  return read_off(text, source).faces.size() < 1e6;
}
bool solid(std::string_view text, const std::string& source) {
  return !read_gismo_solids(text, source).empty();
}

bool stl(std::string_view text, const std::string& source) {
  return read_stl(text, source).vertices.allFinite();
}
bool obj(std::string_view text, const std::string& source) {
  return read_obj(text, source).vertices.allFinite();
}
bool ply(std::string_view text, const std::string& source) {
  return read_ply(text, source).vertices.allFinite();
}

const std::string stl_seed =
    "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1.5 0 0\nvertex 0 2.25 "
    "0\nendloop\nendfacet\nendsolid a\n";
const std::string obj_seed =
    "v 0 0 0\nv 1 0 0\nv 1 1 .5\nv 0 1 0\nvn 0 0 1\nf 1/1/1 2//1 3/1 4\nf -4 -3 \\\n -2\n";
const std::string ply_seed =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty double z\nelement "
    "face 2\n"
    "property list uchar int vertex_indices\nend_header\n0 0 0\n1.5 0 0\n0 2.25 0\n0 0 1\n3 0 1 2\n4 0 1 2 "
    "3\n";

struct Seed {
  const char* name;
  std::string text;
  Reader read = patches;
};

// Anything but an Error escapes and fails the test.
Tally read_mutants(const Seed& seed, int count) {
  EXPECT_EQ(error_of([&] { seed.read(seed.text, "seed"); }), "no error");
  Tally tally;
  for (int n = 0; n < count; ++n) {
    const std::string text = Mutator(static_cast<unsigned>(n))(seed.text);
    try {
      EXPECT_TRUE(seed.read(text, "mutant"));
      ++tally.read;
    } catch (const Error& error) {
      EXPECT_TRUE(error.code() == ErrorCode::bad_format || error.code() == ErrorCode::unsupported)
          << error.what();
      EXPECT_TRUE(std::string(error.what()).starts_with("mutant:")) << error.what();
      ++tally.refused;
    }
  }
  return tally;
}

class BrokenFile : public testing::TestWithParam<Seed> {};

TEST_P(BrokenFile, GivesAnErrorAndNothingElse) {
  const Tally tally = read_mutants(GetParam(), 4000);
  // The mutator must reach both outcomes, or it tests nothing.
  EXPECT_GT(tally.read, 100);
  EXPECT_GT(tally.refused, 1000);
}

INSTANTIATE_TEST_SUITE_P(Fuzz, BrokenFile,
                         testing::Values(Seed{"gismo", xml_seed()}, Seed{"g2", g2_seed},
                                         Seed{"mfem", mfem_seed}, Seed{"mfem_patches", mfem_patch_seed},
                                         Seed{"mfem_spacing", mfem_spacing_seed},
                                         Seed{"gismo_base64", base64_seed}, Seed{"off", off_seed, polyhedron},
                                         Seed{"stl", stl_seed, stl}, Seed{"obj", obj_seed, obj},
                                         Seed{"ply", ply_seed, ply},
                                         Seed{"gismo_solid", gismo_solid_seed, solid}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST(Fuzz, DamagedHdf5FilesGiveErrorsAndNothingElse) {
  Hdf5Writer writer;
  writer.write("/a/points", Eigen::MatrixXd(Eigen::MatrixXd::Random(3, 20)));
  writer.write("/a/numbers", std::vector<std::int64_t>{1, 2, 3});
  writer.write("/title", "text");
  const std::string seed = writer.image();
  const auto path = std::filesystem::temp_directory_path() / fmt::format("isopatch_fuzz_{}.h5", ::getpid());
  int refused = 0;
  for (int n = 0; n < 60; ++n) {
    write_file(path, Mutator(static_cast<unsigned>(n))(seed));
    try {
      const Hdf5Reader reader(path);
      reader.matrix("/a/points");
      reader.integers("/a/numbers");
      reader.text("/title");
    } catch (const Error& error) {
      ++refused;
    }
  }
  EXPECT_GT(refused, 10);
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace isopatch::geometry
