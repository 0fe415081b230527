#include <sstream>
#include <string>

#include "berm/io/road_file.hpp"
#include "fuzz_parser.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return berm::test::fuzz_parser(data, size, [](std::span<const std::byte> bytes) {
    std::istringstream input(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    double last_m = -1e9;
    for (const berm::RoadStation& station : berm::read_road(input, "road.csv")) {
      berm::test::demand(station.position_m.allFinite() && station.chainage_m >= last_m);
      berm::test::demand(!station.width_m || station.width_m->sigma >= 0.0);
      last_m = station.chainage_m;
    }
  });
}
