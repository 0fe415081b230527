#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "berm/core/label.hpp"
#include "berm/core/series.hpp"
#include "berm/edge/edge.hpp"
#include "berm/geometry/height_grid.hpp"
#include "berm/pipeline/mount_check.hpp"
#include "berm/piste/piste.hpp"

namespace berm {

/// How many points of a scan have which label; they add up to its points.
struct LabelCounts {
  std::size_t drivable = 0;
  std::size_t terrain = 0;
  std::size_t obstacle = 0;
  std::size_t falling_snow = 0;
  std::size_t no_return = 0;
  std::size_t invalid = 0;  ///< NaN or absurdly far

  [[nodiscard]] std::size_t points() const { return returns() + no_return + invalid; }
  [[nodiscard]] std::size_t returns() const { return drivable + terrain + obstacle + falling_snow; }
};

[[nodiscard]] LabelCounts count_labels(std::span<const Label> labels);

/// What made a scan worse than it should be. The work goes on with less; see docs/command_line.md.
enum class Degradation : std::uint8_t {
  no_points,
  few_returns,           ///< too few to say much about
  no_ground,             ///< none was found
  invalid_points,        ///< more than one in a hundred
  no_intensity,          ///< absent, or the same for all
  no_returns_dropped,    ///< beams that met nothing are missing from the list
  no_time,               ///< absent, or the same for all
  no_firing_order,       ///< neighbours in the list are none in the world
  snow_hides_the_scene,  ///< more flakes than all other returns
  mount_implausible,     ///< the ground near the machine contradicts the mount
};
inline constexpr std::size_t kDegradations = 10;

/// As it stands in files: "no_intensity".
[[nodiscard]] std::string_view to_string(Degradation degradation);

/// A set of degradations.
class Degradations {
 public:
  void add(Degradation degradation) { bits_ = static_cast<std::uint16_t>(bits_ | bit(degradation)); }
  [[nodiscard]] bool has(Degradation degradation) const { return (bits_ & bit(degradation)) != 0; }
  [[nodiscard]] bool empty() const { return bits_ == 0; }
  /// Their names, joined by '+'; empty without any.
  [[nodiscard]] std::string text() const;

 private:
  static std::uint16_t bit(Degradation degradation) {
    return static_cast<std::uint16_t>(1U << static_cast<unsigned>(degradation));
  }

  std::uint16_t bits_ = 0;
};

/// What the chain says of one scan. Spans and pointers are valid until its next call.
struct ScanResult {
  std::span<const Label> labels;  ///< one per point
  LabelCounts counts;
  SeriesView series;                      ///< gaps closed; empty without a piste method
  PisteResult piste;                      ///< nothing in it without a piste method
  EdgeResult edge;                        ///< nothing in it without an edge method
  const HeightGrid* surface = nullptr;    ///< the ground; null if the method gives none
  std::optional<double> ground_tilt_rad;  ///< of the ground plane of the whole scan against the mount; for information
  MountCheckResult mount;
  Degradations degraded;
};

}  // namespace berm
