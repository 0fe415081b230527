#include "berm/sim/sensor.hpp"

#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "berm/core/error.hpp"
#include "berm/io/settings.hpp"
#include "berm/io/settings_folders.hpp"
#include "berm/sim/surface.hpp"
#include "sensor_files.hpp"

namespace berm::sim {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

TEST(Sensor, SixAreDescribedAndMakeBeams) {
  const auto names = list_settings({test::sensors_folder()});
  EXPECT_THAT(names, ElementsAre("hdl32e", "hdl64e", "livox_mid360", "livox_mid70", "ouster64", "vlp16"));
  for (const std::string& name : names) {
    SCOPED_TRACE(name);
    const Sensor sensor = test::sensor(name);
    EXPECT_FALSE(sensor.sensor.description.empty());
    Beams beams;
    const BeamPattern pattern(sensor.pattern);
    pattern.beams_of_scan(3, beams);
    EXPECT_GT(beams.size(), 9000U);
    EXPECT_LE(beams.size(), pattern.beams_per_scan());
  }
}

TEST(Sensor, ReadsBackWhatItWrites) {
  const Sensor sensor = test::sensor("hdl64e");
  const Sensor again = parse_sensor(to_yaml(sensor), "again.yaml");
  EXPECT_EQ(again.pattern.elevations_deg, sensor.pattern.elevations_deg);
  EXPECT_EQ(again.pattern.column_s, sensor.pattern.column_s);
  EXPECT_EQ(again.optics.echo, sensor.optics.echo);
}

TEST(Sensor, UnknownNameListsTheKnown) {
  try {
    (void)find_sensor("livox_mid71", {test::sensors_folder()});
    FAIL() << "found a sensor that is not there";
  } catch (const ConfigError& error) {
    EXPECT_THAT(error.what(), HasSubstr("livox_mid70"));
  }
}

/// What is wrong with a VLP-16 that `change` was done to; empty if nothing is.
std::string problem_after(const std::function<void(Sensor&)>& change) {
  Sensor sensor = test::sensor("vlp16");
  change(sensor);
  try {
    sensor.check();
  } catch (const ConfigError& error) {
    return error.key();
  }
  return "";
}

TEST(Sensor, RefusesWhatDoesNotFitTogether) {
  EXPECT_EQ(problem_after([](Sensor&) {}), "");
  EXPECT_EQ(problem_after([](Sensor& s) { s.pattern.elevations_deg = ""; }), "pattern.elevations_deg");
  EXPECT_EQ(problem_after([](Sensor& s) { s.pattern.elevations_deg = "1 2 x"; }), "pattern.elevations_deg");
  EXPECT_EQ(problem_after([](Sensor& s) { s.pattern.elevations_deg = "1 2 91"; }), "pattern.elevations_deg");
  EXPECT_EQ(problem_after([](Sensor& s) { s.pattern.elevations_deg = "1 nan"; }), "pattern.elevations_deg");
  EXPECT_EQ(problem_after([](Sensor& s) { s.pattern.azimuth_offsets_deg = "1 2 3"; }), "pattern.azimuth_offsets_deg");
  EXPECT_EQ(problem_after([](Sensor& s) { s.pattern.column_s = 0.0; }), "pattern.column_s");
  EXPECT_EQ(problem_after([](Sensor& s) { s.pattern.column_s = 1e-9; }), "pattern.column_s");
  EXPECT_EQ(problem_after([](Sensor& s) { s.pattern.column_s = 0.5; }), "pattern.column_s");
  EXPECT_EQ(problem_after([](Sensor& s) { s.pattern.firing_s = 4e-6; }), "pattern.firing_s");
  EXPECT_EQ(problem_after([](Sensor& s) { s.optics.min_range_m = 100.0, s.optics.max_range_m = 50.0; }),
            "optics.min_range_m");
  EXPECT_EQ(problem_after([](Sensor& s) { s.pattern.kind = "rosette", s.pattern.points_per_s = 5.0; }),
            "pattern.points_per_s");
  EXPECT_EQ(problem_after([](Sensor& s) { s.pattern.kind = "swirl", s.pattern.max_elevation_deg = -6.0; }),
            "pattern.max_elevation_deg");
}

TEST(Sensor, LimitIsTenPercentAtItsRange) {
  OpticsConfig optics;
  optics.near_field_m = 3.0;
  optics.range_at_10_percent_m = 80.0;
  EXPECT_NEAR(optics.detection_limit(), 0.1 / 6400.0, 1e-9);
  // Far away light falls with the square of the range; in the near field the receiver loses more than that gains.
  EXPECT_NEAR(received_light(optics, 0.5, 0.5, 40.0) / received_light(optics, 0.5, 0.5, 80.0), 4.0, 1e-3);
  EXPECT_GT(received_light(optics, 0.5, 0.5, 3.0), received_light(optics, 0.5, 0.5, 1.5));
  EXPECT_GT(received_light(optics, 0.1, 1.0, 0.05), optics.detection_limit());
  EXPECT_TRUE(std::isfinite(received_light(optics, 1.0, 1.0, 0.0)));
}

TEST(SurfaceOptics, SnowIsAsBrightAsPublished) {
  const double scale = test::sensor("livox_mid70").optics.reflectivity_scale;
  EXPECT_NEAR(scale * optics_of(Surface::groomed_snow).reflectivity, 151.5, 3.0);  // P section 1: 150 to 153
  for (int i = 0; i <= static_cast<int>(Surface::concrete); ++i) {
    const SurfaceOptics& optics = optics_of(static_cast<Surface>(i));
    EXPECT_GT(optics.reflectivity, 0.0);
    EXPECT_LE(optics.reflectivity, 255.0);
    EXPECT_GT(optics.reflectivity_sigma, 0.0);
    EXPECT_GE(optics.relief_m, 0.0);
    EXPECT_LE(optics.mirror, 1.0);
  }
  EXPECT_GT(optics_of(Surface::water).mirror, 0.9);
  EXPECT_LT(optics_of(Surface::asphalt).reflectivity, optics_of(Surface::concrete).reflectivity);
}

}  // namespace
}  // namespace berm::sim
