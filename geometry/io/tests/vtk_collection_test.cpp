#include "geometry/io/vtk_collection.hpp"

#include <gtest/gtest.h>
#include <vtkInformation.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLMultiBlockDataReader.h>

#include <filesystem>

#include "geometry/base/atomic_file.hpp"
#include "geometry/base/atomic_writer.hpp"
#include "geometry/base/error.hpp"
#include "geometry/base/tests/expect_error.hpp"
#include "geometry/io/vtu_file.hpp"

namespace isopatch::geometry {
namespace {

void write_cubes(const std::filesystem::path& path, int count) {
  AtomicWriter writer(path);
  VtuFile file(VtuCell::hexahedron, std::vector(static_cast<std::size_t>(count), VtuGrid{}), {}, {},
               [&](std::uint64_t place, std::string_view bytes) { writer.write_at(place, bytes); });
  file.points(0, Eigen::Matrix3Xd::Random(3, 8 * count));
  file.finish();
  writer.finish();
}

const char* name_of(vtkMultiBlockDataSet* blocks, unsigned index) {
  return blocks->GetMetaData(index)->Get(vtkCompositeDataSet::NAME());
}

TEST(VtkCollection, OpensItsFilesInGroups) {
  const auto folder = std::filesystem::temp_directory_path() / "isopatch_vtm_test";
  std::filesystem::create_directories(folder / "run");
  write_cubes(folder / "run/a.vtu", 4);
  write_cubes(folder / "run/b.vtu", 1);
  write_file(folder / "all.vtm", to_vtm({{"steel", {{"patch <0>", "run/a.vtu"}, {"patch 1", "run/b.vtu"}}},
                                         {"M\xC3\xBCsli & milk", {{"patch 2", "run/b.vtu"}}}}));
  vtkNew<vtkXMLMultiBlockDataReader> reader;
  reader->SetFileName((folder / "all.vtm").c_str());
  reader->Update();
  auto* groups = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutput());
  ASSERT_NE(groups, nullptr);
  ASSERT_EQ(groups->GetNumberOfBlocks(), 2u);
  EXPECT_STREQ(name_of(groups, 0), "steel");
  EXPECT_STREQ(name_of(groups, 1), "M\xC3\xBCsli & milk");
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(groups->GetBlock(0));
  ASSERT_NE(blocks, nullptr);
  ASSERT_EQ(blocks->GetNumberOfBlocks(), 2u);
  EXPECT_STREQ(name_of(blocks, 0), "patch <0>");
  EXPECT_EQ(vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(0))->GetNumberOfCells(), 4);
  EXPECT_EQ(vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(1))->GetNumberOfCells(), 1);
  std::filesystem::remove_all(folder);
  EXPECT_ERROR(to_vtm({{"a", {{"b", "/tmp/a.vtu"}}}}), ErrorCode::invalid_argument,
               "a relative path is needed");
}

}  // namespace
}  // namespace isopatch::geometry
