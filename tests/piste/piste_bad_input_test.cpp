// Both methods on scans that go wrong on real machines, behind the stages that come before them. Whatever arrives:
// no crash, no label that the contract does not allow, and the same again when it arrives again.

#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "berm/ground/polar_ground.hpp"
#include "berm/ground/terrain_ground.hpp"
#include "berm/piste/boundary_piste.hpp"
#include "berm/piste/envelope_piste.hpp"
#include "berm/snow/box_snow.hpp"
#include "berm/snow/repair.hpp"
#include "berm/snow/sparse_snow.hpp"
#include "piste/bad_scans.hpp"
#include "piste/mid70_scan.hpp"

namespace berm {
namespace {

enum class Methods : std::uint8_t { by_default, reference };

std::unique_ptr<PisteSegmenter> make_piste(Methods methods) {
  if (methods == Methods::reference) {
    return std::make_unique<EnvelopePiste>(EnvelopePisteConfig{});
  }
  return std::make_unique<BoundaryPiste>(BoundaryPisteConfig{});
}

/// The stages before the piste, with the default methods or those of the papers (which give no surface).
class Earlier {
 public:
  explicit Earlier(Methods methods) {
    if (methods == Methods::reference) {
      snow_ = std::make_unique<BoxSnow>(BoxSnowConfig{});
      ground_ = std::make_unique<PolarGround>(PolarGroundConfig{});
    } else {
      snow_ = std::make_unique<SparseSnow>(SparseSnowConfig{});
      ground_ = std::make_unique<TerrainGround>(TerrainGroundConfig{});
    }
  }

  PisteInput process(const PointsView& points, const Pose& T_base_sensor) {
    const SnowResult snow = snow_->process(points, T_base_sensor);
    const GroundResult ground = ground_->process(without_flakes(points, snow), T_base_sensor);
    labels_.clear();
    for (std::size_t i = 0; i < points.size(); ++i) {
      labels_.push_back(snow.falling[i] != 0 ? Label::falling_snow : label_of(ground.classes[i]));
    }
    return {.points = points,
            .labels = labels_,
            .series = repair_.process(points, snow.falling),
            .surface = ground.surface,
            .T_base_sensor = T_base_sensor};
  }

 private:
  PointsView without_flakes(const PointsView& points, const SnowResult& snow) {
    kept_x_.assign(points.x.begin(), points.x.end());
    kept_y_.assign(points.y.begin(), points.y.end());
    kept_z_.assign(points.z.begin(), points.z.end());
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (snow.falling[i] != 0) {
        kept_x_[i] = kept_y_[i] = kept_z_[i] = 0.0F;
      }
    }
    PointsView kept = points;
    kept.x = kept_x_;
    kept.y = kept_y_;
    kept.z = kept_z_;
    return kept;
  }

  std::unique_ptr<SnowFilter> snow_;
  std::unique_ptr<GroundSegmenter> ground_;
  SeriesRepair repair_;
  std::vector<float> kept_x_;
  std::vector<float> kept_y_;
  std::vector<float> kept_z_;
  std::vector<Label> labels_;
};

using Counts = std::array<std::size_t, 6>;

Counts count(std::span<const Label> labels) {
  Counts counts{};
  for (const Label label : labels) {
    ++counts.at(static_cast<std::size_t>(label));
  }
  return counts;
}

std::size_t of(const Counts& counts, Label label) {
  return counts.at(static_cast<std::size_t>(label));
}

/// What is no return stays what it is, and every return becomes drivable, terrain or obstacle.
void expect_labels_sound(const PisteInput& input, const PisteResult& result) {
  ASSERT_EQ(result.labels.size(), input.points.size());
  for (std::size_t i = 0; i < result.labels.size(); ++i) {
    const Label before = input.labels[i];
    const Label after = result.labels[i];
    if (before == Label::drivable || before == Label::obstacle) {
      ASSERT_TRUE(after == Label::drivable || after == Label::terrain || after == Label::obstacle) << "point " << i;
    } else {
      ASSERT_EQ(after, before) << "point " << i;
    }
  }
  const Counts before = count(input.labels);
  const Counts after = count(result.labels);
  for (const Label kept : {Label::unlabeled, Label::no_return, Label::falling_snow}) {
    EXPECT_EQ(of(after, kept), of(before, kept));
  }
  EXPECT_EQ(of(after, Label::drivable) + of(after, Label::terrain) + of(after, Label::obstacle),
            of(before, Label::drivable) + of(before, Label::obstacle));
}

void expect_boundary_sound(std::span<const BoundaryPoint> boundary) {
  for (const BoundaryPoint& point : boundary) {
    EXPECT_TRUE(std::isfinite(point.x_m) && std::isfinite(point.y_m) && std::isfinite(point.z_m));
    EXPECT_GE(point.confidence, 0.0F);
    EXPECT_LE(point.confidence, 1.0F);
  }
}

void expect_figures_sound(const PisteResult& result) {
  if (result.slope) {
    EXPECT_TRUE(std::isfinite(result.slope->slope_rad));
    EXPECT_GE(result.slope->slope_sigma_rad, 0.0);
    EXPECT_TRUE(std::isfinite(result.slope->slope_sigma_rad));
    EXPECT_TRUE(std::isfinite(result.slope->cross_fall_rad.value_or(0.0)));
    EXPECT_GE(result.slope->cross_fall_sigma_rad, 0.0);
  }
  if (result.obstacle_ahead_m) {
    EXPECT_TRUE(std::isfinite(*result.obstacle_ahead_m));
    EXPECT_GE(*result.obstacle_ahead_m, 0.0);
  }
  expect_boundary_sound(result.left);
  expect_boundary_sound(result.right);
  EXPECT_TRUE(result.steps.empty() || result.steps.size() == result.labels.size());
  for (const Envelope& envelope : result.envelopes) {
    EXPECT_LE(envelope.first, envelope.last);
    EXPECT_LT(envelope.last, result.labels.size());
  }
}

const std::vector<test::BadScan>& scans() {
  static const std::vector<test::BadScan> all = test::bad_scans();
  return all;
}

/// The methods before the piste, the method of the piste.
class PisteOnBadInput : public testing::TestWithParam<std::tuple<Methods, Methods>> {};

TEST_P(PisteOnBadInput, KeepsItsContract) {
  const auto& [earlier_methods, piste_methods] = GetParam();
  for (const test::BadScan& scan : scans()) {
    SCOPED_TRACE(scan.name);
    Earlier earlier(earlier_methods);
    const std::unique_ptr<PisteSegmenter> piste = make_piste(piste_methods);
    const PisteInput input = earlier.process(scan.cloud.view(), test::groomer_mount());
    const PisteResult result = piste->process(input);
    expect_labels_sound(input, result);
    expect_figures_sound(result);
  }
}

TEST_P(PisteOnBadInput, LeavesNothingBehind) {
  const auto& [earlier_methods, piste_methods] = GetParam();
  Earlier earlier(earlier_methods);
  const std::unique_ptr<PisteSegmenter> piste = make_piste(piste_methods);
  const auto labels_of = [&](const PointsView& points) {
    const std::span<const Label> labels = piste->process(earlier.process(points, test::groomer_mount())).labels;
    return std::vector<Label>(labels.begin(), labels.end());
  };
  const PointsView good = scans().front().cloud.view();
  const std::vector<Label> before = labels_of(good);
  for (const test::BadScan& scan : scans()) {
    SCOPED_TRACE(scan.name);
    (void)labels_of(scan.cloud.view());
    EXPECT_TRUE(labels_of(good) == before);
  }
}

std::string name_of(const testing::TestParamInfo<PisteOnBadInput::ParamType>& info) {
  const auto& [earlier, piste] = info.param;
  return std::string(earlier == Methods::reference ? "AfterReferences" : "AfterDefaults") +
         (piste == Methods::reference ? "Reference" : "Default");
}

INSTANTIATE_TEST_SUITE_P(AllScans, PisteOnBadInput,
                         testing::Combine(testing::Values(Methods::by_default, Methods::reference),
                                          testing::Values(Methods::by_default, Methods::reference)),
                         name_of);

/// The cases are what their names say.
TEST(BadScans, HaveSomethingToFind) {
  Earlier earlier(Methods::by_default);
  const auto counts_of = [&earlier](const std::string& name) {
    for (const test::BadScan& scan : scans()) {
      if (scan.name == name) {
        return count(earlier.process(scan.cloud.view(), test::groomer_mount()).labels);
      }
    }
    ADD_FAILURE() << "no scan " << name;
    return Counts{};
  };
  EXPECT_GT(of(counts_of("as_it_should_be"), Label::drivable), 5000U);
  EXPECT_GT(of(counts_of("as_it_should_be"), Label::no_return), 1000U);
  EXPECT_EQ(of(counts_of("no_returns_dropped"), Label::no_return), 0U);
  EXPECT_GT(of(counts_of("much_nan"), Label::unlabeled), 500U);
  EXPECT_GT(of(counts_of("flakes_60_percent"), Label::falling_snow), 4000U);
  EXPECT_EQ(of(counts_of("nothing_but_no_returns"), Label::no_return), 10000U);
  EXPECT_EQ(of(counts_of("nothing_but_nan"), Label::unlabeled), 10000U);
}

}  // namespace
}  // namespace berm
