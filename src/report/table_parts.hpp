#pragma once

#include <filesystem>

#include <nlohmann/json_fwd.hpp>

namespace berm {

/// scans.csv over the time since the first scan, s.
[[nodiscard]] nlohmann::ordered_json scans_part(const std::filesystem::path& file);

/// times.csv over the same time, and for every stage how many scans took how long.
[[nodiscard]] nlohmann::ordered_json times_part(const std::filesystem::path& file);

/// odometry.csv over the same time; `health` counts from 0, good, to 3, lost.
[[nodiscard]] nlohmann::ordered_json odometry_part(const std::filesystem::path& file);

/// road.csv by chainage, m.
[[nodiscard]] nlohmann::ordered_json road_part(const std::filesystem::path& file);

}  // namespace berm
