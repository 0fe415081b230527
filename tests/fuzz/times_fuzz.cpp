#include <limits>
#include <sstream>
#include <string>

#include "berm/io/times_file.hpp"
#include "fuzz_parser.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return berm::test::fuzz_parser(data, size, [](std::span<const std::byte> bytes) {
    std::istringstream input(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    const berm::TimesFile times = berm::read_times(input, "times.txt", std::numeric_limits<std::size_t>::max());
    berm::test::demand(times.stamps.size() == times.lines && times.lines <= bytes.size());
    for (std::size_t i = 1; i < times.stamps.size(); ++i) {
      berm::test::demand(times.stamps[i - 1] < times.stamps[i]);
    }
  });
}
