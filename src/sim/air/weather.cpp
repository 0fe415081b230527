#include "berm/sim/weather.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "dust.hpp"
#include "gusts.hpp"
#include "snowfall_table.hpp"

namespace berm::sim {
namespace {

/// Share of flakes that happen to mirror the beam, and the reflectivity that they are reported with on average: as in
/// the recordings of WADS, where 97 % of the flakes have intensity 0 and the others up to 20 and more.
constexpr double kMirroringFlakes = 0.03;
constexpr double kMirroringReflectivity = 7.0;

/// Where gusts are looked up along a beam: most flakes are found about there.
constexpr double kGustRange = 5.0;

}  // namespace

struct Weather::Air {
  SnowfallConfig snowfall;
  OpticsConfig optics;
  SnowfallTable table;
  Gusts gusts;
  Dust dust;
  double extinction_m2;  ///< two-way, of a flake
};

Weather::Weather(const SnowfallConfig& snowfall, const OpticsConfig& optics, std::vector<Plume> plumes,
                 std::uint64_t seed) {
  snowfall.check();
  optics.check();
  // Mean area of a flake is pi/4 E[D^2] = pi/2 mean^2; the light passes it twice. What flakes diffract stays in the
  // beam.
  const double extinction_m2 = std::numbers::pi * snowfall.mean_diameter_m * snowfall.mean_diameter_m;
  air_ = std::make_shared<const Air>(Air{snowfall, optics, SnowfallTable(snowfall, optics), Gusts(snowfall, seed),
                                         Dust(std::move(plumes), optics), extinction_m2});
}

bool Weather::is_clear() const {
  return air_->snowfall.flakes_per_m3 <= 0.0 && air_->snowfall.drift_flakes_per_m3 <= 0.0 && air_->dust.is_empty();
}

double Weather::expected_flakes(double range_m) const {
  return air_->snowfall.flakes_per_m3 * air_->table.expected(range_m);
}

namespace {

/// Flakes per cubic metre along one beam.
class FlakeDensity {
 public:
  FlakeDensity(const SnowfallConfig& snowfall, const AirBeam& beam, double gust)
      : falling_(snowfall.flakes_per_m3 * gust),
        drifting_(snowfall.drift_flakes_per_m3 * gust),
        per_drift_height_(1.0 / snowfall.drift_height_m),
        height_m_(beam.height_m),
        slope_(beam.slope) {
    first_ = at(0.0);
    last_ = at(beam.end_m);
  }

  /// It thins with height, hence one of the ends has the most.
  [[nodiscard]] double most() const { return std::max(first_, last_); }
  [[nodiscard]] double mean() const { return 0.5 * (first_ + last_); }
  [[nodiscard]] double at(double range_m) const {
    return drifting_ > 0.0 ? falling_ + drifting(height_m_ + slope_ * range_m) : falling_;
  }

 private:
  [[nodiscard]] double drifting(double height_m) const {
    const double thinned = std::max(height_m, 0.0) * per_drift_height_;
    return drifting_ * static_cast<double>(std::exp(-static_cast<float>(thinned)));
  }

  double falling_;
  double drifting_;
  double per_drift_height_;
  double height_m_;
  double slope_;
  double first_;
  double last_;
};

/// exp(-depth), to 4e-6 and without calling it where little is lost, as in most beams.
double share_left(double depth) {
  return depth < 0.1 ? 1.0 - depth * (1.0 - depth / 2.0 * (1.0 - depth / 3.0)) : std::exp(-depth);
}

double apparent_reflectivity(const Flake& flake, const OpticsConfig& optics, Random& random) {
  const bool mirrors = random.chance(kMirroringFlakes);
  const double glint = mirrors ? kMirroringReflectivity : optics.weak_echo_reflectivity;
  return 100.0 * flake.reflectivity * flake.share + glint * random.exponential() / optics.reflectivity_scale;
}

/// Range of the nearest flake that is found before the end of the beam, negative if none is: a Poisson process of the
/// greatest density on the beam, of which as many are dropped as the density is lower where they lie.
double nearest_flake_m(const SnowfallTable& table, const FlakeDensity& density, double end_m, Random& random) {
  const double most = density.most();
  const double u = random.uniform();
  // 1 - exp(-expected) is less than what is expected, and that on this beam less than on a long one: most beams need
  // neither the logarithm nor the table.
  if (u >= table.all() * most) {
    return -1.0;
  }
  const double expected = table.expected(end_m) * most;
  if (u >= expected) {
    return -1.0;
  }
  double flakes = -std::log(1.0 - u);
  while (flakes < expected) {
    const double range_m = std::min(table.range_of(flakes / most), end_m);
    if (random.uniform() * most < density.at(range_m)) {
      return range_m;
    }
    flakes += random.exponential();
  }
  return -1.0;
}

}  // namespace

AirPath Weather::along(const AirBeam& beam, Random& random) const {
  AirPath path;
  const SnowfallConfig& snowfall = air_->snowfall;
  if (snowfall.flakes_per_m3 > 0.0 || snowfall.drift_flakes_per_m3 > 0.0) {
    const double gust = air_->gusts.at(beam.origin_m + beam.direction * std::min(beam.end_m, kGustRange), beam.time_s);
    const FlakeDensity density(snowfall, beam, gust);
    path.transmission = share_left(density.mean() * air_->extinction_m2 * beam.end_m);
    const double range_m = nearest_flake_m(air_->table, density, beam.end_m, random);
    if (range_m >= 0.0) {
      const Flake flake = air_->table.draw(range_m, random);
      path.has_echo = true;
      path.echo = {range_m, flake.light, apparent_reflectivity(flake, air_->optics, random), false};
      path.transmission *= (1.0 - flake.share) * (1.0 - flake.share);
    }
  }
  if (!air_->dust.is_empty()) {
    air_->dust.pass(beam, random, path);
  }
  return path;
}

}  // namespace berm::sim
