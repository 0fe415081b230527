#include "output_folder.hpp"

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
#include "run_report.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(ErrorCode code, const fs::path& path, const std::string& problem) {
  throw FileError(code, path.string(), std::nullopt, problem);
}

[[noreturn]] void fail_with(const fs::path& path, const std::string& what, const std::error_code& reason) {
  fail(ErrorCode::write_failed, path, what + ": " + reason.message() + "; choose another folder with -o");
}

/// Whether `file` is the run.json of a run of berm: it starts with its schema.
bool is_run_file(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::array<char, 256> head{};
  stream.read(head.data(), head.size());
  const std::string_view text(head.data(), static_cast<std::size_t>(stream.gcount()));
  return text.find(std::string("\"schema\": \"") + kRunSchemaName) != std::string_view::npos;
}

bool is_temporary(const fs::path& file) {
  return file.filename().string().ends_with(AtomicFile::kTemporarySuffix);
}

bool is_label_file(const fs::path& file) {
  return file.extension() == ".label" || is_temporary(file);
}

void remove_file(const fs::path& file) {
  std::error_code code;
  fs::remove(file, code);
  if (code) {
    fail_with(file, "the result of an earlier run cannot be removed", code);
  }
}

void remove_files_if(const fs::path& folder, bool (*is_of_a_run)(const fs::path&)) {
  std::error_code code;
  for (fs::directory_iterator entry(folder, code), end; !code && entry != end; entry.increment(code)) {
    if (is_of_a_run(entry->path())) {
      remove_file(entry->path());
    }
  }
}

bool same_folder(const fs::path& a, const fs::path& b) {
  std::error_code code;
  return fs::equivalent(a, b, code);
}

}  // namespace

OutputFolder::OutputFolder(fs::path folder, bool force, const fs::path& recording) : folder_(std::move(folder)) {
  std::error_code code;
  const auto status = fs::status(folder_, code);
  if (fs::exists(status) && !fs::is_directory(status)) {
    fail(ErrorCode::exists, folder_, "is a file; choose another folder with -o");
  }
  if (same_folder(folder_, recording)) {
    fail(ErrorCode::exists, folder_, "is the recording itself; choose another folder with -o");
  }
  if (fs::exists(status) && !force && !fs::is_empty(folder_, code)) {
    const bool unfinished = fs::exists(folder_ / kMarker, code);
    fail(ErrorCode::exists, folder_,
         std::string(unfinished ? "holds a run that did not finish" : "is not empty") +
             "; choose another folder with -o, or replace the results in it with --force");
  }
  create();
  try {
    claim();
    remove_old_results();
    fs::create_directory(labels_folder(), code);
    if (code) {
      fail_with(labels_folder(), "cannot be created", code);
    }
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
    fail(ErrorCode::exists, folder_, "another run is writing there now; wait for it or choose another folder with -o");
  }
}

void OutputFolder::remove_old_results() const {
  std::error_code code;
  const bool ours = marker_was_there_ || is_run_file(run_file());
  for (const fs::path& result : {run_file(), trajectory_file(), labels_folder()}) {
    const auto status = fs::symlink_status(result, code);
    if ((!ours && fs::exists(status)) || fs::is_symlink(status)) {
      fail(ErrorCode::exists, result,
           "was not written by a run of berm and is not replaced; choose another folder with -o");
    }
  }
  // run.json first: from here on the folder is no whole run.
  remove_file(run_file());
  remove_file(trajectory_file());
  remove_files_if(labels_folder(), is_label_file);
  remove_files_if(folder_, is_temporary);
}

void OutputFolder::finish() {
  std::error_code code;
  fs::remove(folder_ / kMarker, code);
}

OutputFolder::~OutputFolder() {
  std::error_code code;
  // Only an empty folder is removed this way.
  if (fs::remove(labels_folder(), code)) {
    fs::remove(folder_ / kMarker, code);
    if (created_) {
      fs::remove(folder_, code);
    }
  }
  ::close(lock_);
}

}  // namespace berm
