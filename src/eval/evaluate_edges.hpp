#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "berm/eval/edge_metrics.hpp"
#include "berm/io/recording.hpp"

namespace berm {

/// The edges of a run against those of the recording, or why they cannot be compared.
struct EdgeEvaluation {
  std::optional<EdgeScore> score;
  std::string reason;
};

/// Truth is asked for where the machine was during the run: on truth.tum at the stamps of trajectory.tum, where both
/// are there. Throws FileError for a broken file.
[[nodiscard]] EdgeEvaluation evaluate_edges(const std::filesystem::path& run_folder, const Recording& recording);

}  // namespace berm
