#pragma once

#include <cstddef>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include "berm/view/payload_cache.hpp"

namespace berm {

/// The files of the front end, read once: what is asked for later never reaches the file system.
class Site {
 public:
  struct File {
    std::string_view content_type;
    Payload content;
  };

  /// No more than this is read.
  static constexpr std::size_t kMaxBytes = std::size_t{64} << 20U;

  /// A page that says that there is no front end.
  Site();
  /// Reads all regular files below `folder`, but for hidden ones and links that lead out of it. Without an index.html
  /// there it is the page of the default. Throws FileError: unreadable, or more than `kMaxBytes`.
  [[nodiscard]] static Site load(const std::filesystem::path& folder);

  /// Null if there is none. `page` as in ViewTarget.
  [[nodiscard]] const File* find(std::string_view page) const;
  [[nodiscard]] bool has_front_end() const { return has_front_end_; }

 private:
  bool has_front_end_ = false;
  std::map<std::string, File, std::less<>> files_;
};

}  // namespace berm
