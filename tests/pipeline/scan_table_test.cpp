#include "scan_table.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "berm/core/angle.hpp"
#include "support/temp_folder.hpp"

namespace berm {
namespace {

TEST(CsvField, IsQuotedWhereItHasToBe) {
  EXPECT_EQ(csv_field("000012"), "000012");
  EXPECT_EQ(csv_field("a b"), "a b");
  EXPECT_EQ(csv_field("a,b"), "\"a,b\"");
  EXPECT_EQ(csv_field("say \"hi\""), "\"say \"\"hi\"\"\"");
  EXPECT_EQ(csv_field("two\nlines"), "\"two\nlines\"");
}

TEST(ScanTable, LeavesOutWhatIsNotKnown) {
  const test::TempFolder folder;
  ScanFigures figures;
  figures.counts = {.drivable = 4, .terrain = 3, .obstacle = 2, .falling_snow = 1, .no_return = 6, .invalid = 5};
  ScanTable table(folder / "scans.csv");
  table.add("000000", -1'500'000'000, figures);
  figures.slope = SlopeAhead{.slope_rad = -10.0 * kRadPerDeg, .slope_sigma_rad = 0.5 * kRadPerDeg};
  figures.obstacle_ahead_m = 12.3456;
  figures.ground_tilt_rad = 2.0 * kRadPerDeg;
  figures.left_vertices = 7;
  figures.right_edge_m = 5.25;
  figures.edge_points = 3;
  figures.degraded.add(Degradation::no_time);
  figures.degraded.add(Degradation::no_intensity);
  table.add("a,b", 12'000'000'345, figures);
  figures.slope->cross_fall_rad = 3.0 * kRadPerDeg;
  figures.slope->cross_fall_sigma_rad = 1.0 * kRadPerDeg;
  table.add("c", 0, figures);
  EXPECT_FALSE(std::filesystem::exists(folder / "scans.csv")) << "not before it is whole";
  table.commit();
  EXPECT_EQ(
      test::slurp(folder / "scans.csv"),
      "scan,stamp,points,returns,no_return,invalid,falling_snow,drivable,terrain,obstacle,slope_deg,"
      "slope_sigma_deg,cross_fall_deg,cross_fall_sigma_deg,obstacle_ahead_m,left_vertices,right_vertices,"
      "left_edge_m,right_edge_m,edge_points,ground_tilt_deg,degraded\n"
      "000000,-1.500000000,21,10,6,5,1,4,3,2,,,,,,0,0,,,0,,\n"
      "\"a,b\",12.000000345,21,10,6,5,1,4,3,2,-10.000,0.500,,,12.346,7,0,,5.250,3,2.000,no_intensity+no_time\n"
      "c,0.000000000,21,10,6,5,1,4,3,2,-10.000,0.500,3.000,1.000,12.346,7,0,,5.250,3,2.000,no_intensity+no_time\n");
}

TEST(BoundaryTable, LeftBeforeRight) {
  const test::TempFolder folder;
  BoundaryTable table(folder / "boundary.csv");
  const std::vector<BoundaryPoint> left = {{1.0F, 5.0F, 0.1F, 0.5F}, {2.0F, 5.25F, -0.2F, 1.0F}};
  const std::vector<BoundaryPoint> right = {{1.5F, -4.0F, 0.0F, 0.25F}};
  table.add("000000", {}, {});
  table.add("000001", left, right);
  table.commit();
  EXPECT_EQ(test::slurp(folder / "boundary.csv"),
            "scan,side,x,y,z,confidence\n"
            "000001,left,1.000,5.000,0.100,0.50\n"
            "000001,left,2.000,5.250,-0.200,1.00\n"
            "000001,right,1.500,-4.000,0.000,0.25\n");
}

TEST(EdgePointTable, HoldsPointsInTheFrameOfTheBase) {
  const test::TempFolder folder;
  EdgePointTable table(folder / "edge_points.csv");
  const std::vector<EdgePoint> points = {
      {.x_m = 3.0F, .y_m = 4.0F, .z_m = -4.0F, .time_s = 0.05F, .confidence = 0.5F, .height_m = 1.0F, .width_m = 2.0F},
      {.x_m = 1.0F, .y_m = -2.0F, .z_m = -5.0F, .side = EdgeSide::right, .kind = EdgeKind::drop}};
  const Pose mount(Eigen::Quaterniond::Identity(), {1.0, 0.0, 4.0});
  table.add("000001", points, mount);
  table.commit();
  EXPECT_EQ(test::slurp(folder / "edge_points.csv"),
            "scan,side,kind,x,y,z,time,confidence,height,width\n"
            "000001,left,rise,4.000,4.000,0.000,0.050000,0.50,1.00,2.00\n"
            "000001,right,drop,2.000,-2.000,-1.000,0.000000,0.00,0.00,0.00\n");
  ScanResult result;
  result.edge.edges = points;
  const ScanFigures figures = figures_of(result, mount);
  EXPECT_NEAR(figures.left_edge_m.value(), std::sqrt(32.0), 1e-6);
  EXPECT_NEAR(figures.right_edge_m.value(), std::sqrt(8.0), 1e-6);
  EXPECT_EQ(figures.edge_points, 2U);
}

}  // namespace
}  // namespace berm
