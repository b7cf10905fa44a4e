#include "solvers/shared_rows.hpp"
#include "solvers/launch.hpp"

#include <gtest/gtest.h>

#include <random>

namespace isopatch::solvers {
namespace {

// Every row on one to all processes, some processes perhaps without any row.
std::vector<std::vector<int>> random_sharing(int rows, const Processes& processes, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<std::vector<int>> result(static_cast<std::size_t>(rows));
  for (auto& sharing : result) {
    for (int p = 0; p < processes.count(); ++p)
      if (random() % 3 != 0) sharing.push_back(p);
    if (sharing.empty()) sharing.push_back(static_cast<int>(random() % processes.count()));
  }
  return result;
}

Eigen::VectorXd random_vector(Eigen::Index size, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  return Eigen::VectorXd::NullaryExpr(size, [&] { return uniform(random); });
}

TEST(SharedRows, SumAddsWhatEveryProcessHas) {
  const Processes processes = Processes::launched();
  for (const int size : {1, 3}) {
    const SharedRows rows(random_sharing(200, processes, 5), processes, size);
    Eigen::VectorXd x = random_vector(size * rows.local_rows(), 10 + processes.rank());
    Eigen::VectorXd expected = Eigen::VectorXd::Zero(size * 200);
    for (int row = 0; row < rows.local_rows(); ++row)
      expected.segment(size * rows.global_of_local()[row], size) += x.segment(size * row, size);
    processes.sum(expected);
    SharedRows::ExtendedVector extended = x.cast<long double>();
    rows.sum(x);
    rows.sum(extended);
    EXPECT_LT((rows.part(expected) - x).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(),
              1e-15 * processes.count());
    EXPECT_LT((extended.cast<double>() - x).cwiseAbs().maxCoeff<Eigen::PropagateNaN>(),
              1e-15 * processes.count());
    // The owner's bits are everybody's bits.
    EXPECT_EQ(rows.part(rows.whole(x)), x);
  }
}

TEST(SharedRows, DotCountsEveryRowOnce) {
  const Processes processes = Processes::launched();
  const SharedRows rows(random_sharing(300, processes, 6), processes);
  const Eigen::VectorXd a = random_vector(900, 1), b = random_vector(900, 2);
  EXPECT_NEAR(rows.dot(rows.part(a), rows.part(b)), a.dot(b), 1e-13);
  EXPECT_NEAR(rows.norm(rows.part(a)), a.norm(), 1e-13);
  EXPECT_NEAR(rows.norm(1e200 * rows.part(a)) / (1e200 * a.norm()), 1, 1e-14);
  EXPECT_EQ(rows.norm(0 * rows.part(a)), 0);
  EXPECT_EQ(rows.whole(rows.part(a)), a);
}

TEST(SharedRows, TheLowestProcessOwns) {
  const Processes processes = Processes::launched();
  const auto sharing = random_sharing(100, processes, 7);
  const SharedRows rows(sharing, processes);
  for (const int row : rows.owned())
    EXPECT_EQ(sharing[rows.global_of_local()[row]].front(), processes.rank());
  EXPECT_EQ(processes.sum(std::int64_t(rows.owned().size())), 100);
}

TEST(SharedRows, AProcessMayHaveNothing) {
  const Processes processes = Processes::launched();
  const SharedRows rows(std::vector<std::vector<int>>(10, {0}), processes);
  Eigen::VectorXd x = Eigen::VectorXd::Ones(3 * rows.local_rows());
  rows.sum(x);
  EXPECT_EQ(rows.dot(x, x), 30);
  EXPECT_EQ(rows.norm(x), std::sqrt(30.0));
  EXPECT_EQ(rows.whole(x), Eigen::VectorXd::Ones(30));
  EXPECT_EQ(rows.local_rows(), processes.is_first() ? 10 : 0);
}

TEST(Processes, SumsBroadcastsAndLargest) {
  const Processes processes = Processes::launched();
  const int n = processes.count();
  EXPECT_EQ(processes.sum(double(processes.rank())), n * (n - 1) / 2);
  EXPECT_EQ(processes.sum(std::int64_t{1} << 40), n * (std::int64_t{1} << 40));
  EXPECT_EQ(processes.largest(processes.rank()), n - 1);
  EXPECT_EQ(processes.from(n - 1, processes.rank()), n - 1);
  EXPECT_GE(processes.fair_threads(64), 1);
  EXPECT_EQ(processes.fair_threads(1), 1);
  EXPECT_EQ(launch().count, n);
  EXPECT_EQ(launch().rank, processes.rank());
}

}  // namespace
}  // namespace isopatch::solvers
