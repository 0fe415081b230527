#pragma once

#include <vector>

#include "berm/core/config.hpp"
#include "berm/ground/ground.hpp"

namespace berm {

struct PolarGroundConfig {
  double min_range_m = 3.4;  ///< G step 1

  static void fields(auto&& field) {
    field("min_range_m", &PolarGroundConfig::min_range_m, Range{0.0, 50.0}, "nearer points are the vehicle itself");
  }
  void check() const { check_fields(*this, "ground_reference"); }
};

/// Method G as published (`--method ground=reference`).
class PolarGround final : public GroundSegmenter {
 public:
  explicit PolarGround(const PolarGroundConfig& config);
  [[nodiscard]] GroundResult process(const PointsView& points, const Pose& T_base_sensor) override;

 private:
  PolarGroundConfig config_;
  std::vector<GroundClass> classes_;
};

}  // namespace berm
