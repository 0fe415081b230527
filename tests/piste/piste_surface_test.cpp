#include "piste_surface.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <utility>
#include <vector>

#include <Eigen/Cholesky>
#include <gtest/gtest.h>
#include <rapidcheck.h>

#include "piste/made_windows.hpp"

namespace berm {
namespace {

using test::WindowPlace;
using Terms = PisteSurface::Terms;

constexpr double kFanHalfAngle_rad = 0.6;
/// So little that the level plane the surface is drawn to does not show.
constexpr PisteSurface::Noise kExact{.height_m = 1e-4, .slope = 1e-4};

PisteSurface fitted(const TraceWindows& windows, const PisteSurface::Noise& noise = kExact) {
  PisteSurface surface;
  surface.fit(windows, std::vector<std::uint8_t>(windows.size(), 1), {}, {}, noise);
  return surface;
}

/// Any cubic: up to a slope of 0.4, and as bent as terrain may be.
rc::Gen<test::HeightOf> any_cubic() {
  return rc::gen::map(rc::gen::container<std::vector<int>>(10, rc::gen::inRange(-100, 101)), [](std::vector<int> c) {
    return test::HeightOf([c](double x_m, double y_m) {
      const double x = x_m / 20.0;
      const double y = y_m / 20.0;
      return (0.5 * c[0] + 8.0 * c[1] * x + 8.0 * c[2] * y + c[3] * x * x + c[4] * x * y + c[5] * y * y +
              0.3 * (c[6] * x * x * x + c[7] * x * x * y + c[8] * x * y * y + c[9] * y * y * y)) *
             0.01;
    });
  });
}

TEST(PisteSurface, IsLevelBeforeAnythingIsSeen) {
  PisteSurface surface;
  EXPECT_EQ(surface.height_m(30.0F, -10.0F), 0.0F);
  surface.fit({}, {}, {}, {}, {});
  EXPECT_EQ(surface.height_m(30.0F, -10.0F), 0.0F);
}

TEST(PisteSurface, IsTheCubicThatItsWindowsLieOn) {
  EXPECT_TRUE(rc::check([] {
    const test::HeightOf cubic = *any_cubic();
    const PisteSurface surface = fitted(test::scattered_windows(600, 3.0, 40.0, kFanHalfAngle_rad, cubic));
    for (const double x : {5.0, 15.0, 38.0}) {
      for (const double y : {-4.0, 0.0, 5.0}) {
        RC_ASSERT(std::abs(double{surface.height_m(static_cast<float>(x), static_cast<float>(y))} - cubic(x, y)) <
                  1e-4);
        const double slope = surface.value(PisteSurface::slope_terms(x, y, 0.6, 0.8));
        const double rise = cubic(x + 0.6e-4, y + 0.8e-4) - cubic(x - 0.6e-4, y - 0.8e-4);
        RC_ASSERT(std::abs(slope - rise / 2e-4) < 1e-4);
      }
    }
  }));
}

TEST(PisteSurface, TakesItsGradientFromSlopesAlone) {
  EXPECT_TRUE(rc::check([] {
    const test::HeightOf cubic = *any_cubic();
    TraceWindows windows = test::scattered_windows(600, 3.0, 40.0, kFanHalfAngle_rad, cubic);
    for (float& z : windows.z) {
      z += static_cast<float>(*rc::gen::inRange(-10, 11));
    }
    const PisteSurface surface = fitted(windows, {.height_m = 1e6, .slope = 1e-4});
    for (const double x : {5.0, 15.0, 38.0}) {
      const double expected = (cubic(x + 1e-4, 2.0) - cubic(x - 1e-4, 2.0)) / 2e-4;
      RC_ASSERT(std::abs(surface.value(PisteSurface::slope_terms(x, 2.0, 1.0, 0.0)) - expected) < 1e-3);
    }
  }));
}

TEST(PisteSurface, LooksAtTheWindowsOfThePisteAlone) {
  const test::HeightOf piste = [](double x, double) { return 0.1 * x; };
  TraceWindows windows = test::scattered_windows(300, 3.0, 40.0, kFanHalfAngle_rad, piste);
  std::vector<std::uint8_t> is_piste(windows.size(), 1);
  for (std::size_t i = 0; i < windows.size(); i += 2) {
    windows.z[i] += 5.0F;
    windows.slope[i] -= 3.0F;
    is_piste[i] = 0;
  }
  PisteSurface surface;
  surface.fit(windows, is_piste, {}, {}, kExact);
  EXPECT_NEAR(surface.height_m(20.0F, 3.0F), 2.0, 1e-3);
}

TEST(PisteSurface, ComparesWindowsWithWhatItSaysOfTheirPlaces) {
  const PisteSurface surface =
      fitted(test::scattered_windows(300, 3.0, 40.0, kFanHalfAngle_rad,
                                     [](double x, double y) { return 1e-3 * x * x + 0.05 * y - 1e-5 * x * y * y; }));
  const TraceWindows others = test::scattered_windows(
      200, 3.0, 60.0, 3.1, [](double x, double y) { return std::sin(0.3 * x) + 0.1 * y; }, 2);
  std::vector<float> height(others.size());
  std::vector<float> slope(others.size());
  surface.compare(others, height, slope);
  for (std::size_t i = 0; i < others.size(); ++i) {
    const double z = surface.value(PisteSurface::height_terms(double{others.x[i]}, double{others.y[i]}));
    EXPECT_NEAR(height[i], std::abs(double{others.z[i]} - z), 1e-4);
    const double rise = surface.value(PisteSurface::slope_terms(double{others.x[i]}, double{others.y[i]},
                                                                double{others.along_x[i]}, double{others.along_y[i]}));
    EXPECT_NEAR(slope[i], std::abs(double{others.slope[i]} - rise), 1e-4);
  }
}

TEST(PisteSurface, GivesLessWeightToWhatTheLastOneMissed) {
  TraceWindows windows = test::scattered_windows(600, 3.0, 40.0, kFanHalfAngle_rad, [](double, double) { return 0.0; });
  for (std::size_t i = 0; i < windows.size(); i += 5) {
    windows.z[i] += 0.8F;
    windows.slope[i] += 0.8F;
  }
  const std::vector<std::uint8_t> all(windows.size(), 1);
  const PisteSurface::Noise noise;
  const auto worst = [](const PisteSurface& surface) {
    float most = 0.0F;
    for (const float x : {5.0F, 10.0F, 20.0F, 35.0F}) {
      most = std::max(most, std::abs(surface.height_m(x, 0.0F)));
    }
    return most;
  };
  PisteSurface surface;
  surface.fit(windows, all, {}, {}, noise);
  const float first = worst(surface);
  EXPECT_GT(first, 0.1F);
  std::vector<float> height(windows.size());
  std::vector<float> slope(windows.size());
  surface.compare(windows, height, slope);
  surface.fit(windows, all, height, slope, noise);
  EXPECT_LT(worst(surface), 0.5F * first);
}

TEST(PisteSurface, GivesLessWeightToSlopesThatTheLastOneMissed) {
  TraceWindows windows = test::scattered_windows(600, 3.0, 40.0, kFanHalfAngle_rad, [](double, double) { return 0.0; });
  for (std::size_t i = 0; i < windows.size(); i += 5) {
    windows.slope[i] += windows.along_x[i] > 0.0F ? 0.8F : -0.8F;
  }
  const std::vector<std::uint8_t> all(windows.size(), 1);
  const PisteSurface::Noise noise{.height_m = 1e3, .slope = 0.06};  // heights say nothing
  const auto slope_of = [](const PisteSurface& surface) {
    return surface.value(PisteSurface::slope_terms(15.0, 0.0, 1.0, 0.0));
  };
  PisteSurface surface;
  surface.fit(windows, all, {}, {}, noise);
  const double first = slope_of(surface);
  EXPECT_GT(first, 0.1);
  std::vector<float> height(windows.size());
  std::vector<float> slope(windows.size());
  surface.compare(windows, height, slope);
  surface.fit(windows, all, height, slope, noise);
  EXPECT_LT(slope_of(surface), 0.5 * first);
}

/// What one observation weighs, from what it does to the variance of the very combination that it observes:
/// 1/after = 1/before + weight.
double weight_of(const TraceWindows& windows, std::size_t i, const PisteSurface::Noise& noise, const Terms& terms) {
  TraceWindows one;
  test::add_window(one, {}, [](double, double) { return 0.0; });
  for (const auto& [to, from] :
       {std::pair{&one.x, &windows.x}, std::pair{&one.y, &windows.y}, std::pair{&one.along_x, &windows.along_x},
        std::pair{&one.along_y, &windows.along_y}, std::pair{&one.length_m, &windows.length_m},
        std::pair{&one.range_m, &windows.range_m}}) {
    (*to)[0] = (*from)[i];
  }
  return 1.0 / fitted(one, noise).variance(terms) - 1.0 / PisteSurface().variance(terms);
}

/// The same fit, straight from the definition.
struct PlainFit {
  Eigen::Matrix<double, PisteSurface::kTerms, PisteSurface::kTerms> information;
  Terms right = Terms::Zero();

  PlainFit() {
    information.setZero();
    for (int i = 0; i < PisteSurface::kTerms; ++i) {
      information(i, i) = 1.0 / PisteSurface().variance(Terms::Unit(i));
    }
  }
  void observe(const Terms& terms, double value, double weight) {
    information += weight * terms * terms.transpose();
    right += weight * value * terms;
  }
};

/// The moments that the fit collects are another way to write the sums of outer products.
TEST(PisteSurface, IsThePlainSolutionOfTheNormalEquations) {
  constexpr double kNever = 1e9;
  EXPECT_TRUE(rc::check([] {
    const PisteSurface::Noise noise{.height_m = *rc::gen::inRange(1, 100) * 1e-3,
                                    .slope = *rc::gen::inRange(1, 100) * 1e-3};
    TraceWindows windows = test::scattered_windows(
        *rc::gen::inRange(1, 200), 2.0, 50.0, *rc::gen::inRange(1, 32) * 0.1,
        [](double x, double y) { return std::sin(0.2 * x + 0.1 * y); }, *rc::gen::arbitrary<unsigned>());
    PlainFit plain;
    for (std::size_t i = 0; i < windows.size(); ++i) {
      windows.length_m[i] = static_cast<float>(*rc::gen::inRange(1, 20)) * 0.1F;
      const Terms height = PisteSurface::height_terms(double{windows.x[i]}, double{windows.y[i]});
      const Terms slope = PisteSurface::slope_terms(double{windows.x[i]}, double{windows.y[i]},
                                                    double{windows.along_x[i]}, double{windows.along_y[i]});
      plain.observe(height, double{windows.z[i]}, weight_of(windows, i, {noise.height_m, kNever}, height));
      plain.observe(slope, double{windows.slope[i]}, weight_of(windows, i, {kNever, noise.slope}, slope));
    }
    const PisteSurface surface = fitted(windows, noise);
    const auto solver = plain.information.llt();
    const Terms solution = solver.solve(plain.right);
    const auto covariance = solver.solve(decltype(plain.information)::Identity()).eval();
    for (int r = 0; r < PisteSurface::kTerms; ++r) {
      const double sigma = std::sqrt(covariance(r, r));
      RC_ASSERT(std::abs(surface.value(Terms::Unit(r)) - solution[r]) < 1e-9 * std::max(sigma, std::abs(solution[r])));
      for (int c = 0; c <= r; ++c) {
        const Terms both = Terms::Unit(r) + Terms::Unit(c);
        const double expected = both.dot(covariance * both);
        RC_ASSERT(std::abs(surface.variance(both) - expected) < 1e-9 * expected);
      }
    }
  }));
}

/// The variance is what the estimate scatters by when the windows scatter as their weights say.
TEST(PisteSurface, ScattersByItsVariance) {
  const PisteSurface::Noise noise{.height_m = 0.02, .slope = 0.02};
  constexpr double kNever = 1e9;
  TraceWindows windows = test::scattered_windows(400, 3.0, 40.0, kFanHalfAngle_rad, [](double, double) { return 0.0; });
  std::vector<double> height_sigma;
  std::vector<double> slope_sigma;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const Terms height = PisteSurface::height_terms(double{windows.x[i]}, double{windows.y[i]});
    const Terms slope = PisteSurface::slope_terms(double{windows.x[i]}, double{windows.y[i]},
                                                  double{windows.along_x[i]}, double{windows.along_y[i]});
    height_sigma.push_back(1.0 / std::sqrt(weight_of(windows, i, {noise.height_m, kNever}, height)));
    slope_sigma.push_back(1.0 / std::sqrt(weight_of(windows, i, {kNever, noise.slope}, slope)));
  }
  const std::vector<Terms> asked = {PisteSurface::height_terms(10.0, 1.0), PisteSurface::height_terms(30.0, -8.0),
                                    PisteSurface::slope_terms(20.0, 0.0, 1.0, 0.0),
                                    PisteSurface::slope_terms(20.0, 0.0, 0.0, 1.0)};
  constexpr int kTrials = 1000;
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  std::vector<double> squares(asked.size(), 0.0);
  PisteSurface surface;
  for (int trial = 0; trial < kTrials; ++trial) {
    for (std::size_t i = 0; i < windows.size(); ++i) {
      windows.z[i] = static_cast<float>(height_sigma[i] * normal(random));
      windows.slope[i] = static_cast<float>(slope_sigma[i] * normal(random));
    }
    surface = fitted(windows, noise);
    for (std::size_t k = 0; k < asked.size(); ++k) {
      squares[k] += std::pow(surface.value(asked[k]), 2);
    }
  }
  for (std::size_t k = 0; k < asked.size(); ++k) {
    EXPECT_NEAR(squares[k] / kTrials / surface.variance(asked[k]), 1.0, 0.15) << k;
  }
}

TEST(PisteSurface, IsMoreCertainWhereMoreIsSeen) {
  const auto flat = [](double, double) { return 0.0; };
  const PisteSurface few = fitted(test::scattered_windows(50, 3.0, 20.0, kFanHalfAngle_rad, flat), {});
  const PisteSurface many = fitted(test::scattered_windows(500, 3.0, 20.0, kFanHalfAngle_rad, flat), {});
  const Terms near = PisteSurface::height_terms(10.0, 0.0);
  EXPECT_LT(many.variance(near), few.variance(near));
  EXPECT_LT(many.variance(near), many.variance(PisteSurface::height_terms(40.0, 0.0)));
  EXPECT_LT(few.variance(near), PisteSurface().variance(near));
}

TEST(PisteSurface, ForgetsWhenItIsReset) {
  PisteSurface surface = fitted(test::scattered_windows(50, 3.0, 20.0, 0.6, [](double x, double) { return 0.3 * x; }));
  const Terms height = PisteSurface::height_terms(10.0, 0.0);
  EXPECT_GT(surface.value(height), 2.0);
  surface.reset();
  EXPECT_EQ(surface.value(height), 0.0);
  EXPECT_EQ(surface.variance(height), PisteSurface().variance(height));
}

}  // namespace
}  // namespace berm
