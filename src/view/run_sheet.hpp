#pragma once

#include <cstddef>
#include <filesystem>
#include <string>

#include "berm/core/mount.hpp"

namespace berm {

/// What run.json says that the view needs.
struct RunSheet {
  std::filesystem::path recording;
  std::size_t first = 0;  ///< index of the run's first scan in the recording
  std::size_t scans = 0;  ///< that the run was asked for
  std::string machine;
  std::string sensor;
  std::string piste_method;  ///< "none" where the run had none
  MountConfig mount;
};

/// Reads run.json. Throws FileError: not there, unreadable, no run.json of berm.
[[nodiscard]] RunSheet read_run_sheet(const std::filesystem::path& file);

}  // namespace berm
