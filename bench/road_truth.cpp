// berm_road_truth RECORDING...: what a survey says of simulated haul roads against their truth, over all recordings,
// and how often the truth lies within one and two of its standard deviations. With --dump FILE every station goes
// there.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "berm/core/mount.hpp"
#include "berm/core/scan.hpp"
#include "berm/edge/trace_edges.hpp"
#include "berm/ground/terrain_ground.hpp"
#include "berm/io/edges_file.hpp"
#include "berm/io/recording.hpp"
#include "berm/map/edge_lines.hpp"
#include "berm/map/edge_map.hpp"
#include "berm/map/road_survey.hpp"
#include "berm_height.hpp"
#include "slope.hpp"

namespace berm::bench {
namespace {

/// The window of the grade, and how far the toe of a berm reaches, as the survey has them.
constexpr double kHalfWindow_m = 5.0;
constexpr double kToe_m = 0.5;

/// What is true at a station.
struct StationTruth {
  std::optional<double> left_m;
  std::optional<double> right_m;
  std::optional<double> left_berm_m;
  std::optional<double> right_berm_m;
  double grade = 0.0;
  std::optional<double> cross_fall;
};

Eigen::Vector2d across(const RoadStation& station, double left_m) {
  return station.position_m.head<2>() +
         left_m * Eigen::Vector2d(-std::sin(station.heading_rad), std::cos(station.heading_rad));
}

/// Of the berm `left_m` of the path.
std::optional<double> true_berm_m(const sim::Terrain& terrain, const RoadStation& station, double left_m) {
  const Eigen::Vector2d toe_m = across(station, left_m);
  return true_berm_height_m(terrain, toe_m, (toe_m - station.position_m.head<2>()).normalized());
}

/// `with_true_edges`: the same survey with the true edges for lines; `around`: stations of the same piece nearby.
StationTruth true_station(const sim::Terrain& terrain, const std::vector<RoadStation>& with_true_edges, std::size_t i) {
  const RoadStation& station = with_true_edges[i];
  StationTruth truth;
  Slope grade;
  for (const RoadStation& other : with_true_edges) {
    const double along_m = other.chainage_m - station.chainage_m;
    if (other.piece == station.piece && std::abs(along_m) <= kHalfWindow_m) {
      grade.add(along_m, height_at(terrain, other.position_m.head<2>()));
    }
  }
  truth.grade = grade.value();
  if (station.left.edge_m) {
    truth.left_m = station.left.edge_m->value;
    truth.left_berm_m = true_berm_m(terrain, station, *truth.left_m);
  }
  if (station.right.edge_m) {
    truth.right_m = station.right.edge_m->value;
    truth.right_berm_m = true_berm_m(terrain, station, -*truth.right_m);
  }
  if (truth.left_m && truth.right_m) {
    Slope cross_fall;
    for (double left_m = kToe_m - *truth.right_m; left_m <= *truth.left_m - kToe_m; left_m += 0.1) {
      cross_fall.add(left_m, height_at(terrain, across(station, left_m)));
    }
    truth.cross_fall = cross_fall.value();
  }
  return truth;
}

/// Errors of one quantity.
class Errors {
 public:
  void add(const std::optional<Measure>& measure, const std::optional<double>& truth) {
    if (!truth || !std::isfinite(*truth)) {
      return;
    }
    ++places_;
    if (measure) {
      errors_.push_back(measure->value - *truth);
      sigmas_.push_back(measure->sigma);
    }
  }

  void print(const std::string& name, double scale) const {
    std::vector<double> absolute;
    std::vector<double> errors = errors_;
    std::size_t one = 0;
    std::size_t two = 0;
    for (std::size_t i = 0; i < errors_.size(); ++i) {
      absolute.push_back(std::abs(errors_[i]));
      one += absolute.back() <= sigmas_[i] ? 1U : 0U;
      two += absolute.back() <= 2.0 * sigmas_[i] ? 1U : 0U;
    }
    const auto percent = [](std::size_t part, std::size_t whole) {
      return 100.0 * static_cast<double>(part) / static_cast<double>(std::max<std::size_t>(whole, 1));
    };
    fmt::print("{:<22} {:8} {:9.1f} {:9.3f} {:9.3f} {:9.3f} {:9.3f} {:8.1f} {:8.1f}\n", name, places_,
               percent(errors_.size(), places_), scale * quantile(errors, 0.5), scale * quantile(absolute, 0.5),
               scale * quantile(absolute, 0.95), scale * quantile(sigmas_, 0.5), percent(one, errors_.size()),
               percent(two, errors_.size()));
  }

 private:
  static double quantile(std::vector<double> values, double share) {
    if (values.empty()) {
      return 0.0;
    }
    const auto at = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + at, values.end());
    return values[static_cast<std::size_t>(at)];
  }

  std::size_t places_ = 0;
  std::vector<double> errors_;
  std::vector<double> sigmas_;
};

struct Table {
  Errors edge;
  Errors width;
  Errors height;
  Errors grade;
  Errors cross_fall;

  void add(const RoadStation& station, const StationTruth& truth) {
    edge.add(station.left.edge_m, truth.left_m);
    edge.add(station.right.edge_m, truth.right_m);
    const bool is_wide = truth.left_m && truth.right_m;
    width.add(station.width_m, is_wide ? std::optional(*truth.left_m + *truth.right_m) : std::nullopt);
    height.add(station.left.berm_height_m, truth.left_berm_m);
    height.add(station.right.berm_height_m, truth.right_berm_m);
    grade.add(station.grade, truth.grade);
    cross_fall.add(station.cross_fall, truth.cross_fall);
  }
};

/// Takes a recording through ground, edges, map and survey as `berm run` does.
class Drive {
 public:
  Drive(const Recording& recording, const RoadConfig& config, bool with_raised)
      : recording_(recording),
        poses_(recording.read_given_poses().value().trajectory),
        survey_(config, poses_),
        with_raised_(with_raised) {}

  void run() {
    Scan scan;
    for (std::size_t i = 0; i < recording_.size(); ++i) {
      recording_.read(i, scan);
      MountConfig mount;
      mount.height_m = recording_.sheet().height_m.value_or(0.0);
      mount.pitch_deg = recording_.sheet().pitch_rad.value_or(0.0) * 180.0 / std::numbers::pi;
      scan.T_base_sensor = mount.T_base_sensor();
      process(scan);
    }
  }

  [[nodiscard]] const EdgeMap& map() const { return map_; }
  [[nodiscard]] const RoadSurvey& survey() const { return survey_; }

 private:
  void process(const Scan& scan) {
    const GroundResult ground = ground_.process(scan.cloud.view(), scan.T_base_sensor);
    labels_.clear();
    for (const GroundClass one : ground.classes) {
      labels_.push_back(label_of(one));
    }
    const EdgeResult found = edges_.process({.points = scan.cloud.view(),
                                             .labels = labels_,
                                             .surface = ground.surface,
                                             .T_base_sensor = scan.T_base_sensor});
    const auto start = poses_.at(scan.stamp_ns);
    const auto end = poses_.at(scan.stamp_ns + 100'000'000);
    if (!start || !end) {
      return;
    }
    const auto place = [&](double time_s, const Eigen::Vector3d& point_m) {
      return interpolate(*start, *end, time_s / 0.1) * (scan.T_base_sensor * point_m);
    };
    std::vector<MappedEdge> mapped;
    std::vector<SurveyedEdge> surveyed;
    for (const EdgePoint& edge : found.edges) {
      const Eigen::Vector3d here_m = place(double{edge.time_s}, {double{edge.x_m}, double{edge.y_m}, double{edge.z_m}});
      mapped.push_back({here_m, edge.side});
      surveyed.push_back({here_m, edge.height_m, edge.width_m, edge.kind});
    }
    const PointsView cloud = scan.cloud.view();
    const auto placed = [&](std::size_t i) {
      return place(cloud.time.empty() ? 0.0 : double{cloud.time[i]},
                   {double{cloud.x[i]}, double{cloud.y[i]}, double{cloud.z[i]}});
    };
    std::vector<Eigen::Vector3d> plain_m;
    for (const std::uint32_t i : found.plain) {
      plain_m.push_back(placed(i));
    }
    static_cast<void>(map_.add_scan(mapped, plain_m));
    std::vector<Eigen::Vector3d> raised_m;
    if (with_raised_) {
      std::vector<bool> is_plain(labels_.size());
      for (const std::uint32_t i : found.plain) {
        is_plain[i] = true;
      }
      for (std::size_t i = 0; i < labels_.size(); ++i) {
        if (!is_plain[i] && (labels_[i] == Label::drivable || labels_[i] == Label::obstacle)) {
          raised_m.push_back(placed(i));
        }
      }
    }
    survey_.add_scan(scan.stamp_ns, surveyed, plain_m, raised_m);
  }

  const Recording& recording_;
  Trajectory poses_;
  RoadSurvey survey_;
  EdgeMap map_{EdgeMapConfig{}};
  TerrainGround ground_{TerrainGroundConfig{}};
  TraceEdges edges_{TraceEdgesConfig{}};
  std::vector<Label> labels_;
  bool with_raised_;
};

std::vector<EdgeLine> as_lines(const std::vector<Edge>& edges) {
  std::vector<EdgeLine> lines;
  for (const Edge& edge : edges) {
    EdgeLine line;
    line.side = edge.left ? EdgeSide::left : EdgeSide::right;
    for (const Eigen::Vector3d& vertex_m : edge.vertices_m) {
      line.vertices.push_back({vertex_m, 1.0});
    }
    lines.push_back(std::move(line));
  }
  return lines;
}

std::string dumped(const std::string& name, const RoadStation& station, const StationTruth& truth) {
  const auto text = [](const std::optional<Measure>& measure) {
    return measure ? fmt::format("{:.4f},{:.4f}", measure->value, measure->sigma) : std::string(",");
  };
  const auto number = [](const std::optional<double>& value) { return value ? fmt::format("{:.4f}", *value) : ""; };
  return fmt::format("{},{:.1f},{},{},{},{},{},{},{},{},{},{},{},{:.4f},{},{}\n", name, station.chainage_m,
                     text(station.left.edge_m), number(truth.left_m), text(station.right.edge_m), number(truth.right_m),
                     text(station.left.berm_height_m), number(truth.left_berm_m), text(station.right.berm_height_m),
                     number(truth.right_berm_m), text(station.width_m), text(station.grade), "", truth.grade,
                     text(station.cross_fall), number(truth.cross_fall));
}

void run(const std::vector<std::string>& folders, const RoadConfig& config, bool with_raised,
         const std::string& dump_file) {
  Table table;
  std::string dump;
  for (const std::string& folder : folders) {
    const Recording recording = Recording::open(folder);
    const auto terrain = read_true_terrain(recording.path());
    const std::vector<EdgeLine> true_lines = as_lines(read_edges(recording.path() / "edges.csv"));
    Drive drive(recording, config, with_raised);
    drive.run();
    const auto stations = drive.survey().stations(extract_lines(drive.map(), {}));
    const auto with_true_edges = drive.survey().stations(true_lines);
    for (std::size_t i = 0; i < stations.size(); ++i) {
      const StationTruth truth = true_station(*terrain, with_true_edges, i);
      table.add(stations[i], truth);
      dump += dumped(recording.path().filename().string(), stations[i], truth);
    }
  }
  fmt::print("{:<22} {:>8} {:>9} {:>9} {:>9} {:>9} {:>9} {:>8} {:>8}\n", "", "places", "known, %", "bias", "median",
             "p95", "sigma", "1 s, %", "2 s, %");
  table.edge.print("edge, m", 1.0);
  table.width.print("width, m", 1.0);
  table.height.print("berm height, m", 1.0);
  table.grade.print("grade, %", 100.0);
  table.cross_fall.print("cross-fall, %", 100.0);
  if (!dump_file.empty()) {
    std::ofstream(dump_file)
        << "name,s,le,le_s,le_t,re,re_s,re_t,lb,lb_s,lb_t,rb,rb_s,rb_t,w,w_s,g,g_s,_,g_t,c,c_s,c_t\n"
        << dump;
  }
}

}  // namespace
}  // namespace berm::bench

int main(int argc, char** argv) {
  CLI::App app("A survey of simulated haul roads against their truth");
  std::vector<std::string> folders;
  std::string dump_file;
  berm::RoadConfig config;
  app.add_option("recordings", folders)->required();
  app.add_option("--dump", dump_file);
  app.add_option("--reach", config.reach_m, "road.reach_m");
  app.add_option("--attitude", config.attitude_sigma_deg, "road.attitude_sigma_deg");
  bool without_raised = false;
  app.add_flag("--edges-alone", without_raised, "berms are measured from the heights of edge points alone");
  CLI11_PARSE(app, argc, argv);
  berm::bench::run(folders, config, !without_raised, dump_file);
  return 0;
}
