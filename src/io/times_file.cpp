#include "berm/io/times_file.hpp"

#include <optional>

#include "berm/io/atomic_file.hpp"
#include "line_reader.hpp"
#include "text_numbers.hpp"

namespace berm {
namespace {

TimesFile read_times(LineReader& lines, std::size_t max_kept) {
  TimesFile times;
  std::optional<Stamp> last;
  std::string_view line;
  while (lines.next(line)) {
    const std::string_view word = take_word(line);
    const std::optional<Stamp> stamp = parse_seconds(word);
    if (!stamp || !take_word(line).empty()) {
      throw lines.error("expected one number, the start of a scan in seconds, found " + quoted(word) +
                        (stamp ? " and more" : ""));
    }
    if (last && *stamp <= *last) {
      throw lines.error("the stamp " + quoted(word) +
                        " is not later than the one before; scans have to be in the order of their time");
    }
    last = stamp;
    ++times.lines;
    if (times.stamps.size() < max_kept) {
      times.stamps.push_back(*stamp);
    }
  }
  return times;
}

}  // namespace

TimesFile read_times(const std::filesystem::path& path, std::size_t max_kept) {
  LineReader lines(path);
  return read_times(lines, max_kept);
}

TimesFile read_times(std::istream& input, const std::string& name, std::size_t max_kept) {
  LineReader lines(input, name);
  return read_times(lines, max_kept);
}

void write_times(const std::filesystem::path& path, std::span<const Stamp> stamps) {
  AtomicFile file(path);
  std::string line;
  for (const Stamp stamp : stamps) {
    line.clear();
    append_seconds(line, stamp);
    line += '\n';
    file.write(line);
  }
  file.commit();
}

}  // namespace berm
