#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "base_series.hpp"
#include "berm/core/label.hpp"
#include "berm/core/point_cloud.hpp"
#include "berm/core/series.hpp"
#include "berm/piste/piste.hpp"

namespace berm::test {

/// A series made by hand; its frame is whatever the test takes it for.
struct MadeSeries {
  std::vector<float> x;
  std::vector<float> y;
  std::vector<float> z;
  std::vector<std::uint8_t> interpolated;

  MadeSeries() = default;
  /// `size` points that all lie `ahead_m` ahead, at height 0.
  explicit MadeSeries(std::size_t size, float ahead_m = 20.0F)
      : x(size, ahead_m), y(size, 0.0F), z(size, 0.0F), interpolated(size, 0) {}

  void add(double x_m, double y_m, double z_m, bool made_up = false) {
    x.push_back(static_cast<float>(x_m));
    y.push_back(static_cast<float>(y_m));
    z.push_back(static_cast<float>(z_m));
    interpolated.push_back(made_up ? 1 : 0);
  }
  [[nodiscard]] std::size_t size() const { return x.size(); }
  [[nodiscard]] SeriesView view() const { return {.x = x, .y = y, .z = z, .interpolated = interpolated}; }
  [[nodiscard]] BaseSeries in_base(const Pose& T_base_sensor = {}) const {
    BaseSeries series;
    series.assign(view(), T_base_sensor);
    return series;
  }
  /// The points are those of the series.
  [[nodiscard]] PisteInput input(const std::vector<Label>& labels, const Pose& T_base_sensor = {}) const {
    PisteInput made;
    made.points.x = x;
    made.points.y = y;
    made.points.z = z;
    made.labels = labels;
    made.series = view();
    made.T_base_sensor = T_base_sensor;
    return made;
  }
};

}  // namespace berm::test
