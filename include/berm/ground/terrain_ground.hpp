#pragma once

#include <vector>

#include "berm/core/config.hpp"
#include "berm/ground/ground.hpp"

namespace berm {

struct TerrainGroundConfig {
  double min_range_m = 2.0;

  static void fields(auto&& field) {
    field("min_range_m", &TerrainGroundConfig::min_range_m, Range{0.0, 50.0}, "nearer points are the vehicle itself");
  }
  void check() const { check_fields(*this, "ground"); }
};

/// The default ground method (`--method ground=default`).
class TerrainGround final : public GroundSegmenter {
 public:
  explicit TerrainGround(const TerrainGroundConfig& config);
  [[nodiscard]] GroundResult process(const PointsView& points, const Pose& T_base_sensor) override;

 private:
  TerrainGroundConfig config_;
  std::vector<GroundClass> classes_;
};

}  // namespace berm
