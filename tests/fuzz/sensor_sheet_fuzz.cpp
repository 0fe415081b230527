#include <cmath>
#include <string_view>

#include "berm/io/sensor_sheet.hpp"
#include "fuzz_parser.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return berm::test::fuzz_parser(data, size, [](std::span<const std::byte> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const berm::SensorSheet sheet = berm::parse_sensor_sheet(text, "sequence.json");
    berm::test::demand(!sheet.scan_hz || *sheet.scan_hz > 0.0);
    berm::test::demand(!sheet.pitch_rad || std::abs(*sheet.pitch_rad) < 1.6);
  });
}
