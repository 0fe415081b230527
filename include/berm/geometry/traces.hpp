#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "berm/core/label.hpp"
#include "berm/core/point_cloud.hpp"
#include "berm/geometry/bearing_grid.hpp"
#include "berm/geometry/level_points.hpp"

namespace berm {

/// How neighbours on the ground were found.
enum class TraceKind {
  firing,       ///< one beam after the other, as a rosette draws
  interleaved,  ///< several lasers take turns: every n-th beam
  rings,        ///< by the ring channel; by elevation where there is none and elevations lie apart
  radial,       ///< no order to be found: outward within sectors. Errors of the pose within the scan come in
};

/// The ground points of a scan along the traces that the beams draw on the ground. Neighbours of a trace were measured
/// within a millisecond of each other, so that a machine that heaves, or a mirror that trembles, moves them together:
/// the shape along a trace is known to millimetres where heights across the scan are known to centimetres.
struct Traces {
  TraceKind kind = TraceKind::firing;
  std::vector<std::uint32_t> index;  ///< of the point in the scan
  std::vector<float> x;              ///< m, levelled frame
  std::vector<float> y;
  std::vector<float> z;
  std::vector<float> range;             ///< m, from the sensor
  std::vector<float> step;              ///< m, on the map, from the point before; of the first: 0
  std::vector<std::uint8_t> is_broken;  ///< 1: the point does not follow on the one before
};

/// Finds the traces. Keeps its memory.
class TraceFinder {
 public:
  /// `labels`: drivable for ground. The result is valid until the next call.
  [[nodiscard]] const Traces& process(const PointsView& points, std::span<const Label> labels, const LevelPoints& level,
                                      const bearing_grid::SectorTable& sectors);

 private:
  void choose_order(const PointsView& points);
  void order_by(std::span<const std::uint32_t> keys, std::size_t key_count, std::span<const Label> labels);
  void gather(const LevelPoints& level);
  void order_around(const LevelPoints& level);
  void order_radially(std::span<const Label> labels, const LevelPoints& level,
                      const bearing_grid::SectorTable& sectors);
  void find_breaks(const LevelPoints& level);

  Traces traces_;
  std::size_t lag_ = 1;
  std::vector<std::uint32_t> keys_;
  std::vector<std::uint32_t> starts_;
};

}  // namespace berm
