#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace berm {

/// Everything that report.html shows, as one JSON object, made from the files of a run (docs/report.md has the keys).
/// A file that the run did not write leaves its part out; one that is broken is named under `trouble`. `evaluation` is
/// what `berm eval` prints, empty without truth. A few 100 kB, however long the run was.
///
/// Throws FileError if `run_folder` has no run.json, or one that is not of berm.
[[nodiscard]] std::string report_data(const std::filesystem::path& run_folder, std::string_view evaluation = {});

/// Where the recording of a run was, as run.json says. Throws as `report_data`.
[[nodiscard]] std::filesystem::path recording_of(const std::filesystem::path& run_folder);

/// The page: `page` with `json` in the place that it has for it. Nothing in `json` ends that place or becomes markup.
/// Throws Error(malformed) if `page` has no such place.
[[nodiscard]] std::string fill_report(std::string_view page, std::string_view json);

/// The page without data that comes with the program: share/berm/web/report.html. Throws FileError(not_found).
[[nodiscard]] std::filesystem::path find_report_page();

/// Writes report.html into the folder of a run and returns its path. Throws as the functions above, and
/// FileError(write_failed) as AtomicFile.
std::filesystem::path write_report(const std::filesystem::path& run_folder, std::string_view evaluation = {});

}  // namespace berm
