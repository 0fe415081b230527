#include "berm/io/sensor_sheet.hpp"

#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "support/file_error.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

using test::expect_file_error;

void expect_no_sheet(const std::string& text, const std::string& part) {
  SCOPED_TRACE(text.substr(0, 80));
  expect_file_error(ErrorCode::malformed, part, [&] { (void)parse_sensor_sheet(text, "sequence.json"); });
}

TEST(SensorSheet, ReadsWhatItKnowsAndListsTheRest) {
  const SensorSheet sheet = parse_sensor_sheet(
      R"({"scan_hz": 10, "sensor": "Mid-70", "sensor_height_m": 2.3, "sensor_pitch_deg": 11, "weather": {"snow": 0.1}, "wind": 7})",
      "sequence.json");
  EXPECT_EQ(sheet.sensor, "Mid-70");
  EXPECT_EQ(sheet.height_m, 2.3);
  EXPECT_NEAR(sheet.pitch_rad.value(), 0.191986, 1e-6);
  EXPECT_EQ(sheet.scan_hz, 10.0);
  EXPECT_EQ(sheet.unknown_keys, (std::vector<std::string>{"weather", "wind"}));
}

TEST(SensorSheet, SurvivesARoundTrip) {
  const test::TempFolder folder;
  SensorSheet sheet;
  sheet.sensor = "Livox \"Mid-70\"";
  sheet.height_m = 2.3;
  sheet.pitch_rad = 11.0 * std::numbers::pi / 180.0;
  sheet.roll_rad = -0.25;
  sheet.yaw_rad = 3.0;
  sheet.scan_hz = 10.0;
  sheet.scenario = "groomer";
  sheet.seed = 18446744073709551615ULL;
  sheet.program = "berm 0.1.0";
  sheet.world_origin_m = {176973.4379983592, 376237.8, 1278.125};
  write_sensor_sheet(folder / "sequence.json", sheet);
  EXPECT_NE(test::slurp(folder / "sequence.json").find("\"sensor_pitch_deg\": 11.0,"), std::string::npos);
  const SensorSheet again = read_sensor_sheet(folder / "sequence.json");
  EXPECT_EQ(again.sensor, sheet.sensor);
  EXPECT_EQ(again.height_m, sheet.height_m);
  EXPECT_NEAR(again.pitch_rad.value(), *sheet.pitch_rad, 1e-10);
  EXPECT_NEAR(again.roll_rad.value(), *sheet.roll_rad, 1e-10);
  EXPECT_NEAR(again.yaw_rad.value(), *sheet.yaw_rad, 1e-10);
  EXPECT_EQ(again.scan_hz, sheet.scan_hz);
  EXPECT_EQ(again.scenario, sheet.scenario);
  EXPECT_EQ(again.seed, sheet.seed);
  EXPECT_EQ(again.program, sheet.program);
  EXPECT_EQ(again.world_origin_m, sheet.world_origin_m);
  EXPECT_TRUE(again.unknown_keys.empty());
  write_sensor_sheet(folder / "empty.json", {});
  EXPECT_FALSE(read_sensor_sheet(folder / "empty.json").seed);
}

TEST(SensorSheet, NeedsNothing) {
  const SensorSheet sheet = parse_sensor_sheet("{}", "sequence.json");
  EXPECT_FALSE(sheet.sensor || sheet.height_m || sheet.pitch_rad || sheet.scan_hz);
}

TEST(SensorSheet, RefusesOtherTypesAndRanges) {
  expect_no_sheet(R"({"scan_hz": "10"})", "sequence.json: 'scan_hz' is a string, expected a number from 0.01 to 1000");
  expect_no_sheet(R"({"scan_hz": true})", "'scan_hz' is a boolean");
  expect_no_sheet(R"({"scan_hz": null})", "'scan_hz' is a null");
  expect_no_sheet(R"({"scan_hz": 0})", "'scan_hz' is 0, expected");
  expect_no_sheet(R"({"scan_hz": 1e300})", "expected a number from");
  expect_no_sheet(R"({"sensor_height_m": -1})", "'sensor_height_m' is -1");
  expect_no_sheet(R"({"sensor_pitch_deg": [11]})", "'sensor_pitch_deg' is a array");
  expect_no_sheet(R"({"seed": -1})", "'seed' is -1, expected a whole number");
  expect_no_sheet(R"({"seed": 1.5})", "'seed' is 1.5");
  expect_no_sheet(R"({"world_origin_m": [1, 2]})", "'world_origin_m' is a array, expected an array of three numbers");
  expect_no_sheet(R"({"world_origin_m": [1, 2, "3"]})", "'world_origin_m' is a string");
  expect_no_sheet(R"({"sensor": 70})", "'sensor' is a number, expected a text");
}

TEST(SensorSheet, RefusesWhatIsNoJsonObject) {
  expect_no_sheet("", "no JSON");
  expect_no_sheet("{\"scan_hz\": 10", "no JSON");
  expect_no_sheet("{\"scan_hz\": nan}", "at byte 13: this is no JSON");
  expect_no_sheet("{} {}", "no JSON");
  expect_no_sheet("[10]", "expected a JSON object");
  expect_no_sheet("{\"\xff\": 1}", "no JSON");
  expect_no_sheet("{\"scan_hz\": 1e999}", "sequence.json: ");
}

TEST(SensorSheet, IsBoundedInDepthAndSize) {
  const std::string deep(100'000, '[');
  expect_no_sheet("{\"a\": " + deep, "nested deeper than 16 levels");
  const test::TempFolder folder;
  test::spill(folder / "sequence.json", "{\"a\": \"" + std::string(1U << 20U, 'x') + "\"}");
  expect_file_error(ErrorCode::unsupported, "sequence.json",
                    [&] { (void)read_sensor_sheet(folder / "sequence.json"); });
}

}  // namespace
}  // namespace berm
