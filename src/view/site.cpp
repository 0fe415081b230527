#include "berm/view/site.hpp"

#include <array>
#include <system_error>
#include <utility>

#include "berm/core/error.hpp"
#include "berm/io/file_reader.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kHtml = "text/html; charset=utf-8";
constexpr const char* kNoFrontEnd =
    "<!doctype html><html lang=\"en\"><meta charset=\"utf-8\"><title>berm view</title>"
    "<h1>berm view</h1><p>The server runs, but the pages of the viewer were not found: share/berm/web/viewer is "
    "missing "
    "beside the program. Install berm anew. The data are served all the same: <a href=\"/api/runs\">/api/runs</a>.</p>";

std::string_view content_type_of(const fs::path& file) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 10> kTypes = {
      {{".html", kHtml},
       {".js", "text/javascript; charset=utf-8"},
       {".mjs", "text/javascript; charset=utf-8"},
       {".css", "text/css; charset=utf-8"},
       {".json", "application/json"},
       {".svg", "image/svg+xml"},
       {".png", "image/png"},
       {".ico", "image/x-icon"},
       {".woff2", "font/woff2"},
       {".txt", "text/plain; charset=utf-8"}}};
  const std::string extension = file.extension().string();
  for (const auto& [ending, type] : kTypes) {
    if (extension == ending) {
      return type;
    }
  }
  return "application/octet-stream";
}

/// Whether `file` is below `root`; both without links.
bool is_below(const fs::path& file, const fs::path& root) {
  const fs::path relative = file.lexically_relative(root);
  return !relative.empty() && *relative.begin() != "..";
}

bool is_hidden(const fs::path& relative) {
  for (const fs::path& part : relative) {
    if (part.string().starts_with('.')) {
      return true;
    }
  }
  return false;
}

}  // namespace

Site::Site() {
  files_["index.html"] = {kHtml, std::make_shared<const std::string>(kNoFrontEnd)};
}

Site Site::load(const fs::path& folder) {
  Site site;
  std::error_code code;
  const fs::path root = fs::canonical(folder, code);
  std::size_t bytes = 0;
  FileBuffer buffer;
  for (fs::recursive_directory_iterator entry(root, code), end; !code && entry != end; entry.increment(code)) {
    std::error_code ignored;
    const fs::path file = fs::canonical(entry->path(), ignored);
    const fs::path relative = entry->path().lexically_relative(root);
    if (ignored || !fs::is_regular_file(file, ignored) || !is_below(file, root) || is_hidden(relative)) {
      continue;
    }
    read_file(file, buffer, kMaxBytes);
    bytes += buffer.bytes().size();
    if (bytes > kMaxBytes) {
      throw FileError(ErrorCode::unsupported, root.string(), std::nullopt, "holds more than a front end can");
    }
    site.files_[relative.generic_string()] = {content_type_of(file),
                                              std::make_shared<const std::string>(buffer.text())};
    site.has_front_end_ = site.has_front_end_ || relative == "index.html";
  }
  return site;
}

const Site::File* Site::find(std::string_view page) const {
  const auto file = files_.find(page);
  return file == files_.end() ? nullptr : &file->second;
}

}  // namespace berm
