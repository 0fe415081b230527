#include "echo_maker.hpp"

#include <algorithm>
#include <cmath>

#include "beam_optics.hpp"
#include "beam_random.hpp"

namespace berm::sim {
namespace {

constexpr float kMaxReflectivity = 255.0F;
constexpr std::uint32_t kFirstMover = 2;

std::uint32_t label_of(const Hit& hit) {
  if (hit.object < kFirstMover) {
    return hit.material.truth_id;
  }
  const std::uint32_t id = hit.material.truth_id == truth::kVehicle ? truth::kMovingVehicle : hit.material.truth_id;
  return id | ((hit.object - kFirstMover + 1) << 16U);
}

}  // namespace

Return EchoMaker::echo_of(std::span<const TracedRay> rays, double height_m, Random& random,
                          std::span<Echo> memory) const {
  if (random.chance(optics_.dropout)) {
    return {};
  }
  // Well before it is read: what is written by halves and read as a whole at once makes the processor wait.
  AirBeam beam;
  if (weathers_) {
    beam.origin_m = rays.front().origin_m.cast<double>();
    beam.direction = rays.front().direction.cast<double>();
    beam.time_s = rays.front().time_s;
  }
  Echoes echoes;
  echoes.parts = memory;
  echoes.nearest_m = static_cast<float>(optics_.max_range_m);
  const float share = 1.0F / static_cast<float>(rays.size());
  for (const TracedRay& ray : rays) {
    if (!ray.hit.is_nothing()) {
      add_surface(ray, share, random, echoes);
    }
  }
  if (weathers_) {
    add_air(beam, height_m, random, echoes);
  }
  const std::span<Echo> parts = memory.first(echoes.count);
  const std::size_t left = melt(parts, static_cast<float>(optics_.echo_separation_m));
  const Echo* echo = choose(parts.first(left), random);
  return echo == nullptr ? Return{} : report(*echo, random);
}

void EchoMaker::add_surface(const TracedRay& ray, float share, Random& random, Echoes& echoes) const {
  const Hit hit = caster_.describe(ray.origin_m, ray.direction, ray.hit);
  const auto range_m = static_cast<float>(hit.range_m);
  if (range_m < echoes.nearest_m) {
    echoes.nearest_m = range_m;
    echoes.on_ground = hit.object == 0;
  }
  const SurfaceOptics& surface = optics_of(hit.material.surface);
  const float cosine = std::clamp(-hit.normal.dot(ray.direction), 0.0F, 1.0F);
  const float lost = mirrored(surface, cosine);
  if (range_m < static_cast<float>(optics_.min_range_m) || (lost > 0.0F && random.chance(static_cast<double>(lost)))) {
    return;
  }
  Echo& echo = echoes.parts[echoes.count++];
  const float bright = share * shade(hit.material.surface, cosine);
  const auto reflectivity = static_cast<float>(surface.reflectivity);
  echo.range_m = range_m;
  if (hit.material.surface == Surface::groomed_snow) {
    echo.range_m -= corduroy_m(hit, ray.direction, cosine, optics_) / std::max(cosine, kLeastCosine);
  }
  echo.energy = bright * reflectivity;
  echo.light = static_cast<float>(
      received_light(optics_, surface.reflectivity * 0.01, static_cast<double>(share * cosine), hit.range_m));
  echo.variance_m2 = relief_variance_m2(surface, cosine, range_m, optics_);
  echo.spot_sigma = bright * static_cast<float>(surface.reflectivity_sigma);
  echo.label = label_of(hit);
  echo.label_lead = echo.energy;
}

void EchoMaker::add_air(AirBeam& beam, double height_m, Random& random, Echoes& echoes) const {
  beam.end_m = static_cast<double>(echoes.nearest_m);
  beam.height_m = height_m;
  // Down to the ground that the beam meets; else as the beam itself rises or falls.
  beam.slope = echoes.on_ground ? -height_m / std::max(beam.end_m, 1e-3) : beam.direction.z();
  const AirPath air = weather_.along(beam, random);
  const auto passes = static_cast<float>(air.transmission);
  for (std::size_t i = 0; i < echoes.count; ++i) {
    echoes.parts[i].energy *= passes;
    echoes.parts[i].light *= passes;
    echoes.parts[i].spot_sigma *= passes;
    echoes.parts[i].label_lead *= passes;
  }
  if (air.has_echo && air.echo.range_m >= optics_.min_range_m) {
    Echo& echo = echoes.parts[echoes.count++];
    echo = {};
    echo.range_m = static_cast<float>(air.echo.range_m);
    echo.energy = static_cast<float>(air.echo.reflectivity);
    echo.light = static_cast<float>(air.echo.light);
    echo.label = air.echo.dust ? truth::kDust : truth::kFallingSnow;
    echo.label_lead = echo.energy;
  }
}

const Echo* EchoMaker::choose(std::span<const Echo> echoes, Random& random) const {
  const Echo* chosen = nullptr;
  float strongest = 0.0F;
  for (const Echo& echo : echoes) {
    const float signal = echo.light / detection_limit_;
    // Echoes of the air are those that the sensor finds.
    const bool is_air = echo.label == truth::kFallingSnow || echo.label == truth::kDust;
    if (!is_air && !random.chance(static_cast<double>(detection_probability(signal)))) {
      continue;
    }
    const bool better =
        choice_ == EchoChoice::last || chosen == nullptr || (choice_ == EchoChoice::strongest && signal > strongest);
    if (better) {
      chosen = &echo;
      strongest = signal;
    }
  }
  return chosen;
}

Return EchoMaker::report(const Echo& echo, Random& random) const {
  const NormalPair normal = normal_pair(random);
  const float variance_m2 = echo.variance_m2 + range_variance_m2(echo.light / detection_limit_, optics_);
  float range_m = echo.range_m + std::sqrt(variance_m2) * normal.first;
  if (optics_.range_quantum_m > 0.0) {
    const auto quantum_m = static_cast<float>(optics_.range_quantum_m);
    range_m = std::round(range_m / quantum_m) * quantum_m;
  }
  if (range_m <= 0.0F || range_m < static_cast<float>(optics_.min_range_m) ||
      range_m > static_cast<float>(optics_.max_range_m)) {
    return {};
  }
  // Sensors report whole numbers.
  const auto scale = static_cast<float>(optics_.reflectivity_scale);
  const float reflectivity = rounded(scale * (echo.energy + echo.spot_sigma * normal.second));
  return {range_m, std::min(std::max(0.0F, reflectivity), kMaxReflectivity), echo.label};
}

}  // namespace berm::sim
