#include <sstream>
#include <string>

#include "berm/io/edges_file.hpp"
#include "fuzz_parser.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  return berm::test::fuzz_parser(data, size, [](std::span<const std::byte> bytes) {
    std::istringstream input(std::string(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
    for (const berm::Edge& edge : berm::read_edges(input, "edges.csv")) {
      berm::test::demand(edge.vertices_m.size() >= 2);
      for (const Eigen::Vector3d& vertex_m : edge.vertices_m) {
        berm::test::demand(vertex_m.allFinite());
      }
    }
  });
}
