#include "berm/eval/evaluate.hpp"

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "berm/core/error.hpp"
#include "berm/io/label_file.hpp"
#include "support/made_recording.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

namespace fs = std::filesystem;
using Labels = std::vector<std::uint32_t>;
using nlohmann::json;

constexpr const char* kRunFile = R"({"schema": "berm.run/1", "stages": {"read": {}, "ground": {}, "write": {}}})";

class EvaluateTest : public testing::Test {
 protected:
  void SetUp() override {
    test::make_recording(recording_, 3, 4);
    fs::create_directories(recording_ / "labels");
    fs::create_directories(run_ / "labels");
    test::spill(run_ / "run.json", kRunFile);
  }

  void put_truth(const std::string& name, const Labels& labels) const {
    write_labels(recording_ / "labels" / (name + ".label"), labels);
  }
  void put_output(const std::string& name, const Labels& labels) const {
    write_labels(run_ / "labels" / (name + ".label"), labels);
  }
  [[nodiscard]] Evaluation evaluate_all(bool per_scan = false) const {
    return evaluate(run_, Recording::open(recording_), per_scan);
  }

  test::TempFolder folder_;
  fs::path recording_ = folder_ / "recording";
  fs::path run_ = folder_ / "run";
};

TEST_F(EvaluateTest, PoolsTheCountsOfScansMatchedByName) {
  put_truth("000000", {40, 40, 50, 0});
  put_truth("000002", {72, 50, 50, 50});
  put_output("000000", {40, 99, 40, 40});
  put_output("000001", {40, 40, 40, 40});
  put_output("000002", {40, 99, 99, 99});
  const Evaluation evaluation = evaluate_all(true);
  EXPECT_EQ(evaluation.scans_judged, 2U);
  EXPECT_EQ(evaluation.scans_without_truth, 1U);
  EXPECT_EQ(*evaluation.labels.ground, (BinaryCounts{2, 1, 1, 3, 1}));
  ASSERT_EQ(evaluation.scans.size(), 2U);
  EXPECT_EQ(evaluation.scans[1].name, "000002");
  EXPECT_EQ(*evaluation.scans[1].labels.ground, (BinaryCounts{1, 0, 0, 3, 0}));
  EXPECT_TRUE(evaluation.is_whole());
}

TEST_F(EvaluateTest, LabelsOfAnotherLengthAreCountedNotJudged) {
  put_truth("000000", {40, 40, 50});
  put_output("000000", {40, 40, 99, 99});
  put_truth("000001", {40, 40, 40, 40, 40});
  put_output("000001", {40, 40, 40, 40, 40});  // both agree, but not with the scan
  put_truth("000002", {40, 40, 40, 50});
  put_output("000002", {40, 40, 40, 99});
  const Evaluation evaluation = evaluate_all();
  EXPECT_EQ(evaluation.scans_judged, 1U);
  ASSERT_EQ(evaluation.failed.size(), 2U);
  EXPECT_EQ(evaluation.failed[0].name, "000000");
  EXPECT_EQ(evaluation.failed[1].name, "000001");
  EXPECT_EQ(*evaluation.labels.ground, (BinaryCounts{3, 0, 0, 1, 0}));
  EXPECT_FALSE(evaluation.is_whole());
}

TEST_F(EvaluateTest, SaysWhyAMetricIsLeftOut) {
  put_truth("000000", {44, 48, 50, 0});
  put_output("000000", {40, 40, 99, 0});
  const Evaluation evaluation = evaluate_all();
  EXPECT_FALSE(evaluation.labels.piste.has_value());
  EXPECT_FALSE(evaluation.labels.snow.has_value());
  EXPECT_FALSE(evaluation.trajectory.has_value());
  for (const char* metric : {"piste", "snow", "trajectory", "edges"}) {
    EXPECT_TRUE(evaluation.left_out.contains(metric)) << metric;
  }
  EXPECT_FALSE(evaluation.left_out.contains("ground"));
}

TEST_F(EvaluateTest, WithoutTruthEverythingIsLeftOut) {
  put_output("000000", {40, 40, 99, 0});
  const Evaluation evaluation = evaluate_all();
  EXPECT_EQ(evaluation.scans_judged, 0U);
  EXPECT_FALSE(evaluation.labels.ground.has_value());
  EXPECT_EQ(evaluation.left_out.size(), 5U);
}

TEST_F(EvaluateTest, PisteAndSnowAreJudgedWhereBothSidesSpeakOfThem) {
  put_truth("000000", {40, 72, 110, 0});
  put_output("000000", {40, 72, 110, 0});
  const Evaluation evaluation = evaluate_all();
  EXPECT_EQ(*evaluation.labels.piste, (BinaryCounts{1, 0, 0, 1, 2}));
  EXPECT_EQ(*evaluation.labels.snow, (BinaryCounts{1, 0, 0, 3, 0}));
}

TEST_F(EvaluateTest, ARunWithoutRunFileIsNotWhole) {
  fs::remove(run_ / "run.json");
  put_truth("000000", {40, 40, 50, 0});
  put_output("000000", {40, 40, 99, 0});
  const Evaluation evaluation = evaluate_all();
  EXPECT_TRUE(evaluation.labels.ground.has_value());
  EXPECT_FALSE(evaluation.is_whole());
}

TEST_F(EvaluateTest, RefusesFoldersThatHoldNoRun) {
  fs::remove_all(run_ / "labels");
  EXPECT_THROW(static_cast<void>(evaluate_all()), FileError);
}

TEST_F(EvaluateTest, RefusesARunFileThatIsNone) {
  for (const char* text : {"", "[]", "{", "{\"stages\": 3}", "nonsense"}) {
    test::spill(run_ / "run.json", text);
    EXPECT_THROW(static_cast<void>(evaluate_all()), FileError) << text;
  }
}

TEST_F(EvaluateTest, MeasuresTheTrajectory) {
  std::string truth;
  std::string output;
  for (int i = 0; i < 40; ++i) {
    truth += std::to_string(i) + " " + std::to_string(i) + " 0 0 0 0 0 1\n";
    output += std::to_string(i) + " " + std::to_string(1.1 * i) + " 0 0 0 0 0 1\n";
  }
  test::spill(recording_ / "truth.tum", truth);
  test::spill(run_ / "trajectory.tum", output);
  const Evaluation evaluation = evaluate_all();
  ASSERT_TRUE(evaluation.trajectory.has_value());
  EXPECT_EQ(evaluation.trajectory->poses, 40U);
  EXPECT_NEAR(evaluation.trajectory->path_m, 39.0, 1e-9);
  EXPECT_EQ(evaluation.trajectory->relative.size(), 2U);
  EXPECT_NEAR(evaluation.trajectory->relative[0].translation_percent, 10.0, 1e-6);
}

TEST_F(EvaluateTest, IsOneJsonObject) {
  put_truth("000000", {40, 40, 50, 0});
  put_output("000000", {40, 99, 99, 0});
  const json object = json::parse(to_json(evaluate_all(true), run_, Recording::open(recording_)));
  EXPECT_EQ(object["schema_version"], 1);
  EXPECT_DOUBLE_EQ(object["ground"]["precision"], 1.0);
  EXPECT_DOUBLE_EQ(object["ground"]["recall"], 0.5);
  EXPECT_DOUBLE_EQ(object["ground"]["iou"], 0.5);
  EXPECT_NEAR(object["ground"]["f1"], 2.0 / 3.0, 1e-12);
  EXPECT_EQ(object["scans"]["judged"], 1);
  EXPECT_EQ(object["per_scan"][0]["scan"], "000000");
  EXPECT_FALSE(object.contains("piste"));
  EXPECT_TRUE(object["left_out"].contains("piste"));
}

/// A run along x for 60 m with an edge 5 m to the left, and truth beside it.
class EvaluateEdgesTest : public EvaluateTest {
 protected:
  void SetUp() override {
    EvaluateTest::SetUp();
    test::spill(recording_ / "edges.csv",
                "side,x,y,z\nleft,-100,5,0\nleft,200,5,0\n\nright,-100,-5,0\nright,200,-5,0\n");
    test::spill(run_ / "edges.csv", "line,side,x,y,z,confidence\n0,left,0,5.1,0,0.9\n0,left,60,5.1,0,0.9\n");
    test::spill(run_ / "trajectory.tum", poses(0.0));
  }
  [[nodiscard]] static std::string poses(double y_m) {
    std::string text;
    for (int i = 0; i <= 60; ++i) {
      text += std::to_string(i) + " " + std::to_string(i) + " " + std::to_string(y_m) + " 0 0 0 0 1\n";
    }
    return text;
  }
};

TEST_F(EvaluateEdgesTest, JudgesTheLinesOfTheRunByTruthNearItsPath) {
  for (const bool has_truth : {false, true}) {
    if (has_truth) {
      test::spill(recording_ / "truth.tum", poses(0.2));
    }
    const Evaluation evaluation = evaluate_all();
    ASSERT_TRUE(evaluation.edges) << evaluation.left_out.at("edges");
    EXPECT_EQ(evaluation.edges->precision, 1.0);
    EXPECT_NEAR(*evaluation.edges->recall, 0.29, 0.03) << "60 m of one side of 109 m of two";
    EXPECT_NEAR(*evaluation.edges->lateral_median_m, 0.1, 1e-6);
    EXPECT_EQ(evaluation.edges->wrong_side_share, 0.0);
    const json object = json::parse(to_json(evaluation, run_, Recording::open(recording_)));
    EXPECT_EQ(object["edges"]["precision"], 1.0);
    EXPECT_EQ(object["edges"]["places"]["found"], evaluation.edges->found);
    EXPECT_FALSE(object["left_out"].contains("edges"));
  }
}

TEST_F(EvaluateEdgesTest, SaysWhyEdgesAreLeftOut) {
  const auto reason = [this] { return evaluate_all().left_out.at("edges"); };
  test::spill(recording_ / "truth.tum", poses(80.0));
  EXPECT_NE(reason().find("another world frame"), std::string::npos);
  fs::remove(recording_ / "truth.tum");
  fs::remove(run_ / "trajectory.tum");
  EXPECT_NE(reason().find("says where the machine was"), std::string::npos);
  fs::remove(recording_ / "edges.csv");
  EXPECT_EQ(reason(), "the recording has no edges.csv");
  fs::remove(run_ / "edges.csv");
  EXPECT_EQ(reason(), "the run has no edges.csv");
}

TEST_F(EvaluateEdgesTest, ABrokenFileIsAnError) {
  test::spill(run_ / "edges.csv", "line,side,x,y,z,confidence\n0,left,nan,5.1,0,0.9\n");
  EXPECT_THROW(static_cast<void>(evaluate_all()), FileError);
}

}  // namespace
}  // namespace berm
