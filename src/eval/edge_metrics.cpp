#include "berm/eval/edge_metrics.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "berm/core/error.hpp"
#include "line_index.hpp"

namespace berm {
namespace {

using Eigen::Vector2d;

/// Keeps the work within bounds for coordinates that nobody drove.
constexpr double kMaxLength_m = 5e6;
constexpr double kMaxCoordinate_m = 1e9;

void check(bool promise, const std::string& expected) {
  if (!promise) {
    throw Error(ErrorCode::invalid_argument, "edge metrics: expected " + expected);
  }
}

/// Horizontal course of a line.
std::vector<Vector2d> course(const EdgeLine& line) {
  std::vector<Vector2d> places_m;
  places_m.reserve(line.vertices.size());
  for (const EdgeLine::Vertex& vertex : line.vertices) {
    places_m.emplace_back(vertex.position_m.head<2>());
  }
  return places_m;
}

double length_m(std::span<const Vector2d> course_m) {
  double length = 0.0;
  for (std::size_t i = 0; i < course_m.size(); ++i) {
    check(course_m[i].cwiseAbs().maxCoeff() <= kMaxCoordinate_m, "coordinates of up to 1e9 m");
    length += i == 0 ? 0.0 : (course_m[i] - course_m[i - 1]).norm();
  }
  return length;
}

using Courses = std::vector<std::vector<Vector2d>>;

Courses courses(std::span<const EdgeLine> lines) {
  Courses all;
  double total_m = 0.0;
  for (const EdgeLine& line : lines) {
    all.push_back(course(line));
    total_m += length_m(all.back());
  }
  check(total_m <= kMaxLength_m, "lines of up to 5000 km");
  return all;
}

/// Without the poses of a machine that stands: they say nothing new and cost much.
std::vector<Vector2d> thinned_path(std::span<const Eigen::Vector3d> path_m) {
  constexpr double kStep_m = 0.25;
  std::vector<Vector2d> thinned;
  for (const Eigen::Vector3d& place_m : path_m) {
    if (thinned.empty() || !((place_m.head<2>() - thinned.back()).norm() < kStep_m) || &place_m == &path_m.back()) {
      thinned.emplace_back(place_m.head<2>());
    }
  }
  check(length_m(thinned) <= kMaxLength_m, "a path of up to 5000 km");
  return thinned;
}

LineIndex index_of(const Courses& lines, double radius_m) {
  LineIndex index(radius_m);
  for (std::size_t line = 0; line < lines.size(); ++line) {
    const std::vector<Vector2d>& places_m = lines[line];
    for (std::size_t i = 0; i < places_m.size(); ++i) {
      // A line of one vertex is that place.
      if (i > 0 || places_m.size() == 1) {
        index.add(places_m[i == 0 ? 0 : i - 1], places_m[i], static_cast<std::uint32_t>(line));
      }
    }
  }
  index.finish();
  return index;
}

/// Calls `visit(place)` for places `step_m` apart along a line, from its first vertex on.
template <typename Visit>
void walk(std::span<const Vector2d> course_m, double step_m, Visit&& visit) {
  double next_m = 0.0;  // from the start of the stretch to the next place
  for (std::size_t i = 0; i + 1 < course_m.size(); ++i) {
    const Vector2d along_m = course_m[i + 1] - course_m[i];
    const double stretch_m = along_m.norm();
    for (; next_m < stretch_m; next_m += step_m) {
      visit(Vector2d(course_m[i] + next_m / stretch_m * along_m));
    }
    next_m -= stretch_m;
  }
  if (course_m.size() == 1) {
    visit(course_m.front());
  }
}

std::optional<double> share(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? std::nullopt : std::optional(static_cast<double>(part) / static_cast<double>(whole));
}

/// The value that `part` of all keep within.
std::optional<double> quantile(std::vector<double>& values, double part) {
  if (values.empty()) {
    return std::nullopt;
  }
  const auto rank = static_cast<std::ptrdiff_t>(part * static_cast<double>(values.size() - 1) + 0.5);
  std::nth_element(values.begin(), values.begin() + rank, values.end());
  return values[static_cast<std::size_t>(rank)];
}

void derive(EdgeScore& score, std::vector<double>& lateral_m) {
  score.precision = share(score.found_right, score.found);
  score.recall = share(score.truth_found, score.truth);
  if (score.precision && score.recall) {
    const double sum = *score.precision + *score.recall;
    score.f1 = sum > 0.0 ? 2.0 * *score.precision * *score.recall / sum : 0.0;
  }
  score.lateral_median_m = quantile(lateral_m, 0.5);
  score.lateral_p95_m = quantile(lateral_m, 0.95);
  score.wrong_side_share = share(score.wrong_side, score.found_right);
}

}  // namespace

EdgeScore judge_edges(std::span<const EdgeLine> found, std::span<const EdgeLine> truth,
                      std::span<const Eigen::Vector3d> path_m, const EdgeJudge& judge) {
  check(judge.sample_m > 0.0 && judge.tolerance_m > 0.0 && judge.near_path_m > 0.0, "positive lengths to judge by");
  const Courses found_m = courses(found);
  const Courses truth_m = courses(truth);
  const LineIndex near_found = index_of(found_m, judge.tolerance_m);
  const LineIndex near_truth = index_of(truth_m, judge.tolerance_m);
  const LineIndex near_path = index_of({thinned_path(path_m)}, judge.near_path_m);

  EdgeScore score;
  std::vector<double> lateral_m;
  for (std::size_t line = 0; line < found.size(); ++line) {
    walk(found_m[line], judge.sample_m, [&](const Vector2d& place_m) {
      ++score.found;
      if (const auto nearest = near_truth.nearest(place_m)) {
        ++score.found_right;
        score.wrong_side += truth[nearest->line].side != found[line].side ? 1U : 0U;
        lateral_m.push_back(nearest->distance_m);
      }
    });
  }
  for (const std::vector<Vector2d>& line_m : truth_m) {
    walk(line_m, judge.sample_m, [&](const Vector2d& place_m) {
      if (near_path.nearest(place_m)) {
        ++score.truth;
        score.truth_found += near_found.nearest(place_m) ? 1U : 0U;
      }
    });
  }
  derive(score, lateral_m);
  return score;
}

}  // namespace berm
