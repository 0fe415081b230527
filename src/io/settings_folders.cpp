#include "berm/io/settings_folders.hpp"

#include <algorithm>
#include <system_error>

#include <sys/auxv.h>

#include "berm/core/error.hpp"
#include "berm/io/closest_name.hpp"

namespace berm {
namespace {

std::vector<std::string> to_strings(const std::vector<std::filesystem::path>& paths) {
  std::vector<std::string> texts(paths.size());
  std::transform(paths.begin(), paths.end(), texts.begin(), [](const auto& path) { return path.string(); });
  return texts;
}

/// The file of the running program; empty if the system does not tell.
std::filesystem::path program_file() {
  std::error_code code;
  std::filesystem::path file = std::filesystem::read_symlink("/proc/self/exe", code);
  if (!code) {
    return file;
  }
  // A bare chroot may have no /proc; the kernel also hands over the name that was started.
  // NOLINTNEXTLINE(performance-no-int-to-ptr): getauxval has one return type for numbers and addresses.
  const auto* started = reinterpret_cast<const char*>(::getauxval(AT_EXECFN));
  file = started == nullptr ? "" : std::filesystem::canonical(started, code);
  return code ? std::filesystem::path() : file;
}

}  // namespace

std::vector<std::filesystem::path> share_folders(const std::string& name) {
  const std::filesystem::path program = program_file();
  if (program.empty()) {
    return {};
  }
  const std::filesystem::path folder = program.parent_path();
  return {folder / "share/berm" / name, folder.parent_path() / "share/berm" / name};
}

std::vector<std::filesystem::path> settings_folders(const SettingsKind& kind) {
  std::vector<std::filesystem::path> folders = share_folders(kind.plural);
  folders.insert(folders.begin(), kind.plural);
  return folders;
}

std::vector<std::string> list_settings(const std::vector<std::filesystem::path>& folders) {
  std::vector<std::string> names;
  for (const auto& folder : folders) {
    std::error_code code;
    for (std::filesystem::directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code)) {
      if (entry->path().extension() == ".yaml") {
        names.push_back(entry->path().stem().string());
      }
    }
  }
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

bool is_settings_file(const std::string& name_or_file) {
  const std::filesystem::path extension = std::filesystem::path(name_or_file).extension();
  return name_or_file.find('/') != std::string::npos || extension == ".yaml" || extension == ".yml";
}

std::filesystem::path find_settings(const SettingsKind& kind, const std::string& name_or_file,
                                    const std::vector<std::filesystem::path>& folders) {
  if (is_settings_file(name_or_file)) {
    return name_or_file;
  }
  for (const auto& folder : folders) {
    std::filesystem::path candidate = folder / (name_or_file + ".yaml");
    std::error_code code;
    if (std::filesystem::exists(candidate, code)) {
      return candidate;
    }
  }
  const auto names = list_settings(folders);
  std::string problem = "unknown " + kind.singular + " '" + name_or_file + "'" + did_you_mean(name_or_file, names);
  if (names.empty()) {
    problem += " No " + kind.singular + " files were found in " + enumerate(to_strings(folders));
  } else {
    problem += " Known: " + enumerate(names);
  }
  throw ConfigError(kind.argument, problem + "; or name a file that ends in .yaml");
}

}  // namespace berm
