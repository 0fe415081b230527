#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <string>

#include "berm/io/cloud_writer.hpp"
#include "berm/view/shown_run.hpp"

namespace berm {

struct ExportOptions {
  std::size_t every = 1;  ///< takes the first of so many scans
  /// Called with what is done and its total.
  std::function<void(std::size_t, std::size_t)> on_progress;
  /// Asked between scans; true ends the export without a file.
  std::function<bool()> should_stop;
};

struct ExportSummary {
  std::uint64_t points = 0;
  std::size_t scans = 0;    ///< that are in the file
  std::size_t skipped = 0;  ///< scans that could not be read or have no pose
  bool interrupted = false;
};

/// Writes the points of all scans of a run in the world, each scan at its pose. Points
/// that are not finite and beams without a return are left out. Throws Error(invalid_argument) if no scan has a pose,
/// FileError(write_failed), the first scan's error if none can be read.
[[nodiscard]] ExportSummary export_cloud(const ShownRun& run, CloudFormat format, const std::filesystem::path& file,
                                         const ExportOptions& options);

/// Writes an MCAP file with Foxglove's schemas: /points (in base_link) with label, intensity and colour, /tf and /pose
/// where poses are known, /edges where the run has lines. Throws as `export_cloud`; poses are not needed.
[[nodiscard]] ExportSummary export_foxglove(const ShownRun& run, const std::filesystem::path& file,
                                            const ExportOptions& options);

/// A layout for Foxglove that shows such a file: JSON.
[[nodiscard]] std::string foxglove_layout();

}  // namespace berm
