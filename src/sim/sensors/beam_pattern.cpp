#include "beam_pattern.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "berm/core/error.hpp"
#include "berm/io/setting.hpp"

namespace berm::sim {

std::vector<double> parse_angles_deg(const std::string& text, const std::string& key) {
  std::vector<double> angles;
  std::size_t begin = text.find_first_not_of(' ');
  while (begin != std::string::npos) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    double angle = 0.0;
    parse_into(angle, Setting{"", "pattern", key, text.substr(begin, end - begin), false});
    if (!(std::abs(angle) <= 90.0)) {
      throw ConfigError("pattern." + key, "expected angles from -90 to 90, found " + text.substr(begin, end - begin));
    }
    angles.push_back(angle);
    begin = text.find_first_not_of(' ', end);
  }
  return angles;
}

// Rates are given in decimal: a shot that falls on the start of a scan but for rounding belongs to that scan.
std::size_t ShotClock::first(std::size_t scan) const {
  constexpr double kRounding = 1e-6;
  return static_cast<std::size_t>(std::ceil(static_cast<double>(scan) * shots_per_s_ / scan_hz_ - kRounding));
}

std::size_t ShotClock::most() const {
  return static_cast<std::size_t>(std::ceil(shots_per_s_ / scan_hz_ - 1e-6));
}

// Whole turns are dropped before the angle is made: it stays exact to 1e-9 rad for months.
double ShotClock::angle_rad(std::size_t shot, double hz) const {
  return 2.0 * std::numbers::pi * std::fmod(static_cast<double>(shot) * hz, shots_per_s_) / shots_per_s_;
}

Rotor::Rotor(double angle_rad, double step_rad)
    : cosine_(std::cos(angle_rad)),
      sine_(std::sin(angle_rad)),
      step_cosine_(std::cos(step_rad)),
      step_sine_(std::sin(step_rad)) {}

void Beams::resize(std::size_t size, bool with_ring) {
  x.resize(size);
  y.resize(size);
  z.resize(size);
  time_s.resize(size);
  ring.resize(with_ring ? size : 0);
}

namespace {

std::shared_ptr<const DirectionMaker> make_directions(const PatternConfig& config) {
  config.check();
  if (config.kind == "rosette") {
    return make_rosette(config);
  }
  return config.kind == "swirl" ? make_swirl(config) : make_spinning(config);
}

}  // namespace

BeamPattern::BeamPattern(const PatternConfig& config) : maker_(make_directions(config)) {}

void BeamPattern::beams_of_scan(std::size_t scan, Beams& beams) const {
  maker_->beams_of_scan(scan, beams);
}

std::size_t BeamPattern::beams_per_scan() const {
  return maker_->beams_per_scan();
}

}  // namespace berm::sim
