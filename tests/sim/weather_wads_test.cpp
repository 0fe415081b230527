// Flakes of the simulator against those of a real snowfall: WADS, sequence 36, whose flakes are labelled. By its
// elevations (-25..15 degrees, 128 rings) and rate the sensor is a Velodyne VLS-128.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <vector>

#include <gtest/gtest.h>

#include "berm/io/kitti_bin.hpp"
#include "berm/io/label_file.hpp"
#include "berm/sim/surface.hpp"
#include "berm/sim/weather.hpp"
#include "support/data.hpp"

namespace berm::sim {
namespace {

constexpr std::size_t kBins = 18;  ///< of a metre
/// 128 lasers every 53.3 us for 0.1 s.
constexpr double kBeamsPerScan = 240'000.0;

/// Divergence from the manual of the VLS-128. Its range on 10 % reflectivity and its near field are what fits the
/// flakes; the data sheet says more of the range, but the sensor fires with less power where it can.
OpticsConfig vls128() {
  OpticsConfig optics;
  optics.max_range_m = 300.0;
  optics.divergence_x_mrad = 3.0;
  optics.divergence_y_mrad = 1.5;
  optics.aperture_m = 0.011;
  optics.range_at_10_percent_m = 71.0;
  optics.near_field_m = 5.5;
  optics.weak_echo_reflectivity = 0.1;
  optics.reflectivity_scale = 0.1;  // the snow on the ground is reported with 9
  return optics;
}

struct Recorded {
  std::array<double, kBins> flakes{};    ///< by range
  std::array<double, kBins> reaching{};  ///< beams that get to the middle of the bin
  double beams = 0.0;
  double black = 0.0;  ///< flakes of intensity 0
  double dim = 0.0;    ///< of 1 to 4
};

double sum(const std::array<double, kBins>& values) {
  double total = 0.0;
  for (const double value : values) {
    total += value;
  }
  return total;
}

Recorded recorded_weather(const std::filesystem::path& folder) {
  Recorded result;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "velodyne")) {
    const PointCloud cloud(read_kitti_bin(entry.path(), IntensityScale::byte).channels);
    const PointsView points = cloud.view();
    const auto labels = read_labels(folder / "labels" / entry.path().stem().concat(".label"), points.size());
    double reaching = kBeamsPerScan;
    std::array<double, kBins> ending{};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const bool is_flake = semantic_class(labels[i]) == truth::kFallingSnow;
      const double range_m = std::hypot(points.x[i], points.y[i], points.z[i]);
      const auto bin = static_cast<std::size_t>(is_flake ? range_m : range_m + 0.5);
      if (is_flake) {
        result.black += points.intensity[i] < 0.5F ? 1.0 : 0.0;
        result.dim += points.intensity[i] >= 0.5F && points.intensity[i] < 4.5F ? 1.0 : 0.0;
      }
      if (bin < kBins) {
        (is_flake ? result.flakes : ending)[bin] += 1.0;
      }
    }
    for (std::size_t bin = 0; bin < kBins; ++bin) {
      reaching -= ending[bin];
      result.reaching[bin] += reaching;
    }
    result.beams += kBeamsPerScan;
  }
  return result;
}

TEST(SnowfallOfWads, RangesOfFlakesAreAlike) {
  BERM_NEED_DATA(folder, "wads36");
  const Recorded real = recorded_weather(folder);
  SnowfallConfig config;
  config.flakes_per_m3 = 532.0;
  const Weather weather(config, vls128(), {}, 1);
  std::array<double, kBins> made{};
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    const auto from_m = static_cast<double>(bin);
    made[bin] = (weather.expected_flakes(from_m + 1.0) - weather.expected_flakes(from_m)) * real.reaching[bin];
  }
  std::printf("share of beams with a flake: recorded_weather %.4f, simulated %.4f\n", sum(real.flakes) / real.beams,
              sum(made) / real.beams);
  double apart = 0.0;
  for (std::size_t bin = 0; bin < kBins; ++bin) {
    const double real_share = real.flakes[bin] / sum(real.flakes);
    const double made_share = made[bin] / sum(made);
    std::printf("%2zu..%2zu m: recorded_weather %.4f, simulated %.4f\n", bin, bin + 1, real_share, made_share);
    EXPECT_NEAR(made_share, real_share, 0.012);
    apart += std::abs(made_share - real_share) / 2.0;
  }
  EXPECT_LT(apart, 0.03);
  EXPECT_NEAR(sum(made) / sum(real.flakes), 1.0, 0.1);
}

TEST(SnowfallOfWads, FlakesAreAsDark) {
  BERM_NEED_DATA(folder, "wads36");
  const Recorded real = recorded_weather(folder);
  SnowfallConfig config;
  config.flakes_per_m3 = 532.0;
  const Weather weather(config, vls128(), {}, 1);
  AirBeam beam;
  beam.end_m = 60.0;
  double echoes = 0.0;
  double black = 0.0;
  double dim = 0.0;
  for (std::uint64_t i = 0; i < 300'000; ++i) {
    Random random(1, Purpose::beam, 0, i);
    const AirPath path = weather.along(beam, random);
    if (path.has_echo) {
      echoes += 1.0;
      const double reported = path.echo.reflectivity * vls128().reflectivity_scale;
      black += reported < 0.5 ? 1.0 : 0.0;
      dim += reported >= 0.5 && reported < 4.5 ? 1.0 : 0.0;
    }
  }
  const double flakes = sum(real.flakes);
  std::printf("intensity 0: recorded_weather %.3f, simulated %.3f; 1 to 4: recorded_weather %.3f, simulated %.3f\n",
              real.black / flakes, black / echoes, real.dim / flakes, dim / echoes);
  EXPECT_NEAR(black / echoes, real.black / flakes, 0.03);
  EXPECT_NEAR(dim / echoes, real.dim / flakes, 0.03);
}

}  // namespace
}  // namespace berm::sim
