#include "dust.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "smooth.hpp"

namespace berm::sim {
namespace {

/// Reflectivity of a dense wall of mineral dust: pi over its lidar ratio of about 45 sr.
constexpr double kDustReflectivity = 0.07;
/// Depth of air whose echoes fall together: half the length of a pulse of 5 ns.
constexpr double kPulseDepth = 0.75;
/// Beams that lose less of their light meet no dust.
constexpr float kLeastDepth = 1e-6F;

}  // namespace

Dust::Dust(std::vector<Plume> plumes, const OpticsConfig& optics)
    : tree_(std::move(plumes), kPlumeReach),
      optics_(optics),
      limit_(optics.detection_limit()),
      bright_per_limit_(static_cast<float>(kDustReflectivity / limit_)) {}

// Farther away than this the brightest dust on the beam is too faint, even without what the near field takes.
float Dust::farthest_m(float most_per_m, float left) const {
  const float share = std::min(1.0F, most_per_m * static_cast<float>(kPulseDepth));
  return left * std::sqrt(share * bright_per_limit_);
}

void Dust::pass(AirLanes& beams) const {
  PlumeCrossings crossings;
  Waiting waiting;
  for (std::size_t first = 0; first < beams.count; first += AirLanes::kPacket) {
    find_crossings(tree_, beams, first, crossings);
    if (crossings.count > 0) {
      pass_packet(beams, first, crossings, waiting);
    }
  }
  add_echoes(beams, waiting);
}

void Dust::pass_packet(AirLanes& beams, std::size_t first, const PlumeCrossings& crossings, Waiting& waiting) const {
  Left left{};
  bool has_flakes = false;
  bool has_dust = false;
  for (std::size_t i = 0; i < AirLanes::kPacket && first + i < beams.count; ++i) {
    if (crossings.total[i] < kLeastDepth) {
      continue;
    }
    const std::size_t lane = first + i;
    beams.transmission[lane] *= crossings.transmission[i];
    has_flakes |= beams.has_echo[lane];
    // Exponentially distributed is the depth at which light is lost, uniformly what is left of it there.
    const auto share = static_cast<float>(1.0 - beams.random[lane]->uniform());
    if (share * share > crossings.transmission[i]) {
      left[i] = share;
      has_dust = true;
    }
  }
  if (has_flakes) {
    dim_flakes(beams, first, crossings);
  }
  if (has_dust) {
    seek_echoes(beams, first, crossings, left, waiting);
  }
}

void Dust::dim_flakes(AirLanes& beams, std::size_t first, const PlumeCrossings& crossings) const {
  alignas(32) Packet range_m{};
  alignas(32) Packet depth;
  for (std::size_t i = 0; i < range_m.size() && first + i < beams.count; ++i) {
    range_m[i] = beams.has_echo[first + i] ? static_cast<float>(beams.echo[first + i].range_m) : 0.0F;
  }
  depths_at(crossings, range_m, depth);
  for (std::size_t i = 0; i < range_m.size() && first + i < beams.count; ++i) {
    if (beams.has_echo[first + i] && crossings.total[i] >= kLeastDepth) {
      AirEcho& echo = beams.echo[first + i];
      const auto share = static_cast<double>(fade(2.0F * std::max(0.0F, depth[i])));
      echo.light *= share;
      echo.reflectivity *= share;
      beams.has_echo[first + i] = echo.light >= limit_;
    }
  }
}

void Dust::seek_echoes(AirLanes& beams, std::size_t first, const PlumeCrossings& crossings, const Left& left,
                       Waiting& waiting) const {
  alignas(32) Packet end_m{};
  alignas(32) Packet end_depth;
  for (std::size_t i = 0; i < left.size(); ++i) {
    const std::size_t lane = first + i;
    if (left[i] > 0.0F) {
      const float hidden_m = beams.has_echo[lane]
                                 ? std::min(beams.end_m[lane], static_cast<float>(beams.echo[lane].range_m))
                                 : beams.end_m[lane];
      end_m[i] = std::min(hidden_m, farthest_m(crossings.most_per_m[i], left[i]));
    }
  }
  depths_at(crossings, end_m, end_depth);
  for (std::size_t i = 0; i < left.size(); ++i) {
    if (left[i] <= 0.0F || end_m[i] < static_cast<float>(optics_.min_range_m)) {
      continue;
    }
    if (const float sought = -logarithm(left[i]); end_depth[i] > sought) {
      waiting.lane[waiting.seekers.count] = first + i;
      waiting.left[waiting.seekers.count] = left[i];
      waiting.seekers.add(crossings, i, end_m[i], sought, end_depth[i]);
      if (waiting.seekers.is_full()) {
        add_echoes(beams, waiting);
      }
    }
  }
}

void Dust::add_echoes(AirLanes& beams, Waiting& waiting) const {
  PlaceSeekers& seekers = waiting.seekers;
  if (seekers.count == 0) {
    return;
  }
  seekers.find();
  for (std::size_t i = 0; i < seekers.count; ++i) {
    add_echo(beams, waiting.lane[i], static_cast<double>(seekers.range_m[i]), seekers.extinction_per_m[i],
             static_cast<double>(waiting.left[i]));
  }
  seekers.clear();
}

void Dust::add_echo(AirLanes& beams, std::size_t lane, double range_m, float extinction_per_m, double left) const {
  const double share = 1.0 - static_cast<double>(fade(static_cast<float>(kPulseDepth) * extinction_per_m));
  const double light = received_light(optics_, kDustReflectivity, share, range_m) * left * left;
  if (light >= limit_ && range_m >= optics_.min_range_m && range_m <= optics_.max_range_m) {
    beams.has_echo[lane] = true;
    beams.echo[lane] = {range_m, light, 100.0 * light * range_m * range_m, true};
  }
}

}  // namespace berm::sim
