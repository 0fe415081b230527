#pragma once

#include <cstddef>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace berm {

/// An output file that appears whole or not at all. Bytes go to a temporary file in the same folder; `commit` brings
/// them to the disk (fsync) and gives them the name of the target (rename). Whoever reads the target, whenever the
/// writer is killed, finds the old file or the new one. Two writers of one target never mix: the last to commit wins.
///
/// Every call checks what the system says and throws FileError(write_failed) that names the target and the reason
/// (disk full, read-only folder, ...). A target that is a pipe or a device (`/dev/stdout`) is written in place; a
/// symbolic link stays, and the file that it names is replaced.
class AtomicFile {
 public:
  /// Creates the temporary file; the folder of `target` must exist.
  explicit AtomicFile(const std::filesystem::path& target);
  /// Without `commit` the temporary file is removed and the target stays as it was.
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Appends. Small pieces are gathered, so that a line at a time is fine.
  void write(std::span<const std::byte> bytes);
  void write(std::string_view text);

  /// Publishes the file; to be called once, after the last `write`.
  void commit();

  [[nodiscard]] const std::filesystem::path& target() const { return target_; }

  /// How the names of temporary files end; a kill can leave one behind, which is safe to delete.
  static constexpr std::string_view kTemporarySuffix = ".berm-tmp";

 private:
  void open_temporary();
  void flush();
  void write_through(std::span<const std::byte> bytes);
  void close_file();
  [[noreturn]] void fail(std::string_view what, int system_error) const;

  std::filesystem::path target_;
  std::filesystem::path temporary_;  ///< empty where the target is written in place, and after `commit`
  std::vector<std::byte> pending_;
  int descriptor_ = -1;
};

/// Writes a whole file by way of AtomicFile; throws as it does.
void write_file_atomically(const std::filesystem::path& target, std::span<const std::byte> bytes);
void write_file_atomically(const std::filesystem::path& target, std::string_view text);

}  // namespace berm
