#pragma once

#include <filesystem>
#include <optional>

#include "berm/eval/evaluate.hpp"
#include "berm/io/recording.hpp"

namespace berm {

/// Judges trajectory_map.tum of the run in `run_folder`: none without it, without truth, or where they share no time.
/// Throws FileError for a broken one.
[[nodiscard]] std::optional<LocalizationEvaluation> evaluate_localization(const std::filesystem::path& run_folder,
                                                                          const Recording& recording);

}  // namespace berm
