#include <cmath>
#include <sstream>
#include <string>

#include "berm/io/edge_lines_file.hpp"
#include "fuzz_parser.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return berm::test::fuzz_parser(data, size, [](std::span<const std::byte> bytes) {
    std::istringstream input(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    for (const berm::EdgeLine& line : berm::read_edge_lines(input, "edges.csv")) {
      berm::test::demand(line.vertices.size() >= 2);
      for (const berm::EdgeLine::Vertex& vertex : line.vertices) {
        berm::test::demand(vertex.position_m.allFinite() && vertex.confidence >= 0.0 && vertex.confidence <= 1.0);
        berm::test::demand(!vertex.berm_height_m || std::isfinite(*vertex.berm_height_m));
      }
    }
  });
}
