#pragma once

#include <cstddef>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace berm {

/// Names of the files of one kind in a folder.
struct FolderListing {
  std::vector<std::string> stems;       ///< names without the extension, in natural order
  std::size_t special = 0;              ///< left out: folders, pipes, devices that are named like a file of this kind
  std::set<std::string> other_endings;  ///< some of the other extensions, for an error message
};

/// Lists the files of `folder` (not below it) that end with `extension` (".pcd"). Hidden files are no part of it. Links
/// that lead nowhere stay in: reading them fails, which is better than not to miss them. Throws FileError(unreadable).
[[nodiscard]] FolderListing list_folder(const std::filesystem::path& folder, std::string_view extension);

}  // namespace berm
