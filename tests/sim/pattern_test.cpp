#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/angle.hpp"
#include "berm/sim/sensor.hpp"
#include "sensor_files.hpp"

namespace berm::sim {
namespace {

constexpr std::size_t kFarScan = 100'000;

double angle_to_boresight_deg(const Beams& beams, std::size_t i) {
  return std::atan2(std::hypot(beams.y[i], beams.z[i]), beams.x[i]) * kDegPerRad;
}
double elevation_deg(const Beams& beams, std::size_t i) {
  return std::asin(static_cast<double>(beams.z[i])) * kDegPerRad;
}
double azimuth_deg(const Beams& beams, std::size_t i) {
  return std::atan2(static_cast<double>(beams.y[i]), static_cast<double>(beams.x[i])) * kDegPerRad;
}
double step_deg(const Beams& a, std::size_t i, const Beams& b, std::size_t k) {
  return std::hypot(a.x[i] - b.x[k], a.y[i] - b.y[k], a.z[i] - b.z[k]) * kDegPerRad;
}
/// Difference of two angles, -180..180.
double turn_deg(double to, double from) {
  return std::remainder(to - from, 360.0);
}

/// Cells of 1 degree that beams fall into.
std::set<std::pair<int, int>> cells_of(const Beams& beams) {
  std::set<std::pair<int, int>> cells;
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const double scale = angle_to_boresight_deg(beams, i) / std::max(1e-9F, std::hypot(beams.y[i], beams.z[i]));
    cells.emplace(static_cast<int>(std::floor(beams.y[i] * scale)), static_cast<int>(std::floor(beams.z[i] * scale)));
  }
  return cells;
}

void expect_sound(const Beams& beams) {
  for (std::size_t i = 0; i < beams.size(); ++i) {
    ASSERT_NEAR(std::hypot(beams.x[i], beams.y[i], beams.z[i]), 1.0, 1e-6) << i;
    ASSERT_GE(beams.time_s[i], i == 0 ? 0.0F : beams.time_s[i - 1]) << i;
  }
}

TEST(EveryPattern, HasUnitDirectionsInOrderOfTime) {
  for (const char* name : {"livox_mid70", "livox_mid360", "vlp16", "hdl32e", "hdl64e", "ouster64"}) {
    SCOPED_TRACE(name);
    const Sensor sensor = test::sensor(name);
    const BeamPattern pattern(sensor.pattern);
    Beams beams;
    for (const std::size_t scan : {std::size_t{0}, std::size_t{1}, kFarScan}) {
      pattern.beams_of_scan(scan, beams);
      expect_sound(beams);
      EXPECT_LT(beams.time_s.back(), 1.001 / sensor.pattern.scan_hz);
      EXPECT_LE(beams.size(), pattern.beams_per_scan());
    }
  }
}

TEST(EveryPattern, MakesAScanAlikeInAnyOrder) {
  const BeamPattern pattern(test::sensor("livox_mid70").pattern);
  Beams one;
  Beams other;
  pattern.beams_of_scan(7, one);
  pattern.beams_of_scan(2, other);
  pattern.beams_of_scan(7, other);
  EXPECT_EQ(one.x, other.x);
  EXPECT_EQ(one.y, other.y);
}

TEST(Rosette, FillsTheCircleOfItsFieldOfView) {
  const BeamPattern pattern(test::sensor("livox_mid70").pattern);
  std::set<std::pair<int, int>> cells;
  double widest_deg = 0.0;
  Beams beams;
  for (std::size_t scan = 0; scan < 10; ++scan) {
    pattern.beams_of_scan(scan, beams);
    ASSERT_EQ(beams.size(), 10'000U);
    for (std::size_t i = 0; i < beams.size(); ++i) {
      widest_deg = std::max(widest_deg, angle_to_boresight_deg(beams, i));
    }
    cells.merge(cells_of(beams));
  }
  EXPECT_LE(widest_deg, 35.2 + 1e-4);
  EXPECT_GT(widest_deg, 35.1);
  EXPECT_GT(static_cast<double>(cells.size()), 0.97 * std::numbers::pi * 35.2 * 35.2);
}

// Two equal arrows that turn past each other at a constant rate: the length of their sum is R |cos|, which is below
// q R for a share of 2/pi asin(q) of the time.
TEST(Rosette, IsDensestInTheMiddleAndAtTheRim) {
  PatternConfig config = test::sensor("livox_mid70").pattern;
  config.prism_share = 0.5;
  Beams beams;
  BeamPattern(config).beams_of_scan(5, beams);
  std::vector<double> angles_deg;
  for (std::size_t i = 0; i < beams.size(); ++i) {
    angles_deg.push_back(angle_to_boresight_deg(beams, i));
  }
  for (const double q : {0.1, 0.3, 0.5, 0.7, 0.9, 0.97}) {
    const auto below = std::count_if(angles_deg.begin(), angles_deg.end(), [&](double a) { return a < q * 35.2; });
    EXPECT_NEAR(static_cast<double>(below) / 10'000.0, 2.0 / std::numbers::pi * std::asin(q), 0.005) << q;
  }
}

TEST(Rosette, HasTwentyPetalsAScan) {
  const BeamPattern pattern(test::sensor("livox_mid70").pattern);
  Beams beams;
  int petals = 0;
  for (std::size_t scan = 0; scan < 50; ++scan) {
    pattern.beams_of_scan(scan, beams);
    for (std::size_t i = 1; i + 1 < beams.size(); ++i) {
      petals += beams.x[i] < beams.x[i - 1] && beams.x[i] <= beams.x[i + 1] ? 1 : 0;
    }
  }
  EXPECT_NEAR(petals / 5.0, 200.5, 1.0);  // a second, as the recording of a Mid-40 has them
}

TEST(Rosette, GoesOnFromScanToScanAndNeverRepeats) {
  const BeamPattern pattern(test::sensor("livox_mid70").pattern);
  Beams before;
  Beams after;
  double widest_deg = 0.0;
  for (const std::size_t scan : {std::size_t{0}, std::size_t{1}, kFarScan}) {
    pattern.beams_of_scan(scan, before);
    pattern.beams_of_scan(scan + 1, after);
    for (std::size_t i = 1; i < before.size(); ++i) {
      widest_deg = std::max(widest_deg, step_deg(before, i - 1, before, i));
    }
    EXPECT_LE(step_deg(before, before.size() - 1, after, 0), widest_deg);
    EXPECT_GT(step_deg(before, before.size() - 1, after, 0), 0.01);
    double apart_deg = 0.0;
    for (std::size_t i = 0; i < before.size(); ++i) {
      apart_deg += step_deg(before, i, after, i) / static_cast<double>(before.size());
    }
    EXPECT_GT(apart_deg, 5.0);
  }
}

TEST(Rosette, IsExactAfterHours) {
  const PatternConfig config = test::sensor("livox_mid70").pattern;
  Beams beams;
  BeamPattern(config).beams_of_scan(kFarScan, beams);
  const long double reach = 35.2L / 180.0L * std::numbers::pi_v<long double>;
  const auto hz = static_cast<long double>(config.prism_hz);
  const auto ratio = static_cast<long double>(config.prism_ratio);
  const auto share = static_cast<long double>(config.prism_share);
  for (const std::size_t i : {std::size_t{0}, std::size_t{5000}, std::size_t{9999}}) {
    const long double t = static_cast<long double>(kFarScan * 10'000 + i) / 100'000.0L;
    const long double one = 2.0L * std::numbers::pi_v<long double> * std::fmod(hz * t, 1.0L);
    const long double two = 2.0L * std::numbers::pi_v<long double> * std::fmod(hz * ratio * t, 1.0L);
    const long double y = reach * (share * std::cos(one) + (1.0L - share) * std::cos(two));
    const long double z = reach * (share * std::sin(one) + (1.0L - share) * std::sin(two));
    const long double angle = std::hypot(y, z);
    EXPECT_NEAR(static_cast<double>(beams.y[i]), static_cast<double>(std::sin(angle) * y / angle), 2e-7) << i;
    EXPECT_NEAR(static_cast<double>(beams.z[i]), static_cast<double>(std::sin(angle) * z / angle), 2e-7) << i;
    EXPECT_NEAR(static_cast<double>(beams.x[i]), static_cast<double>(std::cos(angle)), 2e-7) << i;
  }
}

TEST(Spinning, Vlp16FiresInItsOrderAndTime) {
  const BeamPattern pattern(test::sensor("vlp16").pattern);
  Beams beams;
  pattern.beams_of_scan(4, beams);
  const std::array<double, 16> order_deg = {-15, 1, -13, 3, -11, 5, -9, 7, -7, 9, -5, 11, -3, 13, -1, 15};
  for (std::size_t i = 0; i < 160; ++i) {
    EXPECT_NEAR(elevation_deg(beams, i), order_deg[i % 16], 1e-5);
    EXPECT_EQ(beams.ring[i], static_cast<int>(order_deg[i % 16] + 15.0) / 2);
    const double since_first_s = static_cast<double>(beams.time_s[i] - beams.time_s[0]);
    EXPECT_NEAR(since_first_s, static_cast<double>(i / 16) * 55.296e-6 + static_cast<double>(i % 16) * 2.304e-6, 1e-8);
    // Ten turns a second, clockwise, while the lasers fire, too.
    EXPECT_NEAR(turn_deg(azimuth_deg(beams, i), azimuth_deg(beams, 0)), -3600.0 * since_first_s, 1e-4);
  }
}

// 0.1 s is no multiple of a column: scans differ by one, none is lost, and the head turns on.
TEST(Spinning, Vlp16LosesNoColumnBetweenScans) {
  const BeamPattern pattern(test::sensor("vlp16").pattern);
  Beams beams;
  Beams before;
  std::size_t columns = 0;
  for (std::size_t scan = 0; scan < 100; ++scan) {
    pattern.beams_of_scan(scan, beams);
    ASSERT_TRUE(beams.size() == 1808 * 16 || beams.size() == 1809 * 16);
    columns += beams.size() / 16;
    if (scan > 0) {
      EXPECT_NEAR(turn_deg(azimuth_deg(beams, 0), azimuth_deg(before, before.size() - 16)), -3600.0 * 55.296e-6, 1e-4);
    }
    std::swap(before, beams);
  }
  EXPECT_EQ(columns, static_cast<std::size_t>(std::ceil(10.0 / 55.296e-6)));
}

TEST(Spinning, RatesAreThoseOfTheDataSheets) {
  const auto per_s = [](const char* name) {
    const BeamPattern pattern(test::sensor(name).pattern);
    Beams beams;
    std::size_t count = 0;
    for (std::size_t scan = 0; scan < 10; ++scan) {
      pattern.beams_of_scan(scan, beams);
      count += beams.size();
    }
    return static_cast<double>(count);
  };
  EXPECT_NEAR(per_s("hdl32e"), 695'000.0, 1000.0);
  EXPECT_NEAR(per_s("hdl64e"), 1'333'000.0, 1000.0);
  EXPECT_EQ(per_s("ouster64"), 655'360.0);
  EXPECT_EQ(per_s("livox_mid360"), 200'000.0);
}

TEST(Spinning, RingsGoUpFromTheLowest) {
  for (const auto& [name, lowest_deg, highest_deg, rings] :
       {std::tuple{"hdl32e", -30.67, 10.67, 32}, {"hdl64e", -24.71, 2.02, 64}, {"ouster64", -16.611, 16.611, 64}}) {
    SCOPED_TRACE(name);
    Beams beams;
    BeamPattern(test::sensor(name).pattern).beams_of_scan(0, beams);
    std::vector<double> of_ring(static_cast<std::size_t>(rings), -99.0);
    for (std::size_t i = 0; i < beams.size(); ++i) {
      double& ring_deg = of_ring.at(beams.ring[i]);
      if (ring_deg > -99.0) {
        ASSERT_NEAR(elevation_deg(beams, i), ring_deg, 1e-4);
      }
      ring_deg = elevation_deg(beams, i);
    }
    EXPECT_NEAR(of_ring.front(), lowest_deg, 1e-4);
    EXPECT_NEAR(of_ring.back(), highest_deg, 1e-4);
    EXPECT_TRUE(std::is_sorted(of_ring.begin(), of_ring.end()));
  }
}

TEST(Spinning, LasersOfAnOusterFireTogetherAndLookSideways) {
  Beams beams;
  BeamPattern(test::sensor("ouster64").pattern).beams_of_scan(0, beams);
  const std::array<double, 4> offsets_deg = {-3.164, -1.055, 1.055, 3.164};
  for (std::size_t i = 0; i < 64; ++i) {
    EXPECT_EQ(beams.time_s[i], beams.time_s[0]);
    EXPECT_NEAR(azimuth_deg(beams, i), offsets_deg[i % 4], 1e-4);
  }
  EXPECT_NEAR(turn_deg(azimuth_deg(beams, 64), azimuth_deg(beams, 0)), -360.0 / 1024.0, 1e-4);
}

TEST(Swirl, FillsTheViewOfAMid360WithoutRepeating) {
  const BeamPattern pattern(test::sensor("livox_mid360").pattern);
  std::array<int, 36> by_azimuth{};
  double lowest_deg = 90.0;
  double highest_deg = -90.0;
  Beams beams;
  Beams first;
  pattern.beams_of_scan(0, first);
  double apart_deg = 0.0;
  for (std::size_t scan = 0; scan < 10; ++scan) {
    pattern.beams_of_scan(scan, beams);
    ASSERT_EQ(beams.size(), 20'000U);
    for (std::size_t i = 0; i < beams.size(); ++i) {
      lowest_deg = std::min(lowest_deg, elevation_deg(beams, i));
      highest_deg = std::max(highest_deg, elevation_deg(beams, i));
      ++by_azimuth.at(static_cast<std::size_t>((azimuth_deg(beams, i) + 180.0) / 10.0001));
      apart_deg += scan == 1 ? step_deg(beams, i, first, i) / 20'000.0 : 0.0;
    }
  }
  EXPECT_NEAR(lowest_deg, -7.0, 0.3);
  EXPECT_NEAR(highest_deg, 52.0, 0.3);
  const auto [least, most] = std::minmax_element(by_azimuth.begin(), by_azimuth.end());
  EXPECT_GT(*least, 0.9 * 200'000 / 36);
  EXPECT_LT(*most, 1.1 * 200'000 / 36);
  EXPECT_GT(apart_deg, 10.0);
}

}  // namespace
}  // namespace berm::sim
