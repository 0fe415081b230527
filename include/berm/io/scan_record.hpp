#pragma once

#include <optional>
#include <string>
#include <vector>

#include "berm/core/point_cloud.hpp"
#include "berm/core/stamp.hpp"

namespace berm {

/// One scan as a file gives it, its channels already in the units and names of `PointCloud`.
struct ScanRecord {
  PointChannels channels;
  std::optional<Stamp> start_ns;    ///< time of the first point, where the file holds absolute time
  std::vector<std::string> fields;  ///< names of the fields as the file spells them
  std::vector<std::string> notes;   ///< what was chosen or looked odd, one sentence each
};

}  // namespace berm
