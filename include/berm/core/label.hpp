#pragma once

#include <cstdint>

namespace berm {

/// What a point is. One byte; the numbers on disk are SemanticKITTI's, see `semantic_kitti_id`.
enum class Label : std::uint8_t {
  unlabeled,     ///< nothing is known
  no_return,     ///< the beam met nothing; the point only keeps its place in the firing order
  falling_snow,  ///< a flake in the air, not the snow on the ground
  drivable,      ///< ground that the machine can drive on
  terrain,       ///< ground that it should not drive on
  obstacle,      ///< everything else
};

/// SemanticKITTI class id of `label`: 0, 0, 110, 40, 72, 99. Ids above 100 are those that WADS added.
[[nodiscard]] constexpr std::uint32_t semantic_kitti_id(Label label) {
  switch (label) {
    case Label::falling_snow:
      return 110;
    case Label::drivable:
      return 40;
    case Label::terrain:
      return 72;
    case Label::obstacle:
      return 99;
    case Label::unlabeled:
    case Label::no_return:
      break;
  }
  return 0;
}

}  // namespace berm
