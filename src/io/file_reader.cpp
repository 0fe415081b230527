#include "berm/io/file_reader.hpp"

#include <cerrno>
#include <limits>
#include <new>
#include <optional>
#include <string>
#include <system_error>

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include "berm/core/error.hpp"

namespace berm {
namespace {

[[noreturn]] void fail(ErrorCode code, const std::filesystem::path& path, const std::string& problem) {
  throw FileError(code, path.string(), std::nullopt, problem);
}

std::string describe(int system_error) {
  return std::generic_category().message(system_error);
}

/// Opens on construction, closes on destruction.
class Descriptor {
 public:
  explicit Descriptor(const std::filesystem::path& path)
      // O_NONBLOCK: opening a pipe that nobody writes to would wait for ever.
      : value_(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY)) {
    if (value_ >= 0) {
      return;
    }
    const int system_error = errno;
    if (system_error == ENOENT || system_error == ENOTDIR) {
      fail(ErrorCode::not_found, path, "there is no such file; check the path");
    }
    fail(ErrorCode::unreadable, path, "cannot be opened: " + describe(system_error));
  }
  ~Descriptor() { ::close(value_); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  [[nodiscard]] int get() const { return value_; }

 private:
  int value_;
};

std::uint64_t regular_size(const Descriptor& descriptor, const std::filesystem::path& path) {
  struct stat status {};
  if (::fstat(descriptor.get(), &status) != 0) {
    fail(ErrorCode::unreadable, path, "cannot be examined: " + describe(errno));
  }
  if (S_ISDIR(status.st_mode)) {
    fail(ErrorCode::unreadable, path, "is a folder, expected a file");
  }
  if (!S_ISREG(status.st_mode)) {
    fail(ErrorCode::unreadable, path, "is a pipe or a device, expected a regular file; copy its content to a file");
  }
  return static_cast<std::uint64_t>(status.st_size);
}

void fill(const Descriptor& descriptor, std::span<std::byte> target, const std::filesystem::path& path) {
  std::size_t done = 0;
  while (done < target.size()) {
    const ssize_t got = ::read(descriptor.get(), target.data() + done, target.size() - done);
    if (got < 0 && errno == EINTR) {
      continue;
    }
    if (got < 0) {
      throw FileError(ErrorCode::unreadable, path.string(), done, "cannot be read: " + describe(errno));
    }
    if (got == 0) {
      throw FileError(
          ErrorCode::truncated, path.string(), done,
          fmt::format("ends here although the system announced {} bytes; is it still being written?", target.size()));
    }
    done += static_cast<std::size_t>(got);
  }
}

}  // namespace

std::string_view FileBuffer::text() const {
  return {reinterpret_cast<const char*>(memory_.get()), size_};
}

std::span<std::byte> FileBuffer::prepare(std::size_t size) {
  if (size > capacity_) {
    size_ = 0;
    capacity_ = 0;
    memory_.reset();  // first, so that old and new memory never exist together
    memory_ = std::make_unique_for_overwrite<std::byte[]>(size);
    capacity_ = size;
  }
  size_ = size;
  return {memory_.get(), size};
}

std::span<const std::byte> read_file(const std::filesystem::path& path, FileBuffer& buffer, std::uint64_t max_bytes) {
  const Descriptor descriptor(path);
  const std::uint64_t size = regular_size(descriptor, path);
  if (size > max_bytes || size > std::numeric_limits<std::ptrdiff_t>::max()) {
    fail(ErrorCode::unsupported, path,
         fmt::format("has {} bytes, more than the {} that are read at once; split it", size, max_bytes));
  }
  try {
    fill(descriptor, buffer.prepare(static_cast<std::size_t>(size)), path);
  } catch (const std::bad_alloc&) {
    fail(ErrorCode::unreadable, path, fmt::format("has {} bytes, more than there is memory for", size));
  }
  return buffer.bytes();
}

}  // namespace berm
