#include "berm/map/road_survey.hpp"

#include <cmath>
#include <cstddef>
#include <utility>

#include "berm/core/angle.hpp"
#include "road_crossings.hpp"
#include "road_path.hpp"
#include "road_sides.hpp"
#include "road_sightings.hpp"
#include "road_surface_fit.hpp"

namespace berm {
namespace {

constexpr double kSure = 2.0;  // standard deviations
constexpr double kPercent = 100.0;

/// Whether `measure` is at least `limit`.
RuleVerdict judge_least(const std::optional<Measure>& measure, double limit) {
  if (!measure || !(limit > 0.0)) {
    return RuleVerdict::unknown;
  }
  const double over = measure->value - limit;
  if (std::abs(over) < kSure * measure->sigma) {
    return RuleVerdict::uncertain;
  }
  return over >= 0.0 ? RuleVerdict::holds : RuleVerdict::broken;
}

/// Whether `measure` is no steeper than `limit`, up or down.
RuleVerdict judge_grade(const std::optional<Measure>& measure, double limit) {
  if (!measure) {
    return RuleVerdict::unknown;
  }
  const double over = std::abs(measure->value) - limit;
  if (std::abs(over) < kSure * measure->sigma) {
    return RuleVerdict::uncertain;
  }
  return over <= 0.0 ? RuleVerdict::holds : RuleVerdict::broken;
}

/// What edges are wrong by is alike on both sides: a toe that is found too early makes both nearer. Hence the sum, not
/// the root of squares.
double width_sigma_m(double left_sigma_m, double right_sigma_m) {
  return left_sigma_m + right_sigma_m;
}

void judge(const RoadConfig& config, RoadStation& station) {
  const double least_berm_m = config.tyre_height_m * config.min_berm_tyres;
  station.left.berm_rule = judge_least(station.left.berm_height_m, least_berm_m);
  station.right.berm_rule = judge_least(station.right.berm_height_m, least_berm_m);
  station.width_rule = judge_least(station.width_m, config.vehicle_width_m * config.min_width_vehicles);
  station.grade_rule = judge_grade(station.grade, config.max_grade_percent / kPercent);
}

const RoadConfig& checked(const RoadConfig& config, const PoseGuardConfig& guard) {
  config.check();
  guard.check();
  return config;
}

}  // namespace

struct RoadSurvey::State {
  RoadConfig config;
  RoadSightings seen;
};

RoadSurvey::RoadSurvey(const RoadConfig& config, const Trajectory& path, const PoseGuardConfig& guard)
    : state_(
          std::make_unique<State>(State{checked(config, guard), RoadSightings(lay_places(path, guard, config.spacing_m),
                                                                              config.spacing_m, config.reach_m)})) {}

RoadSurvey::~RoadSurvey() = default;
RoadSurvey::RoadSurvey(RoadSurvey&&) noexcept = default;
RoadSurvey& RoadSurvey::operator=(RoadSurvey&&) noexcept = default;

void RoadSurvey::add_scan(Stamp stamp_ns, std::span<const SurveyedEdge> edges,
                          std::span<const Eigen::Vector3d> ground_m, std::span<const Eigen::Vector3d> raised_m) {
  state_->seen.add_scan(stamp_ns, edges, ground_m, raised_m);
}

std::vector<RoadStation> RoadSurvey::stations(std::span<const EdgeLine> lines) const {
  const RoadSightings& seen = state_->seen;
  const RoadEdgeIndex index(lines);
  std::vector<RoadCrossings> crossings;
  crossings.reserve(seen.places().size());
  for (const RoadPlace& place : seen.places()) {
    crossings.push_back(index.find(place, state_->config.reach_m));
  }
  const std::vector<RoadSlopes> slopes =
      measure_slopes(seen, crossings, std::tan(state_->config.attitude_sigma_deg * kRadPerDeg));
  std::vector<RoadStation> stations(seen.places().size());
  for (std::size_t i = 0; i < stations.size(); ++i) {
    const RoadPlace& place = seen.places()[i];
    RoadStation& station = stations[i];
    station.piece = place.piece;
    station.chainage_m = place.chainage_m;
    station.position_m = place.position_m;
    station.heading_rad = std::atan2(place.ahead.y(), place.ahead.x());
    station.left = measure_side(seen, crossings, i, EdgeSide::left, slopes[i]);
    station.right = measure_side(seen, crossings, i, EdgeSide::right, slopes[i]);
    if (station.left.edge_m && station.right.edge_m) {
      station.width_m = Measure{station.left.edge_m->value + station.right.edge_m->value,
                                width_sigma_m(station.left.edge_m->sigma, station.right.edge_m->sigma)};
    }
    station.grade = slopes[i].grade;
    station.cross_fall = slopes[i].cross_fall;
    judge(state_->config, station);
  }
  return stations;
}

std::size_t RoadSurvey::memory_bytes() const {
  return sizeof(State) + state_->seen.memory_bytes();
}

}  // namespace berm
