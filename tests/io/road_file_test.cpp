#include "berm/io/road_file.hpp"

#include <cmath>
#include <limits>
#include <sstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/core/error.hpp"
#include "support/file_error.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

const std::string kRoadHeader =
    "piece,chainage_m,x_m,y_m,z_m,heading_deg,left_m,left_sigma_m,right_m,right_sigma_m,width_m,width_sigma_m,"
    "grade_percent,grade_sigma_percent,cross_fall_percent,cross_fall_sigma_percent,left_berm_height_m,"
    "left_berm_height_sigma_m,left_berm_width_m,left_berm_width_sigma_m,right_berm_height_m,"
    "right_berm_height_sigma_m,right_berm_width_m,right_berm_width_sigma_m,width_rule,grade_rule,left_berm_rule,"
    "right_berm_rule\n";
const std::string kRow =
    "1,12.000,500000.125,5000000.250,310.500,90.000,7.500,0.100,,,,,6.000,0.150,-2.000,0.050,1.200,0.110,,,,,,,,holds,"
    "broken,\n";

RoadStation made_station() {
  RoadStation station;
  station.piece = 1;
  station.chainage_m = 12.0;
  station.position_m = {500000.125, 5000000.25, 310.5};
  station.heading_rad = std::asin(1.0);
  station.left.edge_m = Measure{7.5, 0.1};
  station.left.berm_height_m = Measure{1.2, 0.11};
  station.left.berm_rule = RuleVerdict::broken;
  station.grade = Measure{0.06, 0.0015};
  station.cross_fall = Measure{-0.02, 0.0005};
  station.grade_rule = RuleVerdict::holds;
  return station;
}

std::vector<RoadStation> parse_road(const std::string& text) {
  std::istringstream input(text);
  return read_road(input, "road.csv");
}

void expect_no_road(const std::string& text, const std::string& part) {
  SCOPED_TRACE(text);
  test::expect_file_error(ErrorCode::malformed, part, [&] { (void)parse_road(text); });
}

/// `kRow` with another text in a column, counted from 1.
std::string changed(int column, const std::string& text) {
  std::size_t begin = 0;
  for (int i = 1; i < column; ++i) {
    begin = kRow.find(',', begin) + 1;
  }
  return kRoadHeader + kRow.substr(0, begin) + text + kRow.substr(std::min(kRow.find(',', begin), kRow.size() - 1));
}

TEST(RoadFile, WritesWhatIsDocumented) {
  const test::TempFolder folder;
  const std::vector<RoadStation> stations = {made_station()};
  write_road(folder / "road.csv", stations);
  EXPECT_EQ(test::slurp(folder / "road.csv"), kRoadHeader + kRow);
  write_road(folder / "road.csv", {});
  EXPECT_EQ(test::slurp(folder / "road.csv"), kRoadHeader);
}

bool is_near(const std::optional<Measure>& a, const std::optional<Measure>& b, double unit) {
  return a.has_value() == b.has_value() &&
         (!a || (std::abs(a->value - b->value) <= 0.00051 * unit && std::abs(a->sigma - b->sigma) <= 0.00051 * unit));
}

TEST(RoadFile, SurvivesARoundTrip) {
  const test::TempFolder folder;
  EXPECT_TRUE(rc::check("any stations", [&] {
    const auto any = [](double most) { return most * *rc::gen::inRange(-1000, 1001) / 1000.0; };
    const auto measure = [&]() -> std::optional<Measure> {
      return *rc::gen::arbitrary<bool>() ? std::optional(Measure{any(40.0), std::abs(any(2.0))}) : std::nullopt;
    };
    const auto verdict = [] { return static_cast<RuleVerdict>(*rc::gen::inRange(0, 4)); };
    std::vector<RoadStation> stations(static_cast<std::size_t>(*rc::gen::inRange(0, 6)));
    double chainage_m = 0.0;
    for (RoadStation& s : stations) {
      chainage_m += std::abs(any(100.0));
      s = {.chainage_m = chainage_m,
           .position_m = {any(1e6), any(6e6), any(4000.0)},
           .heading_rad = any(3.14159),
           .left = {measure(), measure(), measure(), verdict()},
           .right = {measure(), measure(), measure(), verdict()},
           .width_m = measure(),
           .grade = measure(),
           .cross_fall = measure(),
           .width_rule = verdict(),
           .grade_rule = verdict()};
    }
    write_road(folder / "road.csv", stations);
    const auto again = read_road(folder / "road.csv");
    RC_ASSERT(again.size() == stations.size());
    for (std::size_t i = 0; i < again.size(); ++i) {
      RC_ASSERT(std::abs(again[i].chainage_m - stations[i].chainage_m) < 0.00051);
      RC_ASSERT((again[i].position_m - stations[i].position_m).cwiseAbs().maxCoeff() < 0.00051);
      RC_ASSERT(std::abs(again[i].heading_rad - stations[i].heading_rad) < 1e-5);
      RC_ASSERT(is_near(again[i].width_m, stations[i].width_m, 1.0));
      RC_ASSERT(is_near(again[i].grade, stations[i].grade, 0.01));
      RC_ASSERT(is_near(again[i].cross_fall, stations[i].cross_fall, 0.01));
      for (auto side : {&RoadStation::left, &RoadStation::right}) {
        RC_ASSERT(is_near((again[i].*side).edge_m, (stations[i].*side).edge_m, 1.0));
        RC_ASSERT(is_near((again[i].*side).berm_height_m, (stations[i].*side).berm_height_m, 1.0));
        RC_ASSERT(is_near((again[i].*side).berm_width_m, (stations[i].*side).berm_width_m, 1.0));
        RC_ASSERT((again[i].*side).berm_rule == (stations[i].*side).berm_rule);
      }
      RC_ASSERT(again[i].width_rule == stations[i].width_rule);
      RC_ASSERT(again[i].grade_rule == stations[i].grade_rule);
    }
  }));
}

TEST(RoadFile, RefusesWhatIsNoTable) {
  EXPECT_TRUE(parse_road(kRoadHeader).empty());
  EXPECT_EQ(parse_road("# made\n" + kRoadHeader + kRow + "\n" + kRow).size(), 2U);
  expect_no_road("", "the file is empty");
  expect_no_road("piece,chainage_m\n" + kRow, "line 1: expected the header piece,chainage_m,x_m");
  expect_no_road(changed(1, "-1"), "line 2: expected a whole number in piece");
  expect_no_road(changed(1, ""), "expected a whole number in piece");
  expect_no_road(changed(1, "99999999999"), "expected a whole number in piece");
  expect_no_road(changed(3, "nan"), "expected a number in x_m, found 'nan'");
  expect_no_road(changed(4, "1e10"), "expected a number in y_m");
  expect_no_road(changed(7, ""), "nothing in left_m, but '0.100' in left_sigma_m");
  expect_no_road(changed(8, ""), "expected a number in left_sigma_m");
  expect_no_road(changed(8, "-0.1"), "found one below 0");
  expect_no_road(changed(25, "perhaps"), "expected holds, uncertain, broken or nothing in width_rule");
  expect_no_road(changed(28, ",1"), "more columns than the header has");
  expect_no_road(kRoadHeader + "0,1,2,3\n", "the line ends before z_m");
  expect_no_road(kRoadHeader + kRow + "0" + kRow.substr(1), "line 3: pieces and chainages must not fall");
  test::expect_file_error(ErrorCode::not_found, "road.csv", [] { (void)read_road("/nowhere/road.csv"); });
}

TEST(RoadFile, RefusesToWriteWhatItWouldNotRead) {
  const test::TempFolder folder;
  const auto refused = [&](auto&& spoil) {
    std::vector<RoadStation> stations = {made_station(), made_station()};
    spoil(stations[1]);
    EXPECT_THROW(write_road(folder / "road.csv", stations), Error);
  };
  refused([](RoadStation& s) { s.position_m.x() = std::numeric_limits<double>::quiet_NaN(); });
  refused([](RoadStation& s) { s.position_m.z() = 2e9; });
  refused([](RoadStation& s) { s.grade->sigma = -1.0; });
  refused([](RoadStation& s) { s.grade->sigma = std::numeric_limits<double>::quiet_NaN(); });
  refused([](RoadStation& s) { s.width_m = Measure{std::numeric_limits<double>::infinity(), 0.0}; });
  refused([](RoadStation& s) { s.chainage_m = 1.0; });
  refused([](RoadStation& s) { s.piece = 0; });
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace berm
