#include "berm_height.hpp"

#include <algorithm>
#include <vector>

#include "berm/core/error.hpp"
#include "berm/io/recording.hpp"
#include "berm/sim/scenario.hpp"
#include "berm/sim/simulate.hpp"
#include "slope.hpp"

namespace berm::bench {
namespace {

/// How far the toe of a berm reaches, how far its crest may lie, and where the road is.
constexpr double kToe_m = 0.5;
constexpr double kBermReach_m = 4.0;
constexpr double kRoad_m = 3.0;
constexpr double kStep_m = 0.1;
constexpr double kAlong_m = 0.5;
constexpr int kProfiles = 4;  // to both sides

/// From the toe outward up to where it falls again by a tenth of a metre, above the road at the toe: on the line of the
/// toe the ground lies up to 0.1 m above it. None on a wall.
std::optional<double> crest_m(const sim::Terrain& terrain, const Eigen::Vector2d& toe_m,
                              const Eigen::Vector2d& outward) {
  Slope road;
  for (double inside_m = kToe_m; inside_m <= kRoad_m; inside_m += 0.25) {
    road.add(inside_m, height_at(terrain, toe_m - inside_m * outward));
  }
  const double foot_m = road.at(0.0);
  double top_m = height_at(terrain, toe_m);
  for (double s = kStep_m; s <= kBermReach_m; s += kStep_m) {
    const double z_m = height_at(terrain, toe_m + s * outward);
    if (!(z_m > top_m - 0.1)) {
      return top_m - foot_m > 0.2 ? std::optional(top_m - foot_m) : std::nullopt;
    }
    top_m = std::max(top_m, z_m);
  }
  return std::nullopt;
}

}  // namespace

std::shared_ptr<const sim::Terrain> read_true_terrain(const std::filesystem::path& recording) {
  const std::optional<std::uint64_t> seed = Recording::open(recording).sheet().seed;
  if (!seed) {
    throw FileError(ErrorCode::malformed, (recording / "sequence.json").string(), std::nullopt,
                    "has no seed: the world cannot be built again");
  }
  return sim::build_world(sim::read_scenario(recording / "scenario.yaml"), *seed).terrain;
}

double height_at(const sim::Terrain& terrain, const Eigen::Vector2d& place_m) {
  return terrain.at(place_m.x(), place_m.y()).height_m;
}

std::optional<double> true_berm_height_m(const sim::Terrain& terrain, const Eigen::Vector2d& toe_m,
                                         const Eigen::Vector2d& outward) {
  const Eigen::Vector2d along(-outward.y(), outward.x());
  std::vector<double> crests_m;
  for (int i = -kProfiles; i <= kProfiles; ++i) {
    if (const auto crest = crest_m(terrain, toe_m + kAlong_m * i / kProfiles * along, outward)) {
      crests_m.push_back(*crest);
    }
  }
  if (crests_m.size() <= kProfiles) {
    return std::nullopt;
  }
  const auto middle = crests_m.begin() + static_cast<std::ptrdiff_t>(crests_m.size() / 2);
  std::nth_element(crests_m.begin(), middle, crests_m.end());
  return *middle;
}

std::optional<double> true_berm_height_beside_m(const sim::Terrain& terrain, const Eigen::Vector2d& toe_m,
                                                const Eigen::Vector2d& along) {
  const Eigen::Vector2d left(-along.y(), along.x());
  const auto one = true_berm_height_m(terrain, toe_m, left);
  const auto other = true_berm_height_m(terrain, toe_m, -left);
  return one && other ? std::max(one, other) : (one ? one : other);
}

}  // namespace berm::bench
