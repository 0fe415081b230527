#pragma once

#include <memory>

#include "berm/core/config.hpp"
#include "berm/snow/snow.hpp"

namespace berm {

/// Settings of the default snow method.
struct SparseSnowConfig {
  double max_range_m = 17.0;

  static void fields(auto&& field) {
    field("max_range_m", &SparseSnowConfig::max_range_m, Range{1.0, 100.0}, "flakes farther away are not looked for");
  }
  void check() const { check_fields(*this, "snow"); }
};

/// The default snow method (`--method snow=default`): a flake is a dark near point that has few neighbours of its own
/// range, measured in angles, so that the density of the sensor's beams does not matter.
class SparseSnow final : public SnowFilter {
 public:
  /// Throws ConfigError as `SparseSnowConfig::check`.
  explicit SparseSnow(const SparseSnowConfig& config);
  ~SparseSnow() override;

  [[nodiscard]] SnowResult process(const PointsView& points, const Pose& T_base_sensor) override;

 private:
  struct State;
  SparseSnowConfig config_;
  std::unique_ptr<State> state_;
};

}  // namespace berm
