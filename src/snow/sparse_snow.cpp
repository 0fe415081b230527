#include "berm/snow/sparse_snow.hpp"

#include <cstdint>
#include <vector>

namespace berm {

struct SparseSnow::State {
  std::vector<std::uint8_t> falling;
};

SparseSnow::SparseSnow(const SparseSnowConfig& config) : config_(config), state_(std::make_unique<State>()) {
  config_.check();
}

SparseSnow::~SparseSnow() = default;

SnowResult SparseSnow::process(const PointsView& points, const Pose& /*T_base_sensor*/) {
  state_->falling.assign(points.size(), 0);
  return {.falling = state_->falling, .count = 0, .limits = {}};
}

}  // namespace berm
