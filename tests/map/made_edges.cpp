#include "made_edges.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace berm::test {
namespace {

constexpr double kStep_m = 0.1;
constexpr double kSight_m = 15.0;

Eigen::Vector3d to_left(const Course& course, std::size_t i) {
  const Eigen::Vector3d along = course[std::min(i + 1, course.size() - 1)] - course[i == 0 ? 0 : i - 1];
  return Eigen::Vector3d(-along.y(), along.x(), 0.0).normalized();
}

}  // namespace

Course straight_course(const Eigen::Vector3d& from_m, double heading_rad, double length_m) {
  Course course;
  for (double s = 0.0; s <= length_m; s += kStep_m) {
    course.emplace_back(from_m + s * Eigen::Vector3d(std::cos(heading_rad), std::sin(heading_rad), 0.0));
  }
  return course;
}

Course arc_course(const Eigen::Vector3d& center_m, double radius_m, double from_rad, double turn_rad) {
  Course course;
  const double step_rad = std::copysign(kStep_m / radius_m, turn_rad);
  for (double angle = 0.0; std::abs(angle) <= std::abs(turn_rad); angle += step_rad) {
    course.emplace_back(center_m +
                        radius_m * Eigen::Vector3d(std::cos(from_rad + angle), std::sin(from_rad + angle), 0.0));
  }
  return course;
}

Course s_bend_course(double radius_m) {
  constexpr double kQuarter = 0.5 * std::numbers::pi;
  Course course = arc_course({0.0, radius_m, 0.0}, radius_m, -kQuarter, kQuarter);
  const Course second = arc_course({2.0 * radius_m, radius_m, 0.0}, radius_m, 2.0 * kQuarter, -kQuarter);
  course.insert(course.end(), second.begin() + 1, second.end());
  return course;
}

Course beside(const Course& course, double left_m) {
  Course moved;
  for (std::size_t i = 0; i < course.size(); ++i) {
    moved.emplace_back(course[i] + left_m * to_left(course, i));
  }
  return moved;
}

double made_uniform(std::mt19937_64& random) {
  return static_cast<double>(random() >> 11U) * 0x1p-53;
}

double made_noise(std::mt19937_64& random) {
  double sum = -6.0;
  for (int i = 0; i < 12; ++i) {
    sum += made_uniform(random);
  }
  return sum;
}

std::vector<MadeScan> drive(const Course& course, const MadeDrive& how) {
  std::mt19937_64 random(how.seed);
  const auto sight = static_cast<std::int64_t>(kSight_m / kStep_m);
  const auto last = static_cast<std::int64_t>(course.size()) - 1;
  std::vector<MadeScan> scans;
  for (std::int64_t at = 0; at <= last; at += static_cast<std::int64_t>(1.0 / kStep_m)) {
    MadeScan scan;
    const std::int64_t low = std::max<std::int64_t>(at - sight, 0);
    const std::int64_t high = std::min(at + sight, last);
    const auto somewhere = [&] {
      return static_cast<std::size_t>(
          low + static_cast<std::int64_t>(made_uniform(random) * static_cast<double>(high - low + 1)));
    };
    const auto hits =
        static_cast<int>(std::lround(how.hits_per_m * static_cast<double>(high - low) * kStep_m / (2.0 * kSight_m)));
    for (const double side : {1.0, -1.0}) {
      for (int hit = 0; hit < hits; ++hit) {
        const std::size_t i = somewhere();
        const Eigen::Vector3d noise(made_noise(random), made_noise(random), made_noise(random) / 3.0);
        scan.edges.push_back({course[i] + side * how.half_width_m * to_left(course, i) + how.scatter_m * noise,
                              side > 0.0 ? EdgeSide::left : EdgeSide::right});
      }
    }
    for (int point = 0; point < 1200; ++point) {
      const std::size_t i = somewhere();
      const double aside_m = (2.0 * made_uniform(random) - 1.0) * (how.half_width_m - 0.1);
      scan.plain_m.emplace_back(course[i] + aside_m * to_left(course, i));
    }
    if (made_uniform(random) < how.outlier_share) {
      const std::size_t i = somewhere();
      for (double along_m = 0.0; along_m < 12.0; along_m += 0.3) {
        const std::size_t k = std::min(i + static_cast<std::size_t>(along_m / kStep_m), course.size() - 1);
        scan.edges.push_back({course[k] + (how.half_width_m - 3.0) * to_left(course, k) +
                                  how.scatter_m * Eigen::Vector3d(made_noise(random), made_noise(random), 0.0),
                              EdgeSide::left});
      }
    }
    scans.push_back(std::move(scan));
  }
  return scans;
}

EdgeMap map_of(const std::vector<MadeScan>& scans, const EdgeMapConfig& config) {
  EdgeMap map(config);
  for (const MadeScan& scan : scans) {
    map.add_scan(scan.edges, scan.plain_m);
  }
  return map;
}

double distance_m(const Course& course, const Eigen::Vector3d& place_m) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < course.size(); ++i) {
    const Eigen::Vector2d along = (course[i + 1] - course[i]).head<2>();
    const Eigen::Vector2d to = (place_m - course[i]).head<2>();
    const double share = std::clamp(to.dot(along) / along.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (to - share * along).norm());
  }
  return least;
}

}  // namespace berm::test
