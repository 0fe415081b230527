#include "geotiff.hpp"

#include <string_view>

#include "berm/core/error.hpp"

namespace berm {

bool is_tiff(std::string_view head) {
  using namespace std::string_view_literals;
  // Either byte order, plain and big.
  return head.starts_with("II*\0"sv) || head.starts_with("MM\0*"sv) || head.starts_with("II+\0"sv) ||
         head.starts_with("MM\0+"sv);
}

#ifndef BERM_WITH_GDAL
HeightRaster read_geotiff(const std::filesystem::path& path) {
  throw FileError(ErrorCode::unsupported, path.string(), std::nullopt,
                  "is a GeoTIFF, and this program was built without GDAL; install libgdal-dev and build again, or "
                  "convert the model: gdal_translate -of AAIGrid model.tif model.asc");
}
#endif

}  // namespace berm
