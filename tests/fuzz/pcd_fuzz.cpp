#include <utility>

#include "berm/io/pcd.hpp"
#include "fuzz_parser.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return berm::test::fuzz_parser(data, size, [size](std::span<const std::byte> bytes) {
    berm::ScanRecord record = berm::parse_pcd(bytes, "fuzz.pcd");
    const berm::PointCloud cloud(std::move(record.channels));  // throws where channels differ in length
    berm::test::demand(cloud.size() <= 88 * size);             // LZF expands no further, and a point has a byte
    for (const float time : cloud.view().time) {
      berm::test::demand(!(time < -1.0F) && !(time > 1.0F));
    }
  });
}
