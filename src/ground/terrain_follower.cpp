#include "terrain_follower.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "berm/core/multiversion.hpp"

namespace berm {
namespace {

/// Variance of the plane's height and slope that stays however well the low points fit it, and the share of their mean
/// square misfit that is added.
constexpr double kStartVariance = 5e-4;
constexpr double kHeightShareOfMisfit = 1.0;
constexpr double kSlopeShareOfMisfit = 0.1;

/// A neighbour's height counts with this variance added, in m^2, and in m^2 per metre of distance to it.
constexpr float kNeighbourVariance = 0.01F;
constexpr float kNeighbourVariancePerMetre = 0.02F;

/// Steeper than this against the levelled plane is no ground that a machine stands on.
constexpr float kMaxSlope = 1.0F;
/// The uncertainty of the height widens the gate by this at most.
constexpr float kMaxWidening_m = 1.0F;
/// A cell spans this much height by slope that is not known yet, per metre of its size.
constexpr float kUnknownSlope = 0.1F;
/// A cell that spans more than this beyond its slope is not bare ground.
constexpr float kBareSpan_m = 0.2F;

/// A drop by more than this, beyond what the uncertainty allows, that neither neighbour shares within the same is a
/// reflection from below the ground.
constexpr float kLonelyDrop_m = 0.2F;

float clamped(float value, float limit) {
  const float low = value > -limit ? value : -limit;
  return low < limit ? low : limit;
}

/// Numbers that hold for one bin.
struct BinStep {
  float step_m;    ///< from the middle of the bin before
  float length_m;  ///< of the cells
  float width_m;   ///< of the cells, across the sector
  float step_up_m;
  float step_down_m;
  float gate_sigmas;
  float object_gate_sigmas;
  float noise_m2;
  float height_growth_m2;  ///< variance that the height gains by roughness on this step
  float slope_growth;      ///< variance that the slope gains by curvature
  float object_height_m;
  float lonely_drop_m;  ///< see kLonelyDrop_m; infinite if reflections are followed
  bool usable;          ///< far enough from the sensor to shape the ground
};

/// Predicts every sector to the bin and corrects it by the cell's lowest point, if that passes the gate.
/// `lowest_ring_m` begins with the last sector and ends with the first; all other arrays begin with the first.
BERM_MULTIVERSION
void predict_and_correct(std::size_t sectors, BinStep bin, const float* __restrict lowest_ring_m,
                         const float* __restrict highest_m, float* __restrict height_m, float* __restrict slope,
                         float* __restrict height_variance, float* __restrict covariance,
                         float* __restrict slope_variance, std::uint8_t* __restrict measured,
                         std::uint8_t* __restrict has_object) {
  const float* const right_m = lowest_ring_m;
  const float* const lowest_m = lowest_ring_m + 1;
  const float* const left_m = lowest_ring_m + 2;
  const float step2 = bin.step_m * bin.step_m;
  const float usable = bin.usable ? 1.0F : 0.0F;
  for (std::size_t s = 0; s < sectors; ++s) {
    const float expected_m = height_m[s] + slope[s] * bin.step_m;
    const float hh = height_variance[s] + 2.0F * covariance[s] * bin.step_m + slope_variance[s] * step2 +
                     bin.height_growth_m2 + bin.slope_growth * step2 * (1.0F / 3.0F);
    const float hg = covariance[s] + slope_variance[s] * bin.step_m + bin.slope_growth * bin.step_m * 0.5F;
    const float gg = slope_variance[s] + bin.slope_growth;

    const float sigma_m = std::sqrt(hh);
    const float surprise_m = lowest_m[s] - expected_m;
    const float drop_m = bin.lonely_drop_m + bin.gate_sigmas * sigma_m;
    const float to_right_m = std::fabs(lowest_m[s] - right_m[s]);
    const float to_left_m = std::fabs(lowest_m[s] - left_m[s]);
    const bool alone = to_right_m > bin.lonely_drop_m && to_left_m > bin.lonely_drop_m;
    const bool reflection = surprise_m < -drop_m && alone;

    const float foot_m = reflection ? expected_m : lowest_m[s];
    const float span_m =
        highest_m[s] - foot_m - (std::fabs(slope[s]) + kUnknownSlope) * bin.length_m - kUnknownSlope * bin.width_m;
    const float widening_m = sigma_m * (span_m > kBareSpan_m ? bin.object_gate_sigmas : bin.gate_sigmas);
    const float up_m = bin.step_up_m + (widening_m < kMaxWidening_m ? widening_m : kMaxWidening_m);
    const float down_m = bin.step_down_m + bin.gate_sigmas * sigma_m;
    const float accepted = surprise_m < up_m && surprise_m > -down_m && !reflection ? usable : 0.0F;

    const float correction_m = accepted > 0.0F ? surprise_m : 0.0F;  // an empty cell's surprise is infinite
    const float gain = accepted / (hh + bin.noise_m2);
    height_m[s] = expected_m + gain * hh * correction_m;
    slope[s] = clamped(slope[s] + gain * hg * correction_m, kMaxSlope);
    height_variance[s] = hh - gain * hh * hh;
    covariance[s] = hg - gain * hg * hh;
    slope_variance[s] = gg - gain * hg * hg;
    measured[s] = static_cast<std::uint8_t>(accepted > 0.0F ? 1 : 0);
    has_object[s] = static_cast<std::uint8_t>(span_m > bin.object_height_m ? 1 : 0);
  }
}

/// The estimates as one ring around the sensor; pointers to sector 0, readable at -1 and at the number of sectors.
struct RingView {
  const float* height_m;
  const float* slope;
  const float* height_variance;
  const float* covariance;
  const float* slope_variance;
};

/// Each sector takes the mean of itself and its neighbours, weighted by their certainty. Where it was measured, the
/// mean is also surer than it was; elsewhere the neighbours' errors may be its own.
BERM_MULTIVERSION
void average_neighbours(std::size_t sectors, float width_m, RingView from, const std::uint8_t* __restrict measured,
                        float* __restrict height_m, float* __restrict slope, float* __restrict height_variance,
                        float* __restrict covariance, float* __restrict slope_variance) {
  const float neighbour_variance = kNeighbourVariance + kNeighbourVariancePerMetre * width_m;
  for (std::size_t s = 0; s < sectors; ++s) {
    const float* const h = from.height_m + s;
    const float* const g = from.slope + s;
    const float* const hh = from.height_variance + s;
    const float* const hg = from.covariance + s;
    const float* const gg = from.slope_variance + s;
    const float right = 1.0F / (hh[-1] + neighbour_variance);
    const float self = 1.0F / hh[0];
    const float left = 1.0F / (hh[1] + neighbour_variance);
    const float inverse = 1.0F / (right + self + left);
    height_m[s] = (right * h[-1] + self * h[0] + left * h[1]) * inverse;
    slope[s] = (right * g[-1] + self * g[0] + left * g[1]) * inverse;
    const float mean_variance = (right * hh[-1] + self * hh[0] + left * hh[1]) * inverse;
    const float shrink = measured[s] != 0 ? inverse / mean_variance : 1.0F;
    const float scale = (shrink < 1.0F ? shrink : 1.0F) * inverse;
    height_variance[s] = (right * hh[-1] + self * hh[0] + left * hh[1]) * scale;
    covariance[s] = (right * hg[-1] + self * hg[0] + left * hg[1]) * scale;
    slope_variance[s] = (right * gg[-1] + self * gg[0] + left * gg[1]) * scale;
  }
}

/// Slope outward in a bin: between the heights of the bins before and behind, `distance_m` apart.
BERM_MULTIVERSION
void difference(std::size_t sectors, float distance_m, const float* __restrict inner_m, const float* __restrict outer_m,
                float* __restrict slope) {
  const float inverse = 1.0F / distance_m;
  for (std::size_t s = 0; s < sectors; ++s) {
    slope[s] = (outer_m[s] - inner_m[s]) * inverse;
  }
}

void close_ring(std::vector<float>& ring) {
  ring.front() = ring[ring.size() - 2];
  ring.back() = ring[1];
}

}  // namespace

TerrainFollower::TerrainFollower(const TerrainGroundConfig& config, const TerrainCells& cells)
    : config_(config),
      sectors_(static_cast<std::size_t>(cells.sectors)),
      radians_per_sector_(2.0F * std::numbers::pi_v<float> / static_cast<float>(cells.sectors)) {
  for (std::size_t b = 0; b + 1 < cells.edges_m.size(); ++b) {
    middles_m_.push_back(0.5F * (cells.edges_m[b] + cells.edges_m[b + 1]));
    lengths_m_.push_back(cells.edges_m[b + 1] - cells.edges_m[b]);
  }
  for (Estimate* estimate : {&now_, &before_}) {
    for (Ring* ring : {&estimate->height_m, &estimate->slope, &estimate->height_variance, &estimate->covariance,
                       &estimate->slope_variance}) {
      ring->resize(sectors_ + 2);
    }
  }
  lowest_m_.resize(sectors_ + 2);
}

void TerrainFollower::start(double plane_rms_m) {
  const double misfit_m2 = plane_rms_m * plane_rms_m;
  const auto fill = [](Ring& ring, double value) { std::fill(ring.begin(), ring.end(), static_cast<float>(value)); };
  fill(now_.height_m, 0.0);
  fill(now_.slope, 0.0);
  fill(now_.height_variance, kStartVariance + kHeightShareOfMisfit * misfit_m2);
  fill(now_.covariance, 0.0);
  fill(now_.slope_variance, kStartVariance + kSlopeShareOfMisfit * misfit_m2);
}

void TerrainFollower::measure(const CellExtremes& extremes, std::size_t bin, float blind_m, std::uint8_t* measured,
                              std::uint8_t* has_object) {
  const auto as_float = [](double value) { return static_cast<float>(value); };
  const float step_m = bin > 0 && middles_m_[bin] > blind_m ? middles_m_[bin] - middles_m_[bin - 1] : 0.0F;
  const BinStep numbers{
      .step_m = step_m,
      .length_m = lengths_m_[bin],
      .width_m = middles_m_[bin] * radians_per_sector_,
      .step_up_m = as_float(config_.step_up_m),
      .step_down_m = as_float(config_.step_down_m),
      .gate_sigmas = as_float(config_.gate_sigmas),
      .object_gate_sigmas = config_.strict_at_objects ? 0.0F : as_float(config_.gate_sigmas),
      .noise_m2 = as_float(config_.height_noise_m * config_.height_noise_m),
      .height_growth_m2 = as_float(config_.roughness_m * config_.roughness_m) * step_m,
      .slope_growth = as_float(config_.curvature * config_.curvature) * step_m,
      .object_height_m = as_float(config_.object_height_m),
      .lonely_drop_m = config_.reject_reflections ? kLonelyDrop_m : std::numeric_limits<float>::infinity(),
      .usable = config_.follow && middles_m_[bin] >= as_float(config_.min_range_m)};
  const std::size_t first = bin * sectors_;
  std::copy_n(extremes.lowest_m.data() + first, sectors_, lowest_m_.data() + 1);
  close_ring(lowest_m_);
  predict_and_correct(sectors_, numbers, lowest_m_.data(), extremes.highest_m.data() + first, now_.height_m.data() + 1,
                      now_.slope.data() + 1, now_.height_variance.data() + 1, now_.covariance.data() + 1,
                      now_.slope_variance.data() + 1, measured, has_object);
}

void TerrainFollower::share(std::size_t bin, const std::uint8_t* measured) {
  const float width_m = middles_m_[bin] * radians_per_sector_;
  if (config_.smooth) {
    std::swap(now_, before_);
    for (Ring* ring :
         {&before_.height_m, &before_.slope, &before_.height_variance, &before_.covariance, &before_.slope_variance}) {
      close_ring(*ring);
    }
    const RingView from{before_.height_m.data() + 1, before_.slope.data() + 1, before_.height_variance.data() + 1,
                        before_.covariance.data() + 1, before_.slope_variance.data() + 1};
    average_neighbours(sectors_, width_m, from, measured, now_.height_m.data() + 1, now_.slope.data() + 1,
                       now_.height_variance.data() + 1, now_.covariance.data() + 1, now_.slope_variance.data() + 1);
  }
}

void TerrainFollower::store(std::size_t bin, HeightGrid::Channels& surface) const {
  const auto copy = [this, bin](const Ring& from, std::vector<float>& to) {
    std::copy_n(from.data() + 1, sectors_, to.data() + bin * sectors_);
  };
  copy(now_.height_m, surface.height_m);
  copy(now_.height_variance, surface.variance_m2);
}

/// The slopes that the heights have in the end; the filters' own lag behind where the ground bends.
void TerrainFollower::slope_outward(HeightGrid::Channels& surface) const {
  for (std::size_t bin = 0; bin < middles_m_.size(); ++bin) {
    const std::size_t inner = bin > 0 ? bin - 1 : bin;
    const std::size_t outer = std::min(bin + 1, middles_m_.size() - 1);
    difference(sectors_, middles_m_[outer] - middles_m_[inner], surface.height_m.data() + inner * sectors_,
               surface.height_m.data() + outer * sectors_, surface.radial_slope.data() + bin * sectors_);
  }
}

void TerrainFollower::follow(const CellExtremes& extremes, double plane_rms_m, double blind_m,
                             HeightGrid::Channels& surface, std::span<std::uint8_t> has_object) {
  start(plane_rms_m);
  for (std::size_t bin = 0; bin < middles_m_.size(); ++bin) {
    std::uint8_t* const measured = surface.measured.data() + bin * sectors_;
    measure(extremes, bin, static_cast<float>(blind_m), measured, has_object.data() + bin * sectors_);
    share(bin, measured);
    store(bin, surface);
  }
  slope_outward(surface);
}

}  // namespace berm
