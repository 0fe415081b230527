#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "berm/core/label.hpp"
#include "berm/core/scan.hpp"
#include "berm/edge/edge.hpp"
#include "berm/ground/ground.hpp"
#include "berm/pipeline/machine.hpp"
#include "berm/pipeline/mount_check.hpp"
#include "berm/pipeline/scan_result.hpp"
#include "berm/piste/piste.hpp"
#include "berm/snow/repair.hpp"
#include "berm/snow/snow.hpp"

namespace berm {

/// The steps of the chain, in the order in which a scan passes them.
enum class Stage : std::uint8_t {
  snow,    ///< which points are flakes
  ground,  ///< which of the others are ground
  repair,  ///< the series without gaps; only with a piste method
  piste,
  edge,   ///< where the road ends
  check,  ///< what the scan lacks, and whether the mount can be right
};
inline constexpr std::size_t kStages = 6;
[[nodiscard]] std::string_view to_string(Stage stage);

/// Called as soon as a stage is done; not for those that the machine leaves out.
using StageListener = std::function<void(Stage)>;

/// The method that `machine.methods` names, with its configuration; null for "none".
[[nodiscard]] std::unique_ptr<SnowFilter> make_snow(const Machine& machine);
[[nodiscard]] std::unique_ptr<GroundSegmenter> make_ground(const Machine& machine);
[[nodiscard]] std::unique_ptr<PisteSegmenter> make_piste(const Machine& machine);
[[nodiscard]] std::unique_ptr<EdgeDetector> make_edge(const Machine& machine);

/// The chain of all stages for one scan after the other. The result depends on the scan and the machine alone. Not to
/// be shared by threads: each has its own.
class Pipeline {
 public:
  /// Throws ConfigError as `Machine::check`.
  explicit Pipeline(const Machine& machine);

  /// Flakes are falling snow, and no later stage sees them. Ground is drivable, what stands on it an obstacle; a piste
  /// method parts ground into drivable and terrain. Edges of a road are looked for whatever the piste method says.
  /// Points that are NaN or absurd are unlabeled.
  [[nodiscard]] ScanResult process(const Scan& scan, const StageListener& on_done = {});

 private:
  [[nodiscard]] PointsView without_flakes(const PointsView& points, const SnowResult& snow);
  void label(const GroundResult& ground, const SnowResult& snow);

  std::unique_ptr<SnowFilter> snow_;
  std::unique_ptr<GroundSegmenter> ground_;
  std::unique_ptr<PisteSegmenter> piste_;
  std::unique_ptr<EdgeDetector> edge_;
  SeriesRepair repair_;
  MountCheck mount_check_;
  std::vector<std::uint8_t> no_flakes_;  ///< what a missing snow method says
  std::vector<float> x_;                 ///< the scan without flakes
  std::vector<float> y_;
  std::vector<float> z_;
  std::vector<Label> labels_;
};

}  // namespace berm
