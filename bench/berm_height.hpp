#pragma once

#include <filesystem>
#include <memory>
#include <optional>

#include <Eigen/Core>

#include "berm/sim/terrain.hpp"

namespace berm::bench {

/// The ground of a simulated recording as the simulator had it: terrain.asc has cells of half a metre, which cut the
/// ridge of a berm by a decimetre. Throws FileError unless scenario.yaml and the seed are there.
[[nodiscard]] std::shared_ptr<const sim::Terrain> read_true_terrain(const std::filesystem::path& recording);

[[nodiscard]] double height_at(const sim::Terrain& terrain, const Eigen::Vector2d& place_m);

/// Height of a berm over the road at its toe: the median of the crests in the metre along the toe, each up to where it
/// falls again by a tenth of a metre; none on a wall, none where most of it is gap. The road is the line through what
/// lies inside the toe. `outward` is a unit vector across the edge.
[[nodiscard]] std::optional<double> true_berm_height_m(const sim::Terrain& terrain, const Eigen::Vector2d& toe_m,
                                                       const Eigen::Vector2d& outward);

/// The same for an edge whose outside is not known: on the side where it is higher.
[[nodiscard]] std::optional<double> true_berm_height_beside_m(const sim::Terrain& terrain, const Eigen::Vector2d& toe_m,
                                                              const Eigen::Vector2d& along);

}  // namespace berm::bench
