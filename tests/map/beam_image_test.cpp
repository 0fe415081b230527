#include "berm/map/beam_image.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

namespace berm {
namespace {

TEST(BeamImageTest, SeesThroughWhatABeamPassedAndNotWhatItMet) {
  const Eigen::Vector3d origin_m(100.0, -50.0, 3.0);
  const std::vector<Eigen::Vector3d> ends_m = {origin_m + Eigen::Vector3d(20.0, 0.0, 0.0)};
  BeamImage image;
  EXPECT_FALSE(image.sees_through(origin_m, 0.1, 0.5));
  image.set(origin_m, ends_m);
  const auto sees = [&](double ahead_m, double aside_m, double up_m) {
    return image.sees_through(origin_m + Eigen::Vector3d(ahead_m, aside_m, up_m), 0.08, 0.5);
  };
  EXPECT_TRUE(sees(10.0, 0.0, 0.0));
  EXPECT_TRUE(sees(10.0, 0.05, -0.05));
  EXPECT_FALSE(sees(10.0, 0.09, 0.0));
  EXPECT_FALSE(sees(19.6, 0.0, 0.0)) << "too near to its end";
  EXPECT_FALSE(sees(25.0, 0.0, 0.0));
  EXPECT_FALSE(sees(-10.0, 0.0, 0.0));
}

TEST(BeamImageTest, FindsWhatTryingEveryBeamFinds) {
  rc::check("bins lose nothing beyond 5 m",
            [](const std::vector<std::pair<int, int>>& directions, int azimuth, int up) {
              std::vector<Eigen::Vector3d> ends_m;
              const auto end_m = [](int across, int above, double range_m) {
                const double a = 1e-3 * (across % 6283);
                const double e = 1e-3 * (above % 900);
                return Eigen::Vector3d(range_m * std::cos(a) * std::cos(e), range_m * std::sin(a) * std::cos(e),
                                       range_m * std::sin(e));
              };
              for (const auto& [across, above] : directions) {
                ends_m.push_back(end_m(across, above, 30.0));
                ends_m.push_back(end_m(azimuth + across % 20, up + above % 20, 30.0));
              }
              BeamImage image;
              image.set(Eigen::Vector3d::Zero(), ends_m);
              const Eigen::Vector3d place_m = end_m(azimuth, up, 10.0);
              bool expected = false;
              for (const Eigen::Vector3d& end : ends_m) {
                const Eigen::Vector3d u = end.normalized();
                const double aside_m = (place_m - place_m.dot(u) * u).norm();
                RC_PRE(std::abs(aside_m - 0.08) > 1e-4);
                expected = expected || aside_m < 0.08;
              }
              RC_ASSERT(image.sees_through(place_m, 0.08, 0.6) == expected);
            });
}

TEST(BeamImageTest, BadEndsTellNothing) {
  const double inf = std::numeric_limits<double>::infinity();
  const std::vector<Eigen::Vector3d> ends_m = {
      {std::nan(""), 0.0, 0.0}, {inf, 0.0, 0.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 50.0}, {0.0, 0.0, -50.0}};
  BeamImage image;
  image.set(Eigen::Vector3d::Zero(), ends_m);
  EXPECT_TRUE(image.empty());
  EXPECT_FALSE(image.sees_through({1.0, 0.0, 0.0}, 0.1, 0.1));
  EXPECT_FALSE(image.sees_through({std::nan(""), 0.0, 0.0}, 0.1, 0.1));
}

}  // namespace
}  // namespace berm
