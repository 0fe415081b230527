#include "pcd_ascii.hpp"

#include <algorithm>
#include <charconv>
#include <cstring>
#include <optional>
#include <string_view>
#include <type_traits>

#include <fmt/format.h>

#include "berm/core/error.hpp"
#include "line_reader.hpp"
#include "little_endian.hpp"
#include "to_float.hpp"

namespace berm {
namespace {

constexpr std::size_t kTextBlockPoints = 512;

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

/// Takes the next word off the line [*begin, end); empty at its end.
std::string_view next_word(const char*& begin, const char* end) {
  while (begin != end && is_blank(*begin)) {
    ++begin;
  }
  const char* const first = begin;
  while (begin != end && !is_blank(*begin)) {
    ++begin;
  }
  return {first, static_cast<std::size_t>(begin - first)};
}

template <typename Value>
bool parse(std::string_view word, std::byte* target) {
  const char* first = word.data();
  const char* const last = first + word.size();
  if (word.size() > 1 && *first == '+' && first[1] != '-') {
    ++first;
  }
  Value value{};
  std::from_chars_result result = std::from_chars(first, last, value);
  if constexpr (std::is_same_v<Value, float>) {
    if (result.ec == std::errc::result_out_of_range) {
      double wide = 0.0;
      result = std::from_chars(first, last, wide);
      value = to_float(wide);
    }
  }
  store(target, value);
  return result.ec == std::errc() && result.ptr == last;
}

using Parser = bool (*)(std::string_view, std::byte*);

Parser parser_of(const PcdField& field) {
  if (field.type == 'F') {
    return field.size == 4 ? parse<float> : parse<double>;
  }
  const bool is_signed = field.type == 'I';
  switch (field.size) {
    case 1:
      return is_signed ? parse<std::int8_t> : parse<std::uint8_t>;
    case 2:
      return is_signed ? parse<std::int16_t> : parse<std::uint16_t>;
    case 4:
      return is_signed ? parse<std::int32_t> : parse<std::uint32_t>;
    default:
      return is_signed ? parse<std::int64_t> : parse<std::uint64_t>;
  }
}

/// What to do with the words of a line, field by field.
struct Step {
  Parser parser = nullptr;  ///< none: the words are skipped
  std::size_t offset = 0;   ///< in the packed record
  std::size_t words = 1;
};

class AsciiReader {
 public:
  AsciiReader(std::span<const std::byte> body, const PcdHeader& header, const PcdPlan& plan, const std::string& name)
      : position_(reinterpret_cast<const char*>(body.data())),
        end_(position_ + body.size()),
        line_(header.lines),
        header_(header),
        plan_(plan),
        name_(name),
        steps_(header.fields.size()) {
    for (std::size_t i = 0; i < header.fields.size(); ++i) {
      steps_[i].words = header.fields[i].count;
    }
    for (const auto& [channel, field] : plan.channels) {
      steps_[field].parser = parser_of(header.fields[field]);
      steps_[field].offset = record_bytes_;
      record_bytes_ += header.fields[field].size;
    }
    block_.resize(record_bytes_ * kTextBlockPoints);
  }

  void read(PcdDecoder& decoder) {
    std::vector<PcdColumn> columns;
    columns.reserve(plan_.channels.size());
    for (const auto& [channel, field] : plan_.channels) {
      columns.push_back({block_.data() + steps_[field].offset, record_bytes_});
    }
    for (std::size_t begin = 0; begin < header_.points; begin += kTextBlockPoints) {
      const std::size_t count = std::min(kTextBlockPoints, header_.points - begin);
      for (std::size_t i = 0; i < count; ++i) {
        if (!next_line()) {
          throw FileError(ErrorCode::truncated, name_, std::nullopt,
                          fmt::format("line {}: the file ends after {} of {} points; it is cut or POINTS is wrong",
                                      line_, begin + i, header_.points));
        }
        parse_line(block_.data() + i * record_bytes_);
      }
      decoder.decode(columns, begin, count);
    }
  }

  void note_rest(std::vector<std::string>& notes) {
    if (header_.points > 0 && !line_ended_) {
      notes.emplace_back("the last line has no line end: its last value may be cut");
    }
    if (next_line()) {
      notes.push_back(
          fmt::format("lines after the {} points of the header were ignored, from line {}", header_.points, line_));
    }
  }

 private:
  [[noreturn]] void fail(const std::string& problem) const {
    throw FileError(ErrorCode::malformed, name_, std::nullopt, fmt::format("line {}: {}", line_, problem));
  }

  /// The next line that holds more than blanks and comment, in [word_, line_end_).
  bool next_line() {
    while (position_ != end_) {
      const auto left = static_cast<std::size_t>(end_ - position_);
      const auto* newline = static_cast<const char*>(std::memchr(position_, '\n', left));
      word_ = position_;
      line_end_ = newline != nullptr ? newline : end_;
      line_ended_ = newline != nullptr;
      position_ = newline != nullptr ? newline + 1 : end_;
      ++line_;
      while (word_ != line_end_ && is_blank(*word_)) {
        ++word_;
      }
      if (word_ != line_end_ && *word_ != '#') {
        return true;
      }
    }
    return false;
  }

  void parse_line(std::byte* record) {
    for (std::size_t i = 0; i < steps_.size(); ++i) {
      const Step& step = steps_[i];
      for (std::size_t j = 0; j < step.words; ++j) {
        const std::string_view word = next_word(word_, line_end_);
        if (word.empty()) {
          fail(fmt::format("ends before field {}, expected {} values", berm::quoted(header_.fields[i].name),
                           words_per_line()));
        }
        if (step.parser != nullptr && !step.parser(word, record + step.offset)) {
          fail(fmt::format("{} is no value of type {} for field {}", berm::quoted(word), header_.fields[i].type_name(),
                           berm::quoted(header_.fields[i].name)));
        }
      }
    }
    if (const std::string_view extra = next_word(word_, line_end_); !extra.empty()) {
      fail(fmt::format("{} follows the last of {} values", berm::quoted(extra), words_per_line()));
    }
  }

  [[nodiscard]] std::size_t words_per_line() const {
    std::size_t words = 0;
    for (const Step& step : steps_) {
      words += step.words;
    }
    return words;
  }

  const char* position_;
  const char* end_;
  const char* word_ = nullptr;
  const char* line_end_ = nullptr;
  bool line_ended_ = true;
  std::size_t line_;
  const PcdHeader& header_;
  const PcdPlan& plan_;
  const std::string& name_;
  std::vector<Step> steps_;
  std::size_t record_bytes_ = 0;
  std::vector<std::byte> block_;
};

}  // namespace

void read_pcd_ascii(std::span<const std::byte> body, const PcdHeader& header, const PcdPlan& plan,
                    const std::string& name, PcdDecoder& decoder, std::vector<std::string>& notes) {
  AsciiReader reader(body, header, plan, name);
  reader.read(decoder);
  reader.note_rest(notes);
}

}  // namespace berm
