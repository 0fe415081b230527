#include "berm/io/atomic_file.hpp"

#include <algorithm>
#include <cerrno>
#include <optional>
#include <random>
#include <string>
#include <system_error>
#include <utility>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "berm/core/error.hpp"

namespace berm {
namespace {

/// One system call for this much: more gains nothing, less costs time.
constexpr std::size_t kGatheredBytes = std::size_t{1} << 16U;
/// With 64 random bits a second try is already a sign of something else.
constexpr int kNameTries = 16;
/// Longest file name of the usual file systems, in bytes.
constexpr std::size_t kLongestName = 255;

std::string random_digits() {
  std::random_device device;
  return fmt::format("{:08x}{:08x}", device(), device());
}

std::filesystem::path folder_of(const std::filesystem::path& file) {
  return file.has_parent_path() ? file.parent_path() : std::filesystem::path(".");
}

const char* advice(int system_error) {
  switch (system_error) {
    case ENOSPC:
    case EDQUOT:
      return "; free some space or choose another folder";
    case EACCES:
    case EPERM:
    case EROFS:
      return "; choose a folder that can be written to";
    case ENOENT:
    case ENOTDIR:
      return "; create the folder first";
    case ENXIO:
      return "; nobody reads from this pipe";
    default:
      return "";
  }
}

/// Makes the new name itself outlast a loss of power. Some file systems cannot do it (EINVAL), some folders may not
/// be opened for reading: the file is complete then, only its name is less safe.
int sync_folder(const std::filesystem::path& folder) {
  const int descriptor = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (descriptor < 0) {
    return errno == EACCES ? 0 : errno;
  }
  const int system_error = ::fsync(descriptor) == 0 ? 0 : errno;
  ::close(descriptor);
  return system_error == EINVAL ? 0 : system_error;
}

}  // namespace

AtomicFile::AtomicFile(const std::filesystem::path& target) : target_(target) {
  std::error_code ignored;
  if (std::filesystem::is_symlink(target_, ignored) && std::filesystem::exists(target_, ignored)) {
    target_ = std::filesystem::canonical(target_, ignored);
  }
  const std::filesystem::file_status status = std::filesystem::status(target_, ignored);
  if (target_.filename().empty() || std::filesystem::is_directory(status)) {
    fail("is a folder, expected the name of a file", 0);
  }
  if (std::filesystem::exists(status) && !std::filesystem::is_regular_file(status)) {
    // O_NONBLOCK: opening a pipe that nobody reads from would wait for ever; writing to it may wait again.
    descriptor_ = ::open(target_.c_str(), O_WRONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (descriptor_ < 0) {
      fail("cannot be opened for writing", errno);
    }
    ::fcntl(descriptor_, F_SETFL, 0);
    return;
  }
  open_temporary();
}

AtomicFile::~AtomicFile() {
  close_file();
  if (!temporary_.empty()) {
    ::unlink(temporary_.c_str());
  }
}

void AtomicFile::open_temporary() {
  for (int attempt = 0; attempt < kNameTries; ++attempt) {
    const std::string ending = "." + random_digits() + std::string(kTemporarySuffix);
    std::string name = "." + target_.filename().string();
    name.resize(std::min(name.size(), kLongestName - ending.size()));
    std::filesystem::path candidate = folder_of(target_) / (name + ending);
    // O_EXCL: two writers cannot come to share a file even if their random numbers agree.
    descriptor_ = ::open(candidate.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (descriptor_ >= 0) {
      temporary_ = std::move(candidate);
      return;
    }
    if (errno != EEXIST) {
      break;
    }
  }
  fail("cannot create a temporary file beside it", errno);
}

void AtomicFile::write(std::string_view text) {
  write(std::as_bytes(std::span(text)));
}

void AtomicFile::write(std::span<const std::byte> bytes) {
  if (pending_.size() + bytes.size() > kGatheredBytes) {
    flush();
  }
  if (bytes.size() >= kGatheredBytes) {
    write_through(bytes);
  } else {
    pending_.insert(pending_.end(), bytes.begin(), bytes.end());
  }
}

void AtomicFile::flush() {
  write_through(pending_);
  pending_.clear();
}

void AtomicFile::write_through(std::span<const std::byte> bytes) {
  if (descriptor_ < 0) {
    throw Error(ErrorCode::invalid_argument, target_.string() + ": written to after commit");
  }
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
    if (written < 0 && errno == EINTR) {
      continue;
    }
    if (written <= 0) {
      fail("cannot be written", written < 0 ? errno : ENOSPC);
    }
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

void AtomicFile::commit() {
  flush();
  if (temporary_.empty()) {
    close_file();
    return;
  }
  if (::fsync(descriptor_) != 0) {
    fail("cannot be brought to the disk", errno);
  }
  // Network file systems report a full disk here at the latest.
  if (::close(std::exchange(descriptor_, -1)) != 0) {
    fail("cannot be closed", errno);
  }
  if (::rename(temporary_.c_str(), target_.c_str()) != 0) {
    fail("cannot be renamed from its temporary name", errno);
  }
  temporary_.clear();
  if (const int system_error = sync_folder(folder_of(target_)); system_error != 0) {
    fail("is written, but its folder cannot be brought to the disk", system_error);
  }
}

void AtomicFile::close_file() {
  if (descriptor_ >= 0) {
    ::close(std::exchange(descriptor_, -1));
  }
}

void AtomicFile::fail(std::string_view what, int system_error) const {
  const std::string reason =
      system_error == 0 ? std::string()
                        : fmt::format(": {}{}", std::generic_category().message(system_error), advice(system_error));
  throw FileError(ErrorCode::write_failed, target_.string(), std::nullopt, std::string(what) + reason);
}

void write_file_atomically(const std::filesystem::path& target, std::span<const std::byte> bytes) {
  AtomicFile file(target);
  file.write(bytes);
  file.commit();
}

void write_file_atomically(const std::filesystem::path& target, std::string_view text) {
  write_file_atomically(target, std::as_bytes(std::span(text)));
}

}  // namespace berm
