#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "berm/eval/label_metrics.hpp"
#include "berm/geometry/height_grid.hpp"
#include "berm/pipeline/pipeline.hpp"
#include "simulated_run.hpp"

namespace berm::test {

/// What comes before the piste stage.
struct FrontEnd {
  std::string snow = "default";
  std::string ground = "default";
  bool shuffled = false;  ///< the points come in an order that means nothing

  friend bool operator==(const FrontEnd&, const FrontEnd&) = default;
};

/// A way through the whole chain.
struct Method {
  std::string name;
  FrontEnd front;
  std::string piste = "default";
  BoundaryPisteConfig config;
};

[[nodiscard]] Machine machine_of(const Method& method);

/// The methods' front ends, each once.
[[nodiscard]] std::vector<FrontEnd> front_ends_of(std::span<const Method> methods);

/// A scan on its way into the piste stage.
struct PreparedScan {
  LabelledScan input;                 ///< as the front end saw it
  std::vector<Label> labels;          ///< of the front end
  std::vector<std::uint8_t> falling;  ///< one per point, 1 for a flake
  std::optional<HeightGrid> surface;
};

/// Takes scans as far as the piste stage, as `Pipeline` does.
class FrontEndPass {
 public:
  explicit FrontEndPass(const FrontEnd& front);
  void prepare(const LabelledScan& scan, PreparedScan& prepared);

 private:
  bool shuffled_;
  Pipeline pipeline_;
};

/// The piste stage of a method. The result is valid until the next call.
class PisteStage {
 public:
  explicit PisteStage(const Method& method);
  /// Labels of the whole chain; without a piste method those of the front end.
  [[nodiscard]] std::span<const Label> process(const PreparedScan& scan);

 private:
  std::unique_ptr<PisteSegmenter> piste_;
  SeriesRepair repair_;
};

/// Added up over the points of all scans.
struct Score {
  BinaryCounts piste;
  BinaryCounts snow;

  Score& operator+=(const Score& other);
};

/// Whether each beam came back, as `judge_snow` wants it.
[[nodiscard]] std::vector<std::uint8_t> find_returns(const PointsView& points);

[[nodiscard]] Score score_labels(std::span<const Label> labels, const LabelledScan& scan);

/// One score per method. Each front end is gone through once, whatever the number of methods that use it.
[[nodiscard]] std::vector<Score> score_methods(std::span<const Method> methods, std::span<const LabelledScan> scans);

}  // namespace berm::test
