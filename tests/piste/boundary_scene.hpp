#pragma once

#include <cstdint>
#include <vector>

#include "berm/core/label.hpp"
#include "berm/core/point_cloud.hpp"
#include "berm/core/pose.hpp"
#include "berm/piste/piste.hpp"
#include "support/made_scan.hpp"

namespace berm::test {

/// A straight piste along x of base_link between two banks of natural snow that is rough. Flat facets, so that beams
/// meet it where a formula says.
struct StraightPiste {
  double half_width_m = 8.0;
  double middle_y_m = 0.0;  ///< where it lies beside the machine
  double bank_m = 0.5;      ///< height of what lies beside it
  double bank_run_m = 0.5;  ///< within which it is reached
  double climb = 0.0;       ///< rise per metre, of all
  double rough_m = 0.04;    ///< of the natural snow, one sigma
};

/// A scan with what earlier stages know of it, and the truth.
struct PisteScan {
  PointCloud cloud;
  std::vector<Label> labels;   ///< ground and no returns
  std::vector<bool> on_piste;  ///< truth
  Pose T_base_sensor;

  [[nodiscard]] PisteInput input() const {
    return {.points = cloud.view(), .labels = labels, .series = {}, .surface = nullptr, .T_base_sensor = T_base_sensor};
  }
};

struct LookOptions {
  double range_noise_m = 0.01;
  double max_range_m = 90.0;
  std::uint32_t seed = 1;
};

[[nodiscard]] PisteScan look_at(const StraightPiste& piste, const Beams& beams, const Pose& T_base_sensor,
                                const LookOptions& options = {});

/// The same points, seen by a sensor that hangs otherwise: turned by `turn` in its own frame, which the mount knows.
[[nodiscard]] PisteScan remounted(const PisteScan& scan, const Eigen::Quaterniond& turn);

/// Left and right exchanged; the sensor must not roll or yaw.
[[nodiscard]] PisteScan mirrored(const PisteScan& scan);

/// In any other order.
[[nodiscard]] PisteScan shuffled(const PisteScan& scan, std::uint32_t seed);

}  // namespace berm::test
