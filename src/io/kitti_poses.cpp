#include <array>
#include <cstdint>
#include <optional>

#include "berm/io/atomic_file.hpp"
#include "berm/io/trajectory_file.hpp"
#include "line_reader.hpp"
#include "text_numbers.hpp"

namespace berm {
namespace {

using Matrix34 = Eigen::Matrix<double, 3, 4, Eigen::RowMajor>;

/// Files print 6 to 12 decimals, so that a real rotation is far better than this and a shear far worse.
constexpr double kRotationTolerance = 1e-3;
/// 12 digits and what separates them. Room is made once: a vector that grows would hold its poses twice for a moment,
/// more than 4 times the file.
constexpr std::uintmax_t kMinLineBytes = 24;
constexpr int kKittiDecimals = 12;
constexpr std::array<std::string_view, 2> kCalibrationKeys = {"Tr:", "Tr_velo_to_cam:"};

Pose parse_pose(const LineReader& lines, std::string_view line) {
  std::array<double, 12> values{};
  lines.parse_numbers(line, "the rows of a 3x4 matrix", values);
  const Matrix34 matrix = Eigen::Map<const Matrix34>(values.data());
  const Eigen::Matrix3d rotation = matrix.leftCols<3>();
  const double deviation = (rotation * rotation.transpose() - Eigen::Matrix3d::Identity()).cwiseAbs().maxCoeff();
  // Also catches an overflow, which compares false.
  if (!(deviation <= kRotationTolerance) || rotation.determinant() < 0.0) {
    throw lines.error("the left 3x3 block is no rotation; expected orthonormal rows and determinant 1");
  }
  if (matrix.col(3).cwiseAbs().maxCoeff() > kMaxCoordinate_m) {
    throw lines.error("a coordinate beyond +-1e9 m cannot be a position");
  }
  return Pose::from_matrix(matrix);
}

std::vector<Pose> read_kitti_poses(LineReader& lines) {
  std::vector<Pose> poses;
  poses.reserve(lines.bytes() / kMinLineBytes);
  std::string_view line;
  while (lines.next(line)) {
    poses.push_back(parse_pose(lines, line));
  }
  return poses;
}

bool is_calibration_key(std::string_view word) {
  return word == kCalibrationKeys[0] || word == kCalibrationKeys[1];
}

Pose read_calibration(LineReader& lines, const std::string& name) {
  std::optional<Pose> T_camera_lidar;
  std::string_view line;
  while (lines.next(line)) {
    if (!is_calibration_key(take_word(line))) {
      continue;
    }
    if (T_camera_lidar) {
      throw lines.error("a second line 'Tr:', expected one");
    }
    T_camera_lidar = parse_pose(lines, line);
  }
  if (!T_camera_lidar) {
    throw FileError(
        ErrorCode::malformed, name, std::nullopt,
        "no line 'Tr:' or 'Tr_velo_to_cam:'; it has to give the pose of the LiDAR in the left camera frame");
  }
  return *T_camera_lidar;
}

}  // namespace

std::vector<Pose> read_kitti_poses(const std::filesystem::path& path) {
  LineReader lines(path);
  return read_kitti_poses(lines);
}

std::vector<Pose> read_kitti_poses(std::istream& input, const std::string& name) {
  LineReader lines(input, name);
  return read_kitti_poses(lines);
}

void write_kitti_poses(const std::filesystem::path& path, std::span<const Pose> poses) {
  AtomicFile file(path);
  std::string line;
  for (const Pose& pose : poses) {
    line.clear();
    const Eigen::Matrix4d matrix = pose.matrix();
    for (Eigen::Index row = 0; row < 3; ++row) {
      for (Eigen::Index column = 0; column < 4; ++column) {
        line += line.empty() ? "" : " ";
        append_scientific(line, matrix(row, column), kKittiDecimals);
      }
    }
    line += '\n';
    file.write(line);
  }
  file.commit();
}

Pose read_kitti_calibration(const std::filesystem::path& path) {
  LineReader lines(path);
  return read_calibration(lines, path.string());
}

Pose read_kitti_calibration(std::istream& input, const std::string& name) {
  LineReader lines(input, name);
  return read_calibration(lines, name);
}

}  // namespace berm
