// A whole run of the first example, its files read back by VTK and held against the stored solution.

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkGenericCell.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLMultiBlockDataReader.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/program.hpp"
#include "geometry/base/atomic_file.hpp"
#include "geometry/base/larger.hpp"
#include "geometry/quadrature.hpp"
#include "iga/result_file.hpp"

namespace isopatch::verification {
namespace {

using geometry::Parameter;

// VTK's own evaluation of a field of a cell at parameters in [0, 1]^3.
Eigen::VectorXd evaluate(vtkUnstructuredGrid* grid, vtkIdType index, const Parameter<3>& t,
                         const char* field) {
  vtkNew<vtkGenericCell> cell;
  grid->GetCell(index, cell);
  std::vector<double> basis(static_cast<std::size_t>(cell->GetNumberOfPoints()));
  Eigen::Vector3d place;
  int sub_cell = 0;
  cell->EvaluateLocation(sub_cell, t.data(), place.data(), basis.data());
  if (!field) return place;
  vtkDataArray* values = grid->GetPointData()->GetArray(field);
  Eigen::VectorXd result = Eigen::VectorXd::Zero(values->GetNumberOfComponents());
  for (std::size_t i = 0; i < basis.size(); ++i)
    for (Eigen::Index c = 0; c < result.size(); ++c)
      result[c] +=
          basis[i] * values->GetComponent(cell->GetPointId(static_cast<vtkIdType>(i)), static_cast<int>(c));
  return result;
}

// Parameter of the patch at parameters of its element, elements counted with the first direction fastest.
Parameter<3> in_patch(const geometry::NurbsVolume& patch, int element, const Parameter<3>& t) {
  Parameter<3> result;
  for (int d = 0; d < 3; ++d) {
    const auto breaks = patch.knots(d).breaks();
    const auto e = static_cast<std::size_t>(element % patch.knots(d).element_count());
    element /= patch.knots(d).element_count();
    result[d] = breaks[e] + t[d] * (breaks[e + 1] - breaks[e]);
  }
  return result;
}

class ParaviewFields : public ::testing::Test {
 protected:
  void SetUp() override {
    directory = std::filesystem::path(::testing::TempDir()) / "isopatch_paraview_fields";
    std::ostringstream out, err;
    const std::string study = std::string(ISOPATCH_SOURCE_DIR) + "/examples/link/study.toml";
    ASSERT_EQ(app::run_program({"run", study, "--output", directory.string(), "--quiet"}, {out, err}), 0)
        << err.str();
  }
  void TearDown() override { std::filesystem::remove_all(directory); }
  std::filesystem::path directory;
};

TEST_F(ParaviewFields, AreTheSolutionWhenVtkReadsThem) {
  const iga::ElasticField field = iga::read_result(directory / "results.h5").field;
  vtkNew<vtkXMLMultiBlockDataReader> reader;
  reader->SetFileName((directory / "results.vtm").c_str());
  reader->Update();
  auto* blocks = vtkMultiBlockDataSet::SafeDownCast(reader->GetOutput());
  ASSERT_EQ(blocks->GetNumberOfBlocks(), field.patches.size());
  const auto rule = geometry::gauss_legendre(4);
  const Parameter<3> anywhere(0.17, 0.62, 0.88);
  const Parameter<3> gauss(rule.nodes[0], rule.nodes[2], rule.nodes[3]);
  double largest = 0;
  for (unsigned p = 0; p < blocks->GetNumberOfBlocks(); ++p) {
    auto* grid = vtkUnstructuredGrid::SafeDownCast(blocks->GetBlock(p));
    const geometry::NurbsVolume& patch = field.patches[p];
    ASSERT_EQ(grid->GetNumberOfCells(), 8);
    EXPECT_EQ(grid->GetCellData()->GetArray("patch")->GetTuple1(0), p);
    for (int element = 0; element < 8; ++element) {
      const iga::FieldValues exact =
          iga::evaluate(field, static_cast<int>(p), in_patch(patch, element, anywhere));
      EXPECT_LT((evaluate(grid, element, anywhere, nullptr) - exact.place).norm(), 1e-8 * 0.1);
      EXPECT_LT((evaluate(grid, element, anywhere, "displacement") - exact.displacement).norm(),
                1e-8 * 5.8e-4);
      const iga::FieldValues at = iga::evaluate(field, static_cast<int>(p), in_patch(patch, element, gauss));
      const Eigen::VectorXd stress = evaluate(grid, element, gauss, "stress");
      const Eigen::Vector3d normal(stress[0], stress[1], stress[2]);
      EXPECT_LT((normal - at.stress.diagonal()).norm(), 1e-8 * 3.4e8);
      EXPECT_LT((Eigen::Vector3d(stress[3], stress[4], stress[5]) -
                 Eigen::Vector3d(at.stress(0, 1), at.stress(1, 2), at.stress(0, 2)))
                    .norm(),
                1e-8 * 3.4e8);
      EXPECT_NEAR(evaluate(grid, element, gauss, "von_mises")[0], at.von_mises, 1e-8 * 3.4e8);
      EXPECT_NEAR(evaluate(grid, element, gauss, "jacobian")[0] / at.jacobian, 1, 1e-8);
      for (int q = 0; q < 64; ++q) {
        const Parameter<3> point(rule.nodes[q % 4], rule.nodes[q / 4 % 4], rule.nodes[q / 16]);
        largest = larger(largest, evaluate(grid, element, point, "von_mises")[0]);
      }
    }
  }
  const auto summary = nlohmann::json::parse(read_file(directory / "summary.json"));
  EXPECT_NEAR(largest / summary["results"]["max_von_mises"].get<double>(), 1, 1e-8);
}

}  // namespace
}  // namespace isopatch::verification
