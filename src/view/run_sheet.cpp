#include "run_sheet.hpp"

#include <cstdint>
#include <optional>

#include <nlohmann/json.hpp>

#include "berm/core/error.hpp"
#include "berm/io/file_reader.hpp"
#include "berm/io/settings.hpp"

namespace berm {
namespace {

using ReportJson = nlohmann::json;

constexpr std::uint64_t kMaxBytes = std::uint64_t{64} << 20U;

struct MountSettings {
  MountConfig mount;

  static void sections(auto&& section) { section("mount", &MountSettings::mount); }
};

class SheetReader {
 public:
  SheetReader(const ReportJson& report, std::string file) : report_(report), file_(std::move(file)) {}

  RunSheet read() const {
    RunSheet sheet;
    sheet.recording = text("/recording/path");
    sheet.first = number("/recording/first");
    sheet.scans = number("/counts/scans/selected");
    sheet.machine = text("/machine/machine/name");
    sheet.sensor = text("/machine/sensor/model");
    sheet.piste_method = text("/machine/methods/piste");
    MountSettings settings;
    for (const auto& value : at("/machine/mount", &ReportJson::is_object).items()) {
      set_value(settings, "mount." + value.key() + "=" + value.value().dump(), file_);
    }
    sheet.mount = settings.mount;
    return sheet;
  }

 private:
  template <typename Check>
  [[nodiscard]] const ReportJson& at(const std::string& pointer, Check&& check) const {
    const ReportJson::json_pointer place(pointer);
    if (!report_.contains(place) || !(report_[place].*check)()) {
      throw FileError(ErrorCode::malformed, file_, std::nullopt,
                      "expected a JSON object with " + pointer + ", as berm run writes it");
    }
    return report_[place];
  }
  [[nodiscard]] std::string text(const std::string& pointer) const {
    return at(pointer, &ReportJson::is_string).get<std::string>();
  }
  [[nodiscard]] std::size_t number(const std::string& pointer) const {
    return at(pointer, &ReportJson::is_number_unsigned).get<std::size_t>();
  }

  const ReportJson& report_;
  std::string file_;
};

}  // namespace

RunSheet read_run_sheet(const std::filesystem::path& file) {
  FileBuffer buffer;
  read_file(file, buffer, kMaxBytes);
  const ReportJson report = ReportJson::parse(buffer.text(), nullptr, false);
  return SheetReader(report, file.string()).read();
}

}  // namespace berm
