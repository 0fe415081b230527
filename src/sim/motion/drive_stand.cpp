#include "drive_stand.hpp"

#include <cmath>

namespace berm::sim {
namespace {

using Eigen::Vector3d;

/// Contact points along each side.
constexpr int kPointsPerSide = 5;
/// On a slope the machine is shorter on the map; two rounds settle how much.
constexpr int kRounds = 3;

struct Slopes {
  double height_m = 0.0;  ///< in the middle
  double ahead = 0.0;     ///< rise per horizontal metre ahead
  double left = 0.0;      ///< the same to the left
};

}  // namespace

Pose stand_on(const Terrain& terrain, const ContactArea& area, double x_m, double y_m, double heading_rad) {
  const double cosine = std::cos(heading_rad);
  const double sine = std::sin(heading_rad);
  Slopes slopes;
  for (int round = 0; round < kRounds; ++round) {
    const double length_m = area.length_m / std::sqrt(1.0 + slopes.ahead * slopes.ahead);
    const double half_m = 0.5 * area.width_m / std::sqrt(1.0 + slopes.left * slopes.left);
    double sum = 0.0;
    double sum_ahead = 0.0;
    double sum_left = 0.0;
    double squares_ahead = 0.0;
    for (int i = 0; i < kPointsPerSide; ++i) {
      const double ahead_m = length_m * (static_cast<double>(i) / (kPointsPerSide - 1) - 0.5);
      const double middle_x_m = x_m + ahead_m * cosine;
      const double middle_y_m = y_m + ahead_m * sine;
      const double left = terrain.at(middle_x_m - half_m * sine, middle_y_m + half_m * cosine).height_m;
      const double right = terrain.at(middle_x_m + half_m * sine, middle_y_m - half_m * cosine).height_m;
      sum += left + right;
      sum_ahead += ahead_m * (left + right);
      sum_left += left - right;
      squares_ahead += 2.0 * ahead_m * ahead_m;
    }
    // Least squares; the points lie evenly around the middle, so that the three sums are independent.
    slopes.height_m = sum / (2 * kPointsPerSide);
    slopes.ahead = sum_ahead / squares_ahead;
    slopes.left = sum_left / (2 * kPointsPerSide * half_m);
  }
  const Vector3d ahead = Vector3d(cosine, sine, slopes.ahead).normalized();
  const Vector3d across(-sine, cosine, slopes.left);
  const Vector3d up = ahead.cross(across).normalized();
  Eigen::Matrix3d rotation;
  rotation << ahead, up.cross(ahead), up;
  return {Eigen::Quaterniond(rotation), {x_m, y_m, slopes.height_m}};
}

}  // namespace berm::sim
