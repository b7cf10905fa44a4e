#include "solvers/control_group.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "geometry/base/temporary_folder.hpp"

namespace isopatch::solvers {
namespace {

namespace fs = std::filesystem;

/// A folder that stands for "/", with what the system would say there.
class ControlGroup : public testing::Test {
 protected:
  void write(const fs::path& path, const std::string& text) {
    fs::create_directories((root_ / path).parent_path());
    std::ofstream(root_ / path) << text;
  }
  void mounted(const std::string& line) {
    write("proc/self/mountinfo", "22 1 0:1 / / rw - ext4 /dev/sda rw\n" + line);
  }
  void in_group(const std::string& lines) { write("proc/self/cgroup", lines); }
  // Limit and use of a group of version 2.
  void group(const fs::path& path, const std::string& limit, std::int64_t used) {
    write(path / "memory.max", limit + "\n");
    write(path / "memory.current", std::to_string(used) + "\n");
  }
  std::int64_t left() const { return control_group_memory(root_).value_or(-1); }

  TemporaryFolder temporary_;
  fs::path root_ = temporary_.path();
};

const std::string version_2 =
    "34 30 0:31 / /sys/fs/cgroup rw,nosuid shared:4 - cgroup2 cgroup2 rw,nsdelegate\n";
const std::string version_1 =
    "33 30 0:30 / /sys/fs/cgroup/cpu rw - cgroup cgroup rw,cpu\n"
    "34 30 0:31 / /sys/fs/cgroup/memory rw,relatime shared:7 - cgroup cgroup rw,memory\n";

TEST_F(ControlGroup, KnowsNoLimitWhereThereIsNone) {
  EXPECT_FALSE(control_group_memory(root_));
  mounted(version_2);
  in_group("0::/user.slice\n");
  group("sys/fs/cgroup/user.slice", "max", 5000);
  EXPECT_FALSE(control_group_memory(root_));
}

TEST_F(ControlGroup, TakesTheLimitOfTheJobAndNotOnlyTheRoots) {
  mounted(version_2);
  in_group("0::/slurm/job_7/step_0\n");
  group("sys/fs/cgroup/slurm/job_7", "9000", 2000);
  group("sys/fs/cgroup/slurm/job_7/step_0", "max", 1500);
  EXPECT_EQ(left(), 7000);
}

TEST_F(ControlGroup, TheLeastOnTheWayToTheRootHolds) {
  mounted(version_2);
  in_group("0::/a/b\n");
  group("sys/fs/cgroup", "100000", 50000);
  group("sys/fs/cgroup/a", "20000", 19000);
  group("sys/fs/cgroup/a/b", "9000", 2000);
  group("sys/fs/cgroup/other", "10", 9);
  EXPECT_EQ(left(), 1000);
  group("sys/fs/cgroup", "50500", 50000);
  EXPECT_EQ(left(), 500);
}

TEST_F(ControlGroup, MemoryHighIsALimitToo) {
  mounted(version_2);
  in_group("0::/a\n");
  group("sys/fs/cgroup/a", "20000", 1000);
  write("sys/fs/cgroup/a/memory.high", "8000\n");
  EXPECT_EQ(left(), 7000);
}

TEST_F(ControlGroup, FilesThatNobodyUsesDoNotCount) {
  mounted(version_2);
  in_group("0::/a\n");
  group("sys/fs/cgroup/a", "20000", 15000);
  write("sys/fs/cgroup/a/memory.stat", "anon 1000\nfile 14000\ninactive_file 12000\nactive_file 2000\n");
  EXPECT_EQ(left(), 17000);
}

TEST_F(ControlGroup, ReadsVersion1) {
  mounted(version_1);
  in_group("9:name=systemd:/\n4:cpu,memory:/jobs/12\n1:cpu:/elsewhere\n");
  write("sys/fs/cgroup/memory/memory.limit_in_bytes", "9223372036854771712\n");
  write("sys/fs/cgroup/memory/jobs/memory.limit_in_bytes", "30000\n");
  write("sys/fs/cgroup/memory/jobs/memory.usage_in_bytes", "25000\n");
  write("sys/fs/cgroup/memory/jobs/12/memory.limit_in_bytes", "10000\n");
  write("sys/fs/cgroup/memory/jobs/12/memory.usage_in_bytes", "8000\n");
  write("sys/fs/cgroup/memory/jobs/12/memory.stat", "inactive_file 1\ntotal_inactive_file 7000\n");
  EXPECT_EQ(left(), 5000);
}

TEST_F(ControlGroup, BothVersionsSideBySide) {
  mounted(version_1 + "40 30 0:37 / /sys/fs/cgroup/unified rw - cgroup2 cgroup2 rw\n");
  in_group("4:memory:/job\n0::/job\n");
  write("sys/fs/cgroup/memory/job/memory.limit_in_bytes", "6000\n");
  EXPECT_EQ(left(), 6000);
  group("sys/fs/cgroup/unified/job", "4000", 1000);
  EXPECT_EQ(left(), 3000);
}

// A container sees its own group as the root of the tree, whatever the group is called outside.
TEST_F(ControlGroup, FollowsTheMountOfAContainer) {
  mounted("34 30 0:31 /docker/abc /sys/fs/cgroup ro - cgroup2 cgroup rw\n");
  group("sys/fs/cgroup", "7000", 1000);
  for (const char* own : {"0::/docker/abc\n", "0::/\n", "0::/../xyz\n"}) {
    in_group(own);
    EXPECT_EQ(left(), 6000) << own;
  }
  group("sys/fs/cgroup/inner", "2000", 500);
  in_group("0::/docker/abc/inner\n");
  EXPECT_EQ(left(), 1500);
  in_group("0::/docker/abcd\n");  // another container's
  EXPECT_EQ(left(), 6000);
}

TEST_F(ControlGroup, MountPointsMayHaveBlanks) {
  mounted("34 30 0:31 / /sys/my\\040groups rw - cgroup2 cgroup2 rw\n");
  in_group("0::/a\n");
  group("sys/my groups/a", "3000", 0);
  EXPECT_EQ(left(), 3000);
}

TEST_F(ControlGroup, AFullGroupLeavesNothing) {
  mounted(version_2);
  in_group("0::/a\n");
  group("sys/fs/cgroup/a", "3000", 3500);
  EXPECT_EQ(control_group_memory(root_).value_or(1), -500);
}

}  // namespace
}  // namespace isopatch::solvers
