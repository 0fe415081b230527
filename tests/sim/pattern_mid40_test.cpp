// The rosette against a real recording of a Livox Mid-40, of the same family as the Mid-70: 3 s in firing order, beams
// without return left out. They are missing above the horizon, hence densities are compared below it.

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/angle.hpp"
#include "berm/io/pcd.hpp"
#include "berm/sim/sensor.hpp"
#include "sensor_files.hpp"
#include "support/data.hpp"

namespace berm::sim {
namespace {

constexpr double kFieldOfView_deg = 38.4;
/// Boresight of this sensor in its own frame: where the rosette has its middle.
constexpr std::complex<double> kMiddle_deg{-0.396, -0.497};

/// Deflections in degrees: length is the angle to the boresight, real part to the left, imaginary part up.
using Deflections = std::vector<std::complex<double>>;

Deflections recorded(const std::filesystem::path& file) {
  const PointCloud cloud(read_pcd(file).channels);
  const PointsView points = cloud.view();
  Deflections deflections;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const std::complex<double> side(points.y[i], points.z[i]);
    const double angle_deg = std::atan2(std::abs(side), static_cast<double>(points.x[i])) * kDegPerRad;
    deflections.push_back(side / std::max(std::abs(side), 1e-9) * angle_deg - kMiddle_deg);
  }
  return deflections;
}

Deflections simulated(std::size_t scans) {
  PatternConfig config = test::sensor("livox_mid70").pattern;
  config.field_of_view_deg = kFieldOfView_deg;
  const BeamPattern pattern(config);
  Deflections deflections;
  Beams beams;
  for (std::size_t scan = 0; scan < scans; ++scan) {
    pattern.beams_of_scan(scan, beams);
    for (std::size_t i = 0; i < beams.size(); ++i) {
      const std::complex<double> side(beams.y[i], beams.z[i]);
      const double angle_deg = std::atan2(std::abs(side), static_cast<double>(beams.x[i])) * kDegPerRad;
      deflections.push_back(side / std::max(std::abs(side), 1e-9) * angle_deg);
    }
  }
  return deflections;
}

/// Where petals begin: the nearest beam to the middle of each passage.
std::vector<std::size_t> petal_starts(const Deflections& deflections) {
  constexpr double kNear_deg = 2.0;
  std::vector<std::size_t> starts;
  std::size_t i = 0;
  while (i < deflections.size()) {
    std::size_t nearest = i;
    const std::size_t begin = i;
    while (i < deflections.size() && std::abs(deflections[i]) < kNear_deg) {
      nearest = std::abs(deflections[i]) < std::abs(deflections[nearest]) ? i : nearest;
      ++i;
    }
    if (i > begin) {
      starts.push_back(nearest);
    }
    ++i;
  }
  return starts;
}

/// Samples of petals that lost no beam: the median of those within 1 % of the longest.
double samples_a_petal(const std::vector<std::size_t>& starts) {
  std::vector<double> lengths;
  for (std::size_t i = 1; i < starts.size(); ++i) {
    lengths.push_back(static_cast<double>(starts[i] - starts[i - 1]));
  }
  std::sort(lengths.begin(), lengths.end());
  const auto whole = std::lower_bound(lengths.begin(), lengths.end(), 0.99 * lengths.back());
  return *(whole + (lengths.end() - whole) / 2);
}

/// Angle from the tip of a petal to the tip of the next, that fits all of them: the angle for which the tips, turned
/// back by it once more for each petal, agree best.
double advance_deg(const Deflections& deflections, const std::vector<std::size_t>& starts) {
  std::vector<std::complex<double>> tips;
  for (std::size_t i = 1; i < starts.size(); ++i) {
    const auto tip = std::max_element(deflections.begin() + static_cast<std::ptrdiff_t>(starts[i - 1]),
                                      deflections.begin() + static_cast<std::ptrdiff_t>(starts[i]),
                                      [](const auto& a, const auto& b) { return std::abs(a) < std::abs(b); });
    tips.push_back(std::abs(*tip) > 18.5 ? *tip / std::abs(*tip) : 0.0);
  }
  double best = 0.0;
  double best_deg = 0.0;
  for (double trial_deg = 138.0; trial_deg < 143.0; trial_deg += 0.002) {
    std::complex<double> sum = 0.0;
    for (std::size_t i = 0; i < tips.size(); ++i) {
      sum += tips[i] * std::polar(1.0, -trial_deg / kDegPerRad * static_cast<double>(i));
    }
    if (std::abs(sum) > best) {
      best = std::abs(sum);
      best_deg = trial_deg;
    }
  }
  return best_deg;
}

/// Beams per degree from 2 degrees outwards in the third of the circle below, over all beams that went there. Nearer to
/// the middle some are lost.
std::array<double, 19> radial_density(const Deflections& deflections) {
  std::array<double, 19> density{};
  double sum = 0.0;
  for (const auto& deflection : deflections) {
    const double angle_deg = std::arg(deflection) * kDegPerRad;
    const auto degree = static_cast<std::size_t>(std::abs(deflection));
    if (angle_deg > -150.0 && angle_deg < -30.0 && degree >= 2 && degree < density.size()) {
      density[degree] += 1.0;
      sum += 1.0;
    }
  }
  for (double& part : density) {
    part /= sum;
  }
  return density;
}

TEST(RosetteOfAMid40, HasTheSameNumberAndTurnOfPetals) {
  BERM_NEED_DATA(file, "livox_mid40/10.pcd");
  const Deflections real = recorded(file);
  const Deflections made = simulated(30);  // the recording spans 2.98 s at this rate
  const auto real_starts = petal_starts(real);
  const auto made_starts = petal_starts(made);
  EXPECT_NEAR(static_cast<double>(real_starts.size()), static_cast<double>(made_starts.size()), 5.0);
  EXPECT_NEAR(samples_a_petal(real_starts), samples_a_petal(made_starts), 2.5);
  // The sense in which the prisms turn counts, too: the other one would give 360 less that.
  EXPECT_NEAR(advance_deg(real, real_starts), advance_deg(made, made_starts), 0.01);
}

TEST(RosetteOfAMid40, HasTheSameRadialDensity) {
  BERM_NEED_DATA(file, "livox_mid40/10.pcd");
  const auto real = radial_density(recorded(file));
  const auto made = radial_density(simulated(30));
  for (std::size_t degree = 0; degree < real.size(); ++degree) {
    EXPECT_NEAR(real[degree], made[degree], 0.003 + 0.06 * made[degree]) << degree;
  }
}

}  // namespace
}  // namespace berm::sim
