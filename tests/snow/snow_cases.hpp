#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "berm/core/point_cloud.hpp"
#include "berm/snow/snow.hpp"
#include "support/made_scan.hpp"

/// Scans in falling snow that the tests of the snow stage share. The flakes are simpler than the simulator's, and drawn
/// in another way, so that nothing that fits only one of them passes both.
namespace berm::test {

/// Beams that meet a flake come back near and dark.
struct Snowfall {
  double share = 0.05;            ///< of the beams
  double median_m = 4.0;          ///< of the ranges, which are log-normal
  double spread = 0.6;            ///< of their logarithm
  float most_intensity = 4.0F;    ///< of flakes: 0 .. this, evenly
  float least_intensity = 60.0F;  ///< of everything else: this .. 180
};

struct SnowyScan {
  PointChannels channels;
  std::vector<std::uint8_t> is_flake;

  [[nodiscard]] PointsView view() const;
};

/// A flake replaces what lies behind it, also where a beam met nothing.
[[nodiscard]] SnowyScan let_it_snow(const MadeScan& scan, const Snowfall& snowfall, std::uint32_t seed);

/// A named sensor over a street.
struct Lookout {
  std::string name;
  Beams beams;
  double height_m = 1.73;
  double pitch_deg = 0.0;

  [[nodiscard]] MadeScan look(const World& world, std::uint32_t seed = 1) const;
};
[[nodiscard]] Lookout spinning_64();
[[nodiscard]] Lookout spinning_16();
[[nodiscard]] Lookout rosette_70();
[[nodiscard]] const std::vector<Lookout>& lookouts();

struct SnowScore {
  double precision = 0.0;
  double recall = 0.0;
  double f1 = 0.0;
  double marked = 0.0;  ///< share of the returns
};
[[nodiscard]] SnowScore score(const SnowResult& result, const SnowyScan& scan);

/// Whether `count` is that of the marks, and no mark is on a no-return, NaN or absurd point.
[[nodiscard]] bool is_sound(const SnowResult& result, const PointsView& points);

/// The scan turned about the axes of the sensor.
[[nodiscard]] SnowyScan turned(const SnowyScan& scan, double yaw_deg, double pitch_deg, double roll_deg);
/// The points of the scan in another order.
[[nodiscard]] SnowyScan picked(const SnowyScan& scan, const std::vector<std::size_t>& order);

}  // namespace berm::test
