#include "snow.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "berm/core/multiversion.hpp"
#include "smooth.hpp"

namespace berm::sim {
namespace {

/// Share of flakes that happen to mirror the beam, and the reflectivity that they are reported with on average: as in
/// the recordings of WADS, where 97 % of the flakes have intensity 0 and the others up to 20 and more.
constexpr double kMirroringFlakes = 0.03;
constexpr double kMirroringReflectivity = 7.0;

/// Where gusts are looked up along a beam: most flakes are found about there.
constexpr float kGustRange = 5.0F;

struct Thinning {
  float falling;
  float drifting;
  float per_height;
  float height_m;
  float extinction_m2;  ///< two-way, of a flake
};

/// Drifting snow thins with height, hence one of the ends of a beam has the most.
BERM_MULTIVERSION void thin(const AirLanes& beams, const float* __restrict gusts, Thinning t, float* __restrict most,
                            float* __restrict transmission) {
  const float height = t.height_m > 0.0F ? t.height_m : 0.0F;
  const float here = t.falling + t.drifting * fade(height * t.per_height);
  for (std::size_t i = 0; i < beams.padded(); ++i) {
    const float end = t.height_m + beams.slope[i] * beams.end_m[i];
    const float there = t.falling + t.drifting * fade((end > 0.0F ? end : 0.0F) * t.per_height);
    most[i] = gusts[i] * (here > there ? here : there);
    transmission[i] = fade(0.5F * gusts[i] * (here + there) * t.extinction_m2 * beams.end_m[i]);
  }
}

double apparent_reflectivity(const Flake& flake, const OpticsConfig& optics, Random& random) {
  const bool mirrors = random.chance(kMirroringFlakes);
  const double glint = mirrors ? kMirroringReflectivity : optics.weak_echo_reflectivity;
  return 100.0 * flake.reflectivity * flake.share + glint * random.exponential() / optics.reflectivity_scale;
}

}  // namespace

Snow::Snow(const SnowfallConfig& snowfall, const OpticsConfig& optics, std::uint64_t seed)
    : snowfall_(snowfall), optics_(optics), table_(snowfall, optics), gusts_(snowfall, seed) {}

void Snow::pass(AirLanes& beams) const {
  std::array<float, AirLanes::kMost> gusts;  // NOLINT(cppcoreguidelines-pro-type-member-init): all that is read is
  std::array<float, AirLanes::kMost> most;   // NOLINT(cppcoreguidelines-pro-type-member-init): written first
  gusts_.along(beams, kGustRange, gusts);
  // Mean area of a flake is pi/4 E[D^2] = pi/2 mean^2; the light passes it twice. What flakes diffract stays in the
  // beam.
  const double extinction_m2 = std::numbers::pi * snowfall_.mean_diameter_m * snowfall_.mean_diameter_m;
  thin(beams, gusts.data(),
       {static_cast<float>(snowfall_.flakes_per_m3), static_cast<float>(snowfall_.drift_flakes_per_m3),
        static_cast<float>(1.0 / snowfall_.drift_height_m), static_cast<float>(beams.height_m),
        static_cast<float>(extinction_m2)},
       most.data(), beams.transmission.data());
  for (std::size_t lane = 0; lane < beams.count; ++lane) {
    const double range_m = nearest_m(beams, lane, {gusts[lane], most[lane]});
    if (range_m >= 0.0) {
      add_flake(beams, lane, range_m);
    }
  }
}

double Snow::at(const Density& density, double height_m) const {
  const double thinned = std::max(height_m, 0.0) / snowfall_.drift_height_m;
  return static_cast<double>(density.gust) *
         (snowfall_.flakes_per_m3 +
          snowfall_.drift_flakes_per_m3 * static_cast<double>(fade(static_cast<float>(thinned))));
}

/// Range of the nearest flake that is found before the end of the beam, negative if none is: a Poisson process of the
/// greatest density on the beam, of which as many are dropped as the density is lower where they lie.
double Snow::nearest_m(const AirLanes& beams, std::size_t lane, const Density& density) const {
  const auto most = static_cast<double>(density.most);
  Random& random = *beams.random[lane];
  const double u = random.uniform();
  // 1 - exp(-expected) is less than what is expected, and that on this beam less than on a long one: most beams need
  // neither the logarithm nor the table.
  if (u >= table_.all() * most) {
    return -1.0;
  }
  const auto end_m = static_cast<double>(beams.end_m[lane]);
  const double expected = table_.expected(end_m) * most;
  if (u >= expected) {
    return -1.0;
  }
  double flakes = -std::log(1.0 - u);
  while (flakes < expected) {
    const double range_m = std::min(table_.range_of(flakes / most), end_m);
    const double height_m = beams.height_m + static_cast<double>(beams.slope[lane]) * range_m;
    if (random.uniform() * most < at(density, height_m)) {
      return range_m;
    }
    flakes += random.exponential();
  }
  return -1.0;
}

void Snow::add_flake(AirLanes& beams, std::size_t lane, double range_m) const {
  Random& random = *beams.random[lane];
  const Flake flake = table_.draw(range_m, random);
  beams.has_echo[lane] = true;
  beams.echo[lane] = {range_m, flake.light, apparent_reflectivity(flake, optics_, random), false};
  beams.transmission[lane] *= static_cast<float>((1.0 - flake.share) * (1.0 - flake.share));
}

}  // namespace berm::sim
