#include "run_mount.hpp"

#include <cstdint>
#include <optional>
#include <string>
#include <system_error>

#include <nlohmann/json.hpp>

#include "berm/core/error.hpp"
#include "berm/io/file_reader.hpp"

namespace berm::app {

MountConfig read_run_mount(const std::filesystem::path& run_folder) {
  constexpr std::uint64_t kMaxBytes = std::uint64_t{256} << 20U;
  const std::filesystem::path file = run_folder / "run.json";
  std::error_code code;
  if (!std::filesystem::exists(file, code)) {
    return {};
  }
  FileBuffer buffer;
  read_file(file, buffer, kMaxBytes);
  const auto report = nlohmann::json::parse(buffer.text(), nullptr, false);
  const nlohmann::json::json_pointer mount("/machine/mount");
  if (!report.is_object() || !report.contains(mount) || !report[mount].is_object()) {
    throw FileError(ErrorCode::malformed, file.string(), std::nullopt,
                    "expected a JSON object with machine.mount, as berm run writes it");
  }
  Machine machine;
  for (const auto& value : report[mount].items()) {
    set_value(machine, "mount." + value.key() + "=" + value.value().dump(), file.string());
  }
  return machine.mount;
}

}  // namespace berm::app
