#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

#include "berm/sim/random.hpp"
#include "berm/sim/sensor.hpp"
#include "berm/sim/weather.hpp"

namespace berm::sim {

/// A flake that the sensor finds.
struct Flake {
  double reflectivity;  ///< 0..1
  double share;         ///< of the beam that it covers
  double light;         ///< as `received_light`
};

/// Where along a beam a sensor finds flakes, for one flake per cubic metre.
///
/// Flakes have exponentially distributed diameters D and log-normal reflectivities. One is met if its disc touches the
/// beam, an ellipse of width a(r) and height b(r): area pi/4 (a + D)(b + D). It covers on average D^2 / (a + D)(b + D)
/// of the beam, more in the middle and less at the rim. It is found if the light that comes back exceeds the limit of
/// the sensor: large flakes far away, small ones only near. The beam grows with the range, hence most flakes are found
/// where it is wide enough to meet some and they are near enough to be seen.
class SnowfallTable {
 public:
  SnowfallTable(const SnowfallConfig& snowfall, const OpticsConfig& optics);

  /// Expected number of flakes nearer than `range_m`.
  [[nodiscard]] double expected(double range_m) const;
  /// The same at any range.
  [[nodiscard]] double all() const { return expected_.back(); }
  /// The range before which `flakes` are expected; `flakes` is below `expected` of some range.
  [[nodiscard]] double range_of(double flakes) const;
  /// A flake at `range_m`, where one is found.
  [[nodiscard]] Flake draw(double range_m, Random& random) const;

 private:
  /// Flakes that are alike but for their diameter.
  static constexpr std::size_t kBrightnesses = 8;
  static constexpr std::size_t kPlaces = 8;
  static constexpr std::size_t kKinds = kBrightnesses * kPlaces;
  /// Parts of the number of flakes per metre: the diameter is the least that is found plus one, two or three times an
  /// exponential one.
  using Parts = std::array<double, 3>;
  using KindShares = std::array<float, kKinds>;

  [[nodiscard]] double least_diameter_m(std::size_t kind, double range_m) const;
  [[nodiscard]] Parts parts(double least_m, double range_m) const;
  [[nodiscard]] double per_metre(double range_m, KindShares* shares) const;
  void tabulate();

  SnowfallConfig snowfall_;
  OpticsConfig optics_;
  double limit_;
  std::array<double, kKinds> reflectivity_{};
  std::array<double, kKinds> gain_{};  ///< of the share that is covered, by the place in the beam
  double step_m_ = 0.0;
  std::vector<double> expected_;      ///< at multiples of the step
  std::vector<std::uint16_t> steps_;  ///< where equal parts of the expected number are reached
  std::vector<KindShares> kinds_;     ///< cumulative, at every tenth step
};

}  // namespace berm::sim
