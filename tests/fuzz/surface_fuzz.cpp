#include <string_view>

#include "berm/core/error.hpp"
#include "berm/io/surface_folder.hpp"
#include "fuzz_parser.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return berm::test::fuzz_parser(data, size, [](std::span<const std::byte> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (text.starts_with('{')) {
      for (const auto& [key, entry] : berm::parse_surface_index(text, "tiles.json").tiles) {
        berm::test::demand(!entry.file.empty() && entry.file.find('/') == std::string::npos);
      }
      return;
    }
    for (const berm::SurfacePoint& point : berm::parse_surface_tile(bytes, "tile.pcd")) {
      berm::test::demand(point.x_m == point.x_m && point.label != berm::Label::unlabeled);
    }
  });
}
