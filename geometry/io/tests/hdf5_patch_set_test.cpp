#include "geometry/io/hdf5_patch_set.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <random>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/io/tests/sample_patches.hpp"

namespace isopatch::geometry {
namespace {

class Hdf5PatchSet : public testing::Test {
 protected:
  ~Hdf5PatchSet() override { std::filesystem::remove(path_); }
  PatchSet stored(const PatchSet& set) const {
    Hdf5Writer writer;
    write_patch_set(writer, "/set", set);
    return stored(writer);
  }
  PatchSet stored(const Hdf5Writer& writer) const {
    write_file(path_, writer.image());
    return read_patch_set(Hdf5Reader(path_), "/set");
  }
  std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / fmt::format("isopatch_patch_set_{}.h5", ::getpid());
};

PatchSet sample_set() {
  std::mt19937 random(3);
  PatchSet set;
  for (int p = 0; p < 3; ++p) set.patches.push_back(random_patch(random));
  set.boundaries = {{"a \"b\"", {{PatchId(2), Side::back}, {PatchId(0), Side::west}}}, {"none", {}}};
  set.interfaces = {{{PatchId(0), Side::east}, {PatchId(1), Side::north}, {true, false, true}},
                    {{PatchId(1), Side::front}, {PatchId(2), Side::front}, {false, true, false}}};
  set.names = {"wheel", ""};
  return set;
}

TEST_F(Hdf5PatchSet, ComesBackAsTheSameValue) {
  const PatchSet set = sample_set();
  EXPECT_EQ(stored(set), set);
  EXPECT_EQ(stored(PatchSet{}), PatchSet{});
}

TEST_F(Hdf5PatchSet, DiffersByEachOfItsMembers) {
  const PatchSet set = sample_set();
  const auto differs = [&](auto change) {
    PatchSet other = set;
    change(other);
    return other != set && stored(other) == other;
  };
  EXPECT_TRUE(differs([](PatchSet& s) { s.patches.pop_back(); }));
  EXPECT_TRUE(differs([](PatchSet& s) { s.boundaries[0].faces[0].side = Side::front; }));
  EXPECT_TRUE(differs([](PatchSet& s) { s.boundaries[1].name = "all"; }));
  EXPECT_TRUE(differs([](PatchSet& s) { s.interfaces[1].orientation.flip_second = true; }));
  EXPECT_TRUE(differs([](PatchSet& s) { s.names[0] = "axle"; }));
  EXPECT_TRUE(differs([](PatchSet& s) {
    const NurbsVolume& patch = s.patches[0];
    s.patches[0] = NurbsVolume(patch.knots(), 2 * patch.control_points(), patch.weights());
  }));
}

TEST_F(Hdf5PatchSet, NumbersThatAreNoPatchesAreRefused) {
  const auto with = [&](const std::string& path, auto values) {
    Hdf5Writer writer;
    const std::string own = "/set/patches/";
    const auto write = [&](const std::string& name, auto usual) {
      if (own + name == path)
        writer.write(path, values);
      else
        writer.write(own + name, usual);
    };
    write("degrees", std::vector<std::int64_t>{1, 1, 1});
    write("knot_counts", std::vector<std::int64_t>{4, 4, 4});
    write("knots", std::vector<double>{0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1});
    write("weights", std::vector<double>(8, 1.0));
    write("control_points", NurbsVolume().control_points());
    for (const char* const list : {"/set/interfaces"}) writer.write(list, std::vector<std::int64_t>{});
    for (const char* const count : {"/set/boundary_count", "/set/name_count"})
      writer.write(count, std::int64_t{0});
    return stored(writer);
  };
  EXPECT_EQ(with("/none", 0.0).patches, std::vector{NurbsVolume()});
  EXPECT_ERROR(with("/set/patches/degrees", std::vector<std::int64_t>{1, 1}), ErrorCode::invalid_argument,
               "2 degrees");
  EXPECT_ERROR(with("/set/patches/degrees", std::vector<std::int64_t>{1, 1, -7}), ErrorCode::invalid_argument,
               "degree");
  EXPECT_ERROR(with("/set/patches/weights", std::vector<double>(7, 1.0)), ErrorCode::invalid_argument,
               "/set/patches/weights ends early");
  EXPECT_ERROR(with("/set/patches/weights", std::vector<double>(9, 1.0)), ErrorCode::invalid_argument,
               "9 columns, of which 8 belong to patches");
}

}  // namespace
}  // namespace isopatch::geometry
