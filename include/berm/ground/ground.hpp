#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "berm/core/label.hpp"
#include "berm/core/point_cloud.hpp"
#include "berm/core/pose.hpp"
#include "berm/geometry/height_grid.hpp"

namespace berm {

/// What the ground stage says of a point.
enum class GroundClass : std::uint8_t {
  not_ground,
  ground,
  no_return,  ///< see `is_no_return`
  invalid,    ///< NaN or absurdly far: counted, never used
};

/// Ground is drivable until a later stage says otherwise, what stands on it an obstacle.
[[nodiscard]] constexpr Label label_of(GroundClass ground) {
  switch (ground) {
    case GroundClass::ground:
      return Label::drivable;
    case GroundClass::not_ground:
      return Label::obstacle;
    case GroundClass::no_return:
      return Label::no_return;
    case GroundClass::invalid:
      break;
  }
  return Label::unlabeled;
}

struct GroundCounts {
  std::size_t ground = 0;
  std::size_t not_ground = 0;
  std::size_t no_return = 0;
  std::size_t invalid = 0;
};

struct GroundResult {
  std::span<const GroundClass> classes;  ///< one per point; valid until the next call of `process`
  const HeightGrid* surface = nullptr;   ///< height of the ground where it is known; valid as long as `classes`
  GroundCounts counts;
};

/// Separates ground from everything else, scan by scan. Keeps scratch memory between calls and nothing else: the
/// result depends on the scan alone.
class GroundSegmenter {
 public:
  GroundSegmenter() = default;
  GroundSegmenter(const GroundSegmenter&) = delete;
  GroundSegmenter& operator=(const GroundSegmenter&) = delete;
  virtual ~GroundSegmenter() = default;

  /// `points` in the frame of the sensor. `T_base_sensor` may be off by decimetres and tens of degrees, see the
  /// documentation of the method.
  [[nodiscard]] virtual GroundResult process(const PointsView& points, const Pose& T_base_sensor) = 0;
};

}  // namespace berm
