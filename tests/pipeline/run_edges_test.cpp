#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "berm/core/error.hpp"
#include "berm/io/edge_export.hpp"
#include "support/file_error.hpp"
#include "truck_run.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using test::TruckDrive;
using testing::HasSubstr;
using testing::Not;

constexpr Geodetic kMine{-23.4, 119.8, 700.0};

class RunEdgesTest : public test::TruckRunTest {};

TEST_F(RunEdgesTest, WritesTheMapAndItsLines) {
  put_poses(drive_.poses());
  const RunSummary summary = run_it();
  expect_on_berms(lines());
  const json report = this->report();
  EXPECT_EQ(report["files"]["edge_map"], "edges.ot");
  EXPECT_EQ(report["files"]["edges"], "edges.csv");
  EXPECT_EQ(report["files"]["edge_points"], "edge_points.csv");
  EXPECT_FALSE(report["files"].contains("edges_geojson"));
  EXPECT_THAT(report["notes"].dump(), HasSubstr("datum.origin=given"));
  EXPECT_FALSE(fs::exists(out_ / "edges.geojson"));
  const json& edges = report["edges"];
  EXPECT_EQ(edges["scans_mapped"], kScans);
  EXPECT_EQ(edges["scans_not_mapped"], json::object());
  EXPECT_EQ(edges["voxels"], map().size());
  EXPECT_GT(edges["voxels"], 1000);
  EXPECT_GT(edges["points"], 5 * kScans);
  EXPECT_EQ(edges["world"], "");
  for (const char* side : {"left", "right"}) {
    EXPECT_GE(edges[side]["lines"], 1) << side;
    EXPECT_GT(edges[side]["km"], 0.01) << side;
  }
  EXPECT_EQ(report["files"]["road"], "road.csv");
  std::size_t heights = 0;
  for (const EdgeLine& line : lines()) {
    for (const EdgeLine::Vertex& vertex : line.vertices) {
      heights += vertex.berm_height_m ? 1U : 0U;
    }
  }
  EXPECT_GT(heights, 20U);
  EXPECT_NEAR(edges["road"]["stations"].get<double>(), 16.0, 2.0);
  EXPECT_GT(edges["road"]["width_rule"]["broken"], 0) << "two lanes for the truck need 22.75 m";
  EXPECT_FALSE(edges["road"]["width_rule"].contains("holds"));
  std::size_t judged = 0;
  for (const auto& [verdict, stations] : edges["road"]["grade_rule"].items()) {
    EXPECT_TRUE(verdict == "holds" || verdict == "uncertain" || verdict == "unknown") << "the road is level";
    judged += stations.get<std::size_t>();
  }
  EXPECT_EQ(judged, edges["road"]["stations"]);
  EXPECT_EQ(report["poses"]["jumps"], 0);
  for (const char* stage : {"edge", "map"}) {
    EXPECT_GT(report["stages"][stage]["max_ms"], 0.0) << stage;
  }
  EXPECT_EQ(summary.edges->voxels, map().size());
}

TEST_F(RunEdgesTest, TheTableHoldsTheNearestEdges) {
  static_cast<void>(run_it());
  const std::string points = test::slurp(out_ / "edge_points.csv");
  EXPECT_THAT(points, testing::StartsWith("scan,side,kind,x,y,z,time,confidence,height,width\n000000,"));
  const std::string table = test::slurp(out_ / "scans.csv");
  EXPECT_THAT(table, HasSubstr("left_edge_m,right_edge_m,edge_points"));
  const std::string row = table.substr(table.find("\n000004,") + 1);
  std::vector<std::string> fields(1);
  for (const char c : row.substr(0, row.find('\n'))) {
    c == ',' ? static_cast<void>(fields.emplace_back()) : fields.back().push_back(c);
  }
  ASSERT_EQ(fields.size(), 22U);
  // The lowest ring meets the ground 14.9 m from the sensor.
  for (const std::size_t side : {17U, 18U}) {
    EXPECT_GT(std::stod(fields[side]), TruckDrive::kHalfWidth_m - 0.5);
    EXPECT_LT(std::stod(fields[side]), 16.0);
  }
  EXPECT_GT(std::stoi(fields[19]), 4);
}

TEST_F(RunEdgesTest, WithoutPosesThereIsNoMapAndANoteSaysWhatToDo) {
  EXPECT_EQ(run_it().counts.labelled, kScans);
  for (const char* name : {"edges.ot", "edges.csv", "road.csv", "trajectory.tum"}) {
    EXPECT_FALSE(fs::exists(out_ / name)) << name;
  }
  const json report = this->report();
  EXPECT_THAT(report["notes"].dump(), HasSubstr("--poses"));
  EXPECT_GT(report["edges"]["points"], 5 * kScans);
  EXPECT_FALSE(report["edges"].contains("voxels"));
  EXPECT_FALSE(report.contains("poses"));
}

TEST_F(RunEdgesTest, TheReferenceMethodMapsAsWell) {
  put_poses(drive_.poses());
  machine_.methods.edge = "reference";
  static_cast<void>(run_it());
  EXPECT_GT(map().size(), 100U);
}

std::string without_last_column(const std::string& csv) {
  std::istringstream lines(csv);
  std::string rest;
  for (std::string line; std::getline(lines, line);) {
    rest += line.substr(0, line.rfind(',')) + "\n";
  }
  return rest;
}

TEST_F(RunEdgesTest, AnyNumberOfThreadsAndAnyPartsGiveTheSameMap) {
  put_poses(drive_.poses());
  static_cast<void>(run_it());
  for (const std::size_t threads : {2U, 5U}) {
    const fs::path out = folder_ / ("threads" + std::to_string(threads));
    static_cast<void>(run_it({.output = out, .threads = threads}));
    for (const char* name : {"edges.ot", "edges.csv", "edge_points.csv", "scans.csv"}) {
      EXPECT_EQ(test::slurp(out / name), test::slurp(out_ / name)) << threads << " " << name;
    }
  }
  static_cast<void>(run_it({.output = folder_ / "first", .count = 7}));
  static_cast<void>(run_it({.output = folder_ / "second", .first = 7}));
  EdgeMap merged = map_in(folder_ / "second");
  merged.merge(map_in(folder_ / "first"));
  const std::string whole = test::slurp(out_ / "edges.ot");
  EXPECT_TRUE(merged.to_octomap() == whole);
  EXPECT_FALSE(test::slurp(folder_ / "first/edges.ot") == whole);

  static_cast<void>(run_it({.output = folder_ / "continued", .first = 7, .map = folder_ / "first/edges.ot"}));
  EXPECT_TRUE(test::slurp(folder_ / "continued/edges.ot") == whole);
  // Heights of berms are those that this run surveyed: the map holds none.
  EXPECT_TRUE(without_last_column(test::slurp(folder_ / "continued/edges.csv")) ==
              without_last_column(test::slurp(out_ / "edges.csv")));
}

TEST_F(RunEdgesTest, MapsThatCannotBeContinuedAreRefused) {
  put_poses(drive_.poses());
  const fs::path old = folder_ / "old.ot";
  const fs::path tried = folder_ / "tried";
  const auto expect_refused = [&](ErrorCode code, const std::string& problem) {
    test::expect_file_error(code, problem, [&] { static_cast<void>(run_it({.output = tried, .map = old})); });
    EXPECT_FALSE(fs::exists(tried));
  };
  expect_refused(ErrorCode::not_found, "old.ot");
  static_cast<void>(run_it());
  const std::string bytes = test::slurp(out_ / "edges.ot");
  test::spill(old, bytes.substr(0, bytes.size() - 7));
  expect_refused(ErrorCode::truncated, "old.ot");
  test::spill(old, "no map\ndata\n");
  expect_refused(ErrorCode::malformed, "old.ot");
  test::spill(old, bytes);
  machine_.map.voxel_m = 0.25;
  expect_refused(ErrorCode::unsupported, "old.ot: has voxels of 0.2 m, this run has 0.25 m; set map.voxel_m=0.2");
  machine_.map.voxel_m = 0.2;
  machine_.datum.origin = "given";
  expect_refused(ErrorCode::unsupported, "holds a world without a datum");
  machine_.datum.origin = "first_fix";
  EXPECT_EQ(run_it({.output = tried, .map = old}).counts.labelled, kScans);
  EXPECT_EQ(test::slurp(old), bytes);
}

TEST_F(RunEdgesTest, AMapThatTheRunWouldReplaceIsRefused) {
  put_poses(drive_.poses());
  static_cast<void>(run_it());
  const std::string bytes = test::slurp(out_ / "edges.ot");
  fs::create_symlink(out_ / "edges.ot", folder_ / "link.ot");
  for (const fs::path& map : {out_ / "edges.ot", folder_ / "link.ot"}) {
    EXPECT_THROW(static_cast<void>(run_it({.force = true, .map = map})), FileError);
  }
  EXPECT_EQ(test::slurp(out_ / "edges.ot"), bytes);
}

TEST_F(RunEdgesTest, ARoadThatIsTooLongForOneMapIsRefusedAtOnce) {
  machine_.map.voxel_m = 0.02;  // 1.3 km from end to end
  TruckDrive far = drive_;
  far.origin_m = {3000.0, 0.0, 0.0};
  put_poses(drive_.poses());
  static_cast<void>(run_it());
  const fs::path old = folder_ / "old.ot";
  fs::copy_file(out_ / "edges.ot", old);
  put_poses(far.poses());
  EXPECT_THROW(static_cast<void>(run_it({.output = folder_ / "far", .map = old})), Error);
  EXPECT_FALSE(fs::exists(folder_ / "far"));
}

TEST_F(RunEdgesTest, AFailureWhileTheMapIsSavedLeavesNoRunAndKeepsTheOldMap) {
  put_poses(drive_.poses());
  static_cast<void>(run_it());
  const fs::path old = folder_ / "old.ot";
  fs::copy_file(out_ / "edges.ot", old);
  const fs::path broken = folder_ / "broken";
  // The map cannot get its name: a folder has it.
  const auto block = [&](std::size_t done, std::size_t) {
    if (done == 1) {
      fs::create_directories(broken / "edges.ot/in_the_way");
    }
  };
  EXPECT_THROW(static_cast<void>(run_it({.output = broken, .map = old, .on_progress = block})), FileError);
  EXPECT_FALSE(fs::exists(broken / "run.json"));
  EXPECT_FALSE(fs::exists(broken / "scans.csv"));
  EXPECT_TRUE(test::slurp(old) == test::slurp(out_ / "edges.ot"));
}

TEST_F(RunEdgesTest, AMapNeedsPosesAndAnEdgeMethod) {
  put_poses(drive_.poses());
  static_cast<void>(run_it());
  fs::copy_file(out_ / "edges.ot", folder_ / "old.ot");
  const auto code_of = [&] {
    try {
      static_cast<void>(run_it({.output = folder_ / "tried", .map = folder_ / "old.ot"}));
    } catch (const Error& error) {
      return std::optional(error.code());
    }
    return std::optional<ErrorCode>();
  };
  machine_.methods.edge = "none";
  EXPECT_EQ(code_of(), ErrorCode::invalid_argument);
  machine_.methods.edge = "default";
  fs::remove(recording_ / "gnss.tum");
  EXPECT_EQ(code_of(), ErrorCode::invalid_argument);
}

TEST_F(RunEdgesTest, ForceRemovesTheMapOfTheEarlierRun) {
  put_poses(drive_.poses());
  machine_.datum.origin = "given";
  static_cast<void>(run_it());
  std::vector<std::string> names = {"edges.ot", "edges.csv", "edges.geojson", "edge_points.csv"};
  for (const char* name : {"edges.gpkg", "edges.dxf"}) {
    if (!find_export_problem(edge_format_of(name).value(), true)) {
      names.emplace_back(name);
    }
  }
  for (const std::string& name : names) {
    EXPECT_TRUE(fs::exists(out_ / name)) << name;
  }
  machine_.methods.edge = "none";
  static_cast<void>(run_it({.force = true}));
  for (const std::string& name : names) {
    EXPECT_FALSE(fs::exists(out_ / name)) << name;
  }
  EXPECT_FALSE(report().contains("edges"));
}

TEST_F(RunEdgesTest, AGivenDatumPutsTheLinesOnTheEarth) {
  put_poses(drive_.poses());
  machine_.datum = {.origin = "given", .lat_deg = kMine.lat_deg, .lon_deg = kMine.lon_deg, .h_m = kMine.h_m};
  static_cast<void>(run_it());
  const json geojson = json::parse(test::slurp(out_ / "edges.geojson"));
  EXPECT_EQ(geojson["features"].size(), lines().size());
  const json place = geojson["features"][0]["geometry"]["coordinates"][0];
  EXPECT_NEAR(place[0].get<double>(), kMine.lon_deg, 1e-3);
  EXPECT_NEAR(place[1].get<double>(), kMine.lat_deg, 1e-3);
  EXPECT_THAT(report()["notes"].dump(), Not(HasSubstr("no datum")));
  EXPECT_EQ(datum_of(map().world())->lat_deg, kMine.lat_deg);
}

}  // namespace
}  // namespace berm
