#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "berm/core/error.hpp"
#include "berm/io/atomic_file.hpp"
#include "berm/render/image.hpp"
#include "berm/render/paint.hpp"
#include "berm/render/png.hpp"
#include "command_map.hpp"
#include "exit_code.hpp"

namespace berm::app {
namespace {

constexpr const char* kMapDrawExamples = R"(Examples:
  berm map draw edges.ot -o map.png
  berm map draw edges.ot -o map.png --size 4000 --set lines.max_gap_m=2

Seen from above, north up. Left edges are orange, right ones blue, brighter the more probable; plain road is grey; the lines
lie over them, paler.)";

constexpr Rgb kGround{16, 18, 22};
constexpr Rgb kRoad{58, 62, 70};
constexpr Rgb kLeft{255, 150, 40};
constexpr Rgb kRight{70, 160, 255};
constexpr Rgb kInk{235, 238, 242};

/// Where the world lies in the picture.
class MapView {
 public:
  MapView(const EdgeMap& map, int size_px) {
    Eigen::Vector2d low_m = Eigen::Vector2d::Constant(std::numeric_limits<double>::max());
    Eigen::Vector2d high_m = -low_m;
    map.for_each([&](const VoxelKey& key, const EdgeMap::Voxel&) {
      const Eigen::Vector2d center_m = voxel_center_m(key, map.config().voxel_m).head<2>();
      low_m = low_m.cwiseMin(center_m);
      high_m = high_m.cwiseMax(center_m);
    });
    const Eigen::Vector2d span_m = (high_m - low_m).array() + map.config().voxel_m;
    unit_px_ = std::max(1.0, size_px / 1600.0);
    margin_px_ = 50.0 * unit_px_;
    px_per_m_ = std::min((size_px - 2.0 * margin_px_) / span_m.maxCoeff(), kMostPxPerM);
    width_px_ = std::max(static_cast<int>(std::ceil(span_m.x() * px_per_m_ + 2.0 * margin_px_)), least_px());
    height_px_ = std::max(static_cast<int>(std::ceil(span_m.y() * px_per_m_ + 2.0 * margin_px_)), least_px());
    middle_m_ = 0.5 * (low_m + high_m);
  }

  [[nodiscard]] PixelPoint at(const Eigen::Vector3d& place_m) const {
    return {0.5 * width_px_ + (place_m.x() - middle_m_.x()) * px_per_m_,
            0.5 * height_px_ - (place_m.y() - middle_m_.y()) * px_per_m_};
  }
  [[nodiscard]] int width_px() const { return width_px_; }
  [[nodiscard]] int height_px() const { return height_px_; }
  [[nodiscard]] double px_per_m() const { return px_per_m_; }
  [[nodiscard]] double unit_px() const { return unit_px_; }

 private:
  static constexpr double kMostPxPerM = 50.0;
  /// Room for scale and legend.
  [[nodiscard]] int least_px() const { return static_cast<int>(360.0 * unit_px_); }

  Eigen::Vector2d middle_m_ = Eigen::Vector2d::Zero();
  double px_per_m_ = 1.0;
  double unit_px_ = 1.0;
  double margin_px_ = 0.0;
  int width_px_ = 1;
  int height_px_ = 1;
};

double probability(double log_odds) {
  return 1.0 / (1.0 + std::exp(-log_odds));
}

void fill_voxel(Image& image, const MapView& view, const Eigen::Vector3d& center_m, double side_m, Rgb color,
                double share) {
  const PixelPoint low = view.at(center_m - Eigen::Vector3d(0.5 * side_m, -0.5 * side_m, 0.0));
  const int left = static_cast<int>(std::floor(low.u));
  const int top = static_cast<int>(std::floor(low.v));
  const int side_px = std::max(1, static_cast<int>(std::ceil(side_m * view.px_per_m())));
  for (int row = top; row < top + side_px; ++row) {
    for (int column = left; column < left + side_px; ++column) {
      image.blend(column, row, color, share);
    }
  }
}

/// Plain road first, so that it hides no edge.
void draw_voxels(Image& image, const MapView& view, const EdgeMap& map) {
  const double side_m = map.config().voxel_m;
  constexpr double kRoadShare = 0.5;
  map.for_each([&](const VoxelKey& key, const EdgeMap::Voxel& voxel) {
    if (voxel.miss > 0) {
      fill_voxel(image, view, voxel_center_m(key, side_m), side_m, kRoad, kRoadShare);
    }
  });
  map.for_each([&](const VoxelKey& key, const EdgeMap::Voxel& voxel) {
    for (const EdgeSide side : {EdgeSide::left, EdgeSide::right}) {
      if ((side == EdgeSide::left ? voxel.left : voxel.right) > 0) {
        fill_voxel(image, view, voxel_center_m(key, side_m), side_m, side == EdgeSide::left ? kLeft : kRight,
                   probability(map.log_odds(voxel, side)));
      }
    }
  });
}

void draw_lines(Image& image, const MapView& view, const EdgeMap& map, const EdgeLinesConfig& config) {
  const PixelBox all{0, 0, image.width_px(), image.height_px()};
  constexpr double kPale = 0.6;
  for (const EdgeLine& line : extract_lines(map, config)) {
    const Rgb color = mix(line.side == EdgeSide::left ? kLeft : kRight, kInk, kPale);
    for (std::size_t i = 0; i + 1 < line.vertices.size(); ++i) {
      draw_line(image, view.at(line.vertices[i].position_m), view.at(line.vertices[i + 1].position_m),
                1.2 * view.unit_px(), color, all);
    }
  }
}

/// The longest of 1, 2, 5, 10, ... m that is no longer than a third of the picture.
double scale_length_m(const MapView& view) {
  const double most_m = view.width_px() / 3.0 / view.px_per_m();
  const double decade_m = std::pow(10.0, std::floor(std::log10(most_m)));
  for (const double factor : {5.0, 2.0}) {
    if (factor * decade_m <= most_m) {
      return factor * decade_m;
    }
  }
  return decade_m;
}

void draw_frame(Image& image, const MapView& view, const EdgeMap& map) {
  const PixelBox all{0, 0, image.width_px(), image.height_px()};
  const double unit_px = view.unit_px();
  const double text_px = 11.0 * unit_px;
  const double bottom = view.height_px() - 22.0 * unit_px;
  const double length_m = scale_length_m(view);
  const double left = 24.0 * unit_px;
  const double right = left + length_m * view.px_per_m();
  draw_line(image, {left, bottom}, {right, bottom}, 3.0 * unit_px, kInk, all);
  for (const double end : {left, right}) {
    draw_line(image, {end, bottom - 6.0 * unit_px}, {end, bottom + 6.0 * unit_px}, 2.0 * unit_px, kInk, all);
  }
  draw_text(image, {right + 12.0 * unit_px, bottom}, fmt::format("{:g} m", length_m), text_px, TextAnchor::left, kInk);
  const double top = 22.0 * unit_px;
  const std::string left_text = "left edge";
  draw_text(image, {left, top}, left_text, text_px, TextAnchor::left, kLeft);
  draw_text(image, {left + text_width_px(left_text, text_px) + 20.0 * unit_px, top}, "right edge", text_px,
            TextAnchor::left, kRight);
  draw_text(image, {view.width_px() - left, top}, fmt::format("voxels of {:g} m", map.config().voxel_m), text_px,
            TextAnchor::right, kInk);
}

struct MapDrawCommand {
  std::string map;
  OutputOption output;
  LinesOption lines;
  int size_px = 1600;
};

int execute(const MapDrawCommand& command) {
  const EdgeLinesConfig config = command.lines.choose();
  const std::string& target = command.output.target();
  const EdgeMap map = read_map(command.map);
  if (map.empty()) {
    throw FileError(ErrorCode::unsupported, command.map, std::nullopt, "the map is empty, there is nothing to draw");
  }
  const MapView view(map, command.size_px);
  Image image(view.width_px(), view.height_px(), kGround);
  draw_voxels(image, view, map);
  draw_lines(image, view, map, config);
  draw_frame(image, view, map);
  write_file_atomically(target, encode_png(image));
  return kWhole;
}

}  // namespace

void add_map_draw(CLI::App& app, int& exit_code) {
  constexpr int kLeast_px = 400;
  auto command = std::make_shared<MapDrawCommand>();
  CLI::App* sub = app.add_subcommand("draw", "Draw a map from above");
  sub->footer(kMapDrawExamples);
  sub->add_option("MAP", command->map, "Map of road edges (.ot)")->required()->type_name("FILE");
  command->output.add_options(*sub, "The picture (.png)");
  sub->add_option("--size", command->size_px, "Longer side of the picture, in pixels")
      ->check(CLI::Range(kLeast_px, Image::kMaxSide_px))
      ->type_name("PX")
      ->capture_default_str();
  command->lines.add_options(*sub);
  sub->callback([command, &exit_code] { exit_code = execute(*command); });
}

}  // namespace berm::app
