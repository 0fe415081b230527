#include "berm/render/color.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <set>
#include <string>

#include <Eigen/Core>
#include <Eigen/LU>
#include <gtest/gtest.h>

namespace berm {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

constexpr std::array kLabels = {Label::unlabeled, Label::no_return, Label::falling_snow,
                                Label::drivable,  Label::terrain,   Label::obstacle};

Vector3d linear(Rgb color) {
  const auto channel = [](std::uint8_t value) {
    const double v = value / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  return {channel(color.r), channel(color.g), channel(color.b)};
}

/// Relative luminance of sRGB.
double luminance(const Vector3d& rgb) {
  return Vector3d(0.2126, 0.7152, 0.0722).dot(rgb);
}

/// CIE L*a*b* of linear sRGB, white D65.
Vector3d lab(const Vector3d& rgb) {
  Matrix3d to_xyz;
  to_xyz << 0.4124, 0.3576, 0.1805, 0.2126, 0.7152, 0.0722, 0.0193, 0.1192, 0.9505;
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16.0 / 116.0; };
  const Vector3d xyz = to_xyz * rgb;
  const double x = f(xyz.x() / 0.9505);
  const double y = f(xyz.y());
  const double z = f(xyz.z() / 1.089);
  return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

/// What people without one kind of cones see of linear sRGB: matrices of Machado, Oliveira and Fernandes (2009).
Matrix3d deficiency(int kind) {
  Matrix3d m = Matrix3d::Identity();
  if (kind == 1) {
    m << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998;
  } else if (kind == 2) {
    m << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881;
  } else if (kind == 3) {
    m << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900;
  }
  return m;
}

TEST(LabelColor, StaysApartForEveryColourVision) {
  // Distances of 2.3 are just noticeable side by side; small points on a dark ground need much more.
  constexpr double kApart = 20.0;
  for (const Background background : {Background::dark, Background::light}) {
    for (int kind = 0; kind < 4; ++kind) {
      for (const Label a : kLabels) {
        for (const Label b : kLabels) {
          if (a < b) {
            const auto seen = [&](Label label) {
              const Vector3d rgb = deficiency(kind) * linear(label_color(label, background));
              return lab(rgb.cwiseMax(0.0).cwiseMin(1.0));
            };
            EXPECT_GT((seen(a) - seen(b)).norm(), kApart)
                << label_name(a) << " and " << label_name(b) << ", deficiency " << kind << ", background "
                << static_cast<int>(background);
          }
        }
      }
    }
  }
}

TEST(LabelName, IsDifferentForEveryLabel) {
  std::set<std::string> names;
  for (const Label label : kLabels) {
    names.insert(label_name(label));
  }
  EXPECT_EQ(names.size(), kLabels.size());
}

TEST(ScaleColor, GrowsEvenlyInBrightness) {
  for (const Background background : {Background::dark, Background::light}) {
    double last = -1.0;
    for (int i = 0; i <= 100; ++i) {
      const double now = luminance(linear(scale_color(i / 100.0, background)));
      EXPECT_GT(now, last - 1e-3) << i;
      last = now;
    }
    EXPECT_GT(last, 0.7);
  }
}

TEST(ScaleColor, ClampsWhatIsOutside) {
  constexpr double kInf = std::numeric_limits<double>::infinity();
  for (const Background background : {Background::dark, Background::light}) {
    const Rgb low = scale_color(0.0, background);
    const Rgb high = scale_color(1.0, background);
    EXPECT_NE(low, high);
    EXPECT_EQ(scale_color(-3.0, background), low);
    EXPECT_EQ(scale_color(-kInf, background), low);
    EXPECT_EQ(scale_color(std::numeric_limits<double>::quiet_NaN(), background), low);
    EXPECT_EQ(scale_color(7.0, background), high);
    EXPECT_EQ(scale_color(kInf, background), high);
  }
}

TEST(Mix, GoesFromOneToTheOther) {
  const Rgb black{0, 0, 0};
  const Rgb color{255, 100, 51};
  EXPECT_EQ(mix(black, color, 0.0), black);
  EXPECT_EQ(mix(black, color, 1.0), color);
  EXPECT_EQ(mix(black, color, 2.0), color);
  EXPECT_EQ(mix(black, color, std::numeric_limits<double>::quiet_NaN()), black);
  EXPECT_EQ(mix(black, color, 0.5), (Rgb{128, 50, 26}));
  EXPECT_EQ(mix(color, black, 1.0), black);
}

}  // namespace
}  // namespace berm
