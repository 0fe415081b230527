#include "berm/view/points_payload.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <utility>
#include <vector>

#include "byte_writer.hpp"

namespace berm {
namespace {

/// NaN becomes 0.
std::uint8_t to_byte(float value) {
  return value > 0.0F ? static_cast<std::uint8_t>(std::lround(std::min(value, 255.0F))) : std::uint8_t{0};
}

/// The points of a payload, one channel after the other.
class PayloadWriter {
 public:
  PayloadWriter(const PointsView& points, std::vector<std::uint32_t> kept) : points_(points), kept_(std::move(kept)) {
    payload_.reserve(kPayloadHeaderBytes + kept_.size() * kPayloadPointBytes);
    append_bytes(payload_, kPayloadMagic);
    append_bytes(payload_, static_cast<std::uint32_t>(kept_.size()));
    append_bytes(payload_, 0.0F);
    append_bytes(payload_, (points.intensity.empty() ? 0U : kPayloadIntensity) |
                               (points.label.empty() ? 0U : kPayloadLabel) | (points.time.empty() ? 0U : kPayloadTime) |
                               (points.ring.empty() ? 0U : kPayloadRing));
  }

  void write_positions(const Pose& T_target_source) {
    const Eigen::Matrix3f R = T_target_source.rotation().toRotationMatrix().cast<float>();
    const Eigen::Vector3f t_m = T_target_source.translation_m().cast<float>();
    for (int axis = 0; axis < 3; ++axis) {
      const float rx = R(axis, 0);
      const float ry = R(axis, 1);
      const float rz = R(axis, 2);
      append<float>(
          [&](std::size_t i) { return rx * points_.x[i] + ry * points_.y[i] + rz * points_.z[i] + t_m[axis]; });
    }
  }

  void write_bytes() {
    append_channel(points_.intensity, to_byte);
    append_channel(points_.label, [](Label label) { return static_cast<std::uint8_t>(label); });
    write_time();
    append_channel(points_.ring,
                   [](std::uint16_t ring) { return static_cast<std::uint8_t>(std::min<int>(ring, 255)); });
  }

  [[nodiscard]] std::string take() { return std::move(payload_); }

 private:
  template <typename Value, typename Get>
  void append(Get&& get) {
    const std::size_t begin = payload_.size();
    payload_.resize(begin + kept_.size() * sizeof(Value));
    char* target = payload_.data() + begin;
    for (const std::uint32_t i : kept_) {
      const Value value = get(i);
      std::memcpy(target, &value, sizeof(Value));
      target += sizeof(Value);
    }
  }

  template <typename Channel, typename Convert>
  void append_channel(const Channel& channel, Convert&& convert) {
    if (channel.empty()) {
      payload_.append(kept_.size(), '\0');
    } else {
      append<std::uint8_t>([&](std::size_t i) { return convert(channel[i]); });
    }
  }

  /// Over all points, not those kept alone: the first and last beam of a scan often meet nothing.
  void write_time() {
    float first = std::numeric_limits<float>::infinity();
    float last = -first;
    for (const float time : points_.time) {
      first = std::isfinite(time) ? std::min(first, time) : first;
      last = std::isfinite(time) ? std::max(last, time) : last;
    }
    const float scale = last > first ? 255.0F / (last - first) : 0.0F;
    append_channel(points_.time, [&](float time) { return to_byte((time - first) * scale); });
  }

  const PointsView& points_;
  std::vector<std::uint32_t> kept_;
  std::string payload_;
};

}  // namespace

bool is_in_payload(float x, float y, float z) {
  const auto is_sane = [](float value_m) { return std::abs(value_m) <= kMaxPayloadCoordinate_m; };
  return is_sane(x) && is_sane(y) && is_sane(z) && !is_no_return(x, y, z);
}

std::string make_points_payload(const PointsView& points, const Pose& T_target_source) {
  std::vector<std::uint32_t> kept;
  kept.reserve(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (is_in_payload(points.x[i], points.y[i], points.z[i])) {
      kept.push_back(static_cast<std::uint32_t>(i));
    }
  }
  PayloadWriter writer(points, std::move(kept));
  writer.write_positions(T_target_source);
  writer.write_bytes();
  return writer.take();
}

}  // namespace berm
