#include <utility>

#include "berm/io/kitti_bin.hpp"
#include "fuzz_parser.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return berm::test::fuzz_parser(data, size, [size](std::span<const std::byte> bytes) {
    berm::ScanRecord record = berm::parse_kitti_bin(bytes, "fuzz.bin", berm::IntensityScale::byte);
    (void)berm::recognise_intensity_scale(record.channels.intensity);
    record = berm::parse_kitti_bin(bytes, "fuzz.bin", berm::IntensityScale::unit, std::move(record.channels));
    const berm::PointCloud cloud(std::move(record.channels));
    berm::test::demand(cloud.size() * 16 == size);
  });
}
