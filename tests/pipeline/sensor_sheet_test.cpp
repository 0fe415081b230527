#include "berm/pipeline/sensor_sheet.hpp"

#include <numbers>

#include <gtest/gtest.h>

#include "berm/core/error.hpp"

namespace berm {
namespace {

Machine sheet_machine() {
  Machine machine;
  machine.machine.name = "made";
  machine.mount.height_m = 2.0;
  machine.mount.pitch_deg = 11.0;
  return machine;
}

TEST(SensorSheet, BeatsTheMachineAndSaysSo) {
  Machine machine = sheet_machine();
  const SensorSheet sheet{.height_m = 2.5, .pitch_rad = 12.0 * std::numbers::pi / 180.0};
  const auto notes = adopt_sheet(machine, sheet, {});
  EXPECT_EQ(machine.mount.height_m, 2.5);
  EXPECT_EQ(machine.mount.pitch_deg, 12.0);
  EXPECT_EQ(machine.sensor.scan_hz, SensorConfig{}.scan_hz);
  EXPECT_EQ(notes.size(), 2U);
}

TEST(SensorSheet, WhatIsEqualIsNotNoted) {
  Machine machine = sheet_machine();
  const SensorSheet sheet{.height_m = 2.0, .pitch_rad = 11.0 * std::numbers::pi / 180.0};
  EXPECT_TRUE(adopt_sheet(machine, sheet, {}).empty());
}

TEST(SensorSheet, PinnedKeysStay) {
  Machine machine = sheet_machine();
  const auto notes = adopt_sheet(machine, {.height_m = 2.5, .scan_hz = 20.0}, {"mount.height_m"});
  EXPECT_EQ(machine.mount.height_m, 2.0);
  EXPECT_EQ(machine.sensor.scan_hz, 20.0);
  EXPECT_EQ(notes.size(), 2U);
}

TEST(SensorSheet, AbsurdValuesAreRefused) {
  Machine machine = sheet_machine();
  EXPECT_THROW(adopt_sheet(machine, {.height_m = 99.0}, {}), ConfigError);
}

}  // namespace
}  // namespace berm
