#include <string>
#include <string_view>
#include <system_error>
#include <vector>

#include "berm/core/error.hpp"
#include "berm/io/atomic_file.hpp"
#include "berm/io/file_reader.hpp"
#include "berm/io/settings_folders.hpp"
#include "berm/report/report.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;

constexpr std::string_view kBegin = "<script type=\"application/json\" id=\"run\">";
constexpr std::string_view kEnd = "</script>";

/// The same JSON without what could end a script or be read as markup. These characters stand in strings only, where
/// JSON takes them as \uXXXX as well. U+2028 and U+2029 end lines of older JavaScript.
std::string without_markup(std::string_view json) {
  std::string text;
  text.reserve(json.size());
  for (std::size_t i = 0; i < json.size(); ++i) {
    const std::string_view rest = json.substr(i);
    if (rest.front() == '<') {
      text += "\\u003c";
    } else if (rest.front() == '>') {
      text += "\\u003e";
    } else if (rest.front() == '&') {
      text += "\\u0026";
    } else if (rest.starts_with("\xE2\x80\xA8") || rest.starts_with("\xE2\x80\xA9")) {
      text += rest[2] == '\xA8' ? "\\u2028" : "\\u2029";
      i += 2;
    } else {
      text += rest.front();
    }
  }
  return text;
}

}  // namespace

std::string fill_report(std::string_view page, std::string_view json) {
  const std::size_t begin = page.find(kBegin);
  const std::size_t end = begin == std::string_view::npos ? begin : page.find(kEnd, begin);
  if (end == std::string_view::npos) {
    throw Error(ErrorCode::malformed, "the page of the report has no place for the data: " + std::string(kBegin));
  }
  std::string filled(page.substr(0, begin + kBegin.size()));
  filled += without_markup(json);
  filled += page.substr(end);
  return filled;
}

std::filesystem::path find_report_page() {
  const std::vector<fs::path> folders = share_folders("web");
  for (const fs::path& folder : folders) {
    std::error_code code;
    if (fs::is_regular_file(folder / "report.html", code)) {
      return folder / "report.html";
    }
  }
  throw FileError(ErrorCode::not_found, "share/berm/web/report.html", std::nullopt,
                  "is not beside the program and not one level above it; install berm whole");
}

std::filesystem::path write_report(const std::filesystem::path& run_folder, std::string_view evaluation) {
  const std::string data = report_data(run_folder, evaluation);
  FileBuffer page;
  read_file(find_report_page(), page);
  const fs::path target = run_folder / "report.html";
  write_file_atomically(target, fill_report(page.text(), data));
  return target;
}

}  // namespace berm
