#include "points_check.hpp"

#include <fmt/format.h>

#include "berm/core/error.hpp"

namespace berm {
namespace {

void check_channel(const char* channel, std::size_t length, std::size_t points, bool optional) {
  if (length != points && !(optional && length == 0)) {
    throw Error(ErrorCode::invalid_argument,
                fmt::format("points to be written: channel {} has {} values for {} points", channel, length, points));
  }
}

}  // namespace

void check_channels(const PointsView& points) {
  check_channel("y", points.y.size(), points.size(), false);
  check_channel("z", points.z.size(), points.size(), false);
  check_channel("intensity", points.intensity.size(), points.size(), true);
  check_channel("time", points.time.size(), points.size(), true);
  check_channel("ring", points.ring.size(), points.size(), true);
  check_channel("label", points.label.size(), points.size(), true);
}

}  // namespace berm
