#include "berm/io/output_folder.hpp"

#include <array>
#include <cerrno>
#include <fstream>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include "berm/core/error.hpp"
#include "berm/io/atomic_file.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail_at(ErrorCode code, const fs::path& path, const std::string& problem) {
  throw FileError(code, path.string(), std::nullopt, problem);
}

[[noreturn]] void fail_with(const fs::path& path, const std::string& what, const std::error_code& reason) {
  fail_at(ErrorCode::write_failed, path, what + ": " + reason.message() + "; choose another folder with -o");
}

bool is_temporary(const fs::path& file) {
  return file.filename().string().ends_with(AtomicFile::kTemporarySuffix);
}

void remove_file(const fs::path& file) {
  std::error_code code;
  fs::remove(file, code);
  if (code) {
    fail_with(file, "cannot be removed to make room for new results", code);
  }
}

/// Temporary files, and those that end with `extension` unless that is empty.
void remove_files(const fs::path& folder, const std::string& extension) {
  std::error_code code;
  for (fs::directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code)) {
    const fs::path& file = entry->path();
    if (is_temporary(file) || (!extension.empty() && file.extension() == extension)) {
      remove_file(file);
    }
  }
}

bool same_folder(const fs::path& a, const fs::path& b) {
  std::error_code code;
  return fs::equivalent(a, b, code);
}

}  // namespace

OutputFolder::OutputFolder(fs::path folder, bool force, OutputResults results, const fs::path& recording)
    : folder_(std::move(folder)), results_(std::move(results)) {
  std::error_code code;
  const auto status = fs::status(folder_, code);
  if (fs::exists(status) && !fs::is_directory(status)) {
    fail_at(ErrorCode::exists, folder_, "is a file; choose another folder with -o");
  }
  if (same_folder(folder_, recording)) {
    fail_at(ErrorCode::exists, folder_, "is the recording itself; choose another folder with -o");
  }
  if (fs::exists(status) && !force && !fs::is_empty(folder_, code)) {
    const bool unfinished = fs::exists(folder_ / kMarker, code);
    fail_at(ErrorCode::exists, folder_,
            (unfinished ? "holds a " + results_.work + " that did not finish" : "is not empty") +
                "; choose another folder with -o, or replace the results in it with --force");
  }
  create();
  try {
    claim();
    remove_old_results();
    create_folders();
  } catch (...) {
    if (lock_ >= 0) {
      ::close(lock_);
      if (!marker_was_there_) {
        fs::remove(folder_ / kMarker, code);
      }
    }
    if (created_) {
      fs::remove(folder_, code);
    }
    throw;
  }
}

void OutputFolder::create() {
  std::error_code code;
  created_ = fs::create_directories(folder_, code);
  if (code) {
    fail_with(folder_, "cannot be created", code);
  }
}

void OutputFolder::claim() {
  const fs::path marker = folder_ / kMarker;
  std::error_code code;
  marker_was_there_ = fs::exists(marker, code);
  lock_ = ::open(marker.c_str(), O_RDWR | O_CREAT | O_CLOEXEC | O_NOFOLLOW, 0644);
  if (lock_ < 0) {
    fail_with(folder_, "cannot be written", {errno, std::generic_category()});
  }
  struct stat held {};
  struct stat named {};
  const bool locked = ::flock(lock_, LOCK_EX | LOCK_NB) == 0;
  // A run that ended meanwhile has removed the marker that was opened here: then the lock means nothing.
  const bool current = ::fstat(lock_, &held) == 0 && ::stat(marker.c_str(), &named) == 0 &&
                       held.st_ino == named.st_ino && held.st_dev == named.st_dev;
  if (!locked || !current) {
    marker_was_there_ = true;
    fail_at(ErrorCode::exists, folder_,
            "another " + results_.work + " is writing there now; wait for it or choose another folder with -o");
  }
}

bool OutputFolder::is_of_berm() const {
  std::ifstream stream(folder_ / results_.last_file, std::ios::binary);
  std::array<char, 4096> head{};
  stream.read(head.data(), head.size());
  const std::string_view text(head.data(), static_cast<std::size_t>(stream.gcount()));
  return text.find(results_.mark) != std::string_view::npos;
}

void OutputFolder::remove_old_results() const {
  std::error_code code;
  const bool ours = marker_was_there_ || is_of_berm();
  std::vector<std::string> names = results_.files;
  names.insert(names.begin(), results_.last_file);
  for (const OutputResults::Folder& folder : results_.folders) {
    names.push_back(folder.name);
  }
  for (const std::string& name : names) {
    const fs::path result = folder_ / name;
    const auto status = fs::symlink_status(result, code);
    if ((!ours && fs::exists(status)) || fs::is_symlink(status)) {
      fail_at(ErrorCode::exists, result,
              "was not written by a " + results_.work + " of berm and is not replaced; choose another folder with -o");
    }
  }
  // The last file first: from here on the folder is not whole.
  remove_file(folder_ / results_.last_file);
  for (const std::string& file : results_.files) {
    remove_file(folder_ / file);
  }
  for (const OutputResults::Folder& folder : results_.folders) {
    remove_files(folder_ / folder.name, folder.extension);
  }
  remove_files(folder_, "");
}

void OutputFolder::create_folders() const {
  std::error_code code;
  for (const OutputResults::Folder& folder : results_.folders) {
    if (folder.on_demand) {
      fs::remove(folder_ / folder.name, code);  // where it is empty
      continue;
    }
    fs::create_directory(folder_ / folder.name, code);
    if (code) {
      fail_with(folder_ / folder.name, "cannot be created", code);
    }
  }
}

void OutputFolder::finish() {
  std::error_code code;
  fs::remove(folder_ / kMarker, code);
}

OutputFolder::~OutputFolder() {
  std::error_code code;
  // Only empty folders are removed this way.
  bool nothing_written = true;
  for (const OutputResults::Folder& folder : results_.folders) {
    const bool is_gone = fs::remove(folder_ / folder.name, code) || !fs::exists(folder_ / folder.name, code);
    nothing_written = is_gone && nothing_written;
  }
  if (nothing_written) {
    fs::remove(folder_ / kMarker, code);
    if (created_) {
      fs::remove(folder_, code);
    }
  }
  ::close(lock_);
}

}  // namespace berm
