#include <set>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "berm/io/label_file.hpp"
#include "program.hpp"
#include "support/made_recording.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;
using test::ProgramResult;
using test::run_berm;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kPngMagic = "\x89PNG\r\n";

class DrawCommandTest : public testing::Test {
 protected:
  void SetUp() override {
    test::make_recording(recording_, 2, 300);
    fs::create_directories(recording_ / "labels");
    write_labels(recording_ / "labels/000000.label", std::vector<std::uint32_t>(300, 40));
  }
  [[nodiscard]] ProgramResult draw(const std::vector<std::string>& more) const {
    std::vector<std::string> all = {"draw", recording_.string(), "--width", "200", "--height", "150"};
    all.insert(all.end(), more.begin(), more.end());
    return run_berm(all);
  }

  test::TempFolder folder_;
  fs::path recording_ = folder_ / "recording";
};

TEST_F(DrawCommandTest, EveryViewAndColourIsAPicture) {
  for (const char* view : {"top", "side", "front", "perspective"}) {
    for (const char* color : {"label", "intensity", "height"}) {
      const ProgramResult result = draw({"--view", view, "--color", color, "-o", "-"});
      EXPECT_EQ(result.exit_code, 0) << result.err;
      EXPECT_THAT(result.out, StartsWith(kPngMagic)) << view << color;
    }
  }
}

TEST_F(DrawCommandTest, LabelsOfARunOfTruthOfBothAndMadeOnTheSpotDiffer) {
  const std::string out = (folder_ / "out").string();
  ASSERT_EQ(run_berm({"run", recording_.string(), "-m", "car", "-o", out}).exit_code, 0);
  const std::string plain = draw({"-o", "-"}).out;
  const std::string run = draw({"--run", out, "-o", "-"}).out;
  const std::string truth = draw({"--truth", "-o", "-"}).out;
  const std::string both = draw({"--run", out, "--truth", "-o", "-"}).out;
  for (const std::string& picture : {run, truth, both}) {
    EXPECT_THAT(picture, StartsWith(kPngMagic));
    EXPECT_NE(picture, plain);
  }
  EXPECT_NE(truth, both);
  EXPECT_THAT(draw({"--machine", "car", "-o", "-"}).out, StartsWith(kPngMagic));
}

TEST_F(DrawCommandTest, WritesAFile) {
  const fs::path file = folder_ / "scan.png";
  EXPECT_EQ(draw({"--scan", "000001", "-o", file.string()}).exit_code, 0);
  EXPECT_THAT(test::slurp(file), StartsWith(kPngMagic));
}

TEST_F(DrawCommandTest, WhatIsNotThereIsSaid) {
  const ProgramResult scan = draw({"--scan", "7", "-o", "-"});
  EXPECT_EQ(scan.exit_code, 2);
  EXPECT_THAT(scan.err, HasSubstr("from 000000 to 000001"));
  const ProgramResult truth = draw({"--scan", "000001", "--truth", "-o", "-"});
  EXPECT_EQ(truth.exit_code, 2);
  EXPECT_THAT(truth.err, HasSubstr("no labels"));
  EXPECT_EQ(draw({"--run", (folder_ / "nowhere").string(), "-o", "-"}).exit_code, 1);
  EXPECT_EQ(draw({"-o", (folder_ / "nowhere/scan.png").string()}).exit_code, 1);
}

TEST_F(DrawCommandTest, FiguresOfThePisteAreDifferentPictures) {
  const std::string scan = draw({"--machine", "groomer", "-o", "-"}).out;
  const std::string histogram = draw({"--machine", "groomer", "--figure", "histogram", "-o", "-"}).out;
  const std::string of_truth = draw({"--truth", "--figure", "histogram", "-o", "-"}).out;
  const std::string bare = draw({"--figure", "histogram", "-o", "-"}).out;
  for (const std::string& picture : {scan, histogram, of_truth, bare}) {
    EXPECT_THAT(picture, StartsWith(kPngMagic));
  }
  EXPECT_NE(scan, histogram);
  std::set<std::string> waveforms;
  for (const char* method : {"piste=default", "piste=reference"}) {
    for (const char* first : {"0", "100"}) {
      const ProgramResult result = draw({"--machine", "groomer", "--method", method, "--figure", "waveform",
                                         "--first-point", first, "--points", "80", "-o", "-"});
      EXPECT_EQ(result.exit_code, 0) << result.err;
      EXPECT_THAT(result.out, StartsWith(kPngMagic));
      waveforms.insert(result.out);
    }
  }
  EXPECT_EQ(waveforms.size(), 4U);
}

TEST_F(DrawCommandTest, AWaveformNeedsAPisteMethodAndPoints) {
  const auto problem = [this](const std::vector<std::string>& more) {
    std::vector<std::string> all = {"--figure", "waveform", "-o", "-"};
    all.insert(all.end(), more.begin(), more.end());
    const ProgramResult result = draw(all);
    EXPECT_EQ(result.exit_code, 2);
    return result.err;
  };
  EXPECT_THAT(problem({}), HasSubstr("needs --machine"));
  EXPECT_THAT(problem({"--machine", "car"}), HasSubstr("--method piste=default"));
  EXPECT_THAT(problem({"--machine", "groomer", "--truth"}), HasSubstr("neither --run nor --truth"));
  EXPECT_THAT(problem({"--machine", "groomer", "--first-point", "300"}), HasSubstr("the scan has 300 points"));
  EXPECT_EQ(draw({"--figure", "poem", "-o", "-"}).exit_code, 2);
}

TEST_F(DrawCommandTest, AHistogramNeedsIntensity) {
  PointChannels channels;
  channels.x = {1.0F};
  channels.y = {0.0F};
  channels.z = {0.0F};
  write_pcd(recording_ / "scans/000000.pcd", PointCloud(std::move(channels)).view());
  const ProgramResult result = draw({"--figure", "histogram", "-o", "-"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("no intensity"));
}

}  // namespace
}  // namespace berm
