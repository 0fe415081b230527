#include "berm/report/report.hpp"

#include <filesystem>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "berm/core/error.hpp"
#include "support/file_error.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

const std::string kPage =
    R"(<html><body><script type="application/json" id="run">null</script><p>end</p></body></html>)";

json run_file() {
  return {{"schema", "berm.run/2"}, {"recording", {{"path", "drive"}}}};
}

class ReportTest : public testing::Test {
 protected:
  void SetUp() override { test::spill(out_ / "run.json", run_file().dump()); }
  [[nodiscard]] json data(const std::string& evaluation = "") const {
    return json::parse(report_data(out_.path(), evaluation));
  }

  test::TempFolder out_;
};

TEST_F(ReportTest, WhatTheRunDidNotWriteIsLeftOut) {
  const json bare = data();
  EXPECT_EQ(bare["run"]["recording"]["path"], "drive");
  for (const char* part :
       {"scans", "times", "odometry", "road", "trajectory", "global_trajectory", "edges", "terrain", "evaluation"}) {
    EXPECT_FALSE(bare.contains(part)) << part;
  }
  EXPECT_TRUE(bare["trouble"].empty());
  EXPECT_EQ(recording_of(out_.path()), "drive");
}

TEST_F(ReportTest, TakesTheGroundOfTheMap) {
  test::spill(out_ / "trajectory.tum", "1700000000.5 500000 10 1 0 0 0 1\n1700000000.75 500003 14 1 0 0 0 1\n");
  test::spill(out_ / "elevation.asc",
              "ncols 2\nnrows 2\nxllcorner 499990\nyllcorner 5\ncellsize 0.5\nNODATA_value -9999\n3 -9999\n3 3\n");
  const json ground = data()["terrain"];
  EXPECT_EQ(ground["x_m"], -10.0);
  EXPECT_EQ(ground["y_m"], -5.0);
  EXPECT_EQ(ground["low_m"], 2.0);
  EXPECT_EQ(ground["shade"], "gACAgA==");  // 128, 0; 128, 128
}

TEST_F(ReportTest, ABrokenRasterIsNamed) {
  test::spill(out_ / "elevation.asc", "ncols 2\n");
  const json all = data();
  EXPECT_FALSE(all.contains("terrain"));
  EXPECT_THAT(all["trouble"].dump(), HasSubstr("elevation.asc"));
}

TEST_F(ReportTest, TakesWhatIsThere) {
  test::spill(out_ / "scans.csv",
              "scan,stamp,points,drivable,slope_deg,cross_fall_deg,degraded\n"
              "a,1700000000.5,100,60,,,no_time\n"
              "b,1700000000.75,110,50,-2.5,,\n");
  test::spill(out_ / "times.csv", "scan,stamp,read_ms,map_ms\na,1700000000.5,1.25,\nb,1700000000.75,900,\n");
  test::spill(out_ / "odometry.csv", "scan,stamp,health,weakest\na,1700000000.5,good,0.5\nb,1700000000.75,lost,0\n");
  test::spill(out_ / "road.csv",
              "piece,chainage_m,width_m,width_sigma_m,width_rule\n0,0,12,0.1,holds\n0,1,9,0.2,broken\n0,2,,,\n");
  test::spill(out_ / "trajectory.tum", "1700000000.5 500000 10 1 0 0 0 1\n1700000000.75 500003 14 1 0 0 0 1\n");
  test::spill(out_ / "edges.csv", "line,side,x,y,z,confidence\n0,left,500000,15,1,1\n0,left,500010,15,1,1\n");
  const json all = data(R"({"schema": "berm.eval/1", "ground": {"f1": 0.5}})");

  EXPECT_EQ(all["scans"]["x"], json({0.0, 0.25}));
  EXPECT_EQ(all["scans"]["columns"]["slope_deg"], json({nullptr, -2.5}));
  EXPECT_EQ(all["scans"]["columns"]["drivable"], json({60, 50}));
  EXPECT_FALSE(all["scans"]["columns"].contains("cross_fall_deg")) << "nothing is known of it";
  EXPECT_EQ(all["times"]["columns"]["read_ms"], json({1.25, 900.0}));
  EXPECT_FALSE(all["times"]["columns"].contains("map_ms"));
  EXPECT_EQ(all["times"]["histogram"]["scans"].size(), 1U);
  EXPECT_EQ(all["odometry"]["columns"]["health"], json({0.0, 3.0}));
  EXPECT_EQ(all["road"]["columns"]["width_m"], json({12.0, 9.0, nullptr}));
  EXPECT_EQ(all["road"]["columns"]["width_rule"], json({0.0, 2.0, nullptr}));
  EXPECT_EQ(all["origin_m"][0], 500000.0);
  EXPECT_EQ(all["trajectory"]["x_m"], json({0.0, 3.0}));
  EXPECT_EQ(all["trajectory"]["t_s"], json({0.0, 0.25}));
  EXPECT_EQ(all["trajectory"]["path_m"], 5.0);
  EXPECT_EQ(all["edges"][0]["side"], "left");
  EXPECT_EQ(all["edges"][0]["y_m"], json({5.0, 5.0}));
  EXPECT_EQ(all["evaluation"]["ground"]["f1"], 0.5);
}

TEST_F(ReportTest, ABrokenFileIsNamedAndTheRestIsShown) {
  test::spill(out_ / "scans.csv", "scan,stamp\na,1\nb\n");
  test::spill(out_ / "times.csv", "scan,stamp,read_ms\na,1,2\n");
  test::spill(out_ / "trajectory.tum", "1 2 3\n");
  const json partly = data("no JSON at all");
  EXPECT_FALSE(partly.contains("scans"));
  EXPECT_TRUE(partly.contains("times"));
  EXPECT_FALSE(partly.contains("evaluation"));
  ASSERT_EQ(partly["trouble"].size(), 2U);
  EXPECT_THAT(partly["trouble"][0].get<std::string>(), HasSubstr("scans.csv"));
  EXPECT_THAT(partly["trouble"][1].get<std::string>(), HasSubstr("trajectory.tum"));
}

TEST_F(ReportTest, WithoutARunThereIsNoReport) {
  const auto expect_refused = [this](ErrorCode code, const std::string& part) {
    test::expect_file_error(code, part, [this] { static_cast<void>(report_data(out_.path())); });
  };
  for (const char* text : {"", "[]", "{", "{\"schema\": 7}", "{\"schema\": \"berm.eval/1\"}"}) {
    SCOPED_TRACE(text);
    test::spill(out_ / "run.json", text);
    expect_refused(ErrorCode::malformed, "run.json");
  }
  test::spill(out_ / "run.json",
              "{\"schema\": \"berm.run/2\", \"deep\": " + std::string(200'000, '[') + std::string(200'000, ']') + "}");
  expect_refused(ErrorCode::malformed, "run.json");
  fs::remove(out_ / "run.json");
  expect_refused(ErrorCode::not_found, "run.json");
}

TEST_F(ReportTest, ANightStaysSmall) {
  std::string scans =
      "scan,stamp,points,returns,no_return,invalid,falling_snow,drivable,terrain,obstacle,slope_deg,"
      "slope_sigma_deg,cross_fall_deg,cross_fall_sigma_deg\n";
  std::string times = "scan,stamp,read_ms,snow_ms,ground_ms,piste_ms,edge_ms,check_ms,map_ms,write_ms\n";
  std::string poses;
  for (int i = 0; i < 100'000; ++i) {
    const std::string n = std::to_string(i);
    const std::string stamp = n + ".125";
    const std::string value = std::to_string(i % 977) + "." + std::to_string(100 + i % 899);
    scans += n + "," + stamp;
    for (int column = 0; column < 12; ++column) {
      scans += "," + value;
    }
    scans += "\n";
    times += n + "," + stamp;
    for (int column = 0; column < 8; ++column) {
      times += "," + value;
    }
    times += "\n";
    poses += stamp + " " + n + ".123 " + value + " 1 0 0 0 1\n";
  }
  test::spill(out_ / "scans.csv", scans);
  test::spill(out_ / "times.csv", times);
  test::spill(out_ / "trajectory.tum", poses);
  const std::string text = report_data(out_.path());
  EXPECT_LT(text.size(), 1'000'000U);
  const json night = json::parse(text);
  EXPECT_EQ(night["scans"]["rows"], 100'000);
  EXPECT_EQ(night["trajectory"]["poses"], 100'000);
  EXPECT_EQ(night["trajectory"]["t_s"].back(), 99'999.0);
}

TEST_F(ReportTest, MarkupInNamesStaysText) {
  const std::string name = "</script><script>alert(1)</script><!-- \xE2\x80\xA8 & \xE2\x80\xA9 \xFF";
  json run = run_file();
  run["recording"]["path"] = name;
  run["notes"] = {name};
  test::spill(out_ / "run.json", run.dump(-1, ' ', false, json::error_handler_t::replace));
  const std::string page = fill_report(kPage, report_data(out_.path()));
  const std::size_t begin = page.find("id=\"run\">") + 9;
  const std::size_t end = page.find("</script>");
  EXPECT_EQ(page.substr(end), "</script><p>end</p></body></html>");
  const std::string block = page.substr(begin, end - begin);
  EXPECT_EQ(block.find_first_of("<>&"), std::string::npos);
  EXPECT_THAT(block, Not(HasSubstr("\xE2\x80\xA8")));
  EXPECT_THAT(json::parse(block)["run"]["recording"]["path"].get<std::string>(), HasSubstr("</script><script>alert"));
}

TEST(FillReport, EscapesWhateverJsonItIsGiven) {
  const std::string filled = fill_report(kPage, "{\"a\":\"<!--<script>&\xE2\x80\xA8\xE2\x80\xA9\xE2\x80\"}");
  EXPECT_THAT(filled, HasSubstr(R"({"a":"\u003c!--\u003cscript\u003e\u0026\u2028\u2029)"));
}

TEST(FillReport, APageWithoutAPlaceIsRefused) {
  EXPECT_THROW(static_cast<void>(fill_report("<html></html>", "{}")), Error);
}

}  // namespace
}  // namespace berm
