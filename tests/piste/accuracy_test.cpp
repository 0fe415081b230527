#include <cstddef>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "berm/eval/label_metrics.hpp"
#include "berm/pipeline/pipeline.hpp"
#include "support/chain_score.hpp"
#include "support/simulated_run.hpp"

// The bars of the accuracy on two seconds of three runs; berm_piste_accuracy shows many more.

namespace berm::test {
namespace {

constexpr double kLeastAccuracy = 0.96;
constexpr double kLeastSnowF1 = 0.97;

const RunPlan kSteep{.name = "steep",
                     .scenario = "groomer_clear",
                     .settings = {"route.min_gradient_deg=30", "route.max_gradient_deg=34"},
                     .seed = 14,
                     .seconds = 2.0};
const RunPlan kFlakes{.name = "flakes",
                      .scenario = "groomer_snowfall",
                      .settings = {"snowfall.flakes_per_m3=330"},
                      .seed = 22,
                      .seconds = 2.0};
const RunPlan kBend{
    .name = "bend",
    .scenario = "groomer_clear",
    .settings = {"route.bend_deg=100", "route.bend_every_m=35", "route.min_radius_m=30", "piste.max_width_m=22"},
    .seed = 15,
    .seconds = 2.0};

SimulatedRun simulated(const RunPlan& plan) {
  return simulate_run(plan, {.scenarios = BERM_SCENARIOS, .sensors = BERM_SENSORS});
}

const std::vector<Method>& methods() {
  static const std::vector<Method> kMethods = {
      {.name = "default", .front = {}, .piste = "default", .config = {}},
      {.name = "baseline: all ground is piste", .front = {}, .piste = "none", .config = {}},
      {.name = "reference", .front = {.snow = "reference"}, .piste = "reference", .config = {}}};
  return kMethods;
}

/// The default reaches the bar, and is better than the baseline and the reference.
void hold_accuracy(const std::vector<Score>& scores) {
  std::vector<double> accuracy;
  accuracy.reserve(scores.size());
  for (const Score& score : scores) {
    accuracy.push_back(derive_metrics(score.piste).accuracy.value());
  }
  EXPECT_GE(accuracy[0], kLeastAccuracy);
  for (std::size_t i = 1; i < accuracy.size(); ++i) {
    EXPECT_GT(accuracy[0], accuracy[i]) << methods()[i].name;
  }
}

TEST(PisteAccuracy, OnASteepSlopeInClearAir) {
  const SimulatedRun run = simulated(kSteep);
  ASSERT_EQ(run.scans.size(), 20U);
  EXPECT_GT(run.max_slope_deg, 28.0);
  const std::vector<Score> scores = score_methods(methods(), run.scans);
  hold_accuracy(scores);
  EXPECT_LT(static_cast<double>(scores[0].snow.false_positive), 5e-4 * static_cast<double>(scores[0].snow.judged()));
}

TEST(PisteAccuracy, WhereEveryEighthBeamMeetsAFlake) {
  const SimulatedRun run = simulated(kFlakes);
  const std::vector<Score> scores = score_methods(methods(), run.scans);
  hold_accuracy(scores);
  const double flakes = static_cast<double>(scores[0].snow.true_positive + scores[0].snow.false_negative);
  EXPECT_GT(flakes, 0.08 * 20.0 * 10000.0);
  EXPECT_GE(derive_metrics(scores[0].snow).f1.value(), kLeastSnowF1);
}

TEST(PisteAccuracy, InABend) {
  const SimulatedRun run = simulated(kBend);
  hold_accuracy(score_methods(methods(), run.scans));
}

/// What is measured stage by stage is what the chain as a whole says.
TEST(PisteAccuracy, IsThatOfTheWholeChain) {
  RunPlan plan = kFlakes;
  plan.seconds = 0.3;
  const SimulatedRun run = simulated(plan);
  const std::vector<Score> scores = score_methods(methods(), run.scans);
  for (std::size_t i = 0; i < methods().size(); ++i) {
    Pipeline pipeline(machine_of(methods()[i]));
    Score whole;
    for (const LabelledScan& scan : run.scans) {
      whole += score_labels(pipeline.process(scan.scan).labels, scan);
    }
    EXPECT_EQ(whole.piste, scores[i].piste) << methods()[i].name;
    EXPECT_EQ(whole.snow, scores[i].snow) << methods()[i].name;
  }
}

}  // namespace
}  // namespace berm::test
