#include "berm/io/sensor_sheet.hpp"

#include <string>

#include <gtest/gtest.h>

#include "support/file_error.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

using test::expect_file_error;

void expect_refused(const std::string& text, const std::string& part) {
  SCOPED_TRACE(text.substr(0, 80));
  expect_file_error(ErrorCode::malformed, part, [&] { (void)parse_sensor_sheet(text, "sequence.json"); });
}

TEST(SensorSheet, ReadsWhatItKnowsAndListsTheRest) {
  const SensorSheet sheet = parse_sensor_sheet(
      R"({"scan_hz": 10, "sensor": "Mid-70", "sensor_height_m": 2.3, "sensor_pitch_deg": 11, "weather": {"snow": 0.1}, "seed": 7})",
      "sequence.json");
  EXPECT_EQ(sheet.sensor, "Mid-70");
  EXPECT_EQ(sheet.height_m, 2.3);
  EXPECT_NEAR(sheet.pitch_rad.value(), 0.191986, 1e-6);
  EXPECT_EQ(sheet.scan_hz, 10.0);
  EXPECT_EQ(sheet.unknown_keys, (std::vector<std::string>{"seed", "weather"}));
}

TEST(SensorSheet, NeedsNothing) {
  const SensorSheet sheet = parse_sensor_sheet("{}", "sequence.json");
  EXPECT_FALSE(sheet.sensor || sheet.height_m || sheet.pitch_rad || sheet.scan_hz);
}

TEST(SensorSheet, RefusesOtherTypesAndRanges) {
  expect_refused(R"({"scan_hz": "10"})", "sequence.json: 'scan_hz' is a string, expected a number from 0.01 to 1000");
  expect_refused(R"({"scan_hz": true})", "'scan_hz' is a boolean");
  expect_refused(R"({"scan_hz": null})", "'scan_hz' is a null");
  expect_refused(R"({"scan_hz": 0})", "'scan_hz' is 0, expected");
  expect_refused(R"({"scan_hz": 1e300})", "expected a number from");
  expect_refused(R"({"sensor_height_m": -1})", "'sensor_height_m' is -1");
  expect_refused(R"({"sensor_pitch_deg": [11]})", "'sensor_pitch_deg' is a array");
  expect_refused(R"({"sensor": 70})", "'sensor' is a number, expected a text");
}

TEST(SensorSheet, RefusesWhatIsNoJsonObject) {
  expect_refused("", "no JSON");
  expect_refused("{\"scan_hz\": 10", "no JSON");
  expect_refused("{\"scan_hz\": nan}", "at byte 13: this is no JSON");
  expect_refused("{} {}", "no JSON");
  expect_refused("[10]", "expected a JSON object");
  expect_refused("{\"\xff\": 1}", "no JSON");
  expect_refused("{\"scan_hz\": 1e999}", "sequence.json: ");
}

TEST(SensorSheet, IsBoundedInDepthAndSize) {
  const std::string deep(100'000, '[');
  expect_refused("{\"a\": " + deep, "nested deeper than 16 levels");
  const test::TempFolder folder;
  test::spill(folder / "sequence.json", "{\"a\": \"" + std::string(1U << 20U, 'x') + "\"}");
  expect_file_error(ErrorCode::unsupported, "sequence.json",
                    [&] { (void)read_sensor_sheet(folder / "sequence.json"); });
}

}  // namespace
}  // namespace berm
