#include "berm/io/edges_file.hpp"

#include <cmath>
#include <optional>
#include <string>
#include <string_view>

#include "berm/core/error.hpp"
#include "berm/io/atomic_file.hpp"
#include "berm/io/trajectory_file.hpp"
#include "csv_columns.hpp"
#include "line_reader.hpp"
#include "text_numbers.hpp"

namespace berm {
namespace {

constexpr std::string_view kHeader = "side,x,y,z";
constexpr int kDecimals = 3;

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
        check_header(line);
        started = true;
      } else {
        take_vertex(line);
      }
    }
    if (!started) {
      throw lines_.error("the file is empty, expected the header " + std::string(kHeader));
    }
    end_polyline();
    return std::move(edges_);
  }

 private:
  void check_header(std::string_view line) const {
    std::string_view rest = line;
    if (take_word(rest) != kHeader || !take_word(rest).empty()) {
      throw lines_.error("expected the header " + std::string(kHeader) + ", found " + quoted(line));
    }
  }

  void take_vertex(std::string_view line) {
    std::string_view rest = line;
    const std::string_view side = take_column(rest);
    if (side != "left" && side != "right") {
      throw lines_.error("expected left or right in column 1, found " + quoted(side) + "; a line holds " +
                         std::string(kHeader));
    }
    Eigen::Vector3d vertex_m;
    for (Eigen::Index i = 0; i < 3; ++i) {
      const bool last = rest.find(',') == std::string_view::npos;
      const std::string_view column = take_column(rest);
      const std::optional<double> value = parse_number(column);
      if (last != (i == 2) || !value || std::abs(*value) > kMaxCoordinate_m) {
        throw lines_.error("expected three coordinates in metres after the side, found " + quoted(line));
      }
      vertex_m[i] = *value;
    }
    const bool left = side == "left";
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
  file.write(std::string(kHeader) + "\n");
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
      for (const double value : {vertex_m.x(), vertex_m.y(), vertex_m.z()}) {
        line += ',';
        append_fixed(line, value, kDecimals);
      }
      file.write(line + "\n");
    }
  }
  file.commit();
}

}  // namespace berm
