#include "boundary_evidence.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>

namespace berm {
namespace {

using bearing_grid::kBins;
using bearing_grid::kSectors;

// Ranges that show how groomed snow looks today: what the machine is about to drive over.
constexpr float kNear_m = 12.0F;
constexpr float kSlopesFrom_m = 8.0F;
constexpr float kSlopesTo_m = 20.0F;
constexpr std::size_t kMinSamples = 8;
constexpr float kMinSlopeLength_m = 0.25F;
constexpr float kRounding_m2 = 1e-10F;  // variance that floats leave in a window
constexpr float kRobustSigma = 1.48F;   // of a median of absolute values
// What half of the windows of groomed snow differ by, at most, from the slope of the surface: in 25 simulated runs the
// median over the scans is 0.006 to 0.008, on snow of 4 and 8 cm roughness 0.013 and 0.019. Counts where too little is
// seen to tell.
constexpr float kGroomedWander = 0.0075F;

// Evidence is a log likelihood ratio, less what on-piste snow reaches by chance; bounded, as a single window may be a
// clod or a hole.
constexpr float kMostFor = 3.0F;
constexpr float kHeightAgainst = -0.3F;
constexpr float kSlopeAgainst = -0.5F;
constexpr float kRoughAgainst = -1.0F;
constexpr float kCellFor = 4.0F;
constexpr float kCellAgainst = -1.0F;
constexpr float kPerObstaclePoint = 0.5F;
constexpr float kObstaclesFor = 2.0F;
constexpr float kUnseen = -0.001F;  // a cell that nobody saw: the boundary lies beyond rather than before it

/// Of a residual in units of its sigma, squared. It grows with the fourth power of the residual: slopes off the piste
/// are far beyond the noise or like it, little lies between. The square costs 0.05 % of accuracy, on a VLP-16 1.1 %.
float log_ratio(float square, float least) {
  return std::clamp(0.5F * square * square - 2.0F, least, kMostFor);
}

/// Of a few hundred of `values` at most, which it reorders.
float median(std::vector<float>& values) {
  constexpr std::size_t kEnough = 200;
  if (const std::size_t stride = values.size() / kEnough; stride > 1) {
    for (std::size_t i = 0; i < kEnough; ++i) {
      values[i] = values[i * stride];
    }
    values.resize(kEnough);
  }
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

std::size_t cell_of(std::size_t sector, std::size_t bin) {
  return sector * kBins + bin;
}

}  // namespace

BoundaryEvidence::BoundaryEvidence(const BoundaryPisteConfig& config)
    : config_(config), cells_(std::size_t{kSectors} * kBins), obstacles_(cells_.size()), seen_(kSectors) {}

void BoundaryEvidence::set_windows(const TraceWindows& windows, const LevelPoints& level, bool is_radial,
                                   const bearing_grid::SectorTable& sectors) {
  const std::size_t size = windows.size();
  sector_.resize(size);
  bin_.resize(size);
  inside_.resize(size);
  expected_m2_.resize(size);
  std::fill(seen_.begin(), seen_.end(), std::uint8_t{0});
  const float h = level.sensor_height_m;
  const auto noise = static_cast<float>(config_.range_noise_m);
  const auto floor = static_cast<float>(config_.roughness_m);
  const auto curvature = static_cast<float>(config_.curvature);
  // Without an order of firing, points of a window were measured at times apart, and the machine moved between.
  const float tremble_rad = is_radial ? static_cast<float>(config_.tremble_mrad) * 1e-3F : 0.0F;
  scratch_.clear();
  for (std::size_t i = 0; i < size; ++i) {
    const float range2 = windows.range_m[i] * windows.range_m[i];
    sector_[i] = sectors.of(windows.x[i], windows.y[i]);
    bin_[i] = static_cast<std::uint8_t>(bearing_grid::bin_of(range2));
    seen_[sector_[i]] = 1;
    // Noise of the range moves a point along its beam: by its sine with the ground up or down.
    const float rise = noise * h / std::sqrt(range2 + h * h);
    const float bow = curvature * windows.length_m[i] * windows.length_m[i] / 12.0F;
    const float tremble = tremble_rad * windows.range_m[i];
    expected_m2_[i] = rise * rise + floor * floor + bow * bow + tremble * tremble + kRounding_m2;
    if (windows.range_m[i] < kNear_m) {
      scratch_.push_back(windows.variance_m2[i] / expected_m2_[i]);
    }
  }
  arc_ = bearing_grid::find_arc(seen_);
  if (config_.adapt && scratch_.size() >= kMinSamples) {
    const float scale = std::clamp(median(scratch_), 0.5F, 100.0F);
    for (float& expected : expected_m2_) {
      expected *= scale;
    }
  }
}

void BoundaryEvidence::set_obstacles(std::span<const std::uint32_t> obstacles, const LevelPoints& level,
                                     const bearing_grid::SectorTable& sectors) {
  for (int i = 0; i < arc_.count; ++i) {
    std::fill_n(obstacles_.begin() + static_cast<std::ptrdiff_t>(cell_of(arc_.sector(i), 0)), kBins, 0.0F);
  }
  if (!config_.use_obstacles) {
    return;
  }
  for (const std::uint32_t i : obstacles) {
    const auto bin = static_cast<std::size_t>(bearing_grid::bin_of(level.range2[i]));
    obstacles_[cell_of(sectors[level.turn[i]], bin)] += kPerObstaclePoint;
  }
}

void BoundaryEvidence::fit_near(const TraceWindows& windows, float range_m, PisteSurface& surface) {
  for (std::size_t i = 0; i < inside_.size(); ++i) {
    inside_[i] = windows.range_m[i] < range_m ? 1 : 0;
  }
  surface.fit(windows, inside_, {}, {}, {.height_m = config_.height_noise_m, .slope = config_.slope_noise});
}

void BoundaryEvidence::fit_inside(const TraceWindows& windows, std::span<const int> bound, PisteSurface& surface) {
  for (std::size_t i = 0; i < inside_.size(); ++i) {
    inside_[i] = bin_[i] < bound[sector_[i]] ? 1 : 0;
  }
  surface.fit(windows, inside_, height_residual_, slope_residual_,
              {.height_m = config_.height_noise_m, .slope = config_.slope_noise});
}

void BoundaryEvidence::weigh(const TraceWindows& windows, const PisteSurface& surface) {
  height_residual_.resize(windows.size());
  slope_residual_.resize(windows.size());
  surface.compare(windows, height_residual_, slope_residual_);
  adapt(windows);
  weigh_windows(windows);
  for (int i = 0; i < arc_.count; ++i) {
    std::fill_n(cells_.begin() + static_cast<std::ptrdiff_t>(cell_of(arc_.sector(i), 0)), kBins, 0.0F);
  }
  for (std::size_t i = 0; i < windows.size(); ++i) {
    cells_[cell_of(sector_[i], bin_[i])] += weights_[i];
  }
  for (int i = 0; i < arc_.count; ++i) {
    const std::size_t first = cell_of(arc_.sector(i), 0);
    for (std::size_t cell = first; cell < first + kBins; ++cell) {
      const float sum = cells_[cell] + std::min(obstacles_[cell], kObstaclesFor);
      cells_[cell] = std::clamp(sum, kCellAgainst, kCellFor) + kUnseen;
    }
  }
}

/// Snow that is rough where the machine drives is no sign of the piste's end.
void BoundaryEvidence::adapt(const TraceWindows& windows) {
  constexpr float kTimesTypical = 1.5F;
  noise_ = {.height_m = config_.height_noise_m, .slope = config_.slope_noise};
  wander_ = kGroomedWander;
  if (!config_.adapt) {
    return;
  }
  scratch_.clear();
  for (std::size_t i = 0; i < windows.size(); ++i) {
    if (inside_[i] != 0 && windows.length_m[i] > 0.4F && windows.range_m[i] > kSlopesFrom_m &&
        windows.range_m[i] < kSlopesTo_m) {
      scratch_.push_back(slope_residual_[i]);
    }
  }
  if (scratch_.size() >= kMinSamples) {
    wander_ = median(scratch_);
    noise_.slope = std::max(noise_.slope, double{kTimesTypical * kRobustSigma * wander_});
  }
  scratch_.clear();
  for (std::size_t i = 0; i < windows.size(); ++i) {
    if (windows.range_m[i] < kNear_m) {
      scratch_.push_back(height_residual_[i]);
    }
  }
  if (scratch_.size() >= kMinSamples) {
    noise_.height_m = std::max(noise_.height_m, double{kTimesTypical * kRobustSigma * median(scratch_)});
  }
}

void BoundaryEvidence::weigh_windows(const TraceWindows& windows) {
  constexpr float kHeightGrows = 0.06F;  // what the polynomial misses per metre beyond kGrowsFrom_m: rollers, crests
  constexpr float kSlopeGrows = 0.008F;
  constexpr float kGrowsFrom_m = 10.0F;
  constexpr float kWanderShare = 0.15F;  // of a slope that wanders, what bends within a window
  constexpr float kTypicalRatio = 4.0F;  // of variances; groomed snow rarely exceeds it
  constexpr float kRoughWeight = 1.5F;
  const auto height2 = static_cast<float>(noise_.height_m * noise_.height_m);
  const auto slope2 = static_cast<float>(noise_.slope * noise_.slope);
  weights_.resize(windows.size());
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const float beyond = std::max(windows.range_m[i] - kGrowsFrom_m, 0.0F);
    const float length = windows.length_m[i];
    float ratio = 0.0F;
    if (config_.use_height) {
      const float variance = height2 + kHeightGrows * kHeightGrows * beyond * beyond;
      ratio += log_ratio(height_residual_[i] * height_residual_[i] / variance, kHeightAgainst);
    }
    if (config_.use_slope && length > kMinSlopeLength_m) {
      const float variance = slope2 + kSlopeGrows * kSlopeGrows * beyond * beyond;
      ratio += log_ratio(slope_residual_[i] * slope_residual_[i] / variance, kSlopeAgainst);
    }
    if (config_.use_roughness) {
      const float bend = kWanderShare * wander_ * length;
      const float excess = windows.variance_m2[i] / ((expected_m2_[i] + bend * bend) * kTypicalRatio);
      ratio += kRoughWeight * std::clamp(2.0F * std::log(std::max(excess, 1e-6F)), kRoughAgainst, kMostFor);
    }
    weights_[i] = ratio * std::clamp(1.5F * length / windows.nominal_m[i], 0.2F, 1.2F);
  }
}

}  // namespace berm
