#include "berm/io/label_file.hpp"
#include "fuzz_parser.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return berm::test::fuzz_parser(data, size, [size](std::span<const std::byte> bytes) {
    berm::test::demand(berm::parse_labels(bytes, "fuzz.label", std::nullopt).size() * 4 == size);
    (void)berm::parse_labels(bytes, "fuzz.label", 3);
  });
}
