#include <fmt/format.h>
#include <signal.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPNGReader.h>
#include <vtkSmartPointer.h>

#include <algorithm>
#include <chrono>
#include <set>
#include <thread>

#include "app/tests/program_fixture.hpp"

namespace isopatch::app {
namespace {

/// Pixels of a picture, from the lower left.
class Pixels {
 public:
  explicit Pixels(const fs::path& file) {
    vtkNew<vtkPNGReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    image_ = reader->GetOutput();
  }
  int width() const { return image_->GetDimensions()[0]; }
  int height() const { return image_->GetDimensions()[1]; }
  int channels() const { return image_->GetNumberOfScalarComponents(); }
  std::array<int, 3> colour(int x, int y) const {
    const auto* at = static_cast<const unsigned char*>(image_->GetScalarPointer(x, y, 0));
    return {at[0], at[1], at[2]};
  }
  int opacity(int x, int y) const {
    return static_cast<const unsigned char*>(image_->GetScalarPointer(x, y, 0))[3];
  }
  /// Different colours left of a share of the width.
  std::set<std::array<int, 3>> colours(double share = 1) const {
    std::set<std::array<int, 3>> found;
    for (int y = 0; y < height(); ++y)
      for (int x = 0; x < share * width(); ++x) found.insert(colour(x, y));
    return found;
  }
  /// Pixels that differ from another picture of the same size, in the columns from .. to.
  int differences(const Pixels& other, int from, int to) const {
    int count = 0;
    for (int y = 0; y < height(); ++y)
      for (int x = from; x < to; ++x) count += colour(x, y) != other.colour(x, y) ? 1 : 0;
    return count;
  }

 private:
  vtkSmartPointer<vtkImageData> image_;
};

/// Renders small pictures of the bar.
class Render : public Program {
 protected:
  void SetUp() override {
    Program::SetUp();
    ASSERT_EQ(run({"run", study(), "-q"}), 0) << err_;
  }
  std::string result() const { return (results() / "results.h5").string(); }
  std::string picture(const std::string& name = "picture.png") const { return (folder_ / name).string(); }
  int render(const std::vector<std::string>& options, const std::string& name = "picture.png") {
    std::vector<std::string> arguments = {"render", result(), "-o", picture(name)};
    arguments.insert(arguments.end(), options.begin(), options.end());
    if (std::find(options.begin(), options.end(), "--size") == options.end())
      arguments.insert(arguments.end(), {"--size", "320x240"});
    return run(arguments);
  }
  Pixels drawn(const std::vector<std::string>& options) {
    EXPECT_EQ(render(options), 0) << err_;
    return Pixels(picture());
  }
  /// The message of options that are refused before anything is drawn.
  std::string refused(const std::vector<std::string>& options) {
    EXPECT_EQ(render(options), 2);
    EXPECT_FALSE(fs::exists(picture()));
    return err_;
  }
};

TEST_F(Render, ResultsBecomeAPictureOfTheSizeAskedFor) {
  ASSERT_EQ(render({"--field", "displacement"}), 0) << err_;
  const Pixels pixels(picture());
  EXPECT_EQ(pixels.width(), 320);
  EXPECT_EQ(pixels.height(), 240);
  EXPECT_EQ(pixels.channels(), 3);
  EXPECT_EQ(pixels.colour(0, 239), (std::array{255, 255, 255}));
  EXPECT_GT(pixels.colours(0.65).size(), 200u);  // shades of the part
  EXPECT_THAT(out_, HasSubstr("320 x 240 pixels, displacement 0 mm to"));
  EXPECT_THAT(out_, HasSubstr("deformation x 10"));
}

TEST_F(Render, ColoursFollowTheField) {
  // Bottom and top of the range, without edges or bar: the middle of the front is all of one colour.
  const auto middle = [&](const char* range) {
    return drawn({"--view", "front", "--edges", "none", "--no-bar", "--range", range}).colour(150, 130);
  };
  const auto low = middle("20,30 MPa");  // the stress is 10 MPa everywhere
  EXPECT_GT(low[2], 1.2 * low[1]);       // purple
  const auto high = middle("1,9.999 MPa");
  EXPECT_GT(high[1], 4 * high[2]);  // yellow
}

TEST_F(Render, TheBarStandsBesideThePart) {
  const Pixels with = drawn({"--view", "front"});
  const Pixels without = drawn({"--view", "front", "--no-bar"});
  EXPECT_GT(with.differences(without, 250, 320), 1000);
  EXPECT_GT(with.colours().size(), without.colours().size() + 100);  // the strip has all of viridis
}

TEST_F(Render, ACaptionIsDrawnAsItIsGiven) {
  const Pixels without = drawn({"--view", "front", "--caption", ""});
  EXPECT_GT(without.differences(drawn({"--view", "front"}), 0, 230), 100) << "title and deformation";
  EXPECT_GT(without.differences(drawn({"--view", "front", "--caption", "case 7"}), 0, 230), 50);
  EXPECT_EQ(without.differences(drawn({"--view", "front", "--caption", ""}), 0, 320), 0);
}

TEST_F(Render, DeformationEdgesAndCutsShow) {
  const Pixels plain = drawn({"--view", "front", "--deformation", "0"});
  EXPECT_THAT(out_, HasSubstr("not deformed"));
  EXPECT_GT(plain.differences(drawn({"--view", "front", "--deformation", "50"}), 0, 230), 500);
  EXPECT_GT(plain.differences(drawn({"--view", "front", "--deformation", "0", "--edges", "none"}), 0, 230),
            100);
  EXPECT_GT(plain.differences(drawn({"--view", "front", "--deformation", "0", "--clip", "x=1.5 m"}), 0, 230),
            500);
  EXPECT_EQ(plain.differences(drawn({"--view", "front", "--deformation", "0"}), 0, 320), 0);
}

TEST_F(Render, TheBackgroundMayBeTransparent) {
  const Pixels pixels = drawn({"--transparent-background", "--view", "front"});
  ASSERT_EQ(pixels.channels(), 4);
  EXPECT_EQ(pixels.opacity(0, 239), 0);
  EXPECT_EQ(pixels.opacity(120, 130), 255);
}

TEST_F(Render, StudiesAreColouredByPatch) {
  ASSERT_EQ(run({"render", study(), "-o", picture(), "--size", "320x240", "--view", "front"}), 0) << err_;
  EXPECT_THAT(out_, HasSubstr("2 patches"));
  const Pixels pixels(picture());
  EXPECT_NE(pixels.colour(75, 130), pixels.colour(200, 130));
}

TEST_F(Render, NamesAreCheckedAndTheNearestIsSaid) {
  EXPECT_THAT(refused({"--field", "von_mieses"}),
              HasSubstr("--field: there is no 'von_mieses' (did you mean 'von_mises'?); choose one of"));
  EXPECT_THAT(refused({"--view", "frnt"}), HasSubstr("did you mean 'front'?"));
  EXPECT_THAT(refused({"--edges", "element"}), HasSubstr("did you mean 'elements'?"));
  EXPECT_THAT(refused({"--component", "w"}), HasSubstr("--component: there is no 'w'"));
  EXPECT_THAT(refused({"--field", "patch", "--component", "x"}), HasSubstr("goes with --field displacement"));
}

TEST_F(Render, ValuesAreChecked) {
  EXPECT_THAT(refused({"--size", "320"}), HasSubstr("--size: expected WIDTHxHEIGHT"));
  EXPECT_THAT(refused({"--size", "99999x10"}), HasSubstr("100 to 8000"));
  EXPECT_THAT(refused({"--range", "3,2"}), HasSubstr("the first value must be below the second"));
  EXPECT_THAT(refused({"--range", "0,3 mm"}), HasSubstr("expected a pressure, got a length"));
  EXPECT_THAT(refused({"--range", "3"}), HasSubstr("expected two values"));
  EXPECT_THAT(refused({"--deformation", "much"}), HasSubstr("expected auto or a factor"));
  EXPECT_THAT(refused({"--percentile", "3"}), HasSubstr("--percentile: expected 51 to 100, got 3"));
  EXPECT_THAT(refused({"--zoom", "0"}), HasSubstr("--zoom"));
  EXPECT_THAT(refused({"--view", "0,0,0"}), HasSubstr("a view needs a direction"));
  EXPECT_THAT(refused({"--view", "0,0,1", "--up", "z"}), HasSubstr("must not lie along the view"));
  EXPECT_THAT(refused({"--clip", "x"}), HasSubstr("--clip: expected x, y or z with a position"));
  EXPECT_THAT(refused({"--clip", "x=-1"}), HasSubstr("nothing of the part is left"));
}

TEST_F(Render, AModelWithoutResultsHasNoStress) {
  EXPECT_EQ(run({"render", study(), "-o", picture(), "--field", "von_mises"}), 2);
  EXPECT_THAT(err_, HasSubstr("solve the study with isopatch run and render its results.h5"));
  EXPECT_EQ(run({"render", study(), "-o", picture(), "--deformation", "2"}), 2);
}

TEST_F(Render, APictureIsWrittenWholeOrNotAtAll) {
  EXPECT_EQ(render({}, "picture.jpg"), 2);
  EXPECT_THAT(err_, HasSubstr("pictures are written as .png"));
  EXPECT_EQ(render({}, "nowhere/picture.png"), 3);
  EXPECT_THAT(err_, HasSubstr("there is no directory"));
  fs::create_directory(picture("folder.png"));
  EXPECT_EQ(render({}, "folder.png"), 3);
  EXPECT_THAT(err_, HasSubstr("is a directory"));
  write_file(picture(), "mine");
  fs::create_directory(picture() + ".unfinished");  // in the way of the temporary file
  EXPECT_EQ(render({}), 3);
  EXPECT_EQ(read_file(picture()), "mine");
  fs::remove(picture() + ".unfinished");
  EXPECT_EQ(render({}), 0);
  EXPECT_EQ(Pixels(picture()).width(), 320);
  EXPECT_FALSE(fs::exists(picture() + ".unfinished"));
}

TEST_F(Render, WithoutADisplayItSaysWhatToInstall) {
  for (const char* display : {"-u DISPLAY", "DISPLAY=:4711"}) {
    const int code = shell(fmt::format("env {} PATH={} {} render {} -o {} 2> {}", display, folder_.string(),
                                       ISOPATCH_PROGRAM, result(), picture(), picture("said")));
    EXPECT_EQ(code, 2);
    EXPECT_THAT(read_file(picture("said")),
                testing::AllOf(HasSubstr("package xvfb"), HasSubstr("xvfb-run -a")));
    EXPECT_FALSE(fs::exists(picture()));
  }
}

TEST_F(Render, ADeadDisplayIsReplacedByAVirtualOne) {
  EXPECT_EQ(shell(fmt::format("env DISPLAY=:4711 {} render {} -o {} -q --size 320x240", ISOPATCH_PROGRAM,
                              result(), picture())),
            0);
  EXPECT_GT(Pixels(picture()).colours().size(), 100u);
}

TEST_F(Render, AServerThatDoesNotStartIsNamed) {
  write_file(folder_ / "Xvfb", "#!/bin/sh\nexit 1\n");
  fs::permissions(folder_ / "Xvfb", fs::perms::owner_all);
  EXPECT_EQ(shell(fmt::format("env -u DISPLAY PATH={}:/bin {} render {} -o {} 2> {}", folder_.string(),
                              ISOPATCH_PROGRAM, result(), picture(), picture("said"))),
            2);
  EXPECT_THAT(read_file(picture("said")), HasSubstr((folder_ / "Xvfb").string() + " does not start"));
}

TEST_F(Render, CtrlCEndsTheVirtualDisplayToo) {
  // A server that says who it is and then nothing more: the program waits for it and is interrupted.
  write_file(folder_ / "Xvfb", fmt::format("#!/bin/sh\necho $$ > {}.new; mv {}.new {}\nexec sleep 60\n",
                                           picture("pid"), picture("pid"), picture("pid")));
  fs::permissions(folder_ / "Xvfb", fs::perms::owner_all);
  const std::string command = fmt::format(
      "env -u DISPLAY PATH={}:/bin:/usr/bin {} render {} -o {} -q 2> /dev/null & program=$!; "
      "for i in $(seq 200); do [ -e {} ] && break; sleep 0.05; done; kill -INT $program; wait $program",
      folder_.string(), ISOPATCH_PROGRAM, result(), picture(), picture("pid"));
  EXPECT_EQ(shell(command), 130);
  const int server = std::stoi(read_file(picture("pid")));
  bool gone = false;
  for (int i = 0; i < 100 && !gone; ++i) {
    gone = ::kill(server, 0) != 0 ||
           read_file(fmt::format("/proc/{}/stat", server)).find(") Z ") != std::string::npos;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
  EXPECT_TRUE(gone);
}

TEST_F(Render, MarksSupportsAndLoadsOfAStudy) {
  ASSERT_EQ(run({"render", study(), "-o", picture(), "--field", "conditions", "--size", "320x240", "--view",
                 "1,-1,1", "--edges", "none"}),
            0)
      << err_;
  EXPECT_THAT(out_, HasSubstr("2 patches, supports blue, loads red"));
  // x_max is loaded, y_min held, z_max neither.
  int red = 0;
  int blue = 0;
  int grey = 0;
  const Pixels drawn(picture());
  for (int y = 0; y < drawn.height(); ++y)
    for (int x = 60; x < drawn.width(); ++x) {
      const auto [r, g, b] = drawn.colour(x, y);
      red += r > 2 * b && r > 2 * g;
      blue += b > 2 * r;
      grey += std::abs(r - b) < 60 && r < 240 && g > r;
    }
  EXPECT_GT(red, 1000);
  EXPECT_GT(blue, 1000);
  EXPECT_GT(grey, 1000);
  EXPECT_EQ(run({"render", result(), "-o", picture("none.png"), "--field", "conditions"}), 2);
  EXPECT_THAT(err_, HasSubstr("give a study"));
  EXPECT_EQ(run({"render", study(), "-o", picture("none.png"), "--field", "conditions", "--set",
                 "load.0.faces=[\"x_mx\"]"}),
            2);
  EXPECT_THAT(err_, HasSubstr("did you mean"));
}

}  // namespace
}  // namespace isopatch::app
