#include "scans.hpp"

#include <cstdlib>
#include <filesystem>
#include <map>
#include <stdexcept>
#include <utility>

#include "berm/core/scan.hpp"
#include "berm/io/recording.hpp"
#include "support/made_scan.hpp"

namespace berm::bench {
namespace {

struct Spinner {
  int rings;
  int columns;
};

const std::map<std::string, Spinner>& spinners() {
  static const std::map<std::string, Spinner> all = {
      {"made_10k", {16, 625}}, {"made_30k", {16, 1875}}, {"made_120k", {64, 1875}}, {"made_1M", {128, 7813}}};
  return all;
}

/// Heights of the sensors above the ground, m: about right, which is all that the methods ask for.
const std::map<std::string, double>& sensor_heights_m() {
  static const std::map<std::string, double> all = {
      {"kitti00", 1.73}, {"wads36", 2.0}, {"hdl32_rings", 2.0}, {"livox_horizon", 1.9}, {"livox_mid360", 0.5}};
  return all;
}

std::filesystem::path data_folder() {
  const char* folder = std::getenv("BERM_DATA");
  return folder != nullptr ? folder : "";
}

Pose mount(double height_m) {
  return Pose::from_yaw_pitch_roll(0.0, 0.0, 0.0, {0.0, 0.0, height_m});
}

BenchScan make_scan(const Spinner& spinner) {
  constexpr double kHeight_m = 1.73;
  const test::World street = test::made_street(1);
  test::MadeScan made = test::cast(street, test::spinning_beams(spinner.rings, -25.0, 3.0, spinner.columns),
                                   test::standing_at_origin(street, kHeight_m));
  return {std::move(made.cloud), mount(kHeight_m)};
}

BenchScan read_scan(const std::string& name) {
  Scan scan;
  Recording::open(data_folder() / name).read(0, scan);
  return {std::move(scan.cloud), mount(sensor_heights_m().at(name))};
}

}  // namespace

const std::vector<std::string>& made_scans() {
  static const std::vector<std::string> names = {"made_10k", "made_30k", "made_120k", "made_1M"};
  return names;
}

const std::vector<std::string>& real_scans() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> found;
    for (const auto& [name, height_m] : sensor_heights_m()) {
      if (!data_folder().empty() && std::filesystem::exists(data_folder() / name)) {
        found.push_back(name);
      }
    }
    return found;
  }();
  return names;
}

std::vector<std::string> all_scans() {
  std::vector<std::string> names = made_scans();
  names.insert(names.end(), real_scans().begin(), real_scans().end());
  return names;
}

const BenchScan& scan(const std::string& name) {
  static std::map<std::string, BenchScan> made;
  const auto known = made.find(name);
  if (known != made.end()) {
    return known->second;
  }
  const auto spinner = spinners().find(name);
  return made.emplace(name, spinner != spinners().end() ? make_scan(spinner->second) : read_scan(name)).first->second;
}

}  // namespace berm::bench
