#pragma once

#include <cstdint>
#include <vector>

#include "berm/core/config.hpp"
#include "berm/snow/snow.hpp"

namespace berm {

/// Settings of the published snow method: METHODS section 1, P eq. 1.
struct BoxSnowConfig {
  double min_x_m = 2.0;
  double max_x_m = 6.0;
  double max_intensity = 4.0;

  static void fields(auto&& field) {
    field("min_x_m", &BoxSnowConfig::min_x_m, Range{0.0, 100.0}, "flakes are farther ahead of base_link than this");
    field("max_x_m", &BoxSnowConfig::max_x_m, Range{0.0, 100.0}, "and nearer than this");
    field("max_intensity", &BoxSnowConfig::max_intensity, Range{0.0, 255.0}, "and send back no more than this");
  }
  /// Throws ConfigError for a value outside its range, or a box without room.
  void check() const;
};

/// Falling snow as document P finds it (`--method snow=reference`): near and dark points are flakes.
class BoxSnow final : public SnowFilter {
 public:
  /// Throws ConfigError as `BoxSnowConfig::check`.
  explicit BoxSnow(const BoxSnowConfig& config);

  /// Without intensity nothing is a flake.
  [[nodiscard]] SnowResult process(const PointsView& points, const Pose& T_base_sensor) override;

 private:
  BoxSnowConfig config_;
  std::vector<std::uint8_t> falling_;
};

}  // namespace berm
