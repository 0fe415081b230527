#pragma once

#include <memory>
#include <span>
#include <vector>

#include "berm/core/label.hpp"
#include "berm/core/scan.hpp"
#include "berm/ground/ground.hpp"
#include "berm/pipeline/machine.hpp"

namespace berm {

/// What the chain says of one scan.
struct ScanLabels {
  std::span<const Label> labels;  ///< one per point; valid until the next call of `process`
  GroundCounts ground;
};

/// The ground method that `machine.methods.ground` names, with its configuration.
[[nodiscard]] std::unique_ptr<GroundSegmenter> make_ground(const Machine& machine);

/// The chain of all stages for one scan after the other. The result depends on the scan and the machine alone. Not to
/// be shared by threads: each has its own.
class Pipeline {
 public:
  /// Throws ConfigError as `Machine::check`.
  explicit Pipeline(const Machine& machine);

  /// Ground is drivable, what stands on it an obstacle, points that are NaN or absurd are unlabeled.
  [[nodiscard]] ScanLabels process(const Scan& scan);

 private:
  std::unique_ptr<GroundSegmenter> ground_;
  std::vector<Label> labels_;
};

}  // namespace berm
