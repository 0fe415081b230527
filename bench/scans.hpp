#pragma once

#include <string>
#include <vector>

#include "berm/core/point_cloud.hpp"
#include "berm/core/pose.hpp"

namespace berm::bench {

/// A scan to measure on.
struct BenchScan {
  PointCloud cloud;
  Pose T_base_sensor;
};

/// Names of the made street scans of 10 k, 30 k, 120 k and 1 M points.
[[nodiscard]] const std::vector<std::string>& made_scans();
/// Names of the real recordings that are found in $BERM_DATA; the scan is the first of each.
[[nodiscard]] const std::vector<std::string>& real_scans();
/// Both.
[[nodiscard]] std::vector<std::string> all_scans();

/// Made or read when it is first asked for.
[[nodiscard]] const BenchScan& scan(const std::string& name);

}  // namespace berm::bench
