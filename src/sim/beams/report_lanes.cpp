#include "report_lanes.hpp"

#include <algorithm>
#include <cmath>

#include "beam_optics.hpp"
#include "berm/core/multiversion.hpp"

namespace berm::sim {
namespace {

constexpr std::size_t kPacket = 8;
constexpr float kMaxReflectivity = 255.0F;
/// Ranges without steps have steps that are finer than a float.
constexpr float kLeastStep_m = 1e-9F;

struct Receiver {
  explicit Receiver(const OpticsConfig& optics)
      : detection_limit(static_cast<float>(optics.detection_limit())),
        range_noise_m(static_cast<float>(optics.range_noise_m)),
        step_m(std::max(kLeastStep_m, static_cast<float>(optics.range_quantum_m))),
        reflectivity_scale(static_cast<float>(optics.reflectivity_scale)) {}

  float detection_limit;
  float range_noise_m;
  float step_m;
  float reflectivity_scale;
};

/// Nearest whole number of one that is not negative and below 2^31.
[[gnu::always_inline]] inline float whole(float positive) {
  return static_cast<float>(static_cast<std::int32_t>(positive + 0.5F));
}

/// In the sensor's steps, unless they are finer than a float.
[[gnu::always_inline]] inline float stepped(float range_m, float step_m) {
  constexpr float kAllWhole = 8e6F;
  const float steps = std::abs(range_m) / step_m;
  const float steps_m = std::copysign(whole(steps < kAllWhole ? steps : kAllWhole) * step_m, range_m);
  return steps < kAllWhole ? steps_m : range_m;
}

// In two loops: in one, compilers make branches of some choices, and compute with one echo at a time.
BERM_MULTIVERSION void add_noise(const Receiver& made, std::size_t count, ReportLanes& __restrict lanes) {
  const Receiver r = made;
  for (std::size_t i = 0; i < count; ++i) {
    const NormalPair normal = normal_pair(UniformPair{lanes.share[i], lanes.turn[i]});
    const float variance_m2 =
        lanes.variance_m2[i] + range_variance_m2(lanes.light[i] / r.detection_limit, r.range_noise_m);
    lanes.range_m[i] += std::sqrt(variance_m2) * normal.first;
    lanes.reflectivity[i] = r.reflectivity_scale * (lanes.energy[i] + lanes.spot_sigma[i] * normal.second);
  }
}

BERM_MULTIVERSION void round_off(const Receiver& made, std::size_t count, ReportLanes& __restrict lanes) {
  const Receiver r = made;
  for (std::size_t i = 0; i < count; ++i) {
    lanes.range_m[i] = stepped(lanes.range_m[i], r.step_m);
    // Sensors report whole numbers.
    const float bright = lanes.reflectivity[i];
    const float positive = bright > 0.0F ? bright : 0.0F;
    lanes.reflectivity[i] = whole(positive < kMaxReflectivity ? positive : kMaxReflectivity);
  }
}

}  // namespace

void ReportLanes::add(std::size_t of_beam, const Echo& echo, UniformPair chance) {
  range_m[count] = echo.range_m;
  energy[count] = echo.energy;
  light[count] = echo.light;
  variance_m2[count] = echo.variance_m2;
  spot_sigma[count] = echo.spot_sigma;
  share[count] = chance.share;
  turn[count] = chance.turn;
  label[count] = echo.label;
  beam[count] = static_cast<std::uint32_t>(of_beam);
  ++count;
}

void report_all(const OpticsConfig& optics, ReportLanes& lanes) {
  // Whole packets: what lies in the lanes behind is never read.
  const std::size_t count = (lanes.count + kPacket - 1) / kPacket * kPacket;
  const Receiver receiver(optics);
  add_noise(receiver, count, lanes);
  round_off(receiver, count, lanes);
}

}  // namespace berm::sim
