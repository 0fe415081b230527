#pragma once

#include <cstddef>
#include <vector>

#include "support/made_scan.hpp"

namespace berm::test {

/// Petals of the rosette below per scan.
inline constexpr double kMid70SamplesPerPetal = 100000.0 / 200.50;

/// Beams of one scan (0.1 s) of a Livox Mid-70 (sensors/livox_mid70.yaml), which starts `first` samples into its
/// pattern.
[[nodiscard]] Beams mid70_beams(std::size_t first = 0, std::size_t count = 10000);

/// The mount of P's groomer: 2.3 m up, 11 degrees nose down.
[[nodiscard]] Pose groomer_mount();

/// A piste 20 m wide that climbs away from the sensor and bends in the plane of the mount, with banks and trees beside
/// it and a hut on it, 30 m ahead.
[[nodiscard]] World made_piste();

/// `made_piste` as the groomer sees it.
[[nodiscard]] MadeScan mid70_scan(std::size_t first = 0, std::size_t count = 10000);

}  // namespace berm::test
