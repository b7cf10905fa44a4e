#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>

#include "geometry/base/atomic_file.hpp"
#include "geometry/io/hdf5_reader.hpp"
#include "geometry/io/hdf5_writer.hpp"
#include "geometry/io/tests/sample_patches.hpp"

namespace isopatch::geometry {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Hdf5 : public testing::Test {
 protected:
  Hdf5() : path_(std::filesystem::temp_directory_path() / fmt::format("isopatch_hdf5_{}.h5", ::getpid())) {}
  ~Hdf5() override { std::filesystem::remove(path_); }

  // Deterministic and larger than the metadata, so that a cut hits data.
  static Eigen::MatrixXd points() { return Eigen::VectorXd::LinSpaced(12000, -1.0 / 3, 7).reshaped(3, 4000); }

  static std::string sample() {
    Hdf5Writer writer;
    writer.write("/geometry/patch 0/points", points());
    writer.write("/geometry/patch 0/weights", Eigen::VectorXd(Eigen::VectorXd::LinSpaced(5, -1, 1)));
    writer.write("/geometry/degrees", std::vector<std::int64_t>{3, -2, std::int64_t{1} << 60});
    writer.write("/none", std::vector<double>{});
    writer.write("/title", "f\xC3\xBCnf");
    writer.write("/empty", "");
    writer.write("/version", std::int64_t{7});
    writer.write("/energy", 68.5963);
    return writer.image();
  }

  void save(const std::string& bytes) const { write_file(path_, bytes); }

  std::filesystem::path path_;
};

TEST_F(Hdf5, WhatIsWrittenComesBack) {
  save(sample());
  const Hdf5Reader reader(path_);
  EXPECT_EQ(reader.matrix("/geometry/patch 0/points", 3), points());
  EXPECT_EQ(reader.vector("/geometry/patch 0/weights", 5),
            Eigen::VectorXd(Eigen::VectorXd::LinSpaced(5, -1, 1)));
  EXPECT_THAT(reader.integers("/geometry/degrees"), ElementsAre(3, -2, std::int64_t{1} << 60));
  EXPECT_EQ(reader.vector("/none").size(), 0);
  EXPECT_EQ(reader.text("/title"), "f\xC3\xBCnf");
  EXPECT_EQ(reader.text("/empty"), "");
  EXPECT_EQ(reader.integer("/version"), 7);
  EXPECT_EQ(reader.number("/energy"), 68.5963);
  EXPECT_THAT(reader.names("/geometry"), ElementsAre("degrees", "patch 0"));
  EXPECT_TRUE(reader.contains("/geometry/patch 0"));
  EXPECT_TRUE(reader.contains("/"));
  EXPECT_FALSE(reader.contains("/geometry/patch 1/points"));
  EXPECT_FALSE(reader.contains("/title/x"));
}

TEST_F(Hdf5, SameContentGivesTheSameBytes) {
  EXPECT_EQ(sample(), sample());
}

TEST_F(Hdf5, SeveralFilesMayBeWrittenAtOnce) {
  Hdf5Writer one, other;
  one.write("/a", 1.0);
  other.write("/a", 2.0);
  save(one.image());
  EXPECT_EQ(Hdf5Reader(path_).number("/a"), 1.0);
  save(other.image());
  EXPECT_EQ(Hdf5Reader(path_).number("/a"), 2.0);
}

TEST_F(Hdf5, ChangedBytesAreNoticed) {
  const std::string good = sample();
  const std::string number(reinterpret_cast<const char*>(points().col(2000).data()), sizeof(double));
  const auto at = good.find(number);
  ASSERT_NE(at, std::string::npos);
  for (std::size_t byte = 0; byte < sizeof(double); ++byte) {
    std::string bad = good;
    bad[at + byte] ^= 1;
    save(bad);
    const Hdf5Reader reader(path_);
    EXPECT_THAT(error_of([&] { reader.matrix("/geometry/patch 0/points"); }),
                HasSubstr("bad_format: " + path_.string() +
                          ": dataset '/geometry/patch 0/points' is not as it was written"));
    EXPECT_EQ(reader.number("/energy"), 68.5963) << "the others are";
  }
}

// Whatever a change of one bit does: what is read is what was written.
TEST_F(Hdf5, NoChangedBitGivesOtherValues) {
  Hdf5Writer writer;
  writer.write("/a/points", Eigen::MatrixXd(Eigen::VectorXd::LinSpaced(12, -1.0 / 3, 7).reshaped(3, 4)));
  writer.write("/a/numbers", std::vector<std::int64_t>{3, -2, std::int64_t{1} << 60});
  writer.write("/a/number", 2.5);
  writer.write("/title", "text");
  const std::string good = writer.image();
  int noticed = 0;
  for (std::size_t at = 0; at < good.size(); at += 37) {
    std::string bad = good;
    bad[at] ^= static_cast<char>(1 << at % 8);
    std::ofstream(path_, std::ios::binary) << bad;
    try {
      const Hdf5Reader reader(path_);
      const Eigen::MatrixXd found = reader.matrix("/a/points", 3);
      EXPECT_EQ(found, Eigen::VectorXd::LinSpaced(12, -1.0 / 3, 7).reshaped(3, 4)) << at;
      EXPECT_THAT(reader.integers("/a/numbers"), ElementsAre(3, -2, std::int64_t{1} << 60)) << at;
      EXPECT_EQ(reader.number("/a/number"), 2.5) << at;
      EXPECT_EQ(reader.text("/title"), "text") << at;
    } catch (const Error& error) {
      ++noticed;
    }
  }
  EXPECT_GT(noticed, 20);
}

// HDF5 keeps parts of some damaged files for ever, and would say so when the program ends.
TEST_F(Hdf5, DamagedFilesAreNoMatterAtTheEndOfTheProgram) {
  const std::string good = sample();
  const auto read_damaged_ones = [&] {
    for (std::size_t at = 0; at < 4096; at += 37) {
      std::string bad = good;
      bad[at] ^= static_cast<char>(1 << at % 8);
      std::ofstream(path_, std::ios::binary) << bad;
      try {
        const Hdf5Reader reader(path_);
        for (const char* name : {"/energy", "/version"}) static_cast<void>(reader.contains(name));
        static_cast<void>(reader.text("/title"));
        static_cast<void>(reader.matrix("/geometry/patch 0/points", 3));
      } catch (const Error&) {
      }
    }
    std::exit(0);
  };
  EXPECT_EXIT(read_damaged_ones(), testing::ExitedWithCode(0), testing::Eq(""));
}

TEST_F(Hdf5, WriterRefusesBadAndTakenPaths) {
  Hdf5Writer writer;
  writer.write("/a", 1.0);
  EXPECT_THAT(error_of([&] { writer.write("/a", 2.0); }),
              HasSubstr("invalid_argument: HDF5: cannot create dataset '/a'"));
  EXPECT_THAT(error_of([&] { writer.write("/a/b", 2.0); }), HasSubstr("cannot create dataset '/a/b'"));
  for (const char* path : {"", "a", "/", "/a/"})
    EXPECT_THAT(error_of([&] { writer.write(path, 2.0); }), HasSubstr("is no path of a dataset"));
}

TEST_F(Hdf5, ErrorsNameFileAndDataset) {
  EXPECT_THAT(error_of([] { Hdf5Reader("/no/such/file.h5"); }),
              testing::AllOf(HasSubstr("io: /no/such/file.h5: cannot be read"), HasSubstr("No such file")));
  save("hello, I am no HDF5 file");
  EXPECT_THAT(error_of([&] { Hdf5Reader reader(path_); }),
              HasSubstr("bad_format: " + path_.string() + ": not an HDF5 file"));
  save("");
  EXPECT_THAT(error_of([&] { Hdf5Reader reader(path_); }), HasSubstr("the file is empty"));
  save(sample());
  const Hdf5Reader reader(path_);
  EXPECT_THAT(error_of([&] { reader.vector("/geometry/x"); }),
              HasSubstr(path_.string() + ": there is no dataset '/geometry/x'"));
  EXPECT_THAT(error_of([&] { reader.vector("/geometry"); }), HasSubstr("'/geometry' is not a dataset"));
  EXPECT_THAT(error_of([&] { reader.vector("/title"); }),
              HasSubstr("dataset '/title' does not hold real numbers"));
  EXPECT_THAT(error_of([&] { reader.text("/energy"); }), HasSubstr("dataset '/energy' does not hold a text"));
  EXPECT_THAT(error_of([&] { reader.matrix("/geometry/patch 0/weights"); }),
              HasSubstr("has 1 dimensions instead of 2"));
  EXPECT_THAT(error_of([&] { reader.matrix("/geometry/patch 0/points", 4); }),
              HasSubstr("has 3 numbers a row instead of 4"));
  EXPECT_THAT(error_of([&] { reader.vector("/geometry/patch 0/weights", 6); }),
              HasSubstr("has 5 entries instead of 6"));
  EXPECT_THAT(error_of([&] { reader.names("/title"); }), HasSubstr("there is no group '/title'"));
}

TEST_F(Hdf5, CutFilesAreErrors) {
  const std::string whole = sample();
  for (const std::size_t size :
       {std::size_t{4}, std::size_t{40}, whole.size() / 10, whole.size() / 2, whole.size() - 1}) {
    save(whole.substr(0, size));
    EXPECT_THAT(error_of([&] { Hdf5Reader(path_).matrix("/geometry/patch 0/points"); }),
                HasSubstr("bad_format: " + path_.string()));
  }
}

}  // namespace
}  // namespace isopatch::geometry
