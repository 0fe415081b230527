#include "berm/sim/weather.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "sensor_files.hpp"

namespace berm::sim {
namespace {

constexpr int kBeams = 200'000;

/// Snowfall on a Mid-70, even in space.
SnowfallConfig even_snowfall(double flakes_per_m3) {
  SnowfallConfig config;
  config.flakes_per_m3 = flakes_per_m3;
  config.gustiness = 0.0;
  return config;
}

OpticsConfig optics() {
  return test::sensor("livox_mid70").optics;
}

AirPath pass(const Weather& weather, const AirBeam& beam, int index) {
  Random random(5, Purpose::weather, 0, static_cast<std::uint64_t>(index));
  return weather.along(beam, random);
}

/// Share of beams that give an echo.
double share(const Weather& weather, const AirBeam& beam, int beams = kBeams) {
  int echoes = 0;
  for (int i = 0; i < beams; ++i) {
    echoes += pass(weather, beam, i).has_echo ? 1 : 0;
  }
  return static_cast<double>(echoes) / beams;
}

AirBeam level_beam(double end_m) {
  AirBeam beam;
  beam.origin_m = {0.0, 0.0, 2.3};
  beam.end_m = end_m;
  return beam;
}

/// Sum of (found - expected)^2 / expected.
double chi_squared(const std::vector<double>& found, const std::vector<double>& expected) {
  double sum = 0.0;
  for (std::size_t i = 0; i < found.size(); ++i) {
    sum += (found[i] - expected[i]) * (found[i] - expected[i]) / expected[i];
  }
  return sum;
}

TEST(Weather, ClearAirDoesNothing) {
  const Weather weather({}, optics(), {}, 1);
  EXPECT_TRUE(weather.is_clear());
  const AirPath path = pass(weather, level_beam(50.0), 0);
  EXPECT_FALSE(path.has_echo);
  EXPECT_EQ(path.transmission, 1.0);
  EXPECT_FALSE(Weather(even_snowfall(1.0), optics(), {}, 1).is_clear());
}

// The nearest echo of a Poisson process: nearer than r with probability 1 - exp(-expected(r)).
TEST(Snowfall, RangesOfTheNearestFlakeFollowTheClosedForm) {
  const Weather weather(even_snowfall(800.0), optics(), {}, 1);
  constexpr double kEnd_m = 12.0;
  constexpr std::size_t kBins = 24;
  std::vector<double> found(kBins + 1, 0.0);
  for (int i = 0; i < kBeams; ++i) {
    const AirPath path = pass(weather, level_beam(kEnd_m), i);
    found[path.has_echo ? static_cast<std::size_t>(path.echo.range_m / kEnd_m * kBins) : kBins] += 1.0;
  }
  std::vector<double> expected;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    const double from_m = static_cast<double>(bin) * kEnd_m / kBins;
    const double to_m = static_cast<double>(bin + 1) * kEnd_m / kBins;
    expected.push_back(kBeams *
                       (std::exp(-weather.expected_flakes(from_m)) - std::exp(-weather.expected_flakes(to_m))));
  }
  expected.push_back(kBeams * std::exp(-weather.expected_flakes(kEnd_m)));
  // 24 degrees of freedom: above 60 in one of 20,000 runs.
  EXPECT_LT(chi_squared(found, expected), 60.0);
}

// An independent count of what the closed form stands for: flakes thrown one by one.
TEST(Snowfall, ClosedFormCountsTheFlakesThatTheSensorFinds) {
  const OpticsConfig sensor = optics();
  const SnowfallConfig config = even_snowfall(1.0);
  const double limit = sensor.detection_limit();
  constexpr double kRange_m = 5.0;
  const double a = sensor.aperture_m + sensor.divergence_x_mrad * 1e-3 * kRange_m;
  const double b = sensor.aperture_m + sensor.divergence_y_mrad * 1e-3 * kRange_m;
  Random random(1, Purpose::weather);
  double sum = 0.0;
  constexpr int kFlakes = 1'000'000;
  for (int i = 0; i < kFlakes; ++i) {
    const double diameter = config.mean_diameter_m * random.exponential();
    const double reflectivity = config.flake_reflectivity * std::exp(0.8 * random.normal());
    const double met_m2 = std::numbers::pi / 4.0 * (a + diameter) * (b + diameter);
    const double covered = random.uniform(0.0, 2.0) * diameter * diameter / ((a + diameter) * (b + diameter));
    const double light = received_light(sensor, reflectivity, std::min(1.0, covered), kRange_m);
    sum += light >= limit ? met_m2 : 0.0;
  }
  const Weather weather(config, sensor, {}, 1);
  const double per_metre = (weather.expected_flakes(kRange_m + 0.1) - weather.expected_flakes(kRange_m - 0.1)) / 0.2;
  EXPECT_NEAR(per_metre / (sum / kFlakes), 1.0, 0.03);
}

// The settings that the documentation gives for light, middling and heavy snowfall.
TEST(Snowfall, DensitiesForOneFiveAndTwelvePercentOfTheBeams) {
  EXPECT_NEAR(share(Weather(even_snowfall(20.0), optics(), {}, 1), level_beam(60.0)), 0.01, 0.0015);
  EXPECT_NEAR(share(Weather(even_snowfall(101.0), optics(), {}, 1), level_beam(60.0)), 0.05, 0.003);
  EXPECT_NEAR(share(Weather(even_snowfall(253.0), optics(), {}, 1), level_beam(60.0)), 0.12, 0.004);
}

TEST(Snowfall, TwiceTheFlakesGiveTwiceTheEchoes) {
  const Weather one(even_snowfall(10.0), optics(), {}, 1);
  const Weather two(even_snowfall(20.0), optics(), {}, 1);
  EXPECT_NEAR(two.expected_flakes(30.0) / one.expected_flakes(30.0), 2.0, 1e-9);
  EXPECT_NEAR(share(two, level_beam(60.0)) / share(one, level_beam(60.0)), 2.0, 0.15);
}

TEST(Snowfall, IsThickAtTwoToSixMetresAndThinElsewhere) {
  const Weather weather(even_snowfall(100.0), optics(), {}, 1);
  const double all = weather.expected_flakes(60.0);
  const auto per_metre = [&](double from_m, double to_m) {
    return (weather.expected_flakes(to_m) - weather.expected_flakes(from_m)) / (to_m - from_m) / all;
  };
  EXPECT_GT(per_metre(2.0, 6.0), 0.12);
  EXPECT_LT(per_metre(0.0, 1.0), 0.05);
  EXPECT_LT(per_metre(10.0, 20.0), 0.01);
  EXPECT_LT(per_metre(20.0, 60.0), 1e-5);
}

TEST(Snowfall, FlakesAreDarkWithATail) {
  const double scale = optics().reflectivity_scale;
  const Weather weather(even_snowfall(800.0), optics(), {}, 1);
  int echoes = 0;
  int dark = 0;
  int bright = 0;
  for (int i = 0; i < kBeams; ++i) {
    const AirPath path = pass(weather, level_beam(60.0), i);
    if (path.has_echo) {
      const double reported = std::round(path.echo.reflectivity * scale);
      ASSERT_GE(reported, 0.0);
      ASSERT_LE(reported, 255.0);
      ++echoes;
      dark += reported <= 4.0 ? 1 : 0;
      bright += reported > 10.0 ? 1 : 0;
    }
  }
  EXPECT_GT(static_cast<double>(dark) / echoes, 0.9);  // P section 1: 0 to 4
  EXPECT_LT(static_cast<double>(dark) / echoes, 0.99);
  EXPECT_GT(bright, echoes / 500);
}

TEST(Snowfall, EchoesAreFoundAndTakeLight) {
  const OpticsConfig sensor = optics();
  const Weather weather(even_snowfall(800.0), sensor, {}, 1);
  double with_echo = 0.0;
  double without = 0.0;
  int echoes = 0;
  for (int i = 0; i < kBeams; ++i) {
    const AirPath path = pass(weather, level_beam(30.0), i);
    ASSERT_GE(path.transmission, 0.0);
    ASSERT_LT(path.transmission, 1.0);
    if (path.has_echo) {
      EXPECT_GE(path.echo.light, 0.999 * sensor.detection_limit());
      EXPECT_GE(path.echo.range_m, sensor.min_range_m);
      EXPECT_LE(path.echo.range_m, 30.0);
      with_echo += path.transmission;
      ++echoes;
    } else {
      without += path.transmission;
    }
  }
  EXPECT_LT(with_echo / echoes, without / (kBeams - echoes));
}

// Blowing snow alone: echoes of a level beam thin with its height as configured.
TEST(BlowingSnow, ThinsWithHeight) {
  SnowfallConfig config = even_snowfall(0.0);
  config.drift_flakes_per_m3 = 100.0;
  config.drift_height_m = 0.5;
  const Weather weather(config, optics(), {}, 1);
  AirBeam beam = level_beam(10.0);
  beam.height_m = 0.5;
  const double low = -std::log(1.0 - share(weather, beam));
  beam.height_m = 1.0;
  const double high = -std::log(1.0 - share(weather, beam));
  EXPECT_NEAR(low / high, std::numbers::e, 0.25);
}

// A beam that goes down to the ground meets more the lower it is: heights of the echoes against the integral.
TEST(BlowingSnow, IsMetNearTheGround) {
  SnowfallConfig config = even_snowfall(0.0);
  config.drift_flakes_per_m3 = 1000.0;
  config.drift_height_m = 0.4;
  const Weather weather(config, optics(), {}, 1);
  const Weather unit(even_snowfall(1.0), optics(), {}, 1);
  AirBeam beam = level_beam(8.0);
  beam.height_m = 2.0;
  beam.slope = -0.25;
  constexpr int kSteps = 800;
  constexpr int kBins = 8;
  std::vector<double> expected(kBins + 1, 0.0);
  std::vector<double> found(kBins + 1, 0.0);
  double depth = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double from_m = i * 8.0 / kSteps;
    const double to_m = (i + 1) * 8.0 / kSteps;
    const double flakes = (unit.expected_flakes(to_m) - unit.expected_flakes(from_m)) * 1000.0 *
                          std::exp(-(2.0 - 0.25 * (from_m + to_m) / 2.0) / 0.4);
    expected[static_cast<std::size_t>(i * kBins / kSteps)] += kBeams * (std::exp(-depth) - std::exp(-depth - flakes));
    depth += flakes;
  }
  expected[kBins] = kBeams * std::exp(-depth);
  for (int i = 0; i < kBeams; ++i) {
    const AirPath path = pass(weather, beam, i);
    found[path.has_echo ? static_cast<std::size_t>(path.echo.range_m / 8.0 * kBins) : kBins] += 1.0;
  }
  expected.erase(expected.begin(), expected.begin() + 3);  // next to nothing there
  found.erase(found.begin(), found.begin() + 3);
  EXPECT_LT(chi_squared(found, expected), 30.0);  // 5 degrees of freedom
}

TEST(Gusts, MoveWithTheWindAndLeaveTheMean) {
  SnowfallConfig config = even_snowfall(100.0);
  config.gustiness = 1.0;
  config.wind_m_per_s = 5.0;
  config.wind_from_deg = 90.0;  // from the east: clouds go west
  const Weather gusty(config, optics(), {}, 3);
  const Weather even(even_snowfall(100.0), optics(), {}, 3);
  int echoes = 0;
  int same = 0;
  int elsewhere = 0;
  for (int i = 0; i < kBeams; ++i) {
    AirBeam beam = level_beam(20.0);
    beam.origin_m = {3.7 * (i % 200), 3.1 * (i / 1000), 0.0};
    const bool now = pass(gusty, beam, i).has_echo;
    beam.time_s = 4.0;
    elsewhere += pass(gusty, beam, i).has_echo == now ? 0 : 1;
    beam.origin_m.x() -= 20.0;
    same += pass(gusty, beam, i).has_echo == now ? 1 : 0;
    echoes += now ? 1 : 0;
  }
  EXPECT_EQ(same, kBeams);
  EXPECT_GT(elsewhere, 100);
  EXPECT_NEAR(static_cast<double>(echoes) / kBeams, share(even, level_beam(20.0)), 0.004);
}

TEST(Gusts, LeaveGapsAndDifferBySeed) {
  SnowfallConfig config = even_snowfall(2000.0);
  config.gustiness = 1.0;
  const Weather one(config, optics(), {}, 1);
  const Weather other(config, optics(), {}, 2);
  int empty = 0;
  double apart = 0.0;
  for (int place = 0; place < 400; ++place) {
    AirBeam beam = level_beam(20.0);
    beam.origin_m.x() = 11.0 * (place % 20);
    beam.origin_m.y() = 11.0 * (place / 20);
    const double here = share(one, beam, 200);
    empty += here == 0.0 ? 1 : 0;
    apart += std::abs(here - share(other, beam, 200));
  }
  EXPECT_GT(empty, 4);
  EXPECT_LT(empty, 100);
  EXPECT_GT(apart / 400.0, 0.1);
}

Plume plume() {
  Plume plume;
  plume.center_m = {20.0, 0.0, 2.3};
  plume.sigma_m = {2.0, 3.0, 1.5};
  plume.extinction_per_m = 0.2;
  return plume;
}

TEST(Dust, TakesLightAsBeerAndLambertSay) {
  const Weather weather({}, optics(), {plume()}, 1);
  const double depth = 0.2 * 2.0 * std::sqrt(2.0 * std::numbers::pi);
  EXPECT_NEAR(pass(weather, level_beam(100.0), 0).transmission, std::exp(-2.0 * depth), 1e-6);
  EXPECT_NEAR(pass(weather, level_beam(20.0), 0).transmission, std::exp(-depth), 1e-6);
  EXPECT_EQ(pass(weather, level_beam(5.0), 0).transmission, 1.0);
  AirBeam beside = level_beam(100.0);
  beside.origin_m.y() = 3.0;  // one sigma
  EXPECT_NEAR(pass(weather, beside, 0).transmission, std::exp(-2.0 * depth * std::exp(-0.5)), 1e-6);
  beside.direction = -beside.direction;
  EXPECT_EQ(pass(weather, beside, 0).transmission, 1.0);
}

TEST(Dust, GivesEchoesWhereItTakesLight) {
  // A sensor that finds the faintest echo shows where light is lost.
  OpticsConfig keen = optics();
  keen.range_at_10_percent_m = 5000.0;
  const Weather weather({}, keen, {plume()}, 1);
  const double total = 0.2 * 2.0 * std::sqrt(2.0 * std::numbers::pi);
  const auto depth = [&](double range_m) { return total * 0.5 * (1.0 + std::erf((range_m - 20.0) / std::sqrt(8.0))); };
  std::vector<double> found(13, 0.0);
  std::vector<double> expected;
  for (int i = 0; i < kBeams; ++i) {
    const AirPath path = pass(weather, level_beam(100.0), i);
    const double place = path.has_echo ? std::clamp(path.echo.range_m - 14.0, 0.0, 11.5) : 12.0;
    found[static_cast<std::size_t>(place)] += 1.0;
    EXPECT_TRUE(!path.has_echo || path.echo.dust);
  }
  for (int bin = 0; bin < 12; ++bin) {
    const double from = bin == 0 ? 0.0 : depth(14.0 + bin);
    const double to = bin == 11 ? total : depth(15.0 + bin);
    expected.push_back(kBeams * (std::exp(-from) - std::exp(-to)));
  }
  expected.push_back(kBeams * std::exp(-total));
  EXPECT_LT(chi_squared(found, expected), 40.0);  // 12 degrees of freedom
}

// What is lost in many plumes is the product of what is lost in each: none is missed where beams are sorted out.
TEST(Dust, ManyPlumesTakeWhatEachTakes) {
  std::vector<Plume> plumes;
  Random random(4, Purpose::things);
  for (int i = 0; i < 150; ++i) {
    Plume one;
    one.center_m = {random.uniform(-80.0, 80.0), random.uniform(-80.0, 80.0), random.uniform(0.0, 6.0)};
    one.sigma_m = {random.uniform(0.5, 4.0), random.uniform(0.5, 4.0), random.uniform(0.5, 2.0)};
    one.extinction_per_m = 0.05;
    plumes.push_back(one);
  }
  const Weather all({}, optics(), plumes, 1);
  std::vector<Weather> alone;
  for (const Plume& one : plumes) {
    alone.emplace_back(SnowfallConfig{}, optics(), std::vector<Plume>{one}, 1);
  }
  int dusty = 0;
  for (int i = 0; i < 300; ++i) {
    AirBeam beam = level_beam(60.0);
    const double turn = random.uniform(0.0, 6.28);
    beam.direction = Eigen::Vector3d(std::cos(turn), std::sin(turn), random.uniform(-0.1, 0.1)).normalized();
    double product = 1.0;
    for (const Weather& weather : alone) {
      product *= pass(weather, beam, i).transmission;
    }
    EXPECT_NEAR(pass(all, beam, i).transmission, product, 2e-3);  // plumes end four sigmas away
    dusty += product < 0.9 ? 1 : 0;
  }
  EXPECT_GT(dusty, 100);
}

TEST(Dust, DoesNotHideFlakesInFrontOfIt) {
  const Weather snow(even_snowfall(800.0), optics(), {}, 1);
  const Weather both(even_snowfall(800.0), optics(), {plume()}, 1);
  for (int i = 0; i < 2000; ++i) {
    const AirPath path = pass(snow, level_beam(12.0), i);
    const AirPath dusty = pass(both, level_beam(12.0), i);
    EXPECT_EQ(path.has_echo, dusty.has_echo);
    EXPECT_EQ(path.echo.range_m, dusty.echo.range_m);
  }
}

TEST(Weather, SameChanceGivesTheSameEcho) {
  SnowfallConfig config = even_snowfall(300.0);
  config.gustiness = 0.7;
  config.drift_flakes_per_m3 = 500.0;
  const Weather one(config, optics(), {plume()}, 9);
  const Weather two(config, optics(), {plume()}, 9);
  for (int i = 0; i < 5000; ++i) {
    AirBeam beam = level_beam(30.0);
    beam.time_s = i * 1e-3;
    beam.height_m = 1.0;
    const AirPath a = pass(one, beam, i);
    const AirPath b = pass(two, beam, i);
    ASSERT_EQ(a.has_echo, b.has_echo);
    ASSERT_EQ(a.echo.range_m, b.echo.range_m);
    ASSERT_EQ(a.transmission, b.transmission);
  }
}

}  // namespace
}  // namespace berm::sim
