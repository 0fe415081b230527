#pragma once

#include <cstdint>
#include <vector>

#include "berm/sim/random.hpp"
#include "berm/sim/scan_maker.hpp"

namespace berm::sim {

/// Rays in the world, structure of arrays.
struct WorldRays {
  std::vector<float> x_m;
  std::vector<float> y_m;
  std::vector<float> z_m;
  std::vector<float> dx;
  std::vector<float> dy;
  std::vector<float> dz;
  std::vector<double> time_s;

  [[nodiscard]] std::size_t size() const { return x_m.size(); }
  void resize(std::size_t count) {
    for (std::vector<float>* channel : {&x_m, &y_m, &z_m, &dx, &dy, &dz}) {
      channel->resize(count);
    }
    time_s.resize(count);
  }
};

struct ScanScratch::Memory {
  Beams beams;
  WorldRays rays;
  std::vector<Hit> hits;
};

}  // namespace berm::sim
