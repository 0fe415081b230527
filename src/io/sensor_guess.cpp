#include "sensor_guess.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "berm/core/angle.hpp"

namespace berm {
namespace {

/// From the data sheets; elevations of the lowest and the highest laser.
struct SpinningModel {
  std::string_view name;
  int rings;
  double low_deg;
  double high_deg;
  double stagger_deg = 0.0;  ///< between the azimuths of neighbouring channels, where it tells the model
};
constexpr std::array<SpinningModel, 17> kSpinningModels = {{
    {"Velodyne VLP-16", 16, -15.0, 15.0},
    {"Velodyne Puck Hi-Res", 16, -10.0, 10.0},
    {"Velodyne VLP-32C", 32, -25.0, 15.0},
    {"Velodyne HDL-32E", 32, -30.67, 10.67},
    {"Velodyne HDL-64E", 64, -24.9, 2.0},
    {"Velodyne VLS-128", 128, -25.0, 15.0},
    {"Hesai Pandar40P", 40, -25.0, 15.0},
    {"Hesai Pandar64", 64, -25.0, 15.0, 2.083},
    {"Hesai PandarXT-32", 32, -16.0, 15.0},
    {"RoboSense Helios-32", 32, -55.0, 15.0},
    {"Ouster OS0-32", 32, -45.0, 45.0},
    {"Ouster OS0-128", 128, -45.0, 45.0},
    {"Ouster OS1-32", 32, -22.5, 22.5},
    {"Ouster OS1-64 (first generation)", 64, -16.6, 16.6},
    {"Ouster OS1-64", 64, -22.5, 22.5},
    {"Ouster OS1-128", 128, -22.5, 22.5},
    {"Ouster OS2-128", 128, -11.25, 11.25},
}};

/// Sensors that steer by prisms or mirrors; the figure never repeats.
struct PrismModel {
  std::string_view name;
  double width_deg;
  double height_deg;
  bool circular;
};
constexpr std::array<PrismModel, 6> kPrismModels = {{
    {"Livox Mid-40", 38.4, 38.4, true},
    {"Livox Mid-70", 70.4, 70.4, true},
    {"Livox Avia", 70.4, 77.2, false},
    {"Livox Horizon", 81.7, 25.1, false},
    {"Livox Tele-15", 14.5, 16.2, false},
    {"Livox HAP", 120.0, 25.0, false},
}};

constexpr double kElevationTolerance_deg = 1.5;
/// Calibrated HDL-64E sets reach higher than their data sheet.
constexpr double kTopTolerance_deg = 2.0;
constexpr double kStaggerTolerance_deg = 0.05;
/// Beams into the sky do not return, so that the uppermost rings can be missing.
constexpr double kMinShareOfRings = 0.85;
constexpr double kMinShareOfHeight = 0.55;
constexpr double kWidthTolerance_deg = 2.0;
constexpr double kHeightTolerance_deg = 3.0;
/// Mid-360: -7 to 52 deg all around.
constexpr double kMid360Low_deg = -7.0;
constexpr double kMid360High_deg = 52.0;

std::string seen_elevations(double low_deg, double high_deg) {
  return fmt::format("elevation {:.1f} to {:.1f} deg", low_deg, high_deg);
}

/// How badly a model fits, in degrees or so; infinite if it cannot be.
double misfit(const SpinningModel& model, int rings, double low_deg, double high_deg, double stagger_deg) {
  const bool possible =
      rings <= model.rings + 1 && rings >= kMinShareOfRings * model.rings &&
      std::abs(low_deg - model.low_deg) <= kElevationTolerance_deg && high_deg <= model.high_deg + kTopTolerance_deg &&
      (model.stagger_deg == 0.0 || std::abs(stagger_deg - model.stagger_deg) <= kStaggerTolerance_deg);
  if (!possible) {
    return std::numeric_limits<double>::infinity();
  }
  // A stagger that fits says more than some missing rings.
  if (model.stagger_deg > 0.0) {
    return 0.0;
  }
  return std::abs(low_deg - model.low_deg) + 0.25 * std::max(0.0, model.high_deg - high_deg) +
         0.1 * std::abs(model.rings - rings);
}

SensorGuess guess_spinning(const RingCount& rings, const FieldOfView& view, const BeamMotion& motion) {
  const double low_deg = view.elevation_min_rad * kDegPerRad;
  const double high_deg = view.elevation_max_rad * kDegPerRad;
  const double stagger_deg = motion.stagger_rad * kDegPerRad;
  const SpinningModel* best = nullptr;
  double best_misfit = std::numeric_limits<double>::infinity();
  for (const SpinningModel& model : kSpinningModels) {
    const double fit = misfit(model, rings.count, low_deg, high_deg, stagger_deg);
    if (fit < best_misfit) {
      best_misfit = fit;
      best = &model;
    }
  }
  SensorGuess guess;
  guess.reasons = {fmt::format("{}{} rings", rings.from_field ? "" : "about ", rings.count),
                   seen_elevations(low_deg, high_deg)};
  if (best != nullptr) {
    guess.name = best->name;
    if (best->stagger_deg > 0.0) {
      guess.reasons.push_back(fmt::format("channels staggered by {:.2f} deg", stagger_deg));
    }
  }
  return guess;
}

SensorGuess guess_prism(const FieldOfView& view, int lines) {
  const double low_deg = view.elevation_min_rad * kDegPerRad;
  const double high_deg = view.elevation_max_rad * kDegPerRad;
  const double width_deg = (view.azimuth_max_rad - view.azimuth_min_rad) * kDegPerRad;
  const double height_deg = high_deg - low_deg;
  const std::string turns = lines > 1 ? fmt::format("{} lines take turns", lines) : "one line";
  SensorGuess guess;
  if (view.full_turn) {
    guess.reasons = {"all around without rings", seen_elevations(low_deg, high_deg), turns};
    if (std::abs(low_deg - kMid360Low_deg) <= kElevationTolerance_deg &&
        high_deg <= kMid360High_deg + kElevationTolerance_deg) {
      guess.name = "Livox Mid-360";
    }
    return guess;
  }
  guess.reasons = {fmt::format("{:.1f} x {:.1f} deg{}", width_deg, height_deg, view.circular ? ", circular" : ""),
                   "pattern that does not repeat", turns};
  for (const PrismModel& model : kPrismModels) {
    const bool fits = std::abs(width_deg - model.width_deg) <= kWidthTolerance_deg &&
                      height_deg <= model.height_deg + kHeightTolerance_deg &&
                      height_deg >= kMinShareOfHeight * model.height_deg &&
                      (!model.circular || view.circular || height_deg < 0.9 * model.height_deg);
    if (fits) {
      guess.name = model.name;
      return guess;
    }
  }
  return guess;
}

}  // namespace

SensorGuess guess_sensor(FiringOrder order, const std::optional<RingCount>& rings, const FieldOfView& view,
                         const BeamMotion& motion) {
  if (rings && (rings->from_field || order == FiringOrder::column_wise || order == FiringOrder::ring_wise)) {
    return guess_spinning(*rings, view, motion);
  }
  if (order == FiringOrder::non_repeating) {
    return guess_prism(view, motion.best_lag);
  }
  return {};
}

}  // namespace berm
