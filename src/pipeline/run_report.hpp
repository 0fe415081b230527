#pragma once

#include <string>

#include "berm/io/output_folder.hpp"
#include "berm/io/recording.hpp"
#include "berm/pipeline/machine.hpp"
#include "berm/pipeline/run.hpp"
#include "stage_times.hpp"

namespace berm {

/// What run.json begins with; followed by a slash and the version of the schema.
inline constexpr const char* kRunSchemaName = "berm.run";
inline constexpr int kRunSchemaVersion = 1;

/// The stages in the order in which a scan passes them.
struct RunTimes {
  StageTimes read;
  StageTimes ground;
  StageTimes write;
  double wall_s = 0.0;
};

/// What a run leaves in its folder.
[[nodiscard]] OutputResults run_results();

/// The text of run.json.
[[nodiscard]] std::string write_run_report(const Recording& recording, const Machine& machine,
                                           const RunOptions& options, const RunSummary& summary, const RunTimes& times,
                                           bool has_trajectory);

}  // namespace berm
