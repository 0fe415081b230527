#include "berm/view/view_api.hpp"

#include <cmath>
#include <cstring>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "berm/core/error.hpp"
#include "berm/io/edges_file.hpp"
#include "berm/map/edge_map.hpp"
#include "berm/view/points_payload.hpp"
#include "view/made_run.hpp"

namespace berm {
namespace {

using Json = nlohmann::json;

template <typename Number>
Number entry_at(const std::string& bytes, std::size_t offset) {
  Number value{};
  std::memcpy(&value, bytes.data() + offset, sizeof(value));
  return value;
}

class ViewApiTest : public testing::Test {
 protected:
  static constexpr std::size_t kRowBytes = 44;

  void SetUp() override { test::make_run(folder_.path()); }

  ViewApi open(const std::vector<std::string>& names, ViewOptions options = {}) {
    std::vector<ShownRun> runs;
    for (const std::string& name : names) {
      runs.push_back(ShownRun::open(folder_ / name));
    }
    return {std::move(runs), Site(), std::move(options)};
  }

  static ViewAnswer ask(ViewApi& api, std::string_view target) {
    return api.answer({.target = target, .caller = {.host = "localhost"}});
  }

  test::TempFolder folder_;
};

TEST_F(ViewApiTest, SaysWhatIsShown) {
  ViewApi api = open({"out", "recording"});
  const ViewAnswer answer = ask(api, "/api/runs");
  EXPECT_EQ(answer.status, 200U);
  EXPECT_EQ(answer.content_type, "application/json");
  EXPECT_EQ(answer.cache_control, "no-store");
  const Json runs = Json::parse(*answer.body);
  ASSERT_EQ(runs.size(), 2U);
  EXPECT_EQ(runs[0]["name"], "out");
  EXPECT_EQ(runs[0]["is_run"], true);
  EXPECT_EQ(runs[0]["scans"], 3);
  EXPECT_EQ(runs[0]["machine"], "car <b>");
  EXPECT_EQ(runs[0]["sensor"], "made");
  EXPECT_EQ(runs[0]["start_ns"], 100'000'000);
  EXPECT_EQ(runs[0]["end_ns"], 300'000'000);
  EXPECT_EQ(runs[0]["layers"]["labels"], true);
  EXPECT_EQ(runs[0]["layers"]["edges"], true);
  EXPECT_EQ(runs[0]["layers"]["octree"], false);
  EXPECT_EQ(runs[0]["layers"]["trajectory"], true);
  EXPECT_EQ(runs[1]["name"], "recording");
  EXPECT_EQ(runs[1]["is_run"], false);
  EXPECT_EQ(runs[1]["scans"], 4);
  EXPECT_EQ(runs[1]["layers"]["labels"], false);
  EXPECT_EQ(runs[1]["layers"]["trajectory"], false);
}

TEST_F(ViewApiTest, ListsTheScansOfARun) {
  ViewApi api = open({"out"});
  const std::string& table = *ask(api, "/api/runs/0/scans").body;
  ASSERT_EQ(table.size(), 4U + 3U * kRowBytes);
  EXPECT_EQ(entry_at<std::uint32_t>(table, 0), 3U);
  const std::size_t second = 4 + kRowBytes;
  EXPECT_EQ(entry_at<std::int64_t>(table, second), 200'000'000);
  EXPECT_EQ(entry_at<std::uint32_t>(table, second + 8), test::kMadePoints);
  EXPECT_EQ(entry_at<float>(table, second + 12), 2.0F);
  EXPECT_EQ(entry_at<float>(table, second + 36), 1.0F);
  EXPECT_EQ(table[4 + 40], 1);                  // whole
  EXPECT_EQ(table[second + 40], 2);             // degraded
  EXPECT_EQ(table[4 + 2 * kRowBytes + 40], 3);  // skipped
}

TEST_F(ViewApiTest, ListsTheScansOfARecordingWithoutPoses) {
  ViewApi api = open({"recording"});
  const std::string& table = *ask(api, "/api/runs/0/scans").body;
  ASSERT_EQ(table.size(), 4U + 4U * kRowBytes);
  EXPECT_EQ(entry_at<std::uint32_t>(table, 4 + 8), test::kMadePoints);
  for (std::size_t i = 0; i < 7; ++i) {
    EXPECT_TRUE(std::isnan(entry_at<float>(table, 4 + 12 + 4 * i)));
  }
  EXPECT_EQ(table[4 + 40], 0);
}

TEST_F(ViewApiTest, ReadsTheHeadsOfALongRecordingHereAndThere) {
  constexpr std::size_t kScans = 2500;
  const std::filesystem::path scans = folder_ / "long";
  std::filesystem::create_directories(scans);
  for (std::size_t i = 0; i < kScans; ++i) {
    std::filesystem::create_hard_link(folder_ / "recording/scans" / (test::scan_name(0) + ".pcd"),
                                      scans / (test::scan_name(i) + ".pcd"));
  }
  ViewApi api = open({"long"});
  const std::string& table = *ask(api, "/api/runs/0/scans").body;
  ASSERT_EQ(table.size(), 4U + kScans * kRowBytes);
  std::size_t known = 0;
  for (std::size_t i = 0; i < kScans; ++i) {
    const auto points = entry_at<std::uint32_t>(table, 4 + i * kRowBytes + 8);
    EXPECT_TRUE(points == 0 || points == test::kMadePoints);
    known += points > 0 ? 1 : 0;
  }
  EXPECT_EQ(entry_at<std::uint32_t>(table, 4 + 8), test::kMadePoints);
  EXPECT_GE(known, 500U);
  EXPECT_LE(known, 1000U);
}

TEST_F(ViewApiTest, ServesPointsWithTheLabelsOfTheRun) {
  ViewApi api = open({"out"});
  const std::string& points = *ask(api, "/api/runs/0/scans/0").body;
  ASSERT_EQ(points.size(), 16U + 16U * test::kMadeReturns);
  EXPECT_EQ(entry_at<std::uint32_t>(points, 4), test::kMadeReturns);
  EXPECT_EQ(entry_at<std::uint32_t>(points, 12), std::uint32_t{kPayloadIntensity} | kPayloadLabel);
  const PointCloud cloud = test::made_cloud(1, test::kMadePoints);
  EXPECT_EQ(entry_at<float>(points, 16), cloud.view().x[0]);
  // The mount lifts the sensor by 1.5 m.
  EXPECT_NEAR(entry_at<float>(points, 16 + 8 * test::kMadeReturns), cloud.view().z[0] + 1.5F, 1e-6F);
  const std::string labels = points.substr(16 + 13 * test::kMadeReturns, test::kMadeReturns);
  EXPECT_EQ(labels, std::string(test::kMadeReturns, static_cast<char>(Label::obstacle)));
  // The same scan from the cache.
  EXPECT_EQ(ask(api, "/api/runs/0/scans/0").body.get(), ask(api, "/api/runs/0/scans/0").body.get());
}

TEST_F(ViewApiTest, ServesAScanWithoutLabelsWhereTheyAreMissingOrOfAnother) {
  test::spill(folder_ / "out/labels/000002.label", "12345678");
  ViewApi api = open({"out"});
  EXPECT_EQ(entry_at<std::uint32_t>(*ask(api, "/api/runs/0/scans/1").body, 12), std::uint32_t{kPayloadIntensity});
  EXPECT_EQ(entry_at<std::uint32_t>(*ask(api, "/api/runs/0/scans/2").body, 12), std::uint32_t{kPayloadIntensity});
}

TEST_F(ViewApiTest, ServesTrajectoryEdgesAndLabels) {
  ViewApi api = open({"out", "recording"});
  const std::string& poses = *ask(api, "/api/runs/0/trajectory").body;
  ASSERT_EQ(poses.size(), 4U + 3U * kRowBytes);
  EXPECT_EQ(entry_at<float>(poses, 4 + 2 * kRowBytes + 12), 4.0F);
  const Json edges = Json::parse(*ask(api, "/api/runs/0/edges").body);
  ASSERT_EQ(edges["features"].size(), 2U);
  EXPECT_EQ(edges["truth"], false);
  EXPECT_EQ(edges["features"][0]["properties"]["side"], "left");
  EXPECT_EQ(edges["features"][0]["properties"]["confidence"], Json({0.75, 1.0}));
  EXPECT_EQ(edges["features"][1]["geometry"]["coordinates"][1], Json({2.0, -2.0, 0.0}));
  EXPECT_EQ(Json::parse(*ask(api, "/api/runs/0/labels").body)[3], Json({{"id", 3}, {"name", "drivable"}}));
  EXPECT_EQ(ask(api, "/api/runs/1/trajectory").status, 404U);
  EXPECT_EQ(ask(api, "/api/runs/1/edges").status, 404U);
}

TEST_F(ViewApiTest, ServesTheTrueEdgesOfARecording) {
  write_edges(folder_ / "recording/edges.csv", std::vector<Edge>{{false, {{1.0, 2.0, 3.0}, {2.0, 2.0, 3.0}}}});
  ViewApi api = open({"recording"});
  const Json edges = Json::parse(*ask(api, "/api/runs/0/edges").body);
  EXPECT_EQ(edges["truth"], true);
  EXPECT_EQ(edges["features"][0]["properties"]["side"], "right");
}

TEST_F(ViewApiTest, ServesTheVoxelsThatMayBeEdge) {
  EdgeMap map({.voxel_m = 0.5});
  const std::vector<MappedEdge> edges = {{{10.2, 0.2, 0.2}, EdgeSide::left}, {{20.2, 0.2, 0.2}, EdgeSide::right}};
  const std::vector<Eigen::Vector3d> plain_m = {{30.2, 0.2, 0.2}};
  map.add_scan(edges, plain_m);
  test::spill(folder_ / "out/edges.ot", map.to_octomap());
  ViewApi api = open({"out"});
  EXPECT_EQ(Json::parse(*ask(api, "/api/runs").body)[0]["layers"]["octree"], true);
  const std::string& voxels = *ask(api, "/api/runs/0/octree").body;
  ASSERT_EQ(voxels.size(), 4U + 2U * 20U);
  EXPECT_EQ(entry_at<std::uint32_t>(voxels, 0), 2U);
  EXPECT_EQ(entry_at<float>(voxels, 4), 10.25F);
  EXPECT_EQ(entry_at<float>(voxels, 4 + 12), 0.5F);
  EXPECT_EQ(voxels[4 + 16], 0);
  EXPECT_EQ(voxels[24 + 16], 1);
  EXPECT_NEAR(static_cast<std::uint8_t>(voxels[4 + 17]), 0.7 * 255.0, 1.0);
}

TEST_F(ViewApiTest, PositionsOfFarWorldsAreRelativeToASharedOrigin) {
  test::make_run(folder_ / "far", {500'000.25, 5'000'000.5, 700.0});
  std::filesystem::create_directories(folder_ / "farther");
  test::make_run(folder_ / "farther", {500'100.25, 5'000'000.5, 700.0});
  ViewApi api = open({"out", "far/out", "farther/out"});
  const Json runs = Json::parse(*ask(api, "/api/runs").body);
  EXPECT_EQ(runs[0]["origin"], Json({0.0, 0.0, 0.0}));
  EXPECT_EQ(runs[1]["origin"], runs[2]["origin"]);
  EXPECT_EQ(runs[1]["origin"][0], 500'000.0);
  const std::string& poses = *ask(api, "/api/runs/1/trajectory").body;
  EXPECT_EQ(entry_at<float>(poses, 4 + 12), 0.25F);
  EXPECT_EQ(entry_at<float>(*ask(api, "/api/runs/2/trajectory").body, 4 + 12), 100.25F);
}

TEST_F(ViewApiTest, RefusesWhatIsNotThere) {
  ViewApi api = open({"out"});
  for (const char* target : {"/api/runs/1/scans", "/api/runs/0/scans/3", "/api/runs/0/octree", "/api/runs/0/global",
                             "/api/runs/0/map", "/api/runs/0/map/0", "/api/runs/0/piste/0", "/nothing.js"}) {
    const ViewAnswer answer = ask(api, target);
    EXPECT_EQ(answer.status, 404U) << target;
    EXPECT_TRUE(Json::parse(*answer.body).contains("hint"));
  }
  EXPECT_EQ(ask(api, "/../run.json").status, 400U);
  EXPECT_EQ(ask(api, "/api/other").status, 400U);
  EXPECT_EQ(api.answer({.reads = false, .target = "/", .caller = {.host = "localhost"}}).status, 405U);
  EXPECT_EQ(api.answer({.target = "/", .caller = {.host = "evil.example"}}).status, 403U);
  EXPECT_EQ(ask(api, "/").status, 200U);
}

TEST_F(ViewApiTest, SaysWhichFileIsBroken) {
  test::spill(folder_ / "recording/scans/000001.pcd", "no pcd");
  test::spill(folder_ / "out/edges.csv", "line,side\n");
  ViewApi api = open({"out"});
  const ViewAnswer scan = ask(api, "/api/runs/0/scans/0");
  EXPECT_EQ(scan.status, 500U);
  EXPECT_NE(scan.body->find("000001.pcd"), std::string::npos);
  EXPECT_EQ(ask(api, "/api/runs/0/edges").status, 500U);
  EXPECT_EQ(ask(api, "/api/runs/0/scans/1").status, 200U);
}

TEST_F(ViewApiTest, AsksForThePisteOnlyOfScansThatAreThere) {
  ViewOptions options;
  options.piste = [](const ShownRun&, std::size_t scan) {
    return std::optional("{\"scan\":" + std::to_string(scan) + "}");
  };
  ViewApi api = open({"out"}, std::move(options));
  EXPECT_EQ(*ask(api, "/api/runs/0/piste/2").body, "{\"scan\":2}");
  EXPECT_EQ(ask(api, "/api/runs/0/piste/3").status, 404U);
}

TEST_F(ViewApiTest, OpensNoRunWithoutItsRecording) {
  std::filesystem::remove_all(folder_ / "recording");
  EXPECT_THROW((void)ShownRun::open(folder_ / "out"), FileError);
  EXPECT_THROW((void)ShownRun::open(folder_ / "nothing"), FileError);
  test::spill(folder_ / "out/run.json", "[]");
  EXPECT_THROW((void)ShownRun::open(folder_ / "out"), FileError);
}

}  // namespace
}  // namespace berm
