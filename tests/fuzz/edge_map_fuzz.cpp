#include <string>
#include <string_view>

#include "berm/map/edge_map.hpp"
#include "fuzz_parser.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return berm::test::fuzz_parser(data, size, [](std::span<const std::byte> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const berm::EdgeMap map = berm::EdgeMap::from_octomap(text, "edges.ot", {});
    berm::test::demand(8 * map.size() <= bytes.size());
    // What was accepted is written and read back the same.
    const std::string again = map.to_octomap();
    berm::test::demand(berm::EdgeMap::from_octomap(again, "edges.ot", {}).to_octomap() == again);
  });
}
