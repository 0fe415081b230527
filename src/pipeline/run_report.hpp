#pragma once

#include <array>
#include <string>

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
  StageTimes write;
  double wall_s = 0.0;
};

/// Which of the files are there that not every run has.
struct RunFiles {
  bool boundary = false;
  bool trajectory = false;
};

/// What a run leaves in its folder.
[[nodiscard]] OutputResults run_results();

/// The text of run.json.
[[nodiscard]] std::string write_run_report(const Recording& recording, const Machine& machine,
                                           const RunOptions& options, const RunSummary& summary, const RunTimes& times,
                                           const RunFiles& files);

}  // namespace berm
