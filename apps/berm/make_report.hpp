#pragma once

#include <filesystem>

#include "berm/io/recording.hpp"

namespace berm::app {

/// Writes report.html into the folder of a run, with the figures of `berm eval` where `recording` (null: unknown) has
/// truth. Returns its path; throws as `write_report`. Truth that cannot be used is warned of and left out.
std::filesystem::path make_report(const std::filesystem::path& run_folder, const Recording* recording);

}  // namespace berm::app
