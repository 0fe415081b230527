#include "berm/io/height_raster.hpp"

#include <array>
#include <cmath>
#include <fstream>
#include <span>
#include <system_error>

#include "ascii_grid.hpp"
#include "berm/core/error.hpp"
#include "berm/io/atomic_file.hpp"
#include "berm/io/file_reader.hpp"
#include "geotiff.hpp"
#include "text_numbers.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;

/// The header of a grid, or the mark of a TIFF, lies within this.
constexpr std::size_t kHeadBytes = 4096;
constexpr std::uint64_t kMaxProjectionBytes = 65'536;
constexpr const char* kNodata = "-9999";
constexpr int kHeightDecimals = 3;

/// The first bytes of `path`; nothing if it is no regular file, which `read_file` has the words for.
std::string read_head(const fs::path& path) {
  std::error_code code;
  if (!fs::is_regular_file(path, code)) {
    return {};
  }
  std::array<char, kHeadBytes> head{};
  std::ifstream stream(path, std::ios::binary);
  stream.read(head.data(), head.size());
  return {head.data(), static_cast<std::size_t>(stream.gcount())};
}

fs::path projection_file(const fs::path& grid) {
  return fs::path(grid).replace_extension(".prj");
}

std::string read_projection(const fs::path& grid) {
  const fs::path file = projection_file(grid);
  std::error_code code;
  if (!fs::exists(file, code)) {
    return {};
  }
  FileBuffer buffer;
  read_file(file, buffer, kMaxProjectionBytes);
  return std::string(buffer.text());
}

void write_header(AtomicFile& file, const HeightRaster& raster) {
  std::string text = "ncols " + std::to_string(raster.columns) + "\nnrows " + std::to_string(raster.rows);
  for (const auto& [key, value] : {std::pair("\nxllcorner ", raster.origin_x_m),
                                   {"\nyllcorner ", raster.origin_y_m},
                                   {"\ncellsize ", raster.cell_m}}) {
    text += key;
    append_shortest(text, value);
  }
  file.write(text + "\nNODATA_value " + kNodata + "\n");
}

void write_rows(AtomicFile& file, const HeightRaster& raster) {
  std::string line;
  for (std::size_t row = raster.rows; row-- > 0;) {
    line.clear();
    for (std::size_t column = 0; column < raster.columns; ++column) {
      line += column == 0 ? "" : " ";
      const float height_m = raster.at(column, row);
      if (std::isnan(height_m)) {
        line += kNodata;
      } else {
        append_fixed(line, static_cast<double>(height_m), kHeightDecimals);
      }
    }
    file.write(line + "\n");
  }
}

}  // namespace

HeightRaster read_height_raster(const fs::path& path) {
  const std::string head = read_head(path);
  if (is_tiff(head)) {
    return read_geotiff(path);
  }
  if (!head.empty()) {
    check_ascii_grid_header(head, path.string());
  }
  FileBuffer buffer;
  read_file(path, buffer);
  HeightRaster raster = parse_ascii_grid(buffer.text(), path.string());
  raster.crs = read_projection(path);
  return raster;
}

void write_ascii_grid(const fs::path& path, const HeightRaster& raster) {
  const bool whole = raster.columns > 0 && raster.rows > 0 && raster.heights_m.size() / raster.columns == raster.rows &&
                     raster.heights_m.size() % raster.columns == 0;
  if (!whole) {
    throw Error(ErrorCode::invalid_argument, "height raster: " + std::to_string(raster.heights_m.size()) +
                                                 " heights for " + std::to_string(raster.columns) + " x " +
                                                 std::to_string(raster.rows) + " cells");
  }
  AtomicFile file(path);
  write_header(file, raster);
  write_rows(file, raster);
  file.commit();
  if (!raster.crs.empty()) {
    write_file_atomically(projection_file(path), raster.crs);
  }
}

}  // namespace berm
