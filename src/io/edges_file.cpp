#include "berm/io/edges_file.hpp"

#include <string>
#include <string_view>
#include <utility>

#include "berm/core/error.hpp"
#include "berm/io/atomic_file.hpp"
#include "edge_row.hpp"
#include "line_reader.hpp"

namespace berm {
namespace {

constexpr std::string_view kEdgesHeader = "side,x,y,z";

class EdgesReader {
 public:
  explicit EdgesReader(LineReader& lines) : lines_(lines) {}

  std::vector<Edge> read() {
    std::string_view line;
    bool started = false;
    while (lines_.next_or_blank(line)) {
      if (line.empty()) {
        end_polyline();
      } else if (!started) {
        check_edge_header(lines_, line, kEdgesHeader);
        started = true;
      } else {
        take_vertex(line);
      }
    }
    if (!started) {
      throw lines_.error("the file is empty, expected the header " + std::string(kEdgesHeader));
    }
    end_polyline();
    return std::move(edges_);
  }

 private:
  void take_vertex(std::string_view line) {
    std::string_view rest = line;
    const bool left = take_side(lines_, rest, 1, kEdgesHeader) == EdgeSide::left;
    const Eigen::Vector3d vertex_m = take_position_m(lines_, line, rest, true);
    if (open_ && edges_.back().left != left) {
      end_polyline();
    }
    if (!open_) {
      edges_.push_back({left, {}});
      open_ = true;
    }
    edges_.back().vertices_m.push_back(vertex_m);
  }

  void end_polyline() {
    if (open_ && edges_.back().vertices_m.size() < 2) {
      throw lines_.error("the polyline that ends before has one vertex, expected at least two");
    }
    open_ = false;
  }

  LineReader& lines_;
  std::vector<Edge> edges_;
  bool open_ = false;
};

}  // namespace

std::vector<Edge> read_edges(const std::filesystem::path& path) {
  LineReader lines(path);
  return EdgesReader(lines).read();
}

std::vector<Edge> read_edges(std::istream& input, const std::string& name) {
  LineReader lines(input, name);
  return EdgesReader(lines).read();
}

void write_edges(const std::filesystem::path& path, std::span<const Edge> edges) {
  AtomicFile file(path);
  file.write(std::string(kEdgesHeader) + "\n");
  bool first = true;
  std::string line;
  for (const Edge& edge : edges) {
    if (edge.vertices_m.size() < 2) {
      throw Error(ErrorCode::invalid_argument, "edges: a polyline needs at least two vertices");
    }
    file.write(first ? "" : "\n");
    first = false;
    for (const Eigen::Vector3d& vertex_m : edge.vertices_m) {
      line = edge.left ? "left" : "right";
      append_position(line, vertex_m);
      file.write(line + "\n");
    }
  }
  file.commit();
}

}  // namespace berm
