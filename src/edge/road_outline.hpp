#pragma once

#include <array>
#include <cstddef>

#include "road_divide.hpp"

namespace berm {

/// What edges on one side say of where that side is between them: no road bends more sharply than a machine can turn,
/// so that between two edges the third lies near their chord, or nearer. Beams that pass over a berm show ground
/// behind it, and what bounds that ground is no edge of this road.
class RoadOutline {
 public:
  static constexpr std::size_t kSectors = 90;

  RoadOutline();
  void clear();
  void add(float x_m, float y_m);
  /// After the last `add`.
  void close(const RoadDivide& divide, float min_radius_m);
  [[nodiscard]] bool is_beyond(float x_m, float y_m) const;

 private:
  struct Place {
    float x_m = 0.0F;
    float y_m = 0.0F;
    float range_m = 0.0F;  ///< 0: none
  };

  /// Limits the sectors between that of `first` and the one `steps` on.
  void limit_between(std::size_t first, std::size_t steps, float min_radius_m);

  std::array<Place, kSectors> rays_{};  ///< unit vectors
  std::array<Place, kSectors> nearest_{};
  std::array<float, kSectors> limit_m_{};
};

}  // namespace berm
