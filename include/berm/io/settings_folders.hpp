#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace berm {

/// A kind of settings that are found by name: NAME.yaml in one of some folders.
struct SettingsKind {
  std::string singular;  ///< "machine"
  std::string plural;    ///< "machines": the name of the folder, too
  std::string argument;  ///< of the command line, for messages: "--machine"
};

/// Where things that come with the program may lie: share/berm/NAME beside it (in the build tree) and one level above
/// it (installed). None if the system does not tell where the program is.
[[nodiscard]] std::vector<std::filesystem::path> share_folders(const std::string& name);

/// Folders that are searched for NAME.yaml, in this order: ./PLURAL, then share/berm/PLURAL beside the program and one
/// level above it (installed).
[[nodiscard]] std::vector<std::filesystem::path> settings_folders(const SettingsKind& kind);

/// Names of the settings in `folders`, sorted, each once.
[[nodiscard]] std::vector<std::string> list_settings(const std::vector<std::filesystem::path>& folders);

/// Whether `name_or_file` names a file: it holds a slash or ends in .yaml or .yml.
[[nodiscard]] bool is_settings_file(const std::string& name_or_file);

/// The file of settings: `name_or_file` itself if it names a file, else the first NAME.yaml in `folders`. Throws
/// ConfigError listing the names that exist.
[[nodiscard]] std::filesystem::path find_settings(const SettingsKind& kind, const std::string& name_or_file,
                                                  const std::vector<std::filesystem::path>& folders);

}  // namespace berm
