#pragma once

#include <cstdint>
#include <vector>

#include "beam_tracer.hpp"
#include "berm/sim/random.hpp"
#include "berm/sim/scan_maker.hpp"

namespace berm::sim {

struct ScanScratch::Memory {
  Beams beams;
  std::vector<Random> randoms;     ///< one a beam
  std::vector<TracedRay> rays;     ///< the middles of the beams
  std::vector<std::uint8_t> torn;  ///< beams that are spread
  std::vector<TracedRay> spread;   ///< kFootprintRays for every torn beam, in their order
  std::vector<std::uint32_t> pending;
};

}  // namespace berm::sim
