#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>

#include "berm/core/scan.hpp"
#include "berm/pipeline/machine.hpp"

namespace berm::test {

/// machines/groomer.yaml with other methods.
[[nodiscard]] Machine groomer(const std::string& snow = "default", const std::string& ground = "default",
                              const std::string& piste = "default");

/// What a groomer sees of a gently rolling piste with trees at both sides: a rosette in firing order, beams without a
/// return kept, snow of intensity 150, times over 0.1 s. Stamp and noise depend on `seed`.
[[nodiscard]] Scan groomer_scan(std::uint32_t seed = 1, std::size_t beams = 10000);

/// Lets `change` work on the channels of a scan.
void change_channels(Scan& scan, const std::function<void(PointChannels&)>& change);

/// Turns `share` of the beams into near dark flakes, whether they came back or not.
void let_it_snow(Scan& scan, double share);

}  // namespace berm::test
