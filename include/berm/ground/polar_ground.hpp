#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "berm/core/config.hpp"
#include "berm/ground/ground.hpp"

namespace berm {

/// Settings of method G. Heights are measured from the sensor, as in the original.
struct PolarGroundConfig {
  int channels = 80;              ///< G step 2
  int bins = 120;                 ///< G step 2
  double min_range_m = 3.4;       ///< G step 1
  double max_range_m = 120.0;     ///< G step 1
  double min_height_m = -2.0;     ///< T_hmin, G step 3
  double max_height_m = -0.4;     ///< T_hmax, G step 3
  double sensor_height_m = 2.0;   ///< G step 3
  double max_difference_m = 0.4;  ///< G step 6
  double tolerance_m = 0.25;      ///< G step 9

  static void fields(auto&& field);
  /// Throws ConfigError for a value outside its range, or if a minimum is not below its maximum.
  void check() const;
};

/// Method G as published (`--method ground=reference`): slope-based classification of channels on a polar grid,
/// consistency check, median filter. Kept for comparison; its faults are kept too, see docs/ground.md.
class PolarGround final : public GroundSegmenter {
 public:
  /// Throws ConfigError as `PolarGroundConfig::check`.
  explicit PolarGround(const PolarGroundConfig& config);

  /// Uses the rotation of `T_base_sensor` alone: the method takes "up" and its sensor height for granted. Gives no
  /// surface.
  [[nodiscard]] GroundResult process(const PointsView& points, const Pose& T_base_sensor) override;

 private:
  struct Cell {
    float lowest_m = 0.0F;
    float height_m = 0.0F;
    float smoothed_m = 0.0F;
    float difference_m = 0.0F;
    float ground_m = 0.0F;
    bool is_ground = false;
  };

  [[nodiscard]] Cell& cell(int channel, int bin);
  void map_points(const PointsView& points, const Pose& T_base_sensor);
  void choose_heights();
  void smooth_heights();
  void compare_neighbours();
  void classify_cells();
  void check_consistency();
  void filter_median();
  GroundCounts classify_points(const PointsView& points);

  PolarGroundConfig config_;
  std::vector<Cell> cells_;
  std::vector<int> cell_of_point_;  ///< -1: in none
  std::vector<float> heights_m_;    ///< of the points, from the sensor
  std::vector<GroundClass> classes_;
};

void PolarGroundConfig::fields(auto&& field) {
  using C = PolarGroundConfig;
  field("channels", &C::channels, Range{8, 1024}, "sectors of the polar grid");
  field("bins", &C::bins, Range{4, 1024}, "cells of a sector");
  field("min_range_m", &C::min_range_m, Range{0.0, 50.0}, "nearer points are the vehicle itself");
  field("max_range_m", &C::max_range_m, Range{5.0, 500.0}, "farther points are unusable");
  field("min_height_m", &C::min_height_m, Range{-50.0, 50.0}, "lowest ground, from the sensor (T_hmin)");
  field("max_height_m", &C::max_height_m, Range{-50.0, 50.0}, "highest ground, from the sensor (T_hmax)");
  field("sensor_height_m", &C::sensor_height_m, Range{0.0, 50.0}, "sensor above the ground");
  field("max_difference_m", &C::max_difference_m, Range{0.01, 10.0}, "step between cells that is ground still");
  field("tolerance_m", &C::tolerance_m, Range{0.0, 5.0}, "points up to this above the ground belong to it");
}

}  // namespace berm
