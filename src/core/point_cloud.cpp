#include "berm/core/point_cloud.hpp"

#include <cmath>
#include <string>
#include <utility>

#include "berm/core/error.hpp"

namespace berm {
namespace {

void check_length(const char* channel, std::size_t length, std::size_t points, bool optional) {
  if (length == points || (optional && length == 0)) {
    return;
  }
  throw Error(ErrorCode::invalid_argument, std::string("point cloud: channel ") + channel + " has " +
                                               std::to_string(length) + " values for " + std::to_string(points) +
                                               " points");
}

}  // namespace

void PointChannels::clear() {
  x.clear();
  y.clear();
  z.clear();
  intensity.clear();
  time.clear();
  ring.clear();
  label.clear();
}

PointCloud::PointCloud(PointChannels channels) : channels_(std::move(channels)) {
  const std::size_t points = channels_.x.size();
  check_length("y", channels_.y.size(), points, false);
  check_length("z", channels_.z.size(), points, false);
  check_length("intensity", channels_.intensity.size(), points, true);
  check_length("time", channels_.time.size(), points, true);
  check_length("ring", channels_.ring.size(), points, true);
  check_length("label", channels_.label.size(), points, true);
}

PointsView PointCloud::view() const {
  return {.x = channels_.x,
          .y = channels_.y,
          .z = channels_.z,
          .intensity = channels_.intensity,
          .time = channels_.time,
          .ring = channels_.ring,
          .label = channels_.label};
}

PointChannels PointCloud::release() && {
  return std::exchange(channels_, {});
}

bool is_no_return(float x, float y, float z) {
  return (x == 0.0F && y == 0.0F && z == 0.0F) || std::isinf(x) || std::isinf(y) || std::isinf(z);
}

}  // namespace berm
