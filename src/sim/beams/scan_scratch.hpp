#pragma once

#include <cstdint>
#include <vector>

#include "beam_tracer.hpp"
#include "berm/sim/random.hpp"
#include "berm/sim/scan_maker.hpp"
#include "echo_maker.hpp"

namespace berm::sim {

struct ScanScratch::Memory {
  Beams beams;
  std::vector<Random> randoms;     ///< one a beam
  std::vector<TracedRay> rays;     ///< the middles of the beams, then kFootprintRays for every torn beam
  std::vector<std::uint8_t> torn;  ///< beams that are spread
  PendingRays pending;
  EchoMaker::Lanes lanes;
};

}  // namespace berm::sim
