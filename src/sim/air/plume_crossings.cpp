#include "plume_crossings.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "berm/core/multiversion.hpp"
#include "smooth.hpp"

namespace berm::sim {
namespace {

constexpr std::size_t kLanes = AirLanes::kPacket;
/// Of the derivative of the error function.
constexpr float kSlope = 2.0F * std::numbers::inv_sqrtpi_v<float>;
/// A last step of Halley's that is this short leaves far less than the noise of any sensor: it cubes what is off.
constexpr float kSettled_m = 0.05F;
/// Beams that stay this many sigmas away, squared, pass a plume by: it ends there.
constexpr float kBeside = 16.0F;
constexpr int kMostSteps = 40;

using Packet = PlumeCrossings::Packet;
using Plumes = std::array<const PlumeShape*, kMostCrossings>;

/// The beams of a packet, close by.
struct alignas(32) Lines {
  std::array<Packet, 3> origin_m;
  std::array<Packet, 3> direction;
  Packet end_m;
};

Lines lines_of(const AirLanes& beams, std::size_t first) {
  Lines lines;  // NOLINT(cppcoreguidelines-pro-type-member-init): written at once
  const auto copy = [first](const AirLanes::Lanes<float>& from, Packet& to) {
    std::copy_n(from.begin() + first, kLanes, to.begin());
  };
  copy(beams.x_m, lines.origin_m[0]);
  copy(beams.y_m, lines.origin_m[1]);
  copy(beams.z_m, lines.origin_m[2]);
  copy(beams.dx, lines.direction[0]);
  copy(beams.dy, lines.direction[1]);
  copy(beams.dz, lines.direction[2]);
  copy(beams.end_m, lines.end_m);
  return lines;
}

PlumeBox box_of(const Lines& lines) {
  using Eight = Eigen::Map<const Eigen::Array<float, kLanes, 1>>;
  const Eight end_m(lines.end_m.data());
  PlumeBox box;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const Eight from_m(lines.origin_m[axis].data());
    const Eight direction(lines.direction[axis].data());
    const Eigen::Array<float, kLanes, 1> to_m = from_m + direction * end_m;
    box.low_m[static_cast<Eigen::Index>(axis)] = from_m.min(to_m).minCoeff();
    box.high_m[static_cast<Eigen::Index>(axis)] = from_m.max(to_m).maxCoeff();
  }
  return box;
}

/// A beam in the frame where a plume is a unit sphere: a line that passes its middle at a distance.
struct alignas(32) Passing {
  Packet square;    ///< sigmas per metre, squared
  Packet middle_m;  ///< range where it is nearest
  Packet nearest2;  ///< how near that is, squared
};

/// False: no beam comes near.
[[gnu::always_inline]] inline bool pass(const PlumeShape& plume, const Lines& beams, Passing& passing) {
  int near = 0;
  for (std::size_t i = 0; i < kLanes; ++i) {
    const float from_x = (beams.origin_m[0][i] - plume.center_m[0]) * plume.per_sigma[0];
    const float from_y = (beams.origin_m[1][i] - plume.center_m[1]) * plume.per_sigma[1];
    const float from_z = (beams.origin_m[2][i] - plume.center_m[2]) * plume.per_sigma[2];
    const float along_x = beams.direction[0][i] * plume.per_sigma[0];
    const float along_y = beams.direction[1][i] * plume.per_sigma[1];
    const float along_z = beams.direction[2][i] * plume.per_sigma[2];
    const float square = along_x * along_x + along_y * along_y + along_z * along_z;
    const float middle_m = -(from_x * along_x + from_y * along_y + from_z * along_z) / square;
    // From the nearest place itself: the difference of two squares would lose digits far away.
    const float x = from_x + middle_m * along_x;
    const float y = from_y + middle_m * along_y;
    const float z = from_z + middle_m * along_z;
    const float nearest2 = x * x + y * y + z * z;
    const float before_m = middle_m < 0.0F ? -middle_m : 0.0F;
    const float beyond_m = middle_m > beams.end_m[i] ? middle_m - beams.end_m[i] : before_m;
    near += nearest2 + beyond_m * beyond_m * square < kBeside ? 1 : 0;
    passing.square[i] = square;
    passing.middle_m[i] = middle_m;
    passing.nearest2[i] = nearest2;
  }
  return near > 0;
}

BERM_MULTIVERSION void cross(const Plumes& plumes, std::size_t count, const Lines& lines, PlumeCrossings& found) {
  const Lines beams = lines;
  alignas(32) Packet before{};
  alignas(32) Packet total{};
  alignas(32) Packet most_per_m{};
  Passing passing;  // NOLINT(cppcoreguidelines-pro-type-member-init): written at once
  found.count = 0;
  for (std::size_t k = 0; k < count; ++k) {
    if (!pass(*plumes[k], beams, passing)) {
      continue;
    }
    const float extinction_per_m = plumes[k]->extinction_per_m;
    PlumeCrossings::Crossing crossing;  // NOLINT(cppcoreguidelines-pro-type-member-init): written at once
    for (std::size_t i = 0; i < kLanes; ++i) {
      const float peak_per_m = extinction_per_m * fade(0.5F * passing.nearest2[i]);
      const float rate_per_m = std::sqrt(0.5F * passing.square[i]);
      const float half_depth = peak_per_m / (kSlope * rate_per_m);
      const float middle = passing.middle_m[i] * rate_per_m;
      const float here = half_depth * error_function(middle);
      crossing.half_depth[i] = half_depth;
      crossing.rate_per_m[i] = rate_per_m;
      crossing.middle[i] = middle;
      before[i] += here;
      total[i] += here + half_depth * error_function(beams.end_m[i] * rate_per_m - middle);
      most_per_m[i] += peak_per_m;
    }
    found.crossings[found.count++] = crossing;
  }
  for (std::size_t i = 0; i < kLanes; ++i) {
    found.before[i] = before[i];
    found.total[i] = total[i];
    found.most_per_m[i] = most_per_m[i];
    found.transmission[i] = fade(2.0F * total[i]);
  }
}

struct alignas(32) Sums {
  Packet depth;
  Packet extinction_per_m;
  Packet growth_per_m2;  ///< of the extinction
};

[[gnu::always_inline]] inline void add_up(const PlumeCrossings& found, const Packet& range_m, Sums& sums) {
  sums.depth = found.before;
  sums.extinction_per_m = {};
  sums.growth_per_m2 = {};
  for (std::size_t k = 0; k < found.count; ++k) {
    const PlumeCrossings::Crossing& crossing = found.crossings[k];
    for (std::size_t i = 0; i < kLanes; ++i) {
      const float place = range_m[i] * crossing.rate_per_m[i] - crossing.middle[i];
      sums.depth[i] += crossing.half_depth[i] * error_function(place);
      const float extinction_per_m = crossing.half_depth[i] * (kSlope * crossing.rate_per_m[i]) * fade(place * place);
      sums.extinction_per_m[i] += extinction_per_m;
      sums.growth_per_m2[i] -= 2.0F * place * crossing.rate_per_m[i] * extinction_per_m;
    }
  }
}

struct alignas(32) Sought {
  Packet end_m;
  Packet depth;
  Packet end_depth;
};

struct alignas(32) Found {
  Packet range_m;
  Packet extinction_per_m;
};

// Halley's steps from what even air would give, halving where they leave.
BERM_MULTIVERSION void find_places(const PlumeCrossings& crossings, const Sought& places, Found& found) {
  const Sought given = places;
  alignas(32) Packet range_m;
  alignas(32) Packet low_m{};
  alignas(32) Packet high_m = given.end_m;
  alignas(32) Packet extinction_per_m{};
  Sums sums{};
  for (std::size_t i = 0; i < kLanes; ++i) {
    range_m[i] = given.end_m[i] > 0.0F ? given.end_m[i] * (given.depth[i] / given.end_depth[i]) : 0.0F;
  }
  int moving = 1;
  for (int step = 0; moving > 0 && step < kMostSteps; ++step) {
    add_up(crossings, range_m, sums);
    moving = 0;
    for (std::size_t i = 0; i < kLanes; ++i) {
      const float at_m = range_m[i];
      const float here_per_m = sums.extinction_per_m[i] > 1e-12F ? sums.extinction_per_m[i] : 1e-12F;
      const float excess = sums.depth[i] - given.depth[i];
      const float newton_m = excess / here_per_m;
      const float bend = 1.0F - 0.5F * newton_m * sums.growth_per_m2[i] / here_per_m;
      const float least = bend > 0.5F ? bend : 0.5F;
      const float step_m = newton_m / (least < 2.0F ? least : 2.0F);
      const float next_m = at_m - step_m;
      const float low = excess > 0.0F ? low_m[i] : at_m;
      const float high = excess > 0.0F ? at_m : high_m[i];
      const bool is_inside = (next_m >= low) & (next_m <= high);
      const bool is_moving = (std::abs(step_m) >= kSettled_m) & (high - low >= kSettled_m);
      const float to_m = is_inside ? next_m : 0.5F * (low + high);
      const float there_per_m = sums.extinction_per_m[i] + (to_m - at_m) * sums.growth_per_m2[i];
      low_m[i] = low;
      high_m[i] = high;
      range_m[i] = to_m;
      extinction_per_m[i] = there_per_m > 0.0F ? there_per_m : 0.0F;
      moving += is_moving ? 1 : 0;
    }
  }
  found = {range_m, extinction_per_m};
}

}  // namespace

BERM_MULTIVERSION void depths_at(const PlumeCrossings& crossings, const Packet& range_m, Packet& depth) {
  alignas(32) Packet sums = crossings.before;
  const Packet ranges_m = range_m;
  for (std::size_t k = 0; k < crossings.count; ++k) {
    const PlumeCrossings::Crossing& crossing = crossings.crossings[k];
    for (std::size_t i = 0; i < kLanes; ++i) {
      const float place = ranges_m[i] * crossing.rate_per_m[i] - crossing.middle[i];
      sums[i] += crossing.half_depth[i] * error_function(place);
    }
  }
  depth = sums;
}

void PlaceSeekers::clear() {
  count = 0;
  crossings.count = 0;
  for (Packet* lanes : {&crossings.before, &end_m, &sought, &end_depth}) {
    lanes->fill(0.0F);
  }
}

void PlaceSeekers::add(const PlumeCrossings& packet, std::size_t lane, float to_m, float depth, float depth_at_end) {
  for (; crossings.count < packet.count; ++crossings.count) {
    crossings.crossings[crossings.count] = {};
  }
  for (std::size_t k = 0; k < packet.count; ++k) {
    const PlumeCrossings::Crossing& from = packet.crossings[k];
    PlumeCrossings::Crossing& to = crossings.crossings[k];
    to.half_depth[count] = from.half_depth[lane];
    to.rate_per_m[count] = from.rate_per_m[lane];
    to.middle[count] = from.middle[lane];
  }
  crossings.before[count] = packet.before[lane];
  end_m[count] = to_m;
  sought[count] = depth;
  end_depth[count] = depth_at_end;
  ++count;
}

void PlaceSeekers::find() {
  Found found;  // NOLINT(cppcoreguidelines-pro-type-member-init): written at once
  find_places(crossings, {end_m, sought, end_depth}, found);
  range_m = found.range_m;
  extinction_per_m = found.extinction_per_m;
}

void find_crossings(const PlumeTree& tree, const AirLanes& beams, std::size_t first, PlumeCrossings& found) {
  const Lines lines = lines_of(beams, first);
  Plumes plumes;  // NOLINT(cppcoreguidelines-pro-type-member-init): as many are written as are read
  std::size_t count = 0;
  tree.visit(box_of(lines), [&](const PlumeShape& plume) {
    if (count < kMostCrossings) {
      plumes[count++] = &plume;
    }
  });
  found.count = 0;
  if (count > 0) {
    cross(plumes, count, lines, found);
  }
}

}  // namespace berm::sim
