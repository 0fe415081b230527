#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "berm/core/label.hpp"
#include "berm/io/label_file.hpp"
#include "berm/render/draw_scan.hpp"

namespace berm::app {

/// Labels as they are on disk.
using RawLabels = std::vector<std::uint32_t>;

/// The colour classes of label files of any origin: what vehicles drive on is drivable, other ground is terrain.
[[nodiscard]] std::vector<Label> to_labels(const RawLabels& raw);

/// How a run's ground compares with truth; the indices of `compare_ground`.
extern const std::array<PointClass, 5> kGroundComparison;

/// One index into `kGroundComparison` per point. Both have the same length.
[[nodiscard]] std::vector<std::uint8_t> compare_ground(const RawLabels& output, const RawLabels& truth);

}  // namespace berm::app
