#include "berm/io/trajectory_file.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <optional>

#include "berm/io/atomic_file.hpp"
#include "line_reader.hpp"
#include "text_numbers.hpp"

namespace berm {
namespace {

constexpr double kUnitTolerance = 1e-2;
/// Stamps that increase over many lines have several digits, so that hardly a line is shorter. Room is made once: a
/// vector that grows would hold its poses twice for a moment, more than 4 times the file.
constexpr std::uintmax_t kLeastLineBytes = 20;
constexpr int kTumDecimals = 6;
constexpr int kQuaternionDecimals = 9;
constexpr std::string_view kTumColumns = "t x y z qx qy qz qw";

void check_position(const LineReader& lines, const Eigen::Vector3d& position_m) {
  if (position_m.cwiseAbs().maxCoeff() > kMaxCoordinate_m) {
    throw lines.error("a coordinate beyond +-1e9 m cannot be a position");
  }
}

StampedPose parse_tum_line(const LineReader& lines, std::string_view line) {
  std::string_view rest = line;
  const std::string_view word = take_word(rest);
  const std::optional<Stamp> stamp = parse_seconds(word);
  if (!stamp) {
    throw lines.error("expected a stamp in seconds, found " + quoted(word) + "; a line holds " +
                      std::string(kTumColumns));
  }
  std::array<double, 7> v{};
  lines.parse_numbers(rest, "after the stamp: x y z qx qy qz qw", v);
  const Eigen::Vector3d position_m(v[0], v[1], v[2]);
  check_position(lines, position_m);
  const Eigen::Quaterniond rotation(v[6], v[3], v[4], v[5]);
  // Also catches an overflow of the norm.
  if (!(std::abs(rotation.norm() - 1.0) <= kUnitTolerance)) {
    throw lines.error("the quaternion has norm " + std::to_string(rotation.norm()) + ", expected 1; columns are " +
                      std::string(kTumColumns));
  }
  return {*stamp, Pose(rotation, position_m)};
}

Trajectory read_tum(LineReader& lines) {
  Trajectory trajectory;
  trajectory.reserve(lines.bytes() / kLeastLineBytes);
  std::string_view line;
  while (lines.next(line)) {
    const StampedPose pose = parse_tum_line(lines, line);
    if (!trajectory.empty() && pose.stamp_ns <= trajectory.poses().back().stamp_ns) {
      throw lines.error("the stamp is not later than the one before; sort the lines by time and drop repeated ones");
    }
    trajectory.append(pose.stamp_ns, pose.T_world_base);
  }
  return trajectory;
}

void append_tum_line(std::string& text, const StampedPose& pose) {
  append_seconds(text, pose.stamp_ns);
  const Eigen::Vector3d& p = pose.T_world_base.translation_m();
  for (const double value : {p.x(), p.y(), p.z()}) {
    text += ' ';
    append_fixed(text, value, kTumDecimals);
  }
  // q and -q are one rotation: the choice of one keeps the bytes a function of the pose.
  const Eigen::Quaterniond& q = pose.T_world_base.rotation();
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  for (const double value : {q.x(), q.y(), q.z(), q.w()}) {
    text += ' ';
    append_fixed(text, sign * value, kQuaternionDecimals);
  }
  text += '\n';
}

}  // namespace

Trajectory read_tum(const std::filesystem::path& path) {
  LineReader lines(path);
  return read_tum(lines);
}

Trajectory read_tum(std::istream& input, const std::string& name) {
  LineReader lines(input, name);
  return read_tum(lines);
}

void write_tum(const std::filesystem::path& path, const Trajectory& trajectory) {
  AtomicFile file(path);
  std::string line;
  for (const StampedPose& pose : trajectory.poses()) {
    line.clear();
    append_tum_line(line, pose);
    file.write(line);
  }
  file.commit();
}

}  // namespace berm
