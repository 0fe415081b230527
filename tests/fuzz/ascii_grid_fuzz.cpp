#include <cmath>
#include <string_view>

#include "berm/io/height_raster.hpp"
#include "fuzz_parser.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return berm::test::fuzz_parser(data, size, [](std::span<const std::byte> bytes) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    const berm::HeightRaster raster = berm::parse_ascii_grid(text, "model.asc");
    berm::test::demand(raster.columns * raster.rows == raster.heights_m.size());
    berm::test::demand(2 * raster.heights_m.size() <= bytes.size());
    berm::test::demand(raster.cell_m > 0.0 && std::isfinite(raster.origin_x_m) && std::isfinite(raster.origin_y_m));
    for (const float height_m : raster.heights_m) {
      berm::test::demand(std::isnan(height_m) || std::abs(height_m) <= 1e5F);
    }
  });
}
