#include <algorithm>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "berm/core/error.hpp"
#include "berm/view/export_run.hpp"
#include "view/made_run.hpp"

namespace berm {
namespace {

template <typename Number>
Number at(const std::string& bytes, std::size_t offset) {
  Number value{};
  if (offset + sizeof(value) <= bytes.size()) {
    std::memcpy(&value, bytes.data() + offset, sizeof(value));
  } else {
    ADD_FAILURE() << "the file ends before " << offset;
  }
  return value;
}

class ExportTest : public testing::Test {
 protected:
  void SetUp() override { test::make_run(folder_.path()); }

  std::string write(CloudFormat format, const std::string& run = "out", const ExportOptions& options = {}) {
    const std::filesystem::path file = folder_ / "cloud";
    summary_ = export_cloud(ShownRun::open(folder_ / run), format, file, options);
    return test::slurp(file);
  }

  test::TempFolder folder_;
  ExportSummary summary_;
};

/// The run has three scans of 600 returns, all obstacles, at x = 0, 2 and 4 m; the last has no labels.
constexpr std::size_t kPoints = 3 * test::kMadeReturns;

TEST_F(ExportTest, PlyHoldsPositionColourIntensityAndLabel) {
  const std::string ply = write(CloudFormat::ply);
  EXPECT_EQ(summary_.points, kPoints);
  EXPECT_EQ(summary_.scans, 3U);
  const std::string end = "end_header\n";
  const std::size_t head = ply.find(end) + end.size();
  EXPECT_EQ(ply.find("ply\nformat binary_little_endian 1.0\n"), 0U);
  EXPECT_NE(ply.find("element vertex 1800\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\n"),
            std::string::npos);
  constexpr std::size_t kRecord = 3 * 4 + 3 + 4 + 1;
  ASSERT_EQ(ply.size(), head + kPoints * kRecord);
  const PointCloud cloud = test::made_cloud(2, test::kMadePoints);
  const std::size_t second_scan = head + test::kMadeReturns * kRecord;
  EXPECT_NEAR(at<float>(ply, second_scan), cloud.view().x[0] + 2.0F, 1e-5F);
  EXPECT_NEAR(at<float>(ply, second_scan + 8), cloud.view().z[0] + 1.5F, 1e-5F);
  EXPECT_EQ(at<float>(ply, second_scan + kRecord + 15), 1.0F);
  EXPECT_EQ(at<std::uint8_t>(ply, second_scan + 19), static_cast<std::uint8_t>(Label::obstacle));
}

TEST_F(ExportTest, PlyTakesDoublesWhereFloatsAreTooCoarse) {
  test::make_run(folder_ / "far", {500'000.125, 5'000'000.0, 0.0});
  const std::string ply = write(CloudFormat::ply, "far/out");
  const std::size_t head = ply.find("end_header\n") + 11;
  EXPECT_NE(ply.find("property double x\n"), std::string::npos);
  ASSERT_EQ(ply.size(), head + kPoints * 32);
  const PointCloud cloud = test::made_cloud(1, test::kMadePoints);
  EXPECT_NEAR(at<double>(ply, head), 500'000.125 + double{cloud.view().x[0]}, 1e-6);
}

TEST_F(ExportTest, LasHasTheHeaderOfVersion14AndRecordsThatFitIt) {
  const std::string las = write(CloudFormat::las);
  EXPECT_EQ(las.substr(0, 4), "LASF");
  EXPECT_EQ(at<std::uint16_t>(las, 6), 16U);  // WKT
  EXPECT_EQ(at<std::uint8_t>(las, 24), 1U);
  EXPECT_EQ(at<std::uint8_t>(las, 25), 4U);
  EXPECT_EQ(at<std::uint16_t>(las, 94), 375U);
  EXPECT_EQ(at<std::uint32_t>(las, 96), 375U);
  EXPECT_EQ(at<std::uint32_t>(las, 100), 0U);
  EXPECT_EQ(at<std::uint8_t>(las, 104), 7U);
  EXPECT_EQ(at<std::uint16_t>(las, 105), 36U);
  EXPECT_EQ(at<std::uint32_t>(las, 107), 0U);
  EXPECT_EQ(at<std::uint64_t>(las, 247), kPoints);
  EXPECT_EQ(at<std::uint64_t>(las, 255), kPoints);
  ASSERT_EQ(las.size(), 375U + kPoints * 36U);
  double min_x_m = 1e9;
  double max_x_m = -1e9;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double x_m = at<std::int32_t>(las, 375 + 36 * i) * at<double>(las, 131) + at<double>(las, 155);
    min_x_m = std::min(min_x_m, x_m);
    max_x_m = std::max(max_x_m, x_m);
  }
  EXPECT_NEAR(at<double>(las, 179), max_x_m, 1e-9);
  EXPECT_NEAR(at<double>(las, 187), min_x_m, 1e-9);
  const PointCloud cloud = test::made_cloud(1, test::kMadePoints);
  const double z_m = at<std::int32_t>(las, 375 + 8) * at<double>(las, 147) + at<double>(las, 171);
  EXPECT_NEAR(z_m, cloud.view().z[0] + 1.5, 5.1e-4);
  EXPECT_EQ(at<std::uint16_t>(las, 375 + 36 + 12), 257U);
  EXPECT_EQ(at<std::uint8_t>(las, 375 + 14), 0x11U);
  EXPECT_EQ(at<std::uint8_t>(las, 375 + 16), 64U);  // obstacle
  EXPECT_EQ(at<double>(las, 375 + 22), 0.1);
  EXPECT_EQ(at<std::uint8_t>(las, las.size() - 36 + 16), 1U);  // a scan without labels
}

TEST_F(ExportTest, CsvHasALineForEachPoint) {
  std::istringstream csv(write(CloudFormat::csv));
  std::string line;
  std::getline(csv, line);
  EXPECT_EQ(line, "x,y,z,intensity,label,time");
  std::getline(csv, line);
  EXPECT_EQ(line, "3.000,-14.400,2.000,0.0,99,0.100000");
  std::size_t lines = 1;
  while (std::getline(csv, line)) {
    ++lines;
  }
  EXPECT_EQ(lines, kPoints);
}

TEST_F(ExportTest, LeavesScansOutAndSaysSo) {
  EXPECT_FALSE(write(CloudFormat::csv, "out", {.every = 2}).empty());
  EXPECT_EQ(summary_.scans, 2U);
  test::spill(folder_ / "recording/scans/000002.pcd", "no pcd");
  (void)write(CloudFormat::ply);
  EXPECT_EQ(summary_.scans, 2U);
  EXPECT_EQ(summary_.skipped, 1U);
}

TEST_F(ExportTest, LeavesNoFileWhereThereIsNothingToWrite) {
  const ShownRun recording = ShownRun::open(folder_ / "recording");
  EXPECT_THROW((void)export_cloud(recording, CloudFormat::ply, folder_ / "none", {}), Error);
  ExportOptions options;
  options.should_stop = [] { return true; };
  const ShownRun run = ShownRun::open(folder_ / "out");
  EXPECT_TRUE(export_cloud(run, CloudFormat::las, folder_ / "none", options).interrupted);
  EXPECT_TRUE(export_foxglove(run, folder_ / "none", options).interrupted);
  EXPECT_FALSE(std::filesystem::exists(folder_ / "none"));
  EXPECT_THROW((void)export_cloud(run, CloudFormat::las, "/dev/full", {}), FileError);
  EXPECT_THROW((void)export_foxglove(run, "/dev/full", {}), FileError);
}

/// A record of an MCAP file.
struct McapRecord {
  std::uint8_t opcode = 0;
  std::size_t begin = 0;
  std::string content;
};

std::vector<McapRecord> records_of(const std::string& bytes, std::size_t begin, std::size_t end) {
  std::vector<McapRecord> records;
  while (begin + 9 <= end) {
    const auto size = at<std::uint64_t>(bytes, begin + 1);
    records.push_back({at<std::uint8_t>(bytes, begin), begin, bytes.substr(begin + 9, size)});
    begin += 9 + size;
  }
  EXPECT_EQ(begin, end);
  return records;
}

TEST_F(ExportTest, McapLeadsToEveryMessage) {
  const ExportSummary summary = export_foxglove(ShownRun::open(folder_ / "out"), folder_ / "run.mcap", {});
  EXPECT_EQ(summary.points, kPoints);
  const std::string file = test::slurp(folder_ / "run.mcap");
  const std::string magic("\x89MCAP0\r\n", 8);
  ASSERT_EQ(file.substr(0, 8), magic);
  ASSERT_EQ(file.substr(file.size() - 8), magic);
  const auto records = records_of(file, 8, file.size() - 8);
  EXPECT_EQ(records.front().opcode, 0x01);
  EXPECT_EQ(records.back().opcode, 0x02);
  const auto summary_begin = at<std::uint64_t>(records.back().content, 0);
  std::size_t messages = 0;
  std::size_t indexed = 0;
  for (const McapRecord& record : records) {
    if (record.opcode == 0x06) {
      const auto size = at<std::uint64_t>(record.content, 16);
      ASSERT_EQ(record.content.size(), 40 + size);
      for (const McapRecord& inner : records_of(record.content, 40, record.content.size())) {
        messages += inner.opcode == 0x05 ? 1 : 0;
      }
    }
    indexed += record.opcode == 0x07 ? at<std::uint32_t>(record.content, 2) / 16 : 0;
    if (record.opcode == 0x0B) {
      EXPECT_GE(record.begin, summary_begin);
      EXPECT_EQ(at<std::uint64_t>(record.content, 0), 10U);  // 3 clouds, 3 transforms, 3 poses, edges
      EXPECT_EQ(at<std::uint32_t>(record.content, 10), 4U);
      EXPECT_EQ(at<std::uint64_t>(record.content, 26), 100'000'000U);
      EXPECT_EQ(at<std::uint64_t>(record.content, 34), 300'000'000U);
    }
  }
  EXPECT_EQ(messages, 10U);
  EXPECT_EQ(indexed, 10U);
  (void)export_foxglove(ShownRun::open(folder_ / "out"), folder_ / "again.mcap", {});
  EXPECT_EQ(test::slurp(folder_ / "again.mcap"), file);
}

TEST_F(ExportTest, ARecordingWithoutPosesBecomesClouds) {
  const ExportSummary summary = export_foxglove(ShownRun::open(folder_ / "recording"), folder_ / "r.mcap", {});
  EXPECT_EQ(summary.scans, test::kMadeScans);
  EXPECT_EQ(nlohmann::json::parse(foxglove_layout())["layout"], "3D!berm");
}

}  // namespace
}  // namespace berm
