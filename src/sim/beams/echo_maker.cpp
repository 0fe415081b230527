#include "echo_maker.hpp"

#include <algorithm>

#include "beam_optics.hpp"

namespace berm::sim {
namespace {

constexpr std::uint32_t kFirstMover = 2;

std::uint32_t label_of(const Hit& hit) {
  if (hit.object < kFirstMover) {
    return hit.material.truth_id;
  }
  const std::uint32_t id = hit.material.truth_id == truth::kVehicle ? truth::kMovingVehicle : hit.material.truth_id;
  return id | ((hit.object - kFirstMover + 1) << 16U);
}

void dim(Echo& echo, float share) {
  echo.energy *= share;
  echo.light *= share;
  echo.spot_sigma *= share;
  echo.label_lead *= share;
}

Echo echo_of(const AirEcho& air) {
  Echo echo;
  echo.range_m = static_cast<float>(air.range_m);
  echo.energy = static_cast<float>(air.reflectivity);
  echo.light = static_cast<float>(air.light);
  echo.label = air.dust ? truth::kDust : truth::kFallingSnow;
  echo.label_lead = echo.energy;
  return echo;
}

}  // namespace

EchoMaker::EchoMaker(const RayCaster& caster, const Weather& weather, const OpticsConfig& optics)
    : caster_(caster),
      weather_(weather),
      optics_(optics),
      choice_(echo_choice(optics.echo)),
      weathers_(!weather.is_clear()),
      per_limit_(static_cast<float>(1.0 / optics.detection_limit())),
      min_range_m_(static_cast<float>(optics.min_range_m)),
      max_range_m_(static_cast<float>(optics.max_range_m)),
      separation_m_(static_cast<float>(optics.echo_separation_m)) {
  for (std::size_t i = 0; i < kSurfaces; ++i) {
    const auto surface = static_cast<Surface>(i);
    const SurfaceOptics& of = optics_of(surface);
    lane_optics_[i] = {static_cast<float>(of.reflectivity),
                       static_cast<float>(of.reflectivity_sigma),
                       static_cast<float>(of.relief_m),
                       static_cast<float>(of.mirror),
                       roughness_of(surface),
                       surface == Surface::groomed_snow ? 1.0F : 0.0F};
  }
}

void EchoMaker::returns_of(std::span<const FiredBeam> beams, double height_m, Lanes& lanes,
                           std::span<Return> returns) const {
  Block block;
  meet(beams, lanes, block);
  shade_all(optics_, lanes.surfaces);
  if (weathers_) {
    pass_air(beams, height_m, lanes.air, block);
  }
  receive(beams, block, lanes);
  report_all(optics_, lanes.reports);
  std::fill(returns.begin(), returns.end(), Return{});
  const ReportLanes& reports = lanes.reports;
  for (std::size_t i = 0; i < reports.count; ++i) {
    const float range_m = reports.range_m[i];
    if (range_m > 0.0F && range_m >= min_range_m_ && range_m <= max_range_m_) {
      returns[reports.beam[i]] = {range_m, reports.reflectivity[i], reports.label[i]};
    }
  }
}

void EchoMaker::meet(std::span<const FiredBeam> beams, Lanes& lanes, Block& block) const {
  std::size_t ray_count = 0;
  for (const FiredBeam& beam : beams) {
    for (const TracedRay& ray : beam.rays) {
      lanes.spots[ray_count++] = caster_.spot_of(ray.origin_m, ray.direction, ray.hit);
    }
  }
  const TerrainSpot* spot = lanes.spots.data();
  SurfaceLanes& surfaces = lanes.surfaces;
  surfaces.count = 0;
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const FiredBeam& beam = beams[i];
    Parts parts;
    parts.is_lost = beam.random->chance(optics_.dropout);
    parts.first = surfaces.count;
    parts.nearest_m = max_range_m_;
    const float share = 1.0F / static_cast<float>(beam.rays.size());
    for (const TracedRay& ray : beam.rays) {
      if (!parts.is_lost && !ray.hit.is_nothing()) {
        add_surface(ray, *spot, share, *beam.random, surfaces, parts);
      }
      ++spot;
    }
    parts.count = surfaces.count - parts.first;
    block[i] = parts;
  }
}

void EchoMaker::add_surface(const TracedRay& ray, const TerrainSpot& spot, float share, Random& random,
                            SurfaceLanes& lanes, Parts& parts) const {
  const Hit hit = caster_.describe(ray.direction, ray.hit, spot);
  const auto range_m = static_cast<float>(hit.range_m);
  if (range_m < parts.nearest_m) {
    parts.nearest_m = range_m;
    parts.on_ground = hit.object == 0;
  }
  const LaneOptics& surface = lane_optics_[static_cast<std::size_t>(hit.material.surface)];
  const float cosine = std::clamp(-hit.normal.dot(ray.direction), 0.0F, 1.0F);
  const float lost = mirrored(surface.mirror, cosine);
  if (range_m < min_range_m_ || (lost > 0.0F && random.chance(static_cast<double>(lost)))) {
    return;
  }
  const std::size_t lane = lanes.count++;
  lanes.range_m[lane] = range_m;
  lanes.cosine[lane] = cosine;
  lanes.share[lane] = share;
  lanes.reflectivity[lane] = surface.reflectivity;
  lanes.reflectivity_sigma[lane] = surface.reflectivity_sigma;
  lanes.relief_m[lane] = surface.relief_m;
  lanes.roughness[lane] = surface.roughness;
  lanes.ridges[lane] = surface.ridges;
  lanes.across_m[lane] = static_cast<float>(hit.across_m);
  lanes.slope_x[lane] = hit.across_slope.x();
  lanes.slope_y[lane] = hit.across_slope.y();
  lanes.dx[lane] = ray.direction.x();
  lanes.dy[lane] = ray.direction.y();
  lanes.label[lane] = label_of(hit);
}

void EchoMaker::pass_air(std::span<const FiredBeam> beams, double height_m, AirLanes& air, Block& block) const {
  air.count = 0;
  air.height_m = height_m;
  for (std::size_t i = 0; i < beams.size(); ++i) {
    Parts& parts = block[i];
    if (parts.is_lost) {
      continue;
    }
    const TracedRay& ray = beams[i].rays.front();
    const std::size_t lane = air.count++;
    parts.air = lane;
    air.x_m[lane] = ray.origin_m.x();
    air.y_m[lane] = ray.origin_m.y();
    air.z_m[lane] = ray.origin_m.z();
    air.dx[lane] = ray.direction.x();
    air.dy[lane] = ray.direction.y();
    air.dz[lane] = ray.direction.z();
    air.time_s[lane] = ray.time_s;
    air.end_m[lane] = parts.nearest_m;
    // Down to the ground that the beam meets; else as the beam itself rises or falls.
    air.slope[lane] =
        parts.on_ground ? -static_cast<float>(height_m) / std::max(parts.nearest_m, 1e-3F) : ray.direction.z();
    air.random[lane] = beams[i].random;
  }
  weather_.along(air);
}

inline bool EchoMaker::finds(const Echo& echo, Random& random) const {
  // Echoes of the air are those that the sensor finds.
  return echo.label == truth::kFallingSnow || echo.label == truth::kDust ||
         random.chance(static_cast<double>(detection_probability(echo.light * per_limit_)));
}

void EchoMaker::receive(std::span<const FiredBeam> beams, const Block& block, Lanes& lanes) const {
  lanes.reports.count = 0;
  for (std::size_t i = 0; i < beams.size(); ++i) {
    const Parts& parts = block[i];
    if (parts.is_lost) {
      continue;
    }
    Random& random = *beams[i].random;
    const float passes = weathers_ ? lanes.air.transmission[parts.air] : 1.0F;
    const bool has_air =
        weathers_ && lanes.air.has_echo[parts.air] && lanes.air.echo[parts.air].range_m >= optics_.min_range_m;
    if (parts.count == 1 && !has_air) {
      // As most beams are: nothing melts, nothing is to be chosen.
      Echo echo = lanes.surfaces.echo(parts.first);
      dim(echo, passes);
      if (finds(echo, random)) {
        lanes.reports.add(i, echo, uniform_pair(random));
      }
      continue;
    }
    std::array<Echo, kFootprintRays + 1> echoes;
    std::size_t count = 0;
    for (; count < parts.count; ++count) {
      echoes[count] = lanes.surfaces.echo(parts.first + count);
      dim(echoes[count], passes);
    }
    if (has_air) {
      echoes[count++] = echo_of(lanes.air.echo[parts.air]);
    }
    if (const Echo* echo = choose({echoes.data(), count}, random); echo != nullptr) {
      lanes.reports.add(i, *echo, uniform_pair(random));
    }
  }
}

const Echo* EchoMaker::choose(std::span<Echo> echoes, Random& random) const {
  const std::size_t left = melt(echoes, separation_m_);
  const Echo* chosen = nullptr;
  for (const Echo& echo : echoes.first(left)) {
    if (!finds(echo, random)) {
      continue;
    }
    if (choice_ == EchoChoice::last || chosen == nullptr ||
        (choice_ == EchoChoice::strongest && echo.light > chosen->light)) {
      chosen = &echo;
    }
  }
  return chosen;
}

}  // namespace berm::sim
