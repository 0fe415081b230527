#include "built_terrain.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <string>
#include <utility>

#include "berm/core/error.hpp"

namespace berm::sim {
namespace {

/// Where two runs overlap, the one that a place is deeper inside of decides; this rounds the change.
constexpr double kMerge_m = 2.5;
/// A berm ends where another run passes through, over this distance.
constexpr double kCut_m = 1.5;
/// Beyond the edge the roughness grows over this distance.
constexpr double kRoughen_m = 1.2;
/// Ruts and holes fade towards the edge of their road and where another one takes over.
constexpr double kDetailFade_m = 1.0;
/// Nothing of a world lies farther away than this; who asks beyond is given what is there.
constexpr double kFar_m = 1e6;

double tame(double coordinate_m) {
  return std::isfinite(coordinate_m) ? std::clamp(coordinate_m, -kFar_m, kFar_m) : 0.0;
}

/// Positive, growing with how deep a place lies inside.
double depth_weight(double inside_m) {
  const double depth = inside_m >= 0.0 ? inside_m + kMerge_m : kMerge_m * kMerge_m / (kMerge_m - inside_m);
  return depth * depth * depth;
}

RunPlace nowhere() {
  RunPlace place;
  place.inside_m = -kFarOutside_m;
  return place;
}

}  // namespace

BuiltTerrain::BuiltTerrain(std::vector<Run> runs, SmoothRaster natural, const GroundStyle& style, std::uint64_t seed)
    : runs_(std::move(runs)), natural_(std::move(natural)), style_(style), noise_(seed, Purpose::terrain, 0) {
  if (runs_.empty() || runs_.size() > kMostRuns) {
    throw Error(ErrorCode::invalid_argument,
                "terrain: expected 1 to " + std::to_string(kMostRuns) + " runs, not " + std::to_string(runs_.size()));
  }
}

BuiltTerrain::Blend BuiltTerrain::blend_runs(double x_m, double y_m, Places& places) const {
  Blend blend{.inside_m = -kFarOutside_m};
  double weights = 0.0;
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    places[i] = i == 0 || runs_[i].reaches(x_m, y_m) ? runs_[i].place(x_m, y_m) : nowhere();
    const RunPlace& place = places[i];
    if (place.inside_m > blend.inside_m) {
      blend.inside_m = place.inside_m;
      blend.run = i;
    }
    if (place.influence > 0.0) {
      const double weight = place.influence * depth_weight(place.inside_m);
      blend.graded_m += weight * runs_[i].graded_m(place);
      weights += weight;
      blend.influence = std::max(blend.influence, place.influence);
    }
  }
  if (weights > 0.0) {
    blend.graded_m /= weights;
  }
  return blend;
}

double BuiltTerrain::detail_share(const Places& places) const {
  double ahead = places[0].inside_m;
  for (std::size_t i = 1; i < runs_.size(); ++i) {
    ahead = std::min(ahead, places[0].inside_m - places[i].inside_m);
  }
  return smooth_step(0.0, kDetailFade_m, ahead);
}

double BuiltTerrain::natural_m(double x_m, double y_m, double left_m) const {
  double height = natural_.at(x_m, y_m);
  if (style_.land_sigma_m > 0.0) {
    height += style_.land_sigma_m * noise_.fractal(x_m, y_m, style_.land_wave_m, 4);
  }
  if (pit_) {
    height += pit_->height_m(x_m, y_m, left_m, noise_);
  }
  return height;
}

double BuiltTerrain::berms_m(double x_m, double y_m, const Places& places) const {
  double highest = 0.0;
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    double height = runs_[i].berm_m(places[i], x_m, y_m);
    for (std::size_t other = 0; height > 0.0 && other < runs_.size(); ++other) {
      if (other != i) {
        height *= smooth_step(0.0, kCut_m, -places[other].inside_m);
      }
    }
    highest = std::max(highest, height);
  }
  return highest;
}

GroundSample BuiltTerrain::at(double x_m, double y_m) const {
  const double x = tame(x_m);
  const double y = tame(y_m);
  Places places;
  const Blend blend = blend_runs(x, y, places);
  GroundSample sample;
  sample.inside_m = blend.inside_m;
  sample.across_m = places[blend.run].place.left_m;
  sample.height_m = blend.graded_m;
  if (blend.influence < 1.0) {
    sample.height_m *= blend.influence;
    sample.height_m += (1.0 - blend.influence) * natural_m(x, y, places[0].place.left_m);
  }
  const double rough = smooth_step(0.0, kRoughen_m, -blend.inside_m);
  if (rough < 1.0 && style_.inside_sigma_m > 0.0) {
    sample.height_m += (1.0 - rough) * style_.inside_sigma_m * noise_.fractal(x, y, style_.inside_wave_m, 2);
  }
  bool water = false;
  if (rough > 0.0) {
    sample.height_m += berms_m(x, y, places);
    sample.height_m += rough * style_.outside_sigma_m * noise_.fractal(x, y, style_.outside_wave_m, 4, 0.6);
  } else if (blend.run == 0) {
    water = details_.apply(places[0], x, y, detail_share(places), sample.height_m);
  }
  sample.surface = water ? Surface::water : blend.inside_m >= 0.0 ? style_.inside : style_.outside;
  if (pit_ && blend.influence < 0.5 && pit_->is_rock(x, y, places[0].place.left_m)) {
    sample.surface = style_.wall;
  }
  return sample;
}

}  // namespace berm::sim
