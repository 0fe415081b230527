#include <cstdio>

#include "berm/core/point_cloud.hpp"

int main() {
  berm::PointChannels channels;
  channels.x = {1.0F};
  channels.y = {2.0F};
  channels.z = {3.0F};
  const berm::PointCloud cloud(std::move(channels));
  std::printf("%zu point\n", cloud.size());
  return cloud.size() == 1 ? 0 : 1;
}
