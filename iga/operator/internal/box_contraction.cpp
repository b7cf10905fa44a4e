#include "iga/operator/internal/box_contraction.hpp"

#include <algorithm>

namespace isopatch::iga {
namespace {

constexpr int value_kind = 0;
constexpr int derivative_kind = 1;

// How often direction d (1 .. 3) is differentiated in the product of derivatives i and j.
int order_along(int d, const std::array<int, 2>& kind) {
  return (kind[0] == d ? 1 : 0) + (kind[1] == d ? 1 : 0);
}

void grow(std::vector<Lanes>& buffer, std::ptrdiff_t size) {
  if (static_cast<std::ptrdiff_t>(buffer.size()) < size) buffer.resize(static_cast<std::size_t>(size));
}

// First function that lives on the elements begin .. end - 1, and how many do.
std::array<int, 2> function_range(const LineTable& table, int begin, int end) {
  const PointRun& low =
      table.runs[static_cast<std::size_t>(table.run_start[static_cast<std::size_t>(begin)])];
  const PointRun& high =
      table.runs[static_cast<std::size_t>(table.run_start[static_cast<std::size_t>(end)]) - 1];
  return {low.first, high.first + table.functions - low.first};
}

template <class Visit>
void for_each_run(const LineTable& table, int element, Visit visit) {
  const int begin = table.run_start[static_cast<std::size_t>(element)];
  const int end = table.run_start[static_cast<std::size_t>(element) + 1];
  const int first_point = table.runs[static_cast<std::size_t>(begin)].begin;
  for (int r = begin; r < end; ++r) {
    const PointRun& run = table.runs[static_cast<std::size_t>(r)];
    visit(run, run.begin - first_point);
  }
}

}  // namespace

ContractionStages field_stages(int fields, bool values) {
  const int f = fields;
  ContractionStages stages{2 * f, 3 * f, values ? 4 * f : 3 * f, {}, {}};
  stages.middle = {{0, 2 * f, value_kind, 0}, {0, f, derivative_kind, 2 * f}};
  const int skipped = values ? 0 : f;
  stages.last = {{skipped, 3 * f - skipped, value_kind, 0}, {0, f, derivative_kind, 3 * f - skipped}};
  return stages;
}

ContractionStages force_stages(bool values, int fields) {
  ContractionStages stages = field_stages(fields, values);
  for (std::vector<ContractionStep>* steps : {&stages.middle, &stages.last})
    for (ContractionStep& step : *steps) std::swap(step.from, step.to);
  return stages;
}

std::vector<std::array<int, 2>> square_kinds(bool values) {
  std::vector<std::array<int, 2>> kinds;
  for (int i = values ? 0 : 1; i <= 3; ++i)
    for (int j = i; j <= 3; ++j) kinds.push_back({i, j});
  return kinds;
}

ContractionStages square_stages(bool values) {
  constexpr int entries = 6;
  // Rows are told apart by the orders along directions 1 and 3, which are at most 2 together.
  constexpr std::array<std::array<int, 3>, 3> row_of = {{{0, 1, 2}, {3, 4, -1}, {5, -1, -1}}};
  ContractionStages stages{3 * entries, 6 * entries, 0, {}, {}};
  for (std::size_t o1 = 0; o1 < 3; ++o1)
    for (std::size_t o3 = 0; o1 + o3 < 3; ++o3)
      stages.middle.push_back(
          {entries * row_of[o1][o3], entries, static_cast<int>(o3), entries * static_cast<int>(o1)});
  for (const std::array<int, 2>& kind : square_kinds(values)) {
    const int row = row_of[static_cast<std::size_t>(order_along(1, kind))]
                          [static_cast<std::size_t>(order_along(3, kind))];
    stages.last.push_back({stages.point, entries, order_along(2, kind), entries * row});
    stages.point += entries;
  }
  return stages;
}

void BoxContraction::start(const LineTable& direction2, const LineTable& direction3,
                           const ContractionStages& stages, const ElementBox& box) {
  table2_ = &direction2;
  table3_ = &direction3;
  stages_ = &stages;
  const auto points_of_element = [](const LineTable& table) {
    return table.points() / (static_cast<int>(table.run_start.size()) - 1);
  };
  points2_ = points_of_element(direction2);
  points3_ = points_of_element(direction3);
  const auto [row, rows] = function_range(direction2, box.begin[1], box.end[1]);
  const auto [plane, planes] = function_range(direction3, box.begin[2], box.end[2]);
  first_row_ = row;
  rows_ = rows;
  first_plane_ = plane;
  planes_count_ = planes;
  grow(planes_, static_cast<std::ptrdiff_t>(planes) * rows * stages.plane);
  grow(rows_buffer_, static_cast<std::ptrdiff_t>(rows) * points3_ * stages.row);
  grow(points_, static_cast<std::ptrdiff_t>(points2_) * stages.point);
}

void BoxContraction::expand_layer(int element3) {
  const std::ptrdiff_t plane_step = static_cast<std::ptrdiff_t>(rows_) * stages_->plane;
  const std::ptrdiff_t row_step = static_cast<std::ptrdiff_t>(rows_) * stages_->row;
  for_each_run(*table3_, element3, [&](const PointRun& run, int q3) {
    for (int r = 0; r < rows_; ++r)
      for (const ContractionStep& s : stages_->middle)
        contract<false>(table3_->at(run, s.kind), {plane(r, run.first - first_plane_) + s.from, plane_step},
                        {row(r, q3) + s.to, row_step}, s.count);
  });
}

void BoxContraction::expand_points(int element2, int q3) {
  for_each_run(*table2_, element2, [&](const PointRun& run, int q2) {
    for (const ContractionStep& s : stages_->last)
      contract<false>(table2_->at(run, s.kind), {row(run.first - first_row_, q3) + s.from, stages_->row},
                      {point(q2) + s.to, stages_->point}, s.count);
  });
}

void BoxContraction::collect_points(int element2, int q3) {
  for_each_run(*table2_, element2, [&](const PointRun& run, int q2) {
    for (const ContractionStep& s : stages_->last)
      contract<true>(table2_->at(run, s.kind), {point(q2) + s.from, stages_->point},
                     {row(run.first - first_row_, q3) + s.to, stages_->row}, s.count);
  });
}

void BoxContraction::collect_layer(int element3) {
  const std::ptrdiff_t plane_step = static_cast<std::ptrdiff_t>(rows_) * stages_->plane;
  const std::ptrdiff_t row_step = static_cast<std::ptrdiff_t>(rows_) * stages_->row;
  for_each_run(*table3_, element3, [&](const PointRun& run, int q3) {
    for (int r = 0; r < rows_; ++r)
      for (const ContractionStep& s : stages_->middle)
        contract<true>(table3_->at(run, s.kind), {row(r, q3) + s.from, row_step},
                       {plane(r, run.first - first_plane_) + s.to, plane_step}, s.count);
  });
}

void BoxContraction::clear_rows() {
  std::fill_n(rows_buffer_.begin(), static_cast<std::ptrdiff_t>(rows_) * points3_ * stages_->row, Lanes{});
}

void BoxContraction::clear_planes() {
  std::fill_n(planes_.begin(), static_cast<std::ptrdiff_t>(planes_count_) * rows_ * stages_->plane, Lanes{});
}

}  // namespace isopatch::iga
