#include "folder_listing.hpp"

#include <algorithm>
#include <system_error>

#include "berm/core/error.hpp"
#include "scan_names.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxOtherEndings = 4;

/// Whether `entry` is there and can be told to be no file: then opening it would fail or wait.
bool is_special(const fs::directory_entry& entry) {
  std::error_code error;
  const fs::file_type type = entry.status(error).type();
  return type == fs::file_type::directory || type == fs::file_type::fifo || type == fs::file_type::socket ||
         type == fs::file_type::character || type == fs::file_type::block;
}

void add(const fs::directory_entry& entry, std::string_view extension, FolderListing& listing) {
  const fs::path name = entry.path().filename();
  const std::string ending = name.extension().string();
  if (name.native().starts_with('.')) {
    return;
  }
  if (ending != extension) {
    if (!ending.empty() && listing.other_endings.size() < kMaxOtherEndings) {
      listing.other_endings.insert(ending);
    }
  } else if (is_special(entry)) {
    ++listing.special;
  } else {
    listing.stems.push_back(name.stem().string());
  }
}

}  // namespace

FolderListing list_folder(const fs::path& folder, std::string_view extension) {
  FolderListing listing;
  std::error_code error;
  for (fs::directory_iterator entry(folder, error); !error && entry != fs::directory_iterator();
       entry.increment(error)) {
    add(*entry, extension, listing);
  }
  if (error) {
    throw FileError(ErrorCode::unreadable, folder.string(), std::nullopt,
                    "the folder cannot be listed (" + error.message() + "); check its permissions");
  }
  std::sort(listing.stems.begin(), listing.stems.end(), natural_less);
  return listing;
}

}  // namespace berm
