#include "dust.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace berm::sim {
namespace {

/// Reflectivity of a dense wall of mineral dust: pi over its lidar ratio of about 45 sr.
constexpr double kDustReflectivity = 0.07;
/// Depth of air whose echoes fall together: half the length of a pulse of 5 ns.
constexpr double kPulseDepth = 0.75;

}  // namespace

Dust::Dust(std::vector<Plume> plumes, const OpticsConfig& optics)
    : tree_(std::move(plumes), kPlumeReach), optics_(optics), limit_(optics.detection_limit()) {}

// Farther away than this the brightest dust on the beam is too faint, even without what the near field takes.
double Dust::farthest_m(double most_per_m, double left) const {
  const double share = std::min(1.0, most_per_m * kPulseDepth);
  return left * std::sqrt(kDustReflectivity * share / limit_);
}

void Dust::pass(const AirBeam& beam, Random& random, AirPath& path) const {
  const PlumeCrossings crossings(tree_, beam);
  if (crossings.is_empty()) {
    return;
  }
  const double passed = static_cast<double>(std::exp(-crossings.total()));
  path.transmission *= passed * passed;
  if (path.has_echo) {
    const double share = std::exp(-2.0 * static_cast<double>(crossings.depth(static_cast<float>(path.echo.range_m))));
    path.echo.light *= share;
    path.echo.reflectivity *= share;
    path.has_echo = path.echo.light >= limit_;
  }
  // Exponentially distributed is the depth at which light is lost, uniformly what is left of it there.
  const double left = 1.0 - random.uniform();
  if (left > passed) {
    add_echo(crossings, left, beam.end_m, path);
  }
}

void Dust::add_echo(const PlumeCrossings& crossings, double left, double end_m, AirPath& path) const {
  const double hidden_m = path.has_echo ? std::min(end_m, path.echo.range_m) : end_m;
  const double seen_m = farthest_m(static_cast<double>(crossings.most_per_m()), left);
  const double most_m = std::min(hidden_m, seen_m);
  const auto sought = static_cast<float>(-std::log(left));
  const float most_depth = most_m < optics_.min_range_m ? 0.0F : crossings.depth(static_cast<float>(most_m));
  if (most_depth <= sought) {
    return;
  }
  const PlumeCrossings::Place place = crossings.place_of(sought, static_cast<float>(most_m), most_depth);
  const auto range_m = static_cast<double>(place.range_m);
  const double share = 1.0 - std::exp(-kPulseDepth * static_cast<double>(place.extinction_per_m));
  const double light = received_light(optics_, kDustReflectivity, share, range_m) * left * left;
  if (light >= limit_ && range_m >= optics_.min_range_m && range_m <= optics_.max_range_m) {
    path.has_echo = true;
    path.echo = {range_m, light, 100.0 * light * range_m * range_m, true};
  }
}

}  // namespace berm::sim
