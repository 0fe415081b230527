#include "berm/geometry/moments.hpp"

#include <vector>

#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "berm/core/error.hpp"
#include "geometry/made_points.hpp"

namespace berm {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using test::Noise;

struct Sample {
  Vector3d point_m;
  double weight;
};

std::vector<Sample> gen_samples(double offset_m) {
  Noise noise(*rc::gen::arbitrary<unsigned>());
  std::vector<Sample> samples(static_cast<std::size_t>(*rc::gen::inRange(0, 60)));
  for (Sample& s : samples) {
    s.point_m = Vector3d(noise.even(10.0), noise.even(5.0), noise.even(0.1)) + Vector3d::Constant(offset_m);
    s.weight = 1.0 + noise.even(0.99);
  }
  return samples;
}

/// Mean and covariance in two passes and long doubles.
Matrix3d covariance_by_definition(const std::vector<Sample>& samples) {
  using Wide = Eigen::Matrix<long double, 3, 1>;
  Wide mean = Wide::Zero();
  long double weight = 0.0L;
  for (const Sample& s : samples) {
    mean += static_cast<long double>(s.weight) * s.point_m.cast<long double>();
    weight += static_cast<long double>(s.weight);
  }
  mean /= weight;
  Eigen::Matrix<long double, 3, 3> scatter = Eigen::Matrix<long double, 3, 3>::Zero();
  for (const Sample& s : samples) {
    const Wide d = s.point_m.cast<long double>() - mean;
    scatter += static_cast<long double>(s.weight) * d * d.transpose();
  }
  return (scatter / weight).cast<double>();
}

Moments moments_of_samples(const std::vector<Sample>& samples) {
  Moments moments;
  for (const Sample& s : samples) {
    moments.add(s.point_m, s.weight);
  }
  return moments;
}

TEST(Moments, AreZeroWithoutPoints) {
  const Moments moments;
  EXPECT_EQ(moments.count(), 0U);
  EXPECT_EQ(moments.weight(), 0.0);
  EXPECT_TRUE(moments.mean_m().isZero(0.0));
  EXPECT_TRUE(moments.covariance_m2().isZero(0.0));
}

TEST(Moments, OfOneOrOfEqualPointsHaveExactlyNoSpread) {
  const Vector3d p(5e6, -1.1, 0.3);
  Moments moments;
  for (int i = 0; i < 1000; ++i) {
    moments.add(p, 0.1 + i);
    EXPECT_EQ(moments.mean_m(), p);
    ASSERT_TRUE(moments.covariance_m2().isZero(0.0));
  }
}

TEST(Moments, AgreeWithTheDefinition) {
  for (const double offset_m : {0.0, 1e3, 5e6}) {
    EXPECT_TRUE(rc::check("also far from the origin", [offset_m] {
      const std::vector<Sample> samples = gen_samples(offset_m);
      RC_PRE(!samples.empty());
      const Matrix3d error = moments_of_samples(samples).covariance_m2() - covariance_by_definition(samples);
      RC_ASSERT(error.cwiseAbs().maxCoeff() < 1e-12);
    }));
  }
}

TEST(Moments, MergeAsIfAddedTogether) {
  EXPECT_TRUE(rc::check("in any division, with empty parts too", [] {
    const std::vector<Sample> samples = gen_samples(100.0);
    Moments parts[3];
    for (const Sample& s : samples) {
      parts[*rc::gen::inRange(0, 3)].add(s.point_m, s.weight);
    }
    Moments merged;
    for (const Moments& part : parts) {
      merged.merge(part);
    }
    const Moments whole = moments_of_samples(samples);
    RC_ASSERT(merged.count() == whole.count());
    RC_ASSERT(std::abs(merged.weight() - whole.weight()) < 1e-10);
    RC_ASSERT((merged.mean_m() - whole.mean_m()).norm() < 1e-10);
    RC_ASSERT((merged.covariance_m2() - whole.covariance_m2()).norm() < 1e-10);
  }));
}

TEST(Moments, LeaveOutWhatIsNoNumber) {
  Moments moments;
  moments.add({1.0, 2.0, 3.0});
  moments.add({test::kNan, 0.0, 0.0});
  moments.add({0.0, test::kInf, 0.0});
  moments.add({9.0, 9.0, 9.0}, test::kNan);
  moments.add({9.0, 9.0, 9.0}, test::kInf);
  moments.add({9.0, 9.0, 9.0}, 0.0);
  moments.add({9.0, 9.0, 9.0}, -1.0);
  EXPECT_EQ(moments.count(), 1U);
  EXPECT_EQ(moments.mean_m(), Vector3d(1.0, 2.0, 3.0));
}

TEST(Moments, OfCloudsTakeOneWeightAPoint) {
  const PointCloud cloud = test::cloud_of({{0.0, 0.0, 0.0}, {4.0, 0.0, 0.0}});
  EXPECT_EQ(moments_of(cloud.view()).mean_m().x(), 2.0);
  EXPECT_EQ(moments_of(cloud.view(), std::vector<double>{3.0, 1.0}).mean_m().x(), 1.0);
  EXPECT_THROW((void)moments_of(cloud.view(), std::vector<double>{1.0}), Error);
  EXPECT_EQ(moments_of({}).count(), 0U);
}

}  // namespace
}  // namespace berm
