#include "air_lanes.hpp"

#include <algorithm>

namespace berm::sim {

void AirLanes::pad() {
  for (Lanes<float>* lanes : {&x_m, &y_m, &z_m, &dx, &dy, &dz, &end_m, &slope}) {
    std::fill(lanes->begin() + count, lanes->begin() + padded(), (*lanes)[count - 1]);
  }
  std::fill(time_s.begin() + count, time_s.begin() + padded(), time_s[count - 1]);
}

}  // namespace berm::sim
