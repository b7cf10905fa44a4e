#include "geometry/io/hdf5_connections.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/io/tests/sample_patches.hpp"

namespace isopatch::geometry {
namespace {

class Hdf5Connections : public testing::Test {
 protected:
  ~Hdf5Connections() override { std::filesystem::remove(path_); }
  PatchConnections stored(const Hdf5Writer& writer) const {
    write_file(path_, writer.image());
    return read_connections(Hdf5Reader(path_), "/model");
  }
  std::filesystem::path path_ =
      std::filesystem::temp_directory_path() / fmt::format("isopatch_connections_{}.h5", ::getpid());
};

PatchConnections sample_connections() {
  PatchConnections result;
  result.interfaces = {{{PatchId(0), Side::east}, {PatchId(1), Side::north}, {true, false, true}, 1e-9},
                       {{PatchId(1), Side::front}, {PatchId(2), Side::back}, {false, true, false}, 3e-7}};
  result.boundaries = {{"a \"b\"", {{PatchId(2), Side::west}, {PatchId(0), Side::south}}}, {"none", {}}};
  result.reversed = {false, true, false};
  result.tolerance = {2e-6, 3e-3, 1e-8};
  result.size = 1.0 / 3;
  return result;
}

TEST_F(Hdf5Connections, ComeBackWithEveryMember) {
  const PatchConnections given = sample_connections();
  Hdf5Writer writer;
  write_connections(writer, "/model", given);
  const PatchConnections found = stored(writer);
  EXPECT_EQ(found.interfaces, given.interfaces);
  ASSERT_EQ(found.boundaries.size(), 2u);
  for (std::size_t b = 0; b < 2; ++b) {
    EXPECT_EQ(found.boundaries[b].name, given.boundaries[b].name);
    EXPECT_EQ(found.boundaries[b].faces, given.boundaries[b].faces);
  }
  EXPECT_EQ(found.reversed, given.reversed);
  EXPECT_EQ(found.tolerance.same_point, 2e-6);
  EXPECT_EQ(found.tolerance.near_miss, 3e-3);
  EXPECT_EQ(found.tolerance.same_knot, 1e-8);
  EXPECT_EQ(found.size, 1.0 / 3);
}

TEST_F(Hdf5Connections, NumbersThatAreNoRecordsAreRefused) {
  Hdf5Writer torn;
  torn.write("/model/reversed", std::vector<std::int64_t>{0, 1, 0});
  torn.write("/model/interfaces", std::vector<std::int64_t>(8, 0));
  EXPECT_ERROR(stored(torn), ErrorCode::invalid_argument,
               "'/model/interfaces' has 8 numbers, which are no records of 7");
  Hdf5Writer gapless;
  gapless.write("/model/reversed", std::vector<std::int64_t>{0, 1, 0});
  gapless.write("/model/interfaces", std::vector<std::int64_t>(14, 0));
  gapless.write("/model/interface_gaps", std::vector<double>{1e-9});
  EXPECT_ERROR(stored(gapless), ErrorCode::bad_format, "'/model/interface_gaps' has 1 entries instead of 2");
}

}  // namespace
}  // namespace isopatch::geometry
