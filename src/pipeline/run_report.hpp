#pragma once

#include <array>
#include <string>
#include <utility>
#include <vector>

#include "berm/io/output_folder.hpp"
#include "berm/io/recording.hpp"
#include "berm/pipeline/machine.hpp"
#include "berm/pipeline/pipeline.hpp"
#include "berm/pipeline/run.hpp"
#include "stage_times.hpp"

namespace berm {

/// What run.json begins with; followed by a slash and the version of the schema.
inline constexpr const char* kRunSchemaName = "berm.run";
inline constexpr int kRunSchemaVersion = 2;

/// What the parts of a run cost, in the order in which a scan passes them.
struct RunTimes {
  StageTimes read;
  std::array<StageTimes, kStages> stages;  ///< nothing in those that the machine leaves out
  StageTimes odometry;                     ///< nothing without an odometry method
  StageTimes localize;                     ///< nothing unless a saved map was named
  StageTimes map;                          ///< nothing without a map
  StageTimes surface;                      ///< nothing without a map of the surface
  StageTimes write;
  double wall_s = 0.0;
};

/// The files of a run: what each holds, and its name.
using RunFiles = std::vector<std::pair<std::string, std::string>>;

/// What a run leaves in its folder.
[[nodiscard]] OutputResults run_results();

/// The text of run.json.
[[nodiscard]] std::string write_run_report(const Recording& recording, const Machine& machine,
                                           const RunOptions& options, const RunSummary& summary, const RunTimes& times,
                                           const RunFiles& files);

}  // namespace berm
