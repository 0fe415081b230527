#pragma once

#include <string>
#include <vector>

#include "berm/core/point_cloud.hpp"

namespace berm::test {

struct BadScan {
  std::string name;  ///< letters, digits and '_'
  PointCloud cloud;  ///< as a driver delivers it, from a sensor that is thought to be on `groomer_mount`
};

/// The scan of `mid70_scan` with every channel a sensor may have, and a good one among the bad: "as_it_should_be".
[[nodiscard]] std::vector<BadScan> bad_scans();

}  // namespace berm::test
