#include <cmath>
#include <cstdio>

#include "berm/core/pose.hpp"

int main() {
  const berm::Pose T_world_base = berm::Pose::from_yaw_pitch_roll(0.5, 0.1, 0.0, {1.0, 2.0, 3.0});
  const berm::Pose identity = T_world_base * T_world_base.inverse();
  const double error_m = identity.translation_m().norm();
  std::printf("translation of T * T.inverse(): %g m\n", error_m);
  return std::abs(error_m) < 1e-12 ? 0 : 1;
}
