#pragma once

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "berm/io/recording.hpp"

namespace berm {

inline constexpr std::string_view kPcdExtension = ".pcd";
inline constexpr std::string_view kBinExtension = ".bin";

/// Finds out what lies at a path and fills a Recording, one question a step.
class RecordingOpener {
 public:
  explicit RecordingOpener(std::filesystem::path path);

  [[nodiscard]] Recording open();

 private:
  void open_file();
  void open_folder();
  /// Lists `folder` for scans; false if it has none. Takes the recording over otherwise.
  [[nodiscard]] bool take_scans(const std::filesystem::path& folder, std::string_view extension,
                                RecordingLayout layout);
  [[noreturn]] void throw_no_scans() const;
  void find_labels();
  void find_poses();
  void read_sheet();
  void find_stamps();
  [[nodiscard]] bool take_stamps_of_times_file();
  [[nodiscard]] bool take_stamps_of_scans();
  void assume_rate();
  void recognise_intensity();
  /// Reads scans, from the first forward or from the last backward, at most `kMaxProbes`, until `enough` says so.
  /// Throws the first error if none of them can be read.
  void probe(bool forward, const std::function<bool(const ScanRecord&)>& enough) const;
  [[nodiscard]] std::optional<Stamp> first_start(bool forward) const;
  [[nodiscard]] std::optional<std::filesystem::path> sidecar(std::string_view name) const;
  void note(std::string sentence);

  std::filesystem::path path_;
  Recording recording_;
};

}  // namespace berm
