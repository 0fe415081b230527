#include <cmath>
#include <sstream>
#include <string>

#include "berm/io/csv_table.hpp"
#include "fuzz_parser.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return berm::test::fuzz_parser(data, size, [](std::span<const std::byte> bytes) {
    std::istringstream input(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    berm::CsvTable table(input, "table.csv");
    berm::test::demand(!table.columns().empty());
    while (table.next()) {
      for (std::size_t i = 0; i < table.columns().size(); ++i) {
        berm::test::demand(table.column(table.columns()[i]) == i);
        berm::test::demand(!std::isinf(table.number(i)) || table.text(i).empty());
      }
    }
  });
}
