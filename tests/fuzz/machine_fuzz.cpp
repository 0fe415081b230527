#include <string>
#include <string_view>

#include "berm/core/error.hpp"
#include "berm/pipeline/machine.hpp"
#include "fuzz_parser.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return berm::test::fuzz_parser(data, size, [](std::span<const std::byte> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    std::string yaml;
    try {
      yaml = berm::to_yaml(berm::parse_machine(text, "machine.yaml"));
    } catch (const berm::ConfigError&) {
      return;
    }
    // What was accepted reads back the same.
    berm::test::demand(berm::to_yaml(berm::parse_machine(yaml, "machine.yaml")) == yaml);
  });
}
