#pragma once

#include <filesystem>

#include "berm/pipeline/machine.hpp"

namespace berm::app {

/// The mount that a run was made with, from its run.json; the default one if the run has none. Throws FileError if the
/// file is none of berm's.
[[nodiscard]] MountConfig read_run_mount(const std::filesystem::path& run_folder);

}  // namespace berm::app
